# SPDX-License-Identifier: Apache-2.0
"""Words in, words and exit codes out."""
import json
import pathlib
import resource
import subprocess
import tempfile
import unittest

from pictures import png_bytes, scene, write
from program import PROGRAM, SANITIZED, InFolder, run, triangle_gltf

# Every option of the design's table that a verb has today.
RENDER_OPTIONS = ("--output --size --region --camera --exposure --accel --integrator --spp --seed --max-depth --precision --intersect --isa --aov --time --environment --limit "
                  "--light-units --strict --subdivide --decimate --crease --sampler --light-samples --aperture --focus --lazy --full-kernel --threads --tile --stats --progress --json").split()


class Help(unittest.TestCase):
    def test_the_program_lists_its_verbs(self):
        said = run("--help")
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        for verb in ("render SCENE", "info SCENE"):
            self.assertIn(verb, said.stdout)

    def test_without_words_it_is_a_usage_error(self):
        said = run()
        self.assertEqual((said.returncode, said.stdout), (64, ""))
        self.assertIn("alidade render", said.stderr)

    def test_each_verb_lists_its_options_and_exit_codes(self):
        for verb in json.loads(run("info", "--features", "--json").stdout)["verbs"]:
            said = run(verb["name"], "--help")
            self.assertEqual((said.returncode, said.stderr), (0, ""))
            self.assertIn(verb["exits"], said.stdout)
        for option in RENDER_OPTIONS:
            self.assertIn(option, run("render", "--help").stdout)


class Slips(InFolder):
    def assert_usage_error(self, *words, says):
        said = run(*words, cwd=self.folder)
        self.assertEqual((said.returncode, said.stdout, said.stderr.count("\n")), (64, "", 1), said)
        self.assertIn(says, said.stderr)
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_verbs(self):
        self.assert_usage_error("redner", "a.glb", says="did you mean 'render'?")
        self.assert_usage_error("zzz", says="`alidade --help` lists the verbs")

    def test_options(self):
        self.assert_usage_error("render", self.scene, "--siez", "3x3", says="unknown option '--siez'; did you mean '--size'?")
        self.assert_usage_error("render", self.scene, "--integratro=cast", says="did you mean '--integrator'?")
        self.assert_usage_error("info", self.scene, "--xyzzy", says="unknown option '--xyzzy'\n")
        self.assert_usage_error("render", self.scene, "another.glb", says="unexpected word 'another.glb'")

    def test_missing_words(self):
        self.assert_usage_error("render", says="SCENE")
        self.assert_usage_error("info", says="SCENE is missing")
        self.assert_usage_error("render", self.scene, "--size", says="--size")

    def test_values(self):
        for option, value, says in (
            ("--size", "12by3", "'12by3' is not WIDTHxHEIGHT, such as 640x480"),
            ("--region", "5,5,5,9", "x0 < x1"),
            ("--accel", "bhv", "did you mean 'bvh'?"),
            ("--accel", "kdtree", "not one of auto, brute"),
            ("--integrator", "pth", "not one of"),
            ("--precision", "half", "not one of float, double"),
            ("--intersect", "quick", "not one of exact, robust, fast"),
            ("--isa", "mmx", "not one of best, scalar"),
            ("--aov", "depth,norml", "did you mean 'normal'?"),
            ("--spp", "0", "whole number from 1"),
            ("--spp", "two", "'two' is not a whole number"),
            ("--seed", "-1", "whole number from 0"),
            ("--max-depth", "1001", "from 0 to 1000"),
            ("--threads", "-2", "from 0"),
            ("--tile", "0", "from 1"),
            ("--exposure", "nan", "'nan' is not a number"),
            ("--time", "soon", "'soon' is not a number"),
            ("--environment", "#blue", "'#blue' is not a colour such as #fff"),
            ("--aperture", "-1", "less than 0"),
            ("--sampler", "sobbol", "did you mean 'sobol'?"),
            ("--light-samples", "0", "from 1"),
            ("--subdivide", "9", "from 0 to 8"),
            ("--decimate", "0", "'0' is less than 1e-06"),
            ("--decimate", "1.5", "'1.5' is more than 1"),
            ("--crease", "200", "'200' is more than 180"),
            ("--light-units", "lumen", "not one of auto, photometric, raw"),
            ("--progress", "fast", "not one of bar, json, none"),
            ("--camera", "sidewards", "sidewards"),
            ("--region", "0,0,5000,5000", "region"),
        ):
            with self.subTest(option=option, value=value):
                self.assert_usage_error("render", self.scene, option, value, says=says)


