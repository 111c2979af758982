# SPDX-License-Identifier: Apache-2.0
"""What accuracy costs: `alidade tradeoff`."""
import csv
import json
import math
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

from pictures import pfm_bytes, png_bytes
from program import PROGRAM, SANITIZED, InFolder, run

POVRAY = shutil.which("povray")


def document(*words, **keywords):
    said = run("tradeoff", *words, "--json", **keywords)
    assert said.returncode == 0, said
    return json.loads(said.stdout)


def slope(points):
    """Of the line of least squares through the logarithms."""
    xs, ys = zip(*((math.log(x), math.log(y)) for x, y in points))
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs)


def by(rows, *names):
    return {tuple(row["setting"][name] for name in names): row for row in rows if set(names) <= set(row["setting"])}


class Words(InFolder):
    def expect_usage(self, says, *words):
        said = run("tradeoff", *words, cwd=self.folder)
        self.assertEqual((said.returncode, said.stdout), (64, ""), said)
        self.assertIn(says, said.stderr)
        self.assertEqual(said.stderr.count("\n"), 1)

    def test_what_is_varied(self):
        for says, *words in (
            ("there is nothing to compare: --vary", ),
            ("unknown option '--ssp'; did you mean '--spp'?", "--vary", "ssp=1,4"),
            ("'two' is not a whole number", "--vary", "spp=1,two"),
            ("did you mean 'grid'?", "--vary", "accel=bvh,gird"),
            ("has an empty value", "--vary", "spp=1,,4"),
            ("has an empty value", "--vary", "spp="),
            ("has the value '4' twice", "--vary", "spp=4,1,4"),
            ("is not NAME=V1,V2", "--vary", "spp"),
            ("'spp' is varied twice", "--vary", "spp=1,4", "--vary", "spp=16"),
            ("pictures of another size cannot be compared", "--vary", "size=8x8,16x16"),
            ("1e+09 settings are more than 4096", *[word for i in range(9) for word in ("--vary", f"{('tile', 'spp', 'seed', 'max-depth', 'light-samples', 'exposure2', 'focus', 'aperture', 'threads')[i] if i != 5 else 'decimate'}="
                                                                                     + ",".join(f"0.{n}" if i == 5 else str(n) for n in range(1, 11)))]),
            ("--mode: 'halton' is not", "--vary", "spp=1,4", "--mode", "halton"),
            ("--metric: 'ssim' is not one of rmse", "--vary", "spp=1,4", "--metric", "ssim"),
            ("a variance needs 8 or more", "--vary", "spp=1,4", "--seeds", "3"),
            ("--seeds varies it already", "--vary", "seed=1,4", "--seeds", "8"),
            ("is not ERROR<LIMIT @ COST<LIMIT", "--vary", "spp=1,4", "--require", "rmse<0.1"),
            ("instructions are counted with --instructions", "--vary", "spp=1,4", "--require", "rmse<0.1 @ instructions<1e9"),
            ("this is no scene of POV-Ray", "--vary", "spp=1,4", "--reference", "povray"),
            ("only scenes analytic:NAME have one", "--vary", "spp=1,4", "--reference", "exact"),
            ("is not a whole number from 2", "--vary", "spp=1,4", "--reference", "self:many"),
            ("--reference-with: unknown option '--zzz'", "--vary", "spp=1,4", "--reference-with", "zzz=1"),
            ("'{aa}' is not varied", "--external", "povray +A{aa} +O{out}"),
            ("does not say where {out}", "--external", "povray"),
            ("unknown option '--varry'; did you mean '--vary'?", "--varry", "spp=1"),
        ):
            with self.subTest(words=words):
                self.expect_usage(says, self.scene, *words)

    def test_limits(self):
        for words in (("--error", "-1"), ("--error", "nan"), ("--budget", "soon"), ("--repeat", "0")):
            self.expect_usage(words[0], self.scene, "--vary", "spp=1,4", *words)

    def expect_error(self, says, *words):
        said = run("tradeoff", *words, "--size", "8x6", "--repeat", 1, cwd=self.folder)
        self.assertEqual((said.returncode, said.stdout), (1, ""), said)
        self.assertIn(says, said.stderr)

    def test_what_cannot_be_measured(self):
        vary = ("--vary", "spp=1,2")
        self.expect_error("none.glb: error: ", "none.glb", *vary)
        self.expect_error("did you mean 'analytic:furnace'?", "analytic:furnance", *vary)
        self.expect_error("none.pfm", self.scene, *vary, "--reference", "none.pfm")
        (self.folder / "text.png").write_text("no picture")
        self.expect_error("text.png", self.scene, *vary, "--reference", "text.png")
        (self.folder / "small.pfm").write_bytes(pfm_bytes([[(1, 1, 1)] * 3] * 3))
        self.expect_error("small.pfm has 3 x 3 pixels, the settings' pictures have 8 x 6", self.scene, *vary, "--reference", "small.pfm")
        self.expect_error("there is no camera 'none'", self.scene, *vary, "--camera", "none")
        self.expect_error("there is no folder 'none'", self.scene, *vary, "--csv", "none/out.csv")
        self.expect_error("false --out", self.scene, "--external", "false --out {out}")
        self.expect_error("cannot run no-such-program", self.scene, "--external", "no-such-program {out}")
        (self.folder / "a.pfm").write_bytes(pfm_bytes([[(1, 1, 1)] * 3] * 3))
        self.expect_error("3 x 3 pixels, not 8 x 6", self.scene, "--external", f"cp {self.folder}/a.pfm {{out.pfm}}")
        self.expect_error("did not end in 0.2 s", self.scene, "--external", "sh -c 'sleep 20' {out}", "--timeout", "0.2")
        for wrong in ("nan", "inf", "0", "1e9"):
            said = run("tradeoff", self.scene, "--vary", "spp=1,2", "--timeout", wrong)
            self.assertEqual(said.returncode, 64)
            self.assertIn(wrong, said.stderr)

    def test_a_scene_without_anything(self):
        (self.folder / "empty.pov").write_text("#declare Nothing = 1;\n")
        said = document(self.folder / "empty.pov", "--vary", "spp=1,4", "--size", "4x4", "--repeat", 1)
        self.assertEqual([row["errors"]["rmse"] for row in said["rows"]], [0] * len(said["rows"]))


