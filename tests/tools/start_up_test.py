# SPDX-License-Identifier: Apache-2.0
"""Starting costs next to nothing, because nothing is loaded before it is needed."""
import os
import subprocess
import unittest

from program import PROGRAM, SANITIZED, InFolder, run

BUDGET = 0.030   # CPU seconds


def cpu_seconds(*words):
    pid = os.posix_spawn(PROGRAM, [PROGRAM, *words], os.environ, file_actions=[(os.POSIX_SPAWN_OPEN, 1, "/dev/null", os.O_WRONLY, 0)])
    _, status, used = os.wait4(pid, 0)
    assert status == 0
    return used.ru_utime + used.ru_stime


def libraries_opened(*words, cwd):
    """What the dynamic linker says while the program runs, as text."""
    said = run(*words, cwd=cwd, env={**os.environ, "LD_DEBUG": "files"})
    assert said.returncode == 0, said.stderr[-500:]
    return said.stderr


class StartUp(InFolder):
    @unittest.skipIf(SANITIZED, "a sanitizer's own start-up is not ours")
    def test_the_tables_are_printed_within_the_budget(self):
        least = min(cpu_seconds("info", "--features") for _ in range(15))
        print(f"info --features: {1000 * least:.1f} ms of CPU (least of 15 runs)")
        self.assertLessEqual(least, BUDGET)

    def test_openimageio_is_not_linked(self):
        linked = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True, check=True).stdout
        self.assertIn("libpng", linked)   # ldd did its work
        self.assertNotIn("OpenImageIO", linked)

    def test_openimageio_is_opened_by_a_picture_that_needs_it_and_by_no_other(self):
        render = ["render", self.scene, "--size", "16x12", "--spp", "1"]
        self.assertNotIn("OpenImageIO", libraries_opened(*render, "-o", "out.png", "--aov", "depth", cwd=self.folder))
        self.assertIn("OpenImageIO", libraries_opened(*render, "-o", "out.jpg", cwd=self.folder))


if __name__ == "__main__":
    unittest.main()
