# SPDX-License-Identifier: Apache-2.0
"""`alidade compare`: POV-Ray's picture beside ours."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from program import PROGRAM, InFolder, run

BALL = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 } light_source { <3, 5, -4>, 1 } #include "ground.inc"
sphere { <0, 0, 0>, 1 pigment { checker rgb <1, 0.2, 0.1>, rgb 0.8 scale 0.4 } }
"""
SOFT = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> look_at <0, 0.4, 0> angle 50 }
light_source { <3, 5, -3>, 1 area_light <2, 0, 0>, <0, 0, 2>, 4, 4 jitter }
plane { y, 0 pigment { rgb 0.8 } }
sphere { <0, 1, 0>, 1 pigment { rgb <1, 0.4, 0.2> } }
box { <-2, 0, -1>, <-1.3, 1.5, -0.5> pigment { rgb <0.3, 0.5, 1> } }
"""
GROUND = "plane { y, -1 pigment { rgb <0.2, 0.5, 0.3> } }\n"


class Compare(InFolder):
    def setUp(self):
        super().setUp()
        (self.folder / "ball.pov").write_text(BALL)
        (self.folder / "ground.inc").write_text(GROUND)

    def compare(self, *words, **keywords):
        return run("compare", "--cache", self.folder / "cache", *words, cwd=self.folder, **keywords)

    def document(self, *words):
        said = self.compare(*words, "--json")
        return json.loads(said.stdout), said.returncode

    def test_a_scene_and_its_kept_reference(self):
        first, code = self.document("ball.pov", "--size", "80x60")
        self.assertEqual((first["verdict"], code, first["grade"]["name"]), ("pass", 0, "exact"), first)
        self.assertEqual((first["width"], first["height"]), (80, 60))
        self.assertFalse(first["reference_render"]["from_cache"])
        again, _ = self.document("ball.pov", "--size", "80x60")
        self.assertTrue(again["reference_render"]["from_cache"])
        self.assertEqual(again["metrics"], first["metrics"])
        for words in (["--size", "81x60"], ["--size", "80x60", "--json", "--", "+A0.1"]):
            self.assertIn("from_cache\": false", self.compare("ball.pov", "--json", *words[:2], *words[3:]).stdout)
        (self.folder / "ground.inc").write_text(GROUND.replace("0.5", "0.9"))   # what the scene includes counts too
        changed, _ = self.document("ball.pov", "--size", "80x60")
        self.assertFalse(changed["reference_render"]["from_cache"])
        self.assertEqual(changed["grade"]["name"], "exact")

    def test_rules_and_the_report(self):
        said = self.compare("ball.pov", "--size", "80x60", "--require", "max_abs<0", "--report", "report.html", "--heatmap", "heat.png")
        self.assertEqual(said.returncode, 2, said.stdout)
        page = (self.folder / "report.html").read_text()
        self.assertIn("POV-Ray 3.7", page)
        for name in ("sphere (ball.pov:3)", "plane (ground.inc:1)"):
            self.assertIn(name, page, "the inspector names what a pixel shows")
        self.assertTrue((self.folder / "heat.png").exists())

    def test_what_cannot_be_compared(self):
        (self.folder / "broken.pov").write_text("sphere { 0, 1 } }\n")
        said = self.compare("broken.pov")
        self.assertEqual(said.returncode, 2)
        self.assertIn("POV-Ray made no picture", said.stderr)
        said = self.compare("absent.pov")
        self.assertEqual(said.returncode, 4)
        self.assertIn("there is no file 'absent.pov'", said.stderr)
        told, code = self.document("broken.pov")
        self.assertEqual((told["exit_code"], code), (2, 2))
        (self.folder / "endless.pov").write_text("#while (1) #end\n")
        said = self.compare("endless.pov", "--timeout", "1")
        self.assertEqual(said.returncode, 2)
        self.assertIn("no picture in 1 s", said.stderr)
        for words in ([], ["ball.pov", "--corpus", "list"], ["--corpus", "list"], ["ball.pov", "--size", "big"]):
            self.assertEqual(self.compare(*words).returncode, 4, words)

    def test_a_missing_povray_is_named(self):
        (self.folder / "bin").mkdir()
        said = self.compare("ball.pov", env={**os.environ, "PATH": str(self.folder / "bin")})
        self.assertEqual(said.returncode, 4)
        self.assertIn("package is povray", said.stderr)

    def test_the_scenes_folder_stays_as_it_is(self):
        before = sorted(path.name for path in self.folder.iterdir())
        self.assertEqual(self.compare("ball.pov", "--size", "16x12").returncode, 0)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir() if path.name != "cache"), before)

    def test_a_list_goes_on_where_it_was(self):
        (self.folder / "broken.pov").write_text("sphere { 0, 1 } }\n")
        (self.folder / "list.csv").write_text("path,width,height,category,tier\nball.pov,40,30,good,1\nbroken.pov,40,30,bad,1\nabsent.pov,40,30,bad,7\n")
        words = ["--corpus", "list.csv", "--out", "out", "--where", "tier<=3", "--jobs", "2"]
        said = self.compare(*words)
        self.assertEqual(said.returncode, 2, said.stderr)
        self.assertRegex(said.stdout, r"exact +pass +ball.pov")
        self.assertRegex(said.stdout, r"error +error +broken.pov: .*POV-Ray made no picture")
        self.assertNotIn("absent", said.stdout)
        self.assertRegex(said.stdout, r"all +1 +0 +0 +0 +1\n")
        lines = (self.folder / "out/results.jsonl").read_text().splitlines()
        self.assertEqual(sorted(json.loads(line)["name"] for line in lines), ["ball.pov", "broken.pov"])
        with open(self.folder / "out/results.jsonl", "w") as file:   # as a kill leaves it: one line, and half of one
            file.write(next(line for line in lines if "ball.pov" in json.loads(line)["name"]) + "\n" + lines[0][:40])
        again = self.compare(*words)
        self.assertEqual(again.stdout, said.stdout)
        self.assertGreater((self.folder / "out/report.html").stat().st_size, 10000)
        self.assertEqual(self.compare("--corpus", "list.csv", "--out", "out", "--where", "colour=red").returncode, 4)

    def test_files_that_words_name_count(self):
        library = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (library / "color.inc").write_text("#declare C = rgb <1, 0, 0>;\n")
        (self.folder / "tinted.pov").write_text(BALL.replace('#include "ground.inc"', '#include "color.inc"').replace("checker rgb <1, 0.2, 0.1>, rgb 0.8 scale 0.4", "C"))
        (library / "words.ini").write_text(f"Library_Path={library}\n")
        for words in (["--", f"Library_Path={library}"], ["--", str(library / "words.ini")]):
            for color in ("<1, 0, 0>", "<0, 0, 1>"):
                (library / "color.inc").write_text(f"#declare C = rgb {color};\n")
                said = self.compare("tinted.pov", "--size", "40x30", "--json", *words)
                self.assertEqual((json.loads(said.stdout)["grade"]["name"], said.returncode), ("exact", 0), words)

    def test_names_that_povray_does_not_take(self):
        shutil.copy(self.folder / "ball.pov", self.folder / "a 'ball' é.pov")
        self.assertEqual(self.compare("a 'ball' é.pov", "--size", "40x30").returncode, 0)

    def test_words_that_one_program_alone_would_take_are_refused(self):
        said = self.compare(self.scene, "--", "+A0.1")
        self.assertEqual(said.returncode, 4)
        self.assertIn("this is no scene of POV-Ray's", said.stderr)
        (self.folder / "list").write_text("ball.pov\n")
        self.assertEqual(self.compare("--corpus", "list", "--out", "out", "--junit", "junit.xml").returncode, 4)

    def test_rows_of_a_list_are_their_own(self):
        (self.folder / "a").mkdir()
        (self.folder / "a/ground.inc").write_text(GROUND)
        (self.folder / "a/b.pov").write_text(BALL)
        (self.folder / "a__b.pov").write_text(BALL.replace("<0, 0, 0>, 1", "<1, 0, 0>, 0.5"))
        (self.folder / "list.csv").write_bytes("\ufeffstatus,path,width,height\nok,a/b.pov,40,30\nok,a__b.pov,40,30\nok,a/b.pov,32,24\nfailed,c.pov,1,1\n".encode())
        words = ["--corpus", "list.csv", "--out", "out"]
        self.assertEqual(run("compare", *words, "--cache", "cache", cwd=self.folder).returncode, 0)
        rows = [json.loads(line) for line in (self.folder / "out/results.jsonl").read_text().splitlines()]
        self.assertEqual(len({row["test_picture"] for row in rows}), 3)
        self.assertIn("iVBORw0KGgo", (self.folder / "out/report.html").read_text(), "a relative cache is found from the report as well")
        self.assertEqual(self.compare(*words).returncode, 0)
        self.assertEqual(len((self.folder / "out/results.jsonl").read_text().splitlines()), 3, "all are kept")
        self.assertEqual(self.compare(*words, "--require", "max_abs<0").returncode, 2, "other rules are another question")
        (self.folder / "list.csv").write_text("path,width\na/b.pov,wide\n")
        said = self.compare(*words)
        self.assertEqual(said.returncode, 4)
        self.assertIn("a/b.pov: the width 'wide' is not a number from 1 to 65535", said.stderr)

    def test_a_scene_is_found_however_it_is_named(self):
        shutil.copy(self.folder / "ball.pov", self.folder / "BALL.POV")
        (self.folder / "links").mkdir()
        (self.folder / "links/round.pov").symlink_to("../ball.pov")
        (self.folder / "links/parts").symlink_to("..", target_is_directory=True)   # and a loop of links
        for name, words in (("BALL.POV", []), ("links/../ball.pov", []), ("links/round.pov", ["--", "+Lparts"])):
            said = self.compare(name, "--size", "40x30", *words)
            self.assertEqual(said.returncode, 0, name + said.stdout + said.stderr)
            self.assertIn("grade: exact", said.stdout)
            self.assertNotIn("lost", said.stdout)

    def test_an_interruption_leaves_nothing_behind(self):
        scratch = self.folder / "scratch"
        scratch.mkdir()
        (self.folder / "endless.pov").write_text("#while (1) #end\n")
        for end in (signal.SIGINT, signal.SIGTERM):
            running = subprocess.Popen([PROGRAM, "compare", "endless.pov", "--cache", self.folder / "cache"], cwd=self.folder, stderr=subprocess.PIPE, text=True,
                                       env={**os.environ, "TMPDIR": str(scratch)})
            while not list(scratch.glob("*/scene")):   # POV-Ray's copy of the folder
                self.assertIsNone(running.poll())
                time.sleep(0.02)
            time.sleep(0.3)
            children = [child for task in pathlib.Path(f"/proc/{running.pid}/task").iterdir() for child in (task / "children").read_text().split()]
            running.send_signal(end)
            self.assertEqual((running.wait(10), running.stderr.read()), (2, "alidade: interrupted\n"))
            running.stderr.close()
            self.assertEqual(list(scratch.iterdir()), [])
            self.assertTrue(children)
            for child in children:
                self.assertFalse(os.path.exists(f"/proc/{child}"))

    def elsewhere(self):
        """A folder that is no part of the scene's."""
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        return pathlib.Path(kept.name)

    def test_noise_is_not_called_error(self):
        (self.folder / "soft.pov").write_text(SOFT)
        words = ["soft.pov", "--size", "80x60"]
        told, code = self.document(*words, "--noise")
        self.assertEqual((told["verdict"], code), ("pass", 0), told["noise"])
        self.assertEqual((told["noise"]["seeds"], told["noise"]["reference_noise"], told["noise"]["tests"]), (16, "like ours", 3 * 80 * 60))
        self.assertGreater(told["metrics"]["over2"]["value"], 0.02)   # the pictures do differ
        kept = next((self.folder / "cache").glob("*.png"))
        for of, to in (("<3, 5, -3>, 1", "<3, 5, -3>, 1.05"), ("box { <-2,", "box { <-2.1,")):
            other = self.elsewhere()
            (other / "soft.pov").write_text(SOFT.replace(of, to))
            self.assertEqual(run("compare", *words, "--cache", other / "cache", cwd=other).returncode, 0)
            shutil.copy(next((other / "cache").glob("*.png")), kept)   # in the place of this scene's
            told, code = self.document(*words, "--noise", "--heatmap", other / "heat.ppm")
            self.assertTrue(told["reference_render"]["from_cache"])
            self.assertEqual((told["verdict"], code), ("fail", 2), told["noise"])
            self.assertGreater(told["noise"]["significant"], 10)
            pixels = (other / "heat.ppm").read_bytes()[-3 * 80 * 60:]
            self.assertEqual(sum(pixels[i:i + 3] == b"\x00\xff\x00" for i in range(0, len(pixels), 3)), told["noise"]["significant"])

    def test_words_of_the_noise(self):
        for words in (["--noise=3"], ["--noise", "8"], ["--spp", "4"], ["--against", "nobody"]):
            self.assertEqual(self.compare("ball.pov", *words).returncode, 4, words)

    def test_another_format_goes_through_the_exporter(self):
        (self.folder / "plate.obj").write_text("mtllib plate.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nusemtl red\nf 4 3 2 1\n")
        (self.folder / "plate.mtl").write_text("newmtl red\nKd 0.8 0.1 0.05\n")
        told, code = self.document("plate.obj", "--size", "64x48")
        self.assertEqual(code, 0, told["reason"])
        self.assertIn(told["grade"]["name"], ("exact", "match"))
        self.assertIsInstance(told["lost"], list)
        self.assertIn("scene.pov", told["reference_render"]["command"])


if __name__ == "__main__":
    if not shutil.which("povray"):
        print("skipped: povray is not installed")
        sys.exit(77)
    unittest.main()
