# SPDX-License-Identifier: Apache-2.0
"""Fails when a patch of tests/mutants does not apply to the tree as it is: a mutant that cannot be made is caught by nothing. (tests/mutants/run makes them, and takes hours.)"""
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[1]


class Mutants(unittest.TestCase):
    def test_all_patches_apply(self):
        patches = sorted((ROOT / "tests/mutants").glob("*.patch"))
        self.assertGreater(len(patches), 11)
        for patch in patches:
            with self.subTest(patch.stem):
                said = subprocess.run(["git", "apply", "--check", str(patch)], cwd=ROOT, capture_output=True, text=True)
                self.assertEqual(said.returncode, 0, said.stderr)
                self.assertRegex(patch.read_text().splitlines()[0], r"^caught by \w+ \S+")


if __name__ == "__main__":
    sys.exit(unittest.main())
