# SPDX-License-Identifier: Apache-2.0
"""`alidade selftest` as its users meet it."""
import json
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

from program import PROGRAM, SANITIZED, run


class Selftest(unittest.TestCase):
    def test_a_few_cases_of_every_row(self):
        done = run("selftest", "--numerics", "--share", 0.02, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        document = json.loads(done.stdout)
        known = [failure["row"] for failure in document["failures"] if failure["known"]]
        self.assertLessEqual(len(known), 2, "so many rows may fall short, if that is told")
        self.assertEqual([failure for failure in document["failures"] if not failure["known"]], [])
        self.assertEqual(len(document["rows"]), 26)
        for row in document["rows"]:
            self.assertGreater(row["asked"], 2, row["id"])
            self.assertEqual(row["wrong"], row["excused"], row["id"])
            self.assertLessEqual(row["wrong"], row["asked"] / 500 if row["id"] in known else 0, row["id"])

    def test_one_case_is_asked_again(self):
        done = run("selftest", "--numerics", "sphere-far", "--case", 11382, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([row["id"] for row in json.loads(done.stdout)["rows"]], ["T07"])

    def test_structures_of_one_precision(self):
        """What fails with the fast test names its precision, and is found again by the words that are told."""
        for precision, other in (("float", "double"), ("double", "float")):
            for row in ("T01", "T04", "T05", "T15"):
                done = run("selftest", "--numerics", row, "--share", 0.02, "--intersect", "fast", "--precision", precision, "--json")
                document = json.loads(done.stdout)
                self.assertEqual((done.returncode, len(document["failures"])), (1, 1), row)
                failure = document["failures"][0]
                self.assertIn(f", {precision}, fast", failure["what"])
                self.assertNotIn(f", {other}, ", failure["what"])
                self.assertEqual(run(*failure["again"].split()[1:]).returncode, 1, failure["again"])

    def test_a_run_that_was_killed_goes_on(self):
        words = ["selftest", "--numerics", "T09", "T07", "--share", 2 if SANITIZED else 12, "--threads", 2]
        strip = lambda text: [{key: value for key, value in row.items() if key != "cpu seconds"} for row in json.loads(text)["rows"]]
        start = time.monotonic()
        want = strip(run(*words, "--json").stdout)
        whole = time.monotonic() - start
        with tempfile.TemporaryDirectory() as folder:
            for kill in (signal.SIGTERM, signal.SIGKILL):
                going = subprocess.Popen([PROGRAM, *map(str, words), "--state", folder], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                time.sleep(whole / 8)
                going.send_signal(kill)
                self.assertEqual(going.wait(), 2 if kill == signal.SIGTERM else -signal.SIGKILL)
            done = run(*words, "--state", folder, "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(strip(done.stdout), want)
            start = time.monotonic()
            table = run("selftest", "--numerics", "--state", folder, "--told", "--markdown")
            self.assertEqual(table.returncode, 0, table.stderr)
            self.assertLess(time.monotonic() - start, 10, "nothing is asked again")
            lines = table.stdout.splitlines()
            self.assertEqual([line.split("|")[1].strip() for line in lines[4:6]], ["T07 sphere-far", "T09 quadric-cancel"])
            self.assertRegex(lines[0], r"^[\d,]+ answers in [\d.e-]+ hours of one processor core, on [\d-]+; wrong: none\.$")
            self.assertIn("| T09 quadric-cancel | distance in sizes | 1e1 to 1e6 |", table.stdout)
            self.assertIn(" % of a whole run) | 0 |", table.stdout)
            other = run("selftest", "--numerics", "T09", "--state", folder)
            self.assertEqual(other.returncode, 1)
            self.assertIn("another share", other.stderr)

    def test_wrong_words(self):
        done = run("selftest", "--numerics", "sphere-fra")
        self.assertEqual(done.returncode, 64)
        self.assertIn("did you mean 'sphere-far'?", done.stderr)
        self.assertEqual(run("selftest").returncode, 64)
        self.assertEqual(run("selftest", "--numerics", "--told").returncode, 64)
        gone = run("selftest", "--numerics", "--told", "--state", "/nowhere/at/all")
        self.assertEqual(gone.returncode, 1)
        self.assertIn("cannot read /nowhere/at/all", gone.stderr)
        for words in (["--share", "nan"], ["--share", "inf"], ["--share", "1e300"], ["--share", "0"], ["--case", "-1"], ["--case", "99999999999999999999999"], ["--case", "1.5"]):
            done = run("selftest", "--numerics", "T07", *words)
            self.assertEqual(done.returncode, 64, words)
            self.assertIn(words[1], done.stderr)

    def test_a_state_that_cannot_be_true_is_no_result(self):
        line = {"begun": "", "day": "", "wanted": 9, "cpu seconds": 1, "cases": 9, "asked": 9, "wrong": 0, "excused": 0, "first wrong": 0, "worst case": 0, "worst": "0x0p+0", "why": "", "bands": []}
        for broken in ({"cases": 10}, {"wrong": 10}, {"excused": 1}, {"asked": -1}, {"worst": 0}, {"bands": [[99, 0, 0, 0, "0"]]}, {"cases": "nine"}):
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder, "measured.jsonl")
                path.write_text(json.dumps({"key": "T07", "value": line | broken}) + "\n")
                told = run("selftest", "--numerics", "--told", "--state", folder)
                self.assertEqual(told.returncode, 1, broken)
                self.assertIn("what is kept of T07 cannot be read", told.stderr)
                other = run("selftest", "--numerics", "T07", "--share", 0.01, "--state", folder)
                self.assertEqual(other.returncode, 1, "of what it is is not said")
                self.assertIn("does not say of what its measurements are", other.stderr)
                path.write_text("")
                self.assertEqual(run("selftest", "--numerics", "T07", "--share", 0.01, "--state", folder).returncode, 0)
                with path.open("a") as file:
                    file.write(json.dumps({"key": "T07", "value": line | broken}) + "\n")
                again = run("selftest", "--numerics", "T07", "--share", 0.01, "--state", folder, "--json")
                self.assertEqual(json.loads(again.stdout)["rows"][0]["cases"], 400, "asked anew")

    def test_a_row_is_told_once(self):
        rows = json.loads(run("selftest", "--numerics", "T07", "sphere-far", "T07", "--share", 0.01, "--json").stdout)["rows"]
        self.assertEqual([row["id"] for row in rows], ["T07"])


if __name__ == "__main__":
    unittest.main()
