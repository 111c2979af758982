# SPDX-License-Identifier: Apache-2.0
"""`alidade selftest` as its users meet it."""
import json
import unittest

from program import run


class Selftest(unittest.TestCase):
    def test_a_few_cases_of_every_row(self):
        done = run("selftest", "--numerics", "--share", 0.02, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        document = json.loads(done.stdout)
        known = [failure["row"] for failure in document["failures"] if failure["known"]]
        self.assertLessEqual(len(known), 2, "so many rows may fall short, if that is told")
        self.assertEqual([failure for failure in document["failures"] if not failure["known"]], [])
        self.assertGreater(len(document["rows"]), 3)
        for row in document["rows"]:
            self.assertGreater(row["asked"], 2, row["id"])
            self.assertLessEqual(row["wrong"], row["asked"] / 1000 if row["id"] in known else 0, row["id"])

    def test_one_case_is_asked_again(self):
        done = run("selftest", "--numerics", "sphere-far", "--case", 11382, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([row["id"] for row in json.loads(done.stdout)["rows"]], ["T07"])

    def test_wrong_words(self):
        done = run("selftest", "--numerics", "sphere-fra")
        self.assertEqual(done.returncode, 64)
        self.assertIn("did you mean 'sphere-far'?", done.stderr)
        self.assertEqual(run("selftest").returncode, 64)


if __name__ == "__main__":
    unittest.main()