class Measurements(InFolder):
    WORDS = ("--size", "24x18", "--repeat", 2)

    def test_tests_of_triangles_are_paid_for(self):
        """With another than the exact one, accelerators may see different edges: they are not compared then."""
        said = document(self.scene, *self.WORDS, "--vary", "intersect=exact,robust,fast", "--vary", "accel=bvh,grid", "--reference", "self:64")
        self.assertEqual((said["free_axes"], said["not_free"], len(said["rows"])), (["accel"], [], 7), "six, and the default")

    @unittest.skipIf(SANITIZED, "so many samples are taken in the ordinary run")
    def test_more_samples_are_more_accurate_and_accelerators_are_free(self):
        said = document(self.scene, *self.WORDS, "--vary", "spp=1,4,64", "--vary", "accel=bvh,grid", "--vary", "threads=1,2", "--reference", "self:512")
        self.assertEqual(said["schema"], 1)
        self.assertEqual(said["free_axes"], ["accel", "threads"])
        self.assertEqual(said["not_free"], [])
        rows = by(said["rows"], "spp", "accel", "threads")
        self.assertEqual(len(rows), 12)
        errors = [rows[(spp, "bvh", "1")]["errors"]["rmse"] for spp in ("1", "4", "64")]
        self.assertGreater(errors[0], errors[1])
        self.assertGreater(errors[1], 2 * errors[2])
        for spp in ("1", "4", "64"):
            self.assertEqual(rows[(spp, "bvh", "1")]["errors"], rows[(spp, "grid", "2")]["errors"])
            self.assertEqual(rows[(spp, "bvh", "1")]["counts"]["camera_rays"], 24 * 18 * int(spp))
        self.assertLess(said["reference"]["own_error"]["rmse"], errors[2])
        for row in said["rows"]:
            self.assertEqual(len(row["rounds"]), 2)
            self.assertAlmostEqual(row["cpu_seconds"], sum(row["rounds"]) / 2)

    def test_a_second_run_says_the_same_but_for_its_times(self):
        def facts():
            return [(row["name"], row["errors"], row["counts"], row["noise"]) for row in document(self.scene, *self.WORDS, "--vary", "spp=1,4", "--seeds", 8)["rows"]]
        self.assertEqual(facts(), facts())

    def test_the_default_is_one_of_them(self):
        said = document(self.scene, *self.WORDS, "--spp", 4, "--vary", "spp=1,4")
        self.assertEqual([(row["name"], row["default"]) for row in said["rows"]], [("spp=1", False), ("spp=4", True)])
        said = document(self.scene, *self.WORDS, "--vary", "spp=1,4")
        self.assertEqual([(row["name"], row["default"]) for row in said["rows"]], [("default", True), ("spp=1", False), ("spp=4", False)])

    def test_recommendations(self):
        said = document(self.scene, *self.WORDS, "--spp", 16, "--vary", "spp=1,4,16,256", "--error", 1, "--budget", 1e-9)
        names = [row["name"] for row in said["rows"]]
        self.assertEqual(said["recommended"]["best_within_time"], None)
        fastest = said["rows"][said["recommended"]["fastest_within_error"]]
        self.assertEqual(fastest["cpu_seconds"], min(row["cpu_seconds"] for row in said["rows"]))
        said = document(self.scene, *self.WORDS, "--spp", 16, "--vary", "spp=1,4,16,256", "--error", 0, "--budget", 1e9)
        self.assertEqual(said["recommended"]["fastest_within_error"], None)
        self.assertEqual(names[said["recommended"]["best_within_time"]], "spp=256")

    def test_requirements_decide_the_exit_code(self):
        words = ("tradeoff", self.scene, *self.WORDS, "--vary", "spp=1,16")
        self.assertEqual(run(*words, "--require", "rmse<1 @ rays<1e9").returncode, 0)
        for rules in (["rmse<1e-9 @ rays<1e9"], ["rmse<1 @ camera_rays<400"], ["rmse<1 @ rays<1e9", "rmse<1e-9 @ time<100"]):
            said = run(*words, *[word for rule in rules for word in ("--require", rule)])
            self.assertEqual(said.returncode, 2, said)
            self.assertIn(f"{rules[-1]}: NO SETTING MEETS IT", said.stdout)

    def test_texture_reads_are_a_cost(self):
        house = pathlib.Path(__file__).resolve().parents[2] / "assets" / "scenes" / "house.obj"
        words = ("tradeoff", house, *self.WORDS, "--vary", "spp=1,4", "--csv", self.folder / "out.csv")
        said = run(*words, "--require", "rmse<9 @ texture_reads<1e9")
        self.assertEqual(said.returncode, 0, said)
        self.assertIn("Mtexels", said.stdout)
        reads = {row["set_spp"]: int(float(row["texture_reads"])) for row in csv.DictReader((self.folder / "out.csv").read_text().splitlines())}
        self.assertGreater(reads["1"], 0)
        self.assertAlmostEqual(reads["4"] / reads["1"], 4, delta=1)
        self.assertEqual(run(*words, "--require", f"rmse<9 @ texture_reads<{reads['1']}").returncode, 2)
        self.assertNotIn("Mtexels", run("tradeoff", self.scene, *self.WORDS, "--vary", "spp=1,4").stdout)

    def test_modes(self):
        vary = ("--vary", "spp=1,2,4", "--vary", "max-depth=1,2", *self.WORDS)
        self.assertEqual(len(document(self.scene, *vary)["rows"]), 7)
        self.assertEqual(len(document(self.scene, *vary, "--mode", "one")["rows"]), 6)
        self.assertEqual(len(document(self.scene, *vary, "--mode", "halton:3")["rows"]), 4)

    def test_a_file_as_reference(self):
        run("render", self.scene, "--size", "24x18", "--spp", 64, "-o", self.folder / "good.pfm")
        run("render", self.scene, "--size", "24x18", "--spp", 64, "-o", self.folder / "good.png")
        exact = document(self.scene, *self.WORDS, "--vary", "spp=4,64", "--reference", self.folder / "good.pfm")
        self.assertEqual(by(exact["rows"], "spp")[("64",)]["errors"]["rmse"], 0)
        coded = document(self.scene, *self.WORDS, "--vary", "spp=4,64", "--reference", self.folder / "good.png")
        row = by(coded["rows"], "spp")[("64",)]
        own = coded["reference"]["own_error"]["rmse"]
        self.assertGreater(row["errors"]["rmse"], 0)
        self.assertLess(row["errors"]["rmse"], 2 * own, "what remains is the rounding to 8 bits")
        self.assertTrue(coded["reference"]["cut_off"])

    def test_a_table_and_csv(self):
        said = run("tradeoff", self.scene, *self.WORDS, "--vary", "spp=1,16", "--csv", self.folder / "out.csv")
        self.assertEqual(said.returncode, 0, said)
        for words in ("reference: the mean of two pictures", "x time", "spp=16", "knee of the front", "fastest with rmse"):
            self.assertIn(words, said.stdout)
        rows = list(csv.DictReader((self.folder / "out.csv").read_text().splitlines()))
        self.assertEqual([row["set_spp"] for row in rows], ["", "1", "16"])
        self.assertGreater(float(rows[1]["rmse"]), float(rows[2]["rmse"]))

    def test_a_picture_without_numbers_keeps_the_columns(self):
        (self.folder / "nan.pfm").write_bytes(b"PF\n8 6\n-1.0\n" + bytes.fromhex("0000c07f") * (8 * 6 * 3))
        words = ("tradeoff", self.scene, "--size", "8x6", "--repeat", 1, "--reference", "self:4", "--vary", "spp=1", "--external", f"cp {self.folder}/nan.pfm {{out.pfm}}", "--csv", self.folder / "out.csv")
        self.assertEqual(run(*words).returncode, 0)
        rows = list(csv.DictReader((self.folder / "out.csv").read_text().splitlines()))
        self.assertEqual([(row["program"], row["rmse"] == "", row["non_finite"]) for row in rows], [("alidade", False, "0")] * 2 + [("cp", True, "48")])

    def test_every_key_is_documented(self):
        text = (pathlib.Path(__file__).resolve().parents[2] / "docs" / "tradeoff.md").read_text()
        said = document(self.scene, *self.WORDS, "--vary", "spp=1,16", "--seeds", 8)
        keys = set(said) | set(said["rows"][0]) | set(said["recommended"]) | set(said["reference"]) | set(said["rows"][0]["counts"]) | set(said["rows"][0]["errors"])
        self.assertEqual([key for key in sorted(keys) if f"`{key}`" not in text], [])
        help_text = run("tradeoff", "--help").stdout
        for option in ("--vary", "--mode", "--external", "--reference", "--reference-with", "--metric", "--error", "--budget", "--require", "--repeat", "--seeds", "--instructions", "--timeout", "--out", "--csv", "--report", "--json"):
            self.assertIn(option, help_text)
            self.assertIn(f"`{option}", text)

    @unittest.skipIf(SANITIZED, "so many samples are taken in the ordinary run")
    def test_noise_is_variance_and_a_shorter_path_is_bias(self):
        said = document("analytic:sphere-plane", "--size", "16x16", "--repeat", 1, "--vary", "spp=4,16", "--sampler", "random", "--seeds", 16)
        rows = by(said["rows"], "spp")
        few, many = rows[("4",)], rows[("16",)]
        self.assertAlmostEqual(few["noise"]["variance"] / many["noise"]["variance"], 4, delta=0.5)
        for row in (few, many):
            self.assertLess(abs(row["noise"]["bias2"]), 0.05 * row["noise"]["variance"])
            self.assertAlmostEqual(row["errors"]["rmse"] ** 2 / (row["noise"]["variance"] + row["noise"]["bias2"]), 1, delta=1e-6 + 1 / 16)
        biased = document("analytic:mirror-sphere", "--size", "32x32", "--repeat", 1, "--vary", "max-depth=0,2", "--spp", 64, "--seeds", 8)
        rows = by(biased["rows"], "max-depth")
        self.assertGreater(rows[("0",)]["noise"]["bias2"], 100 * rows[("2",)]["noise"]["bias2"])
        self.assertGreater(rows[("0",)]["noise"]["bias2"], 100 * rows[("0",)]["noise"]["variance"])

    @unittest.skipIf(shutil.which("valgrind") is None or SANITIZED, "needs valgrind")
    def test_instructions(self):
        """Of a second run, the same within a hundredth."""
        def instructions():
            said = document(self.scene, "--size", "8x6", "--repeat", 1, "--vary", "spp=1,64", "--reference", "self:4", "--instructions", "--isa", "scalar")
            return {spp: row["instructions"] for (spp,), row in by(said["rows"], "spp").items()}
        first, second = instructions(), instructions()
        self.assertGreater(first["64"], first["1"] + 63 * 48 * 100)
        for spp, count in first.items():
            self.assertAlmostEqual(second[spp] / count, 1, delta=0.01)


