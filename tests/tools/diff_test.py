# SPDX-License-Identifier: Apache-2.0
"""`alidade diff`: the table of pairs with known answers, its files and its words."""
import json
import struct
import unittest
import xml.etree.ElementTree

from diff_pairs import CODES, files, pairs
from pictures import changed, png_bytes, pfm_bytes, scene, write
from program import InFolder, read_png, run


def tiff_bytes(pages, orientation):
    """Gray pictures of 4 x 4 pixels, one a page."""
    out = b"II*\0" + struct.pack("<I", 8)
    for page in range(pages):
        tags = [(256, 3, 1, 4), (257, 3, 1, 4), (258, 3, 1, 8), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, 0), (274, 3, 1, orientation), (277, 3, 1, 1), (278, 3, 1, 4), (279, 4, 1, 16)]
        size = 2 + 12 * len(tags) + 4
        pixels = len(out) + size
        out += struct.pack("<H", len(tags)) + b"".join(struct.pack("<HHII", tag, kind, count, pixels if tag == 273 else value) for tag, kind, count, value in tags)
        out += struct.pack("<I", pixels + 16 if page + 1 < pages else 0) + bytes([100 + page] * 16)
    return out


class Diff(InFolder):
    def diff(self, *words):
        return run("diff", *words, cwd=self.folder)

    def document(self, *words):
        return json.loads(self.diff(*words, "--json").stdout)

    def picture(self, name, picture):
        return write(self.folder / name, png_bytes(picture))

    def test_pairs_with_known_answers(self):
        for name, reference, test, words, verdict, cause in pairs():
            with self.subTest(name):
                said = self.diff(*files(self.folder, name, reference, test), *words, "--json")
                told = json.loads(said.stdout)
                self.assertEqual((told["verdict"], told["cause"], said.returncode), (verdict, cause, CODES[verdict]), told["reason"] + "; " + told["cause_text"])
                self.assertEqual(told["exit_code"], said.returncode)
                self.assertTrue(told["reason"])

    def test_numbers_of_one_pixel(self):
        a = scene()
        b = changed(a, lambda x, y, pixel: (pixel[0], pixel[1] + 30 / 255, pixel[2]) if (x, y) == (5, 60) else pixel)
        told = self.document(self.picture("a.png", a), self.picture("b.png", b))
        metrics, pixels, step = told["metrics"], 96 * 64, 30 / 255
        self.assertEqual((metrics["max_abs"]["x"], metrics["max_abs"]["y"], metrics["max_abs"]["channel"]), (5, 60, 1))
        self.assertAlmostEqual(metrics["max_abs"]["value"], step, 6)
        self.assertAlmostEqual(metrics["mae"]["value"], step / pixels / 3, 8)
        self.assertAlmostEqual(metrics["rmse"]["value"], step / (3 * pixels) ** 0.5, 8)
        self.assertAlmostEqual(metrics["bias"]["G"], step / pixels, 8)
        self.assertEqual(metrics["over8"], {"value": 1 / pixels, "pixels": 1})
        self.assertEqual({key: metrics["region"][key] for key in ("pixels", "x0", "y0", "x1", "y1")}, {"pixels": 1, "x0": 5, "y0": 60, "x1": 6, "y1": 61})
        tiles = told["tiles"]
        self.assertEqual((tiles["size"], tiles["columns"], tiles["rows"]), (8, 12, 8))
        self.assertEqual([i for i, most in enumerate(tiles["max"]) if most > 0], [7 * 12])

    def test_mask_and_crop_leave_out_what_differs(self):
        a = scene()
        b = changed(a, lambda x, y, pixel: (0, 0, 0) if x < 10 else pixel)
        mask = changed(a, lambda x, y, pixel: (0.0 if x < 10 else 1.0,))
        paths = [self.picture("a.png", a), self.picture("b.png", b)]
        self.picture("mask.png", mask)
        self.assertEqual(self.diff(*paths).returncode, 2)
        self.assertEqual(self.diff(*paths, "--mask", "mask.png").returncode, 0)
        self.assertEqual(self.diff(*paths, "--crop", "10,0,96,64").returncode, 0)
        self.assertEqual(self.diff(*paths, "--crop", "9,0,96,64").returncode, 2)
        self.assertEqual(self.diff(*paths, "--crop", "9,0,97,64").returncode, 4)
        self.picture("black.png", changed(mask, lambda x, y, pixel: (0.0,)))
        self.assertEqual(self.diff(*paths, "--mask", "black.png").returncode, 3)

    def test_idiffs_words_with_one_dash_or_two(self):
        a = scene()
        b = changed(a, lambda x, y, pixel: tuple(v + (0.2 if x == 3 and y < 10 else 0.0) * (v < 0.7) for v in pixel))
        paths = [self.picture("a.png", a), self.picture("b.png", b)]
        for words, code in ((["fail", "0.3"], 0), (["fail", "0.1"], 2), (["allowfailures", "10"], 0), (["allowfailures", "9"], 2), (["failpercent", "0.17"], 0),
                            (["failpercent", "0.1"], 2), (["failrelative", "5"], 0), (["fail", "0.3", "hardfail", "0.1"], 2), (["warn", "0.1"], 1),
                            (["warn", "0.1", "warnpercent", "1"], 0), (["fail", "0.3", "hardwarn", "0.1"], 1), (["warn", "0.1", "allowwarnings", "10"], 0)):
            for dashes in ("-", "--"):
                said = self.diff(*paths, *(dashes + w if w.isalpha() else w for w in words))
                self.assertEqual(said.returncode, code, (words, dashes, said.stdout, said.stderr))

    def test_requirements(self):
        a = scene()
        paths = [self.picture("a.png", a), self.picture("b.png", changed(a, lambda x, y, pixel: (1, 1, 1) if y == 0 and x < 6 else pixel))]
        for rule, code in (("over8<0.1%", 0), ("over8<0.05%", 2), ("over8.value<=0.001", 0), ("max_abs<8/255", 2), ("p99<1/255", 0), ("percentiles.p99.9<1/255", 0),
                           ("psnr>20", 0), ("psnr>=60", 2), ("flip.mean<0.02", 0), ("flip<0.02", 0), ("region.pixels<6", 2), ("region.pixels<=6", 0)):
            said = self.diff(*paths, "--require", rule)
            self.assertEqual(said.returncode, code, (rule, said.stdout, said.stderr))
        for rule, hint in (("flop.mean<1", "flip.mean"), ("flip.mean", "METRIC<LIMIT"), ("flip<much", "no limit"), ("hdr_flip<1", None)):
            said = self.diff(*paths, "--require", rule)
            self.assertEqual(said.returncode, 4 if hint else 2, (rule, said.stdout))   # what is not measured for these files keeps no rule
            self.assertIn(hint or "not measured", said.stderr + said.stdout)

    def test_limits_are_meant_exactly(self):
        a = [[(100 / 255,) * 3] * 10 for _ in range(10)]
        b = changed(a, lambda x, y, pixel: (101 / 255,) * 3 if 10 * y + x < 7 else pixel)
        paths = [self.picture("a.png", a), self.picture("b.png", b)]
        for words, code in ((("--failpercent", "7"), 0), (("--failpercent", "6.99"), 2), (("--fail", "0.00392156862745"), 0), (("--hardfail", "0.00392156862745", "--fail", "1"), 0),
                            (("--require", "max_abs<=1/255"), 0), (("--require", "max_abs<1/255"), 2), (("--require", "max_abs>=1/255"), 0)):
            self.assertEqual(self.diff(*paths, *words).returncode, code, words)

    def test_no_word_switches_a_rule_off(self):
        a = scene()
        paths = [self.picture("a.png", a), self.picture("b.png", changed(a, lambda x, y, pixel: (1, 0, 0) if x == 3 else pixel))]
        for word in ("--fail", "--hardfail", "--failrelative", "--failpercent", "--warn"):
            said = self.diff(*paths, word, "nan")
            self.assertEqual(said.returncode, 4, word)
            self.assertIn("'nan' is not a number from 0 on", said.stderr)
        self.assertEqual(self.diff(*paths, "--preset", "exact", "--failpercent", "5").returncode, 2)
        self.assertEqual(self.diff(*paths, "--failpercent", "5").returncode, 0)

    def test_noise_that_cannot_be_tested_is_none(self):
        paths = [self.picture("k.png", [[(0,) * 3] * 2] * 3), self.picture("w.png", [[(1,) * 3] * 2] * 3)]
        self.assertEqual(self.diff(*paths, "--preset", "noise").returncode, 2)
        self.assertEqual(self.diff(paths[0], paths[0], "--preset", "noise").returncode, 0)

    def test_nothing_that_is_read_is_overwritten(self):
        a = self.picture("a.png", scene())
        before = (self.folder / "a.png").read_bytes()
        for words in (("--heatmap", a), ("--report", a), ("--junit", "o.html", "--report", "o.html")):
            said = self.diff(a, a, *words)
            self.assertEqual(said.returncode, 4, words)
            self.assertIn("would be overwritten", said.stderr)
        self.assertEqual((self.folder / "a.png").read_bytes(), before)
        self.assertEqual(self.diff(a, a, "--junit", "junit").returncode, 0, "only pictures need an ending")

    def test_shift_is_told(self):
        a = scene()
        told = self.document(self.picture("a.png", a), self.picture("b.png", [row[2:] + [row[-1]] * 2 for row in a]), "--align")
        self.assertAlmostEqual(told["shift"]["x"], -2, 2)
        self.assertAlmostEqual(told["shift"]["y"], 0, 2)

    def test_far_shifts_are_found_or_not_told(self):
        a = scene(256, 192)
        reference = self.picture("a.png", a)
        for far in (12, 27, *range(34, 91, 4), 60):
            words = reference, self.picture("b.png", [row[far:] + [row[-1]] * far for row in a]), "--align"
            with self.subTest(far):
                shift = self.document(*words)["shift"]
                if far < 33:
                    self.assertAlmostEqual(shift["x"], -far, 1)
                    self.assertAlmostEqual(shift["y"], 0, 1)
                    self.assertGreaterEqual(shift["explained"], 0.75)
                else:
                    self.assertIsNone(shift)
        self.assertIn("shift: none that explains 75 %", self.diff(*words).stdout)

    def test_the_heat_map_shows_nan_and_alpha(self):
        a = [[(0.5, 0.5, 0.5) for x in range(32)] for _ in range(24)]
        write(self.folder / "a.pfm", pfm_bytes(a))
        write(self.folder / "b.pfm", pfm_bytes(changed(a, lambda x, y, pixel: (float("nan"), 0.5, 0.5) if (x, y) == (5, 7) else pixel)))
        clear = changed(scene(), lambda x, y, pixel: (0, 0, 0, 0.75))
        paths = [self.picture("c.png", clear), self.picture("d.png", changed(clear, lambda x, y, pixel: (0, 0, 0, 0.1) if (x, y) == (5, 7) else pixel))]
        for pair in (["a.pfm", "b.pfm"], paths):
            self.assertEqual(self.diff(*pair, "--heatmap", "heat.ppm").returncode, 2)
            width, data = self.ppm("heat.ppm")
            self.assertEqual([i // 3 for i in range(0, len(data), 3) if data[i] > 100], [7 * width + 5])

    def test_further_pages_and_orientation_are_told(self):
        for name, pages, orientation in (("one.tif", 1, 1), ("two.tif", 2, 1), ("turned.tif", 1, 6)):
            write(self.folder / name, tiff_bytes(pages, orientation))
        self.assertEqual(self.document("one.tif", "one.tif")["notes"], [])
        self.assertIn("not compared of two.tif: further pages", self.document("one.tif", "two.tif")["notes"])
        self.assertIn("orientation (6", " ".join(self.document("one.tif", "turned.tif")["notes"]))

    def ppm(self, name):
        """The width, and the bytes of the pixels."""
        _, size, _, data = (self.folder / name).read_bytes().split(b"\n", 3)
        width, height = map(int, size.split())
        self.assertEqual(len(data), 3 * width * height)
        return width, data

    def test_files(self):
        a = scene()
        paths = [self.picture("a.png", a), self.picture("b.png", changed(a, lambda x, y, pixel: (1, 1, 1) if x > 80 else pixel))]
        self.assertEqual(self.diff(*paths, "--heatmap", "heat.png", "--junit", "out.xml", "--preset", "ci").returncode, 2)
        self.assertEqual(read_png(self.folder / "heat.png")[:2], (96, 64))
        suite = xml.etree.ElementTree.parse(self.folder / "out.xml").getroot()[0]
        self.assertEqual((suite.get("tests"), suite.get("failures"), len(suite.findall("testcase/failure"))), ("1", "1", 1))

    def test_floats_beyond_one_are_seen(self):
        a = [[(float(x + 1), 0.5, 0.25) for x in range(16)] for _ in range(16)]
        b = [[(x * 1.5, y, z) if x > 15 else (x, y, z) for x, y, z in row] for row in a]
        write(self.folder / "a.pfm", pfm_bytes(a)), write(self.folder / "b.pfm", pfm_bytes(b))
        told = self.document("a.pfm", "b.pfm")
        self.assertEqual((told["values"], told["metrics"]["max_abs"]["value"]), ("linear", 8.0))
        self.assertIn("hdr_flip", told["metrics"])

    def test_layers(self):
        self.assertEqual(run("render", self.scene, "-o", self.folder / "a.exr", "--size", "32x32", "--aov", "depth,normal").returncode, 0)
        self.assertEqual(self.diff("a.exr", "a.exr", "--layer", "depth").returncode, 0)   # the background's depth is infinite in both
        self.assertEqual(self.diff("a.exr", "a.exr", "--layer", "normal").returncode, 0)
        said = self.diff("a.exr", "a.exr", "--layer", "uv")
        self.assertEqual(said.returncode, 4)
        self.assertIn("normal.X", said.stderr)

    def test_bad_words_exit_4(self):
        path = self.picture("a.png", scene())
        for words in ([path], [path, path, "--fial", "1"], [path, path, "--fail", "much"], [path, path, "--preset", "strict"], [path, path, "--crop", "1,2,3"],
                      [path, "absent.png"], [path, path, "--heatmap", "absent/heat.png"]):
            said = self.diff(*words)
            self.assertEqual(said.returncode, 4, (words, said.stdout, said.stderr))
            self.assertTrue(said.stderr)


if __name__ == "__main__":
    unittest.main()
