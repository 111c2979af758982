# SPDX-License-Identifier: Apache-2.0
"""`alidade stress`: what it measures, what it leaves out, what it writes, and odd words."""
import csv
import json
import os
import pathlib
import re
import signal
import struct
import subprocess
import unittest

from program import PROGRAM, InFolder, run, triangle_gltf

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs/stress.md"
QUICK = ["--side", "24", "--rounds", "1"]
KINDS = "scan architecture stadium hair soup sphere forest lattice needle nested zoo".split()


class Stress(InFolder):
    def stress(self, *words, code=0):
        said = run("stress", *words, cwd=self.folder)
        self.assertEqual(said.returncode, code, said)
        return said

    def document(self, *words, code=0):
        self.stress(*words, "--json", "out.json", code=code)
        return json.loads((self.folder / "out.json").read_text())


class Figures(Stress):
    def test_json_is_printed_or_written(self):
        words = ["--generate", "soup:500", "--side", "8", "--rounds", "1"]
        self.assertIn("soup", json.dumps(json.loads(self.stress(*words, "--json").stdout)))
        self.assertFalse((self.folder / "out.json").exists())
        self.assertIn("all agree", self.stress(*words, "--json", "out.json").stdout)
        self.assertTrue((self.folder / "out.json").exists())

    def test_the_table_has_all_structures_and_rays_and_they_agree(self):
        said = self.stress("--generate", "scan:2000", *QUICK).stdout
        self.assertTrue(said.startswith("scan: 2028 triangles\n"), said)
        for accelerator in ("bvh", "hlbvh", "compact", "grid", "octree"):
            for precision in ("float", "double"):
                self.assertRegex(said, rf"\n  {accelerator} +{precision} +[\d.e-]+ +[\d.]+ +[\d.]+ +[\d.-]+ +\d+ +\d+")
                for rays in ("primary", "shadow", "diffuse", "random"):
                    self.assertRegex(said, rf"\n  {rays} +{accelerator} +{precision} +[\d.]+ +- +\d+ +[\d.]+ +[\d.]+ +[\d.]+ +0\n")
        self.assertRegex(said, r"\n  all agree; brute force was asked \d+ primary, \d+ shadow, \d+ diffuse, \d+ random rays\n")

    def test_tests_of_triangles_stand_beside_each_other(self):
        document = self.document("--generate", "scan:2000", *QUICK, "--precision", "float", "--accel", "bvh,grid", "--intersect", "fast,exact,robust")
        structures = document["scenes"][0]["sizes"][0]["structures"]
        self.assertEqual([one["accelerator"] for one in structures], ["bvh:fast", "bvh", "bvh:robust", "grid:fast", "grid", "grid:robust"])
        hits = [[rays["hits"] for rays in one["rays"]] for one in structures]
        for other in hits:
            for got, want in zip(other, hits[1]):
                self.assertLessEqual(abs(got - want), 2, "but for an edge")

    def test_the_docs_show_this_table(self):
        shown = DOCS.read_text().split("<!-- output -->\n")[1].split("<!-- end -->")[0]
        said = self.stress("--generate", "scan:2000", *QUICK, "--accel", "bvh,octree", "--precision", "float").stdout

        def words(text):
            """Without the numbers, which differ."""
            return [re.sub(r"[\d.]+(e-?\d+)?|(?<= )-(?= |$)", "#", " ".join(line.split())) for line in text.splitlines() if line.strip()]
        self.assertEqual(words(shown), words(said))

    def test_every_kind_is_measured(self):
        words = [word for kind in KINDS for word in ("--generate", f"{kind}:500:3")]
        document = self.document(*words, *QUICK, "--precision", "float")
        self.assertEqual([scene["kind"] for scene in document["scenes"]], KINDS)
        for scene in document["scenes"]:
            self.assertEqual(scene["seed"], 3)
            for size in scene["sizes"]:
                self.assertEqual([one["accelerator"] for one in size["structures"]], ["bvh", "hlbvh", "compact", "grid", "octree"])
                for rays in range(4):
                    self.assertEqual(len({one["rays"][rays]["hash"] for one in size["structures"]}), 1, "the same hits, bit for bit")
                self.assertEqual(size["disagreements"], [])

    def test_a_users_scene_with_its_instances_camera_and_lights(self):
        document = self.document(self.scene, *QUICK)
        scene = document["scenes"][0]
        self.assertEqual((scene["name"], scene["kind"]), (str(self.scene), None))
        size = scene["sizes"][0]
        self.assertEqual((size["triangles"], size["places"]), (1, 0))
        primary = size["structures"][0]["rays"][0]
        self.assertEqual(primary["count"], 576)
        # 2 x 2 under an angle of 1 at distance 3: the triangle is half of a square of 2 in a window of 6 tan(0.5).
        self.assertAlmostEqual(primary["hits"] / 576, 2 / (6 * 0.5463) ** 2, delta=0.02)
        self.assertEqual(size["structures"][0]["rays"][1]["hits"], 0, "nothing stands between it and the sun")
        twice = json.loads(triangle_gltf())
        twice["nodes"] += [{"mesh": 0, "translation": [0, 0, -1]}]
        twice["scenes"][0]["nodes"].append(3)
        (self.folder / "twice.gltf").write_text(json.dumps(twice))
        size = self.document("twice.gltf", *QUICK)["scenes"][0]["sizes"][0]
        self.assertEqual((size["triangles"], size["places"], size["placed_triangles"]), (1, 2, 2))

    def test_mesh_files_and_pov_scenes(self):
        (self.folder / "two.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        (self.folder / "one.pov").write_text("camera { location <0, 0, -3> look_at 0 } light_source { <5, 5, -5>, 1 } triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> } sphere { 0, 0.1 }\n")
        said = self.stress("two.obj", *QUICK)
        self.assertIn("two.obj: 2 triangles", said.stdout)
        self.assertIn("the scene has no light: shadow rays go to a sun", said.stderr)
        said = self.stress("one.pov", *QUICK)
        self.assertIn("one.pov: 1 triangles", said.stdout)
        self.assertIn("1 closed forms are left out", said.stderr)

    def test_growth_is_fitted(self):
        document = self.document("--generate", "soup:1e2..1e4", "--accel", "brute,bvh", "--precision", "float", "--side", "16", "--rounds", "1")
        self.assertEqual([size["asked"] for size in document["scenes"][0]["sizes"]], [100, 316, 1000, 3162, 10000])
        law = {(one["accelerator"], one["cost"]): one for one in document["scenes"][0]["growth"]}
        self.assertAlmostEqual(law["brute", "random tests"]["exponent"], 1, delta=1e-3)   # brute force looks at all
        self.assertLess(law["bvh", "random tests"]["exponent"], 0.5)
        self.assertAlmostEqual(law["bvh", "bytes"]["exponent"], 1, delta=0.15)
        self.assertIn("growth: cost ~ triangles ^ exponent", self.stress("--generate", "soup:1e2..1e3", *QUICK).stdout)

    def test_embree_stands_beside_ours_or_is_said_to_be_missing(self):
        said = run("stress", "--generate", "scan:2000", *QUICK, "--against", "embree", "--json", "out.json", cwd=self.folder)
        if said.returncode == 1:
            self.assertIn("was built without Embree 3, or the system has no", said.stderr)
            return
        self.assertEqual(said.returncode, 0, said)
        for peer in ("embree", "embree robust", "embree high"):
            self.assertRegex(said.stdout, rf"\n  primary +{peer} +float ")
        size = json.loads((self.folder / "out.json").read_text())["scenes"][0]["sizes"][0]
        for one in size["structures"]:
            self.assertLess(one["rays"][0]["unlike"], 6, "of 576 rays")