class ClosedForms(unittest.TestCase):
    """The renderer converges to what is known."""

    def test_every_analytic_scene(self):
        for scene, most in (("lambert-sphere", 4e-4), ("sphere-plane", 2e-4), ("furnace", 1e-6), ("mirror-sphere", 4e-3), ("disc-disc", 5e-3)):
            with self.subTest(scene=scene):
                said = document(f"analytic:{scene}", "--size", "32x32", "--spp", 4, "--repeat", 1, "--vary", "spp=4,128")
                rows = by(said["rows"], "spp")
                self.assertEqual(said["reference"]["what"], "the closed form")
                self.assertLess(rows[("128",)]["errors"]["rmse"], most)
                self.assertLessEqual(rows[("128",)]["errors"]["rmse"], rows[("4",)]["errors"]["rmse"])

    @unittest.skipIf(SANITIZED, "so many samples are taken in the ordinary run")
    def test_random_samples_converge_as_they_must_and_ours_are_nowhere_worse(self):
        counts = [4 ** k for k in range(1, 7)]
        said = document("analytic:disc-disc", "--size", "6x6", "--repeat", 1, "--seeds", 16, "--threads", 0, "--spp", 4, "--vary", "sampler=random,sobol",
                        "--vary", "spp=" + ",".join(map(str, counts)))
        rows = by(said["rows"], "sampler", "spp")
        error = {name: [rows[(name, str(n))]["errors"]["rmse"] for n in counts] for name in ("random", "sobol")}
        self.assertAlmostEqual(slope(list(zip(counts, error["random"]))), -0.5, delta=0.03)
        for ours, theirs in zip(error["sobol"], error["random"]):
            self.assertLessEqual(ours, theirs)

    @unittest.skipIf(SANITIZED, "so many samples are taken in the ordinary run")
    def test_a_pixel_and_a_light_that_go_together_are_sampled_together(self):
        """Both discs in one pixel: which point of the light counts most goes with the place in the pixel, so that good samples of each alone are no better than chance."""
        said = document("analytic:disc-disc", "--size", "1x1", "--repeat", 1, "--seeds", 64, "--threads", 0, "--spp", 64, "--vary", "sampler=random,sobol", "--vary", "spp=64,1024")
        rows = by(said["rows"], "sampler", "spp")
        for count, better in (("64", 1.3), ("1024", 3)):
            self.assertLess(rows[("sobol", count)]["errors"]["rmse"] * better, rows[("random", count)]["errors"]["rmse"])


