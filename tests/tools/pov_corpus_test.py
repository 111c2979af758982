# SPDX-License-Identifier: Apache-2.0
"""`compare --corpus` over POV-Ray's example scenes judges as the project's yardstick does (shared/pov/score.py, which knows nothing of our code)."""
import csv
import json
import os
import pathlib
import shutil
import subprocess
import unittest

from program import PROGRAM, SANITIZED, InFolder, run

EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
YARDSTICK = pathlib.Path(__file__).resolve().parents[3] / "shared/pov"
PYTHON = shutil.which("python3", path="/usr/bin") or "python3"   # the system's, whose packages the yardstick needs
FULL = bool(os.environ.get("ALIDADE_FULL"))


def why_not():
    if SANITIZED:
        return "two renderers a scene: too slow under a sanitizer"
    if not (YARDSTICK / "score.py").exists():
        return "the shared yardstick is not there"
    if not EXAMPLES.is_dir():
        return "povray-examples is not installed"
    if subprocess.run([PYTHON, "-c", "import numpy, PIL"], capture_output=True).returncode != 0:
        return "the yardstick needs python3-numpy and python3-pil"
    return None


class PovCorpus(InFolder):
    def test_grades_are_the_yardsticks_verdicts(self):
        with open(YARDSTICK / "corpus.csv") as file:
            rows = [row for row in csv.DictReader(file) if row["status"] == "ok" and int(row["tier"]) <= 3][::1 if FULL else 16]
        with open(self.folder / "list.csv", "w") as file:
            writer = csv.DictWriter(file, rows[0].keys())
            writer.writeheader()
            writer.writerows(rows)
        said = run("compare", "--corpus", "list.csv", "--scenes", EXAMPLES, "--out", "out", "--cache", "cache", "--jobs", 2, cwd=self.folder, timeout=3000)
        self.assertIn(said.returncode, (0, 1, 2), said.stderr)
        grades = {row["name"]: row["grade"]["name"] for row in map(json.loads, (self.folder / "out/results.jsonl").read_text().splitlines())}
        subprocess.run([PYTHON, YARDSTICK / "score.py", "--ours", f"{PROGRAM} povray", "--manifest", "list.csv", "--scenes", EXAMPLES, "--cache", "references", "--jobs", "2", "--csv", "scores.csv"],
                       cwd=self.folder, check=True, capture_output=True, timeout=3000)
        with open(self.folder / "scores.csv") as file:
            verdicts = {row["path"]: row["verdict"] for row in csv.DictReader(file)}
        self.assertEqual(grades.keys(), verdicts.keys())
        self.assertEqual(len(verdicts), len(rows))
        others = {path: (grades[path], verdict) for path, verdict in verdicts.items() if grades[path] != verdict}
        self.assertLessEqual(len(others), 0.01 * len(rows), others)
        self.assertGreater((self.folder / "out/report.html").stat().st_size, 10000)


if __name__ == "__main__":
    if reason := why_not():
        print(reason)
        raise SystemExit(77)
    unittest.main()
