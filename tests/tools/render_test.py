# SPDX-License-Identifier: Apache-2.0
"""`alidade render`: the files it leaves, what it says, and that the picture does not depend on how it was made."""
import json
import struct
import unittest

from program import InFolder, read_png, run


class Render(InFolder):
    def render(self, *words):
        said = run("render", self.scene, "--size", "40x30", "--spp", "4", *words, cwd=self.folder)
        self.assertEqual(said.returncode, 0, said.stderr)
        return said

    def test_a_picture_named_after_the_scene(self):
        said = self.render()
        self.assertEqual(read_png(self.folder / "triangle.png")[:2], (40, 30))
        self.assertEqual(said.stdout, "")
        self.assertRegex(said.stderr, r"^triangle\.png: 40x30, read in .* s\n$")

    def test_the_triangle_is_in_the_middle(self):
        self.render("-o", "out.ppm")
        header, pixels = (self.folder / "out.ppm").read_bytes().split(b"\n255\n", 1)
        self.assertEqual(header.split(), [b"P6", b"40", b"30"])
        middle, corner = pixels[3 * (15 * 40 + 20)], pixels[0]
        self.assertGreater(middle, 100)
        self.assertNotEqual(middle, corner)

    def test_the_same_bytes_however_it_was_made(self):
        self.render("-o", "first.png")
        first = (self.folder / "first.png").read_bytes()
        for words in (["--threads", 1], ["--threads", 2], ["--tile", 8], ["--tile", 64], ["--accel", "brute"], ["--accel", "grid"], ["--accel", "compact"], ["--accel", "octree"],
                      ["--isa", "scalar"], ["--full-kernel"], ["--lazy"], ["--progress", "json"]):
            self.render("-o", "other.png", *words)
            self.assertEqual((self.folder / "other.png").read_bytes(), first, words)
        self.render("-o", "other.png", "--seed", 1)
        self.assertNotEqual((self.folder / "other.png").read_bytes(), first, "another seed moves the samples")

    def test_adaptive_spends_less_where_nothing_is(self):
        def render(*words):
            said = run("render", self.scene, "--size", "40x30", "--spp", "64", *words, cwd=self.folder)
            self.assertEqual(said.returncode, 0, said.stderr)

        render("-o", "plain.png")
        render("-o", "zero.png", "--adaptive", "0")
        self.assertEqual((self.folder / "zero.png").read_bytes(), (self.folder / "plain.png").read_bytes())
        render("-o", "less.png", "--adaptive", "0.01", "--stats", "less.json")
        cost = json.loads((self.folder / "less.json").read_text())["render"]
        self.assertLess(cost["samples_per_pixel"], 32)
        self.assertGreater(cost["pixels_ended_early"], 40 * 30 // 2)
        self.assertEqual(run("render", self.scene, "--adaptive", "-1", cwd=self.folder).returncode, 64)

    def test_layers_stand_beside(self):
        self.render("-o", "out.png", "--aov", "depth,coverage,depth")
        self.assertEqual({path.name for path in self.folder.glob("out*")}, {"out.png", "out.depth.exr", "out.coverage.exr"})

    def test_layers_stand_inside_an_exr(self):
        self.render("-o", "out.exr", "--aov", "depth,normal")
        self.assertEqual([path.name for path in self.folder.glob("out*")], ["out.exr"])
        head = (self.folder / "out.exr").read_bytes()[:1000]
        for channel in (b"depth.Z", b"normal.X", b"normal.Z"):
            self.assertIn(channel, head)

    def test_a_region_leaves_the_rest_black(self):
        self.render("-o", "part.ppm", "--region", "16,12,24,18", "--environment", "#fff")
        pixels = (self.folder / "part.ppm").read_bytes().split(b"\n255\n", 1)[1]
        lit = {(i % 40, i // 40) for i in range(40 * 30) if pixels[3 * i] > 0}
        self.assertEqual(lit, {(x, y) for x in range(16, 24) for y in range(12, 18)})

    def test_a_sky_with_pixels_that_are_no_numbers(self):
        values = struct.pack("<24f", *[1.0] * 12, *[float("nan")] * 3, *[float("inf")] * 3, *[1.0] * 6)
        (self.folder / "sky.pfm").write_bytes(b"PF\n4 2\n-1\n" + values)
        said = self.render("-o", "lit.ppm", "--environment", "sky.pfm")
        self.assertIn("environment 'sky.pfm' has 2 pixels that are not finite numbers: they are taken for black", said.stderr)
        self.assertGreater((self.folder / "lit.ppm").read_bytes().split(b"\n255\n", 1)[1][3 * (15 * 40 + 20)], 100)

    def test_exposure_brightens(self):
        middle = []
        for stops in ("-2", "0"):
            self.render("-o", "out.ppm", "--exposure", stops)
            middle.append((self.folder / "out.ppm").read_bytes().split(b"\n255\n", 1)[1][3 * (15 * 40 + 20)])
        self.assertLess(*middle)

    def test_the_cost_is_told(self):
        said = self.render("--stats", "cost.json", "--json")
        cost = json.loads(said.stdout)
        self.assertEqual(json.loads((self.folder / "cost.json").read_text()), cost)
        self.assertEqual(cost["render"]["camera_rays"], 40 * 30 * 4)
        self.assertEqual(cost["render"]["samples_per_pixel"], 4)
        self.assertEqual(cost["render"]["tiles"], cost["render"]["tiles_done"])
        self.assertTrue(cost["complete"])
        self.assertEqual(cost["files"], ["triangle.png"])

    def test_progress_as_json_counts_to_one(self):
        lines = [json.loads(line) for line in self.render("--progress", "json", "--tile", "2").stderr.splitlines() if line.startswith("{")]
        self.assertEqual(len(lines), 10)
        self.assertEqual(lines[-1]["progress"], 1)
        self.assertEqual([round(10 * line["progress"]) for line in lines], list(range(1, 11)))

    def test_no_bar_without_a_terminal(self):
        for mode in ("bar", "none"):
            self.assertNotIn("\r", self.render("--progress", mode).stderr)

    def test_no_temporary_file_is_left(self):
        self.render("-o", "out.exr", "--aov", "depth")
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"triangle.gltf", "out.exr"})


if __name__ == "__main__":
    unittest.main()
