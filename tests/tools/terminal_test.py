# SPDX-License-Identifier: Apache-2.0
"""The program on a terminal (a pseudo one): the bar, and what Ctrl-C does."""
import fcntl
import os
import pty
import signal
import struct
import subprocess
import sys
import termios
import threading
import time
import unittest

from program import PROGRAM, InFolder, read_png


class OnTerminal:
    """A run whose stderr is a terminal of 60 columns; `said` grows while it runs."""

    def __init__(self, folder, *words):
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 60, 0, 0))
        self.process = subprocess.Popen([PROGRAM, *map(str, words)], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=theirs)
        os.close(theirs)
        self.said = b""
        self.reader = threading.Thread(target=self.read, args=(ours,))
        self.reader.start()

    def read(self, ours):
        try:
            while part := os.read(ours, 4096):
                self.said += part
        except OSError:   # the other side is closed
            pass
        os.close(ours)

    def wait_until(self, text, seconds=60):
        end = time.monotonic() + seconds
        while text not in self.said:
            if time.monotonic() > end or self.process.poll() is not None:
                raise AssertionError(f"{text!r} never came: {self.said!r}")
            time.sleep(0.01)

    def finish(self):
        code = self.process.wait(60)
        out = self.process.stdout.read()
        self.process.stdout.close()
        self.reader.join()
        return code, out.decode(), self.said.decode().replace("\r\n", "\n")


class Terminal(InFolder):
    LONG = ["--size", "640x480", "--spp", "20000", "--tile", "8"]   # minutes

    def test_the_bar_is_drawn_seldom_and_erased(self):
        start = time.monotonic()
        code, out, said = OnTerminal(self.folder, "render", self.scene, "--size", "320x240", "--spp", "64", "--tile", "8").finish()
        seconds = time.monotonic() - start
        self.assertEqual((code, out), (0, ""))
        drawn = said.count("\r[")
        self.assertGreaterEqual(drawn, 1)
        self.assertLessEqual(drawn, 10 * seconds + 1)
        for line in said.split("\r"):
            self.assertLessEqual(len(line.split("\033")[0].rstrip("\n").split("\n")[0]), 60) if line.startswith("[") else None
        self.assertRegex(said, r"\r\x1b\[Ktriangle\.png: 320x240[^\r]*\n$", "the bar is erased before the last words")

    def test_a_bar_can_be_refused(self):
        code, _, said = OnTerminal(self.folder, "render", self.scene, "--size", "64x48", "--progress", "none").finish()
        self.assertEqual((code, said.count("\r")), (0, 0))

    def test_interrupted_it_writes_what_is_there(self):
        for sent in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=sent):
                run = OnTerminal(self.folder, "render", self.scene, "-o", "part.png", *self.LONG)
                run.wait_until(b"left")
                run.process.send_signal(sent)
                code, _, said = run.finish()
                self.assertEqual(code, 2, said)
                self.assertRegex(said, r"alidade: interrupted after [1-9]\d* of 4800 tiles; the rest of the picture is black\n$")
                self.assertEqual(read_png(self.folder / "part.png")[:2], (640, 480))
                (self.folder / "part.png").unlink()

    def test_an_interrupt_is_heard_in_the_midst_of_a_tile(self):
        run = OnTerminal(self.folder, "render", self.scene, "-o", "part.png", "--size", "640x480", "--spp", "100000", "--tile", "4096", "--progress", "none")
        time.sleep(1)   # the one tile takes minutes, and says nothing
        self.assertIsNone(run.process.poll())
        run.process.send_signal(signal.SIGINT)
        start = time.monotonic()
        code, _, said = run.finish()
        self.assertEqual(code, 2)
        self.assertLess(time.monotonic() - start, 5)
        self.assertIn("interrupted after 0 of 1 tiles", said)
        self.assertEqual(read_png(self.folder / "part.png")[:2], (640, 480))

    def test_a_pixel_that_takes_for_ever_is_told_and_left_at_the_second_signal(self):
        (self.folder / "long.pov").write_text("camera { location -z } plane { z, 0 pigment { mandel 2000000000 color_map { [0 rgb 0] [1 rgb 1] } scale 100 } finish { ambient 1 } }\n")
        run = OnTerminal(self.folder, "render", "long.pov", "--size", "4x4", "--threads", "1", "--progress", "none")
        time.sleep(1)
        run.process.send_signal(signal.SIGINT)
        run.wait_until(b"a second signal ends the program", 20)
        run.process.send_signal(signal.SIGINT)
        self.assertEqual(run.finish()[0], -signal.SIGINT)


SKIPPED = 77   # as tests/tools/CMakeLists.txt has it


def why_not():
    """Why there is no pseudo terminal here (a bare root without /dev/pts), or None."""
    try:
        for end in pty.openpty():
            os.close(end)
    except OSError as error:
        return f"this machine has no pseudo terminals ({error})"


if __name__ == "__main__":
    if reason := why_not():
        print(reason)
        sys.exit(SKIPPED)
    unittest.main()
