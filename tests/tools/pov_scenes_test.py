# SPDX-License-Identifier: Apache-2.0
"""POV-Ray's example scenes (Debian's povray-examples), written by `convert` and read again: the colours are the same, bit for bit.

Scenes that lose something, or that we do not read without a warning, are counted and left alone; so are those that need words of their own (a frame, a clock)."""
import collections
import os
import pathlib
import subprocess
import unittest

from program import SANITIZED, InFolder, run

EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
STEP = 1 if os.environ.get("ALIDADE_FULL") else 9
SECONDS = 60
UNREADABLE = 1   # docs/adding.md


class PovScenes(InFolder):
    def render(self, scene, out):
        return run("render", scene, "-o", out, "--size", "320x240", "--spp", 1, cwd=self.folder, timeout=SECONDS)

    def fate(self, scene):
        """`same`, `differs`, or why it is not compared."""
        try:
            written = run("convert", scene, "out.pov", cwd=self.folder, timeout=SECONDS)
            if written.returncode != 0:
                self.assertEqual(written.returncode, UNREADABLE, f"{scene}: {written.stderr}")   # a signal's is negative
                self.assertRegex(written.stderr, ": error: ", scene)
                return "refused"
            if "lost: " in written.stderr or "warning: " in written.stderr:
                return "lost"
            before, again = self.render(scene, "before.exr"), self.render("out.pov", "again.exr")
        except subprocess.TimeoutExpired:
            return "slow"
        self.assertEqual((before.returncode, again.returncode), (0, 0), again.stderr)
        if "warning: " in again.stderr:
            self.assertIn("prism", again.stderr, "nothing else is written that we do not read")
            return "letters"
        return "same" if run("diff", "before.exr", "again.exr", "--preset", "exact", cwd=self.folder).returncode == 0 else "differs"

    def test_what_is_read_again_has_the_same_colours(self):
        scenes = sorted(EXAMPLES.rglob("*.pov"))[::STEP]
        fates = collections.defaultdict(list)
        for scene in scenes:
            fates[self.fate(scene)].append(str(scene.relative_to(EXAMPLES)))
        if os.environ.get("ALIDADE_FIGURES"):
            print({fate: len(names) for fate, names in fates.items()}, fates["lost"], fates["slow"], fates["refused"], flush=True)
        self.assertEqual(fates["differs"], [])
        self.assertLessEqual(len(fates["refused"]), 0.05 * len(scenes), fates["refused"])
        self.assertGreater(len(fates["same"]), 0.54 * len(scenes))


if __name__ == "__main__":
    if SANITIZED or not EXAMPLES.is_dir():
        print("two pictures a scene: too slow under a sanitizer" if SANITIZED else "povray-examples is not installed")
        raise SystemExit(77)
    unittest.main()