class Resuming(InFolder):
    def words(self, *more):
        return ("tradeoff", self.scene, "--size", "32x24", "--spp", 1, "--vary", "spp=1,2,3,4,5,6,7,8,64,128", "--repeat", 4, "--reference", "self:32", "--progress", "none", "--out", self.folder / "out", *more)

    def keys(self):
        path = self.folder / "out" / "measured.jsonl"
        return [json.loads(line)["key"] for line in path.read_text().split("\n")[:-1] if line] if path.exists() else []

    def test_what_is_measured_is_not_measured_again(self):
        process = subprocess.Popen([PROGRAM, *map(str, self.words())], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + 60
        while len(self.keys()) < 8 and time.monotonic() < end:
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.wait()
        before = self.keys()
        self.assertGreaterEqual(len(before), 8)
        self.assertEqual(run(*self.words()).returncode, 0)
        after = self.keys()
        self.assertEqual(after[:len(before)], before)
        self.assertEqual(len(after), len(set(after)), "nothing twice")
        self.assertEqual(len(after), 2 + 10 + 10 * 4)
        first = json.loads((self.folder / "out" / "results.json").read_text())
        self.assertEqual(run(*self.words()).returncode, 0)
        self.assertEqual(self.keys(), after)
        self.assertEqual(json.loads((self.folder / "out" / "results.json").read_text()), first)
        for name in ("results.csv", "tradeoff.html"):
            self.assertTrue((self.folder / "out" / name).exists())

    def test_what_cannot_be_read_is_measured_again(self):
        words = ("tradeoff", self.scene, "--size", "8x6", "--vary", "spp=1,2", "--repeat", 1, "--out", self.folder / "out", "--reference", "self:4")
        self.assertEqual(run(*words).returncode, 0)
        rows = json.loads((self.folder / "out" / "results.json").read_text())["rows"]
        keys, path = self.keys(), self.folder / "out" / "measured.jsonl"
        for value in ({}, None, 3, [], "", {"errors": {"rmse": "0"}, "cpu": "1", "what": 3}):
            with path.open("a") as file:
                for key in keys:
                    if key != "head":
                        file.write(json.dumps({"key": key, "value": value}) + "\n")
            said = run(*words)
            self.assertEqual(said.returncode, 0, f"{value}: {said.stderr}")
            self.assertEqual([row["errors"] for row in json.loads((self.folder / "out" / "results.json").read_text())["rows"]], [row["errors"] for row in rows])

    def test_another_experiment_is_refused(self):
        words = ("tradeoff", self.scene, "--size", "8x6", "--vary", "spp=1,2", "--repeat", 1, "--out", self.folder / "out", "--reference", "self:4")
        self.assertEqual(run(*words).returncode, 0)
        said = run(*words, "--light-samples", 2)
        self.assertEqual((said.returncode, said.stdout), (1, ""))
        self.assertIn("holds measurements of something else (another options)", said.stderr)

    def test_errors_that_are_infinite_are_read_again(self):
        words = ("tradeoff", "analytic:furnace", "--size", "8x8", "--vary", "spp=1,4", "--repeat", 1, "--out", self.folder / "out", "--csv", self.folder / "out.csv")
        self.assertEqual(run(*words).returncode, 0)
        first = (self.folder / "out.csv").read_text()
        self.assertEqual(run(*words).returncode, 0)
        self.assertEqual((self.folder / "out.csv").read_text(), first)

    def test_a_reference_of_the_same_name_is_another_one(self):
        words = ("tradeoff", self.scene, "--size", "8x6", "--vary", "spp=1,2", "--repeat", 1, "--out", self.folder / "out", "--reference", self.folder / "ref.pfm")
        for exposure, code in ((0, 0), (0, 0), (3, 1)):
            run("render", self.scene, "--size", "8x6", "--exposure", exposure, "-o", self.folder / "ref.pfm")
            said = run(*words)
            self.assertEqual(said.returncode, code, said)
        self.assertIn("(another reference)", said.stderr)

    def test_finer_settings_are_added_to_what_is_there(self):
        words = ("tradeoff", self.scene, "--size", "8x6", "--repeat", 1, "--out", self.folder / "out", "--json")
        first = json.loads(run(*words, "--vary", "spp=1,2").stdout)
        said = run(*words, "--vary", "spp=1,2,32")
        self.assertEqual(said.returncode, 0, said)
        second = json.loads(said.stdout)
        self.assertEqual(second["reference"], first["reference"])
        self.assertIn("has a reference already: the mean of two pictures of ours with", "".join(second["warnings"]))
        self.assertEqual([row["errors"] for row in second["rows"][:3]], [row["errors"] for row in first["rows"]])


@unittest.skipIf(POVRAY is None, "needs POV-Ray")
class OtherPrograms(InFolder):
    def test_povray_has_its_own_curve(self):
        scene = self.folder / "scene.pov"
        scene.write_text('#include "ball.inc"\n camera { location <0, 1, -4> look_at 0 } light_source { <3, 5, -6>, 1 } plane { y, -1 pigment { checker rgb 1, rgb 0.2 } }\n')
        (self.folder / "ball.inc").write_text("sphere { 0, 1 pigment { rgb <1, 0.4, 0.2> } }\n")
        said = document(scene, "--size", "40x30", "--repeat", 1, "--vary", "spp=1,16", "--vary", "aa=2,4", "--reference", "self:64",
                        "--external", "povray '+I{scene}' '+L{folder}' +W{width} +H{height} +A0.0 +AM1 +R{aa} -J +WT1 -D +O{out}")
        theirs = by(said["rows"], "aa")
        self.assertEqual(set(theirs), {("2",), ("4",)})
        self.assertGreater(theirs[("2",)]["errors"]["rmse"], theirs[("4",)]["errors"]["rmse"])
        self.assertLess(theirs[("4",)]["errors"]["rmse"], 0.02, "both programs see one scene")
        self.assertEqual((theirs[("2",)]["program"], theirs[("2",)]["counts"], len(said["rows"])), ("povray", {}, 5))
        self.assertGreater(theirs[("2",)]["cpu_seconds"], 0)
        self.assertTrue(said["reference"]["cut_off"])

    def test_povray_as_reference(self):
        scene = self.folder / "a.pov"
        scene.write_text("camera { location -4*z look_at 0 } light_source { <3, 5, -6>, 1 } sphere { 0, 1 pigment { rgb 1 } }\n")
        said = document(scene, "--size", "40x30", "--repeat", 1, "--vary", "spp=1,64", "--reference", "povray")
        rows = by(said["rows"], "spp")
        self.assertLess(rows[("64",)]["errors"]["rmse"], 0.2 * rows[("1",)]["errors"]["rmse"])


if __name__ == "__main__":
    unittest.main()