class Files(Stress):
    def test_what_the_document_says_is_what_docs_say(self):
        document = self.document("--generate", "scan:300..1000", "--generate", "zoo:300", *QUICK)
        text = DOCS.read_text()
        told = set(re.findall(r"`(\w+)`", text[text.index("## The document"):text.index("## The table for programs")]))

        def keys(value):
            if isinstance(value, dict):
                for key, each in value.items():
                    yield key
                    yield from keys(each)
            elif isinstance(value, list):
                for each in value:
                    yield from keys(each)
        self.assertEqual(set(keys(document)) - told, set(), "docs/stress.md must name every key")
        self.assertEqual(document["schema"], 1)
        self.assertEqual(document["exit_code"], 0)
        self.assertIn("alidade stress --generate", document["command"])

    def test_the_csv_has_a_line_for_each_peer_and_rays(self):
        self.stress("--generate", "soup:300", "--generate", "hair:1000", *QUICK, "--csv", "out.csv")
        with open(self.folder / "out.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 2 * 10 * 4)
        text = DOCS.read_text()
        told = re.findall(r"`(\w+)`", text[text.index("## The table for programs"):text.index("## Rays in files")])
        self.assertEqual(list(rows[0]), told)
        for row in rows:
            self.assertNotIn(None, row.values())
            self.assertGreater(float(row["rays_per_second"]), 0)
            self.assertEqual(row["unlike"], "0")

    def test_dumped_rays_are_asked_again_with_the_same_answers(self):
        first = self.document("--generate", "scan:1000:5", *QUICK, "--dump-rays", "rays.bin")
        self.assertEqual(sorted(path.name for path in self.folder.glob("rays*")), ["rays.diffuse.bin", "rays.primary.bin", "rays.random.bin", "rays.shadow.bin"])
        again = self.document("--generate", "scan:1000:5", *QUICK, "--rays", "rays.diffuse.bin")
        for old, new in zip(first["scenes"][0]["sizes"][0]["structures"], again["scenes"][0]["sizes"][0]["structures"]):
            self.assertEqual([rays["rays"] for rays in new["rays"]], ["given", "given, any hit"])
            self.assertEqual(new["rays"][0]["hash"], old["rays"][2]["hash"])
            self.assertEqual(new["rays"][0]["hits"], new["rays"][1]["hits"])

    def test_trees_are_written_as_docs_say(self):
        said = self.stress("--generate", "scan:2000", *QUICK, "--accel", "bvh,octree,grid", "--tree", "tree.json")
        self.assertEqual(said.stderr.count("grid is no tree"), 1, said.stderr)
        self.assertEqual(sorted(path.name for path in self.folder.glob("*.json")), [f"tree.{one}.{precision}.json" for one in ("bvh", "octree") for precision in ("double", "float")])
        document = json.loads((self.folder / "tree.bvh.double.json").read_text())
        self.assertEqual((document["schema"], document["accelerator"], document["precision"], len(document["trees"])), (1, "bvh", "double", 1))
        tree = document["trees"][0]
        page = DOCS.read_text().split("## Trees in files")[1].split("## ")[0]
        for key in [*document, *tree, *tree["tree"][0], *tree["tree"][-1]]:
            self.assertIn(f"`{key}`", page)
        nodes = tree["tree"]
        self.assertEqual({id for node in nodes for id in node.get("primitives", [])}, set(range(tree["triangles"])))
        self.assertEqual((tree["nodes"], tree["leaves"]), (sum("children" in node for node in nodes), sum("primitives" in node for node in nodes)))
        example = page.split("```python\n")[1].split("```")[0].replace("tree.bvh.float.json", "tree.bvh.double.json")
        cost = subprocess.run(["python3", "-c", example], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertAlmostEqual(float(cost.stdout), tree["sah_cost"], places=6)

    def test_rays_made_elsewhere(self):
        rays = [(0.25, -0.25, 3, 0, 0, -1, 0, float("inf")), (5, 5, 3, 0, 0, -1, 0, float("inf")), (0.25, -0.25, 3, 0, 0, -1, 0, 2.5)]
        for code, size in (("f", 4), ("d", 8)):
            (self.folder / "mine.bin").write_bytes(b"ALIDRAYS" + struct.pack("<IIQ", 1, size, len(rays)) + b"".join(struct.pack(f"<8{code}", *ray) for ray in rays))
            document = self.document(self.scene, "--rays", "mine.bin", "--rounds", "1")
            for one in document["scenes"][0]["sizes"][0]["structures"]:
                self.assertEqual([rays["hits"] for rays in one["rays"]], [1, 1])

    def test_files_of_rays_that_are_none(self):
        (self.folder / "bad.bin").write_bytes(b"ALIDRAYS" + struct.pack("<IIQ", 1, 4, 10**15))
        said = self.stress(self.scene, "--rays", "bad.bin", code=1)
        self.assertRegex(said.stderr, r"bad\.bin: error: byte 16: 1000000000000000 rays are told, but there are bytes for 0\n")
        self.assertIn("none.bin", self.stress(self.scene, "--rays", "none.bin", code=1).stderr)
        (self.folder / "text.bin").write_text("0 0 0  0 0 1\n" * 10)
        self.assertIn("text.bin: error: byte 0: this is no file of rays", self.stress(self.scene, "--rays", "text.bin", code=1).stderr)


class Budgets(Stress):
    def test_what_takes_too_long_is_left_out_and_said_everywhere(self):
        said = self.stress("--generate", "soup:1e3..1e9", "--side", "16", "--rounds", "1", "--accel", "bvh", "--precision", "float", "--time", "2", "--json", "out.json", "--csv", "out.csv")
        self.assertRegex(said.stdout, r"soup, 1000000000 triangles: left out: (to make the scene takes about|the scene needs about)")
        sizes = json.loads((self.folder / "out.json").read_text())["scenes"][0]["sizes"]
        self.assertNotIn("left_out", sizes[0])
        self.assertIn("left_out", sizes[-1])
        self.assertRegex((self.folder / "out.csv").read_text(), r"\nsoup,1,1000000000,+\"?(to make|the scene)")

    def test_memory(self):
        document = self.document("--generate", "soup:20000", *QUICK, "--memory", "6M")
        size = document["scenes"][0]["sizes"][0]
        lefts = [one.get("left_out", "") for one in size["structures"]]
        self.assertIn("", lefts, "something fits")
        self.assertTrue(any(re.search(r"needs about .* while it is built, beside .*: more than 6.0 MB", left) for left in lefts), lefts)
        self.assertIn("needs about 600 bytes while it is built", self.stress(self.scene, *QUICK, "--memory", "100", code=1).stdout)
        said = self.stress("--generate", "soup:1e9", *QUICK, "--memory", "100M", code=1)
        self.assertIn("the scene needs about", said.stdout)
        self.assertIn("nothing was measured", said.stderr)

    def test_interrupted_it_tells_what_there_is(self):
        process = subprocess.Popen([PROGRAM, "stress", "--generate", "soup:500", "--generate", "scan:1000000", "--side", "16", "--rounds", "50", "--json", "out.json"], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertIn("soup: 500 triangles", process.stdout.readline())   # it has been measured
        process.send_signal(signal.SIGINT)
        out, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 2, said)
        self.assertIn("interrupted", said)
        document = json.loads((self.folder / "out.json").read_text())
        self.assertEqual((document["interrupted"], document["exit_code"]), (True, 2))
        self.assertEqual(len(document["scenes"][0]["sizes"][0]["structures"]), 10)

    def test_no_time_at_all(self):
        said = self.stress("--generate", "soup:2000", *QUICK, "--time", "0", code=1)
        self.assertIn("left out", said.stdout)
        self.assertIn("nothing was measured", said.stderr)


class OddWords(Stress):
    def assert_usage(self, *words, says):
        said = self.stress(*words, code=64)
        self.assertEqual((said.stdout, said.stderr.count("\n")), ("", 1), said)
        self.assertIn(says, said.stderr)

    def test_usage(self):
        for words, says in (
            ([], "a file or --generate KIND:N is missing"),
            (["--generate", "scan:0"], "'0' is not a whole number of triangles from 1 to 1000000000"),
            (["--generate", "scan:1e12"], "'1e12' is not a whole number of triangles"),
            (["--generate", "scan:1.5"], "'1.5' is not a whole number"),
            (["--generate", "scan:-3"], "'-3' is not a whole number"),
            (["--generate", "scan:many"], "'many' is not a number"),
            (["--generate", "scan:"], "'' is not a number"),
            (["--generate", "scan:1e5..1e3"], "does not go from a smaller number to a larger one"),
            (["--generate", "scan:5..5"], "does not go from a smaller"),
            (["--generate", "scan:1e3..1e12"], "'1e12' is not a whole number"),
            (["--generate", "scan:10:x"], "seed: 'x' is not a whole number"),
            (["--generate", "scan:10:1:2"], "is not KIND:N:SEED"),
            (["--generate", "scna:10"], "'scna' is not one of scan, architecture"),
            (["--generate", "scna:10"], "did you mean 'scan'?"),
            (["--generate", ""], "is not one of"),
            (["--generate"], "--generate"),
            ([self.scene, "--generate", "scan:10"], "a file and --generate: give one of them"),
            ([self.scene, "--growth"], "--growth needs --generate"),
            (["--generate", "scan:10", "--accel", "bvh,octre"], "did you mean 'octree'?"),
            (["--generate", "scan:10", "--accel", ""], "'' is not one of"),
            (["--generate", "scan:10", "--precision", "half"], "'half' is not one of float, double"),
            (["--generate", "scan:10", "--against", "optix"], "embree"),
            (["--generate", "scan:10", "--side", "0"], "from 1 to 8192"),
            (["--generate", "scan:10", "--rounds", "0"], "from 1"),
            (["--generate", "scan:10", "--time", "-1"], "less than 0"),
            (["--generate", "scan:10", "--time", "soon"], "'soon' is not a number"),
            (["--generate", "scan:10", "--memory", "lots"], "'lots' is not a number of bytes, such as 2e9 or 500M"),
            (["--generate", "scan:10..100", "--tree", "x"], "--tree are for one scene of one size"),
            (["--generate", "scan:10..100", "--rays", "x"], "--rays, --dump-rays and --tree are for one scene of one size"),
            (["--generate", "scan:10", "--generte", "x"], "did you mean '--generate'?"),
        ):
            with self.subTest(words=words, says=says):
                self.assert_usage(*words, says=says)

    def test_input(self):
        (self.folder / "empty.obj").write_text("")
        (self.folder / "ball.pov").write_text("sphere { 0, 1 }\n")
        (self.folder / "none.gltf").write_text('{"asset": {"version": "2.0"}}')
        (self.folder / "noise.glb").write_bytes(bytes(range(200)))
        for name, says in (("nowhere.obj", "nowhere.obj: error: "), ("noise.glb", "noise.glb"), (".", ": error: "), ("empty.obj", "empty.obj: error: "),
                           ("none.gltf", "none.gltf: error: the scene has no triangles"), ("ball.pov", "the scene has no triangles")):
            with self.subTest(name=name):
                said = self.stress(name, *QUICK, code=1)
                self.assertEqual(said.stdout, "")
                self.assertIn(says, said.stderr)
        self.assertIn("`alidade convert SCENE out.glb` makes meshes of its closed forms", self.stress("ball.pov", code=1).stderr)

    def test_outputs(self):
        for words, says in ((["--json", "no/out.json"], "there is no folder 'no'"), (["--tree", "no/tree.json"], "there is no folder 'no'"), (["--csv", "."], "is a folder"), (["--json", "a", "--csv", "a"], "'a' would be overwritten"),
                            (["--report", "no/out.html"], "there is no folder 'no'")):
            with self.subTest(words=words):
                self.assertIn(says, self.stress("--generate", "scan:10", *words, code=1).stderr)
        self.assertIn("would be overwritten", self.stress(self.scene, "--json", self.scene, code=1).stderr)

    def test_one_triangle_of_each_kind(self):
        words = [word for kind in KINDS for word in ("--generate", f"{kind}:1")]
        self.stress(*words, "--side", "8", "--rounds", "1")

    def test_progress_for_programs(self):
        said = self.stress("--generate", "soup:2000", *QUICK, "--progress", "json")
        lines = [json.loads(line) for line in said.stderr.splitlines()]
        self.assertGreater(len(lines), 3)
        self.assertEqual([line["progress"] for line in lines], sorted(line["progress"] for line in lines))
        self.assertIn("steps_done", lines[0])


if __name__ == "__main__":
    os.environ.setdefault("LC_ALL", "C")
    unittest.main()
