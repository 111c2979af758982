# SPDX-License-Identifier: Apache-2.0
"""`alidade povray +C`: pictures that were interrupted are gone on with, and are those that were not. Parts of pictures join."""
import fcntl
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from program import PROGRAM, SANITIZED, run

# Mirrors and glass: a tile takes a millisecond or more.
SCENE = """#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, 2, -6> look_at 0 right x*4/3 }
light_source { <10, 20, -20> rgb 1 }
plane { y, -1 pigment { checker rgb 1, rgb .2 } finish { reflection .3 } }
#ifndef (Speed) #declare Speed = 7; #end
#declare I = 0;
#while (I < 12)
  sphere { <3*sin(I*Speed), sin(I*3), 3*cos(I*5)>, .7
    pigment { rgbt <.5 + .5*sin(I), .5, .5 + .5*cos(I), .5> } finish { reflection .3 specular .5 } interior { ior 1.3 } }
  #declare I = I + 1;
#end
"""
EDGES = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
plane { z, 0 pigment { checker rgb <1, .3, .2>, rgb .1 scale .11 rotate 17*z } finish { ambient 1 diffuse 0 } }
"""
WAYS = (["-A"], ["+A0.3", "+AM1", "+R2"], ["+A0.3", "+AM2", "+R2"])
WIDTH, HEIGHT = (80, 60) if SANITIZED else (160, 120)


def whole_size(width, height, tile):
    """Of the records of a state with all tiles."""
    return 12 * width * height + 12 * -(-width // tile) * -(-height // tile)


class Resuming(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(kept.cleanup)
        cls.folder = pathlib.Path(kept.name)
        (cls.folder / "s.pov").write_text(SCENE)
        (cls.folder / "edges.pov").write_text(EDGES)
        cls.random = random.Random(20110621)
        cls.references = {}

    def setUp(self):
        for left in (*self.folder.glob("*.png"), *self.folder.glob("*.pov-state")):
            left.unlink()
        self.picture, self.state = self.folder / "p.png", self.folder / "p.pov-state"

    def words(self, *more, size=(WIDTH, HEIGHT)):
        return ["povray", "s.pov", f"+W{size[0]}", f"+H{size[1]}", "+Op.png", "-V", *more]

    def render(self, *more, size=(WIDTH, HEIGHT), code=0):
        said = run(*self.words(*more, size=size), cwd=self.folder)
        self.assertEqual((said.returncode, said.stdout), (code, ""), said)
        return said.stderr

    def reference(self, *way, size=(WIDTH, HEIGHT)):
        """The bytes of the picture that was never interrupted."""
        if (way, size) not in self.references:
            said = run("povray", "s.pov", f"+W{size[0]}", f"+H{size[1]}", "+Owhole.png", "+WT1", *way, cwd=self.folder)
            self.assertEqual(said.returncode, 0, said)
            self.assertFalse((self.folder / "whole.pov-state").exists(), "a finished picture leaves no state")
            self.references[way, size] = (self.folder / "whole.png").read_bytes()
        return self.references[way, size]

    def end_within(self, share, *more, with_signal=signal.SIGKILL):
        """Ends a render once its state has so much of its bytes; true if that was before it was done."""
        least = share * whole_size(WIDTH, HEIGHT, 32 if "+AM" in " ".join(more) else 16)
        process = subprocess.Popen([PROGRAM, *self.words(*more)], cwd=self.folder, stderr=subprocess.DEVNULL)
        while process.poll() is None:
            if self.state.exists() and self.state.stat().st_size >= least:
                time.sleep(self.random.random() * 0.01)
                process.send_signal(with_signal)
                break
            time.sleep(0.0005)
        return process.wait(60) in (-signal.SIGKILL, 2)

    def interrupt(self, share, *more, with_signal=signal.SIGKILL):
        """The same, until it was. On a machine with much to do, this program may be too late."""
        for attempt in range(20):
            self.picture.unlink(missing_ok=True)
            if self.end_within(share * 0.9**attempt, *more, with_signal=with_signal):
                return
        self.fail("the renders were done too soon")

    def interrupted_state(self):
        """The bytes of a state with some tiles, all of them whole: what is killed may leave a part of its last one."""
        self.interrupt(0.3, with_signal=signal.SIGINT)
        return self.state.read_bytes()

    def test_killed_at_ten_moments_it_goes_on_to_the_same_bytes(self):
        in_the_middle = 0
        for i in range(10):
            way, threads = WAYS[i % 3], 1 + i % 2
            with self.subTest(way=way, threads=threads):
                self.interrupt(self.random.uniform(0.02, 0.8), *way, f"+WT{threads}")
                self.assertFalse(self.picture.exists())
                known, tiles = map(int, re.search(r"p\.png: (\d+) of (\d+) tiles are known", self.render(*way, "+C", f"+WT{3 - threads}")).groups())
                in_the_middle += 0 < known < tiles
                self.assertEqual(self.picture.read_bytes(), self.reference(*way))
                self.assertFalse(self.state.exists())
        self.assertGreaterEqual(in_the_middle, 8)

    def test_killed_again_and_again_it_ends_with_the_same_bytes(self):
        way = WAYS[1]
        kills = sum(self.end_within(0.08 * i, *way, "+C", f"+WT{1 + i % 3}") for i in range(1, 11))
        self.assertGreaterEqual(kills, 5)
        self.render(*way, "+C")
        self.assertEqual(self.picture.read_bytes(), self.reference(*way))

    def test_killed_before_its_first_tile_it_goes_on_too(self):
        for i in range(5):
            process = subprocess.Popen([PROGRAM, *self.words()], cwd=self.folder, stderr=subprocess.DEVNULL)
            time.sleep(self.random.random() * 0.05)
            process.kill()
            process.wait()
        self.render("+C")
        self.assertEqual(self.picture.read_bytes(), self.reference())

    def test_interrupts_leave_the_state(self):
        for sent in (signal.SIGINT, signal.SIGTERM):
            self.interrupt(0.2, with_signal=sent)
            self.assertTrue(self.picture.exists(), "what is there is written")
            self.assertRegex(self.render("+C"), "tiles are known")
            self.assertEqual(self.picture.read_bytes(), self.reference())

    def test_without_C_it_begins_anew(self):
        state = self.interrupted_state()
        for word in ("-C", "+WT2", "Continue_Trace=off"):
            self.state.write_bytes(state)
            self.assertNotIn("known", self.render(word))
            self.assertFalse(self.state.exists())
        self.assertIn("'Continue_Trace=perhaps' has no value", self.render("Continue_Trace=perhaps", code=1))

    def test_a_state_of_another_picture_is_not_used(self):
        state = self.interrupted_state()
        small = (40, 30)
        other = self.folder / "other_program"
        shutil.copy(PROGRAM, other)
        scene = self.folder / "s.pov"
        for why, size, words in ((f"size is {WIDTH}x{HEIGHT}, not 40x30", small, ()), (f"part is 0,0,{WIDTH},{HEIGHT}, not 0,0,{WIDTH // 2},{HEIGHT}", None, ("+EC0.5",)), ("antialiasing is", None, ("+A0.1",)),
                                 ("integrator is", None, ("+KFI7", "+KFF7", "Clock=0")), ("scene is", None, ("Declare=Speed=9",)), ("scene is", None, ("changed",)), ("program is", None, ("other",))):
            with self.subTest(why=why, words=words):
                size = size or (WIDTH, HEIGHT)
                scene.write_text(SCENE.replace("sin(I*3)", "sin(I*4)") if "changed" in words else SCENE)
                given = [w for w in words if w not in ("changed", "other")]
                name = "p7" if "+KFI7" in words else "p"
                (self.folder / f"{name}.pov-state").write_bytes(state)
                command = [other if "other" in words else PROGRAM, *self.words(*given, "+C", size=size)]
                said = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
                self.assertEqual(said.returncode, 0, said)
                self.assertRegex(said.stderr, rf"warning: {name}\.pov-state cannot be continued: it is of another picture: its {re.escape(why)}")
                continued = (self.folder / f"{name}.png").read_bytes()
                self.render(*given, "-C", size=size)
                self.assertEqual(continued, (self.folder / f"{name}.png").read_bytes())
        scene.write_text(SCENE)

    def test_a_damaged_state_is_not_used(self):
        state = self.interrupted_state()
        head = state.index(b"scene ") + 7 + 16 + 8
        flipped = bytearray(state)
        flipped[head + 2000] ^= 4
        for why, data in (("its head was cut off", state[:100]), ("its head is damaged", state[:60] + b"x" + state[61:]), ("it is damaged at byte", flipped),
                          ("it is not a state of Alidade", bytes(self.random.randrange(256) for _ in range(5000))), ("it is damaged at byte", state[:head] + bytes(len(state) - head))):
            with self.subTest(why=why):
                self.state.write_bytes(data)
                self.assertIn(f"p.pov-state cannot be continued: {why}", self.render("+C"))
                self.assertEqual(self.picture.read_bytes(), self.reference())

    def test_a_state_that_was_cut_off_loses_its_tail_alone(self):
        state = self.interrupted_state()
        self.state.write_bytes(state)
        known = int(re.search(r"(\d+) of", self.render("+C"))[1])
        least = whole_size(16, HEIGHT % 16, 16)   # of a record: a tile at the lower edge
        for cut in (1, least, self.random.randrange(1, least)):
            self.state.write_bytes(state[:-cut])
            self.assertRegex(self.render("+C"), f"^p.png: {known - 1} of ")
            self.assertEqual(self.picture.read_bytes(), self.reference())

    def test_without_a_state_the_picture_is_made_with_one_warning(self):
        small = (40, 30)
        for make in (self.state.mkdir, lambda: os.mkfifo(self.state), lambda: self.state.symlink_to("s.pov")):
            make()
            self.picture.unlink(missing_ok=True)
            said = self.render("+C", size=small)
            self.assertRegex(said, r"^alidade: warning: p\.pov-state: [^\n]*: this picture cannot be continued if it is interrupted\n$")
            self.assertEqual(self.picture.read_bytes(), self.reference(size=small))
            self.state.rmdir() if self.state.is_dir() else self.state.unlink()
        self.assertEqual((self.folder / "s.pov").read_text(), SCENE)

    def test_a_full_disc_ends_the_state_and_not_the_picture(self):
        def limited():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000))

        small = (40, 30)
        said = run(*self.words(size=small), cwd=self.folder, preexec_fn=limited)
        self.assertEqual(said.returncode, 0, said)
        self.assertEqual(said.stderr.count("warning"), 1)
        self.assertIn("what is rendered from now on is lost", said.stderr)
        self.assertEqual(self.picture.read_bytes(), self.reference(size=small))

    def test_two_processes_do_not_share_a_state(self):
        small = (40, 30)
        with open(self.state, "wb") as held:
            fcntl.flock(held, fcntl.LOCK_EX)
            self.assertIn("another process is rendering this picture", self.render(size=small))
            self.assertEqual(self.state.read_bytes(), b"")
        self.assertEqual(self.picture.read_bytes(), self.reference(size=small))

    def test_a_picture_that_is_there_is_skipped(self):
        small = (40, 30)
        self.render(size=small)
        self.picture.write_bytes(b"kept")
        self.assertEqual(self.render("+C", size=small), "p.png: rendered already, and +C: skipped\n")
        self.assertEqual(self.picture.read_bytes(), b"kept")
        self.state.write_bytes(b"")   # its process was killed before it wrote anything
        self.assertEqual(self.render("+C", size=small), "")
        self.assertEqual(self.picture.read_bytes(), self.reference(size=small))

    def test_an_animation_goes_on_where_it_was(self):
        small = (40, 30)
        self.render("+KFF3", size=small)
        frames = {i: (self.folder / f"p{i}.png").read_bytes() for i in (1, 2, 3)}
        (self.folder / "p2.png").unlink()
        said = self.render("+KFF3", "+C", size=small)
        self.assertEqual(said, "p1.png: rendered already, and +C: skipped\np3.png: rendered already, and +C: skipped\n")
        self.assertEqual({i: (self.folder / f"p{i}.png").read_bytes() for i in (1, 2, 3)}, frames)

    def test_without_a_file_there_is_no_state(self):
        self.render("-F", "+C", size=(40, 30))
        self.assertEqual((self.picture.exists(), self.state.exists()), (False, False))


class Parts(unittest.TestCase):
    WIDTH, HEIGHT = 83, 71

    def pixels(self, folder, *words):
        said = run("povray", "edges.pov", f"+W{self.WIDTH}", f"+H{self.HEIGHT}", "+FP", "+Op.ppm", *words, cwd=folder)
        self.assertEqual(said.returncode, 0, said)
        data = (folder / "p.ppm").read_bytes()
        return data[-3 * self.WIDTH * self.HEIGHT:]

    def test_parts_join_without_a_seam(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "edges.pov").write_text(EDGES)
            for way in (["-A"], ["+A0.05", "-J"], ["+A0.05", "+R4"], ["+A0.05", "+AM2", "+R2"]):
                whole = self.pixels(folder, *way)
                columns = [("+EC23",), ("+SC24", "+EC65"), ("+SC66",)]
                rows = [("+ER32",), ("+SR33", "+ER33"), ("+SR34",)]
                joined = bytearray(len(whole))
                for part in ((*c, *r) for c in columns for r in rows):
                    for i, code in enumerate(self.pixels(folder, *way, *part)):
                        joined[i] += code   # black elsewhere
                self.assertEqual(bytes(joined), whole, way)
                self.assertGreater(len(set(whole)), 2 if way == ["-A"] else 20, "the test must see antialiased edges")


if __name__ == "__main__":
    unittest.main()