class BadInput(InFolder):
    def assert_error(self, *words, says):
        said = run(*words, cwd=self.folder)
        self.assertEqual((said.returncode, said.stdout), (1, ""), said)
        self.assertIn(says, said.stderr)

    def test_a_file_that_is_not_there(self):
        for verb in ("render", "info"):
            self.assert_error(verb, "none.glb", says="none.glb: error: ")

    def test_a_file_that_is_no_scene(self):
        (self.folder / "noise.xyz").write_bytes(bytes(range(256)))
        self.assert_error("render", "noise.xyz", says="noise.xyz: error: ")

    def test_a_broken_scene_is_an_error_with_its_place(self):
        (self.folder / "broken.gltf").write_text(triangle_gltf(meshes=[{"primitives": [{"attributes": {"POSITION": 7}}]}]))
        self.assert_error("info", "broken.gltf", says="broken.gltf:/meshes/0/primitives/0/attributes/POSITION: error: ")

    def test_a_sky_that_is_not_there(self):
        self.assert_error("render", self.scene, "--environment", "none.hdr", says="none.hdr")

    def test_an_output_that_cannot_be_written_is_told_before_rendering(self):
        self.assert_error("render", self.scene, "-o", "none/out.png", says="there is no folder 'none'")
        self.assert_error("render", self.scene, "-o", ".", says="is a folder")
        self.assert_error("render", self.scene, "-o", "out.xyz", says="no picture format that can be written has the ending .xyz")
        self.assert_error("render", self.scene, "--stats", "none/x.json", says="--stats: 'none/x.json': there is no folder 'none'")

    @unittest.skipIf(SANITIZED, "sanitizers take more address space than any limit leaves")
    def test_a_picture_that_memory_does_not_hold(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
        for words in (["render", self.scene, "--size", "30000x30000"], ["povray", "+Is.pov", "+W30000", "+H30000"]):
            (self.folder / "s.pov").write_text("sphere { 0, 1 }")
            said = subprocess.run([PROGRAM, *words], cwd=self.folder, capture_output=True, text=True, preexec_fn=limit)
            self.assertEqual(said.returncode, 1, said)
            self.assertIn("out of memory: a picture of 30000x30000 pixels with 3 channels takes 10.8 GB; ask for a smaller one", said.stderr)

    def test_a_full_disk_is_no_success(self):
        with open("/dev/full", "w") as full:
            said = subprocess.run([PROGRAM, "info", "--features"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual((said.returncode, said.stderr), (1, "alidade: error: stdout cannot be written to\n"))

    def test_a_full_disk_is_no_verdict(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = str(write(pathlib.Path(folder) / "a.png", png_bytes(scene())))
            for words in (["diff", picture, picture], ["diff", picture, picture, "--json"]):
                with open("/dev/full", "w") as full:
                    said = subprocess.run([PROGRAM, *words], stdout=full, stderr=subprocess.PIPE, text=True)
                self.assertEqual((said.returncode, said.stderr), (4, "alidade: error: stdout cannot be written to\n"))


class Info(InFolder):
    def test_features_are_the_tables(self):
        said = run("info", "--features", "--json")
        tables = json.loads(said.stdout)
        for table, rows in {"importers": "gltf obj", "shapes": "sphere plane box", "accelerators": "brute bvh hlbvh compact grid octree", "instruction sets": "scalar",
                            "integrators": "cast whitted", "output layers": "depth normal coverage", "verbs": "render info"}.items():
            self.assertLessEqual(set(rows.split()), {row["name"] for row in tables[table]}, table)
        self.assertIn("accelerators:\n", run("info", "--features").stdout)

    def test_a_scene_is_described(self):
        said = json.loads(run("info", self.scene, "--json").stdout)
        self.assertEqual(said["holds"]["nodes"], 3)
        self.assertEqual(said["compiled"]["triangles"], 1)
        for end, corner in {"min": [-1, -1, 0], "max": [1, 1, 0]}.items():
            for ours, exact in zip(said["bounds"][end], corner):
                self.assertAlmostEqual(ours, exact, places=9)
        self.assertEqual([camera["name"] for camera in said["cameras"]], ["front"])
        self.assertEqual([(light["name"], light["kind"], light["unit"]) for light in said["lights"]], [("sun", "directional", "W/m^2")])
        self.assertIn("directional lights", [each["what"] for each in said["requires"]])
        self.assertEqual(said["messages"], [])
        self.assertIn("triangle", run("info", self.scene).stdout)

    def test_every_kind_of_light_is_named(self):
        scene = self.folder / "lights.pov"
        scene.write_text("""#version 3.7; light_source { 1, 1 } light_source { 1, 1 spotlight point_at 0 } light_source { 1, 1 cylinder point_at 0 } light_source { 1, 1 parallel point_at 0 } sphere { 0, 1 }""")
        said = json.loads(run("info", scene, "--json").stdout)
        self.assertEqual([light["kind"] for light in said["lights"]], ["point", "POV-Ray spotlight", "POV-Ray cylinder", "POV-Ray parallel"])

    def test_surfaces_and_their_defects(self):
        said = json.loads(run("info", self.scene, "--json").stdout)
        self.assertEqual(said["surfaces"], [{"shape": 0, "name": said["surfaces"][0]["name"], "triangles": 1, "vertices": 3, "edges": 3, "components": 1,
                                             "closed": False, "euler": 1, "genus": None}])
        defects = said["defects"][0]
        self.assertEqual((defects["holes"], defects["hole edges"], defects["non-manifold edges"], defects["refused"]), (1, 3, 0, 0))
        self.assertAlmostEqual(defects["hole length"], 2 + 2 * 5 ** 0.5)
        (self.folder / "closed.off").write_text("OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
        closed = json.loads(run("info", self.folder / "closed.off", "--json").stdout)
        self.assertEqual((closed["surfaces"][0]["closed"], closed["surfaces"][0]["genus"], closed["defects"]), (True, 0, []))
        self.assertIn("surfaces:", run("info", self.scene).stdout)

    def test_meshes_are_reshaped_after_reading(self):
        finer = json.loads(run("info", self.scene, "--subdivide", 2, "--json").stdout)
        self.assertEqual(finer["compiled"]["triangles"], 16)
        coarser = json.loads(run("info", self.scene, "--subdivide", 3, "--decimate", 0.25, "--json").stdout)
        self.assertLess(coarser["compiled"]["triangles"], 64)
        self.assertEqual(run("render", self.scene, "--size", "8x8", "--spp", 1, "--crease", 30, "--subdivide", 1, cwd=self.folder).returncode, 0)
        (self.folder / "fan.off").write_text("OFF\n402 400 0\n0 0 0\n" + "".join(f"{i} {i * i % 7} 1\n" for i in range(401)) +
                                             "".join(f"3 0 {i} {i + 1}\n" for i in range(1, 401)))
        too_many = run("info", self.folder / "fan.off", "--subdivide", 8)
        self.assertEqual((too_many.returncode, too_many.stdout), (1, ""))
        self.assertIn("--subdivide 8 would make 26214400 triangles", too_many.stderr)

    def test_what_was_not_understood_is_told(self):
        self.scene.write_text(triangle_gltf(extensionsUsed=["KHR_lights_punctual", "VENDOR_unheard_of"],
                                            materials=[{"extensions": {"VENDOR_unheard_of": {}}}]))
        messages = json.loads(run("info", self.scene, "--json").stdout)["messages"]
        self.assertTrue(any("VENDOR_unheard_of" in each["message"] for each in messages), messages)
        self.assertEqual(run("info", self.scene, "--strict").returncode, 1)

    def test_features_take_no_scene(self):
        self.assertEqual(run("info", "--features", self.scene).returncode, 64)


if __name__ == "__main__":
    unittest.main()
