# SPDX-License-Identifier: Apache-2.0
"""`alidade convert SCENE out.pov`: POV-Ray renders what is written without a warning, and its pictures are those of `alidade render`.

The assets, and where the shared data is beside the repository, Blender's exports. Coverage is compared before a magenta background that no surface has, where
POV-Ray draws surfaces in their plain colours (+Q1), opaque ones; or as they are."""
import base64
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import unittest

from pictures import png_bytes, write
from program import SANITIZED, InFolder, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
ASSETS = ROOT / "assets/scenes"
BLENDER = pathlib.Path(os.environ.get("ALIDADE_SHARED_DATA", ROOT.parent / "shared/data")) / "blender"
WIDTH, HEIGHT = 160, 120
LIT_BY_SKY = {"house.obj", "shell.ply", "gear.stl", "star.off"}
CUT_OUT = {"foliage.glb", "textured.glb"}
MAGENTA = bytes((255, 0, 255))

# By how much the mean code of a picture may differ: what POV-Ray's highlights, normal maps and skies cannot be is in it. Tight where nothing is lost.
MEAN = {"motion.glb": 0.005, "house.obj": 0.02, "foliage.glb": 0.02, "prims.glb": 0.02, "materials.glb": 0.03, "textured.glb": 0.05, "instances.glb": 0.06}


def read_ppm(path):
    """(width, height, bytes) of a binary PPM with 8 bits a colour."""
    data = path.read_bytes()
    header = re.match(rb"P6\s+(?:#[^\n]*\n\s*)*(\d+)\s+(\d+)\s+255\s", data)
    return int(header[1]), int(header[2]), data[header.end():]


def linear(code):
    return code / 255 / 12.92 if code <= 10 else ((code / 255 + 0.055) / 1.055) ** 2.4


KEPT = {"KHR_materials_transmission", "KHR_materials_unlit", "KHR_materials_ior", "KHR_materials_volume", "KHR_materials_emissive_strength"}


def strip(material):
    """Leaves of a material what POV-Ray has words for: diffuse and clear surfaces, mirrors, emission, pictures, alpha."""
    extensions = material["extensions"] = {name: value for name, value in material.get("extensions", {}).items() if name in KEPT}
    for picture in ("normalTexture", "occlusionTexture"):
        material.pop(picture, None)
    surface = material.setdefault("pbrMetallicRoughness", {})
    if surface.pop("metallicRoughnessTexture", None):
        surface["metallicFactor"] = 0
    if "KHR_materials_transmission" in extensions or "KHR_materials_unlit" in extensions:
        return
    if surface.get("metallicFactor", 1) == 1:
        surface["roughnessFactor"] = 0
    else:
        surface["metallicFactor"] = 0
        extensions["KHR_materials_specular"] = {"specularFactor": 0}


def without_highlights(glb):
    """The scene with what POV-Ray has words for alone."""
    data = glb.read_bytes()
    size = struct.unpack("<I", data[12:16])[0]
    document = json.loads(data[20:20 + size])
    for material in document["materials"]:
        strip(material)
    document["extensionsUsed"] = sorted({*document.get("extensionsUsed", []), "KHR_materials_specular"})
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + size:]
    return data[:8] + struct.pack("<II", 20 + len(text) + len(rest), len(text)) + b"JSON" + text + rest


def pixels(picture):
    width, height, data = picture
    return [[data[3 * (y * width + x):][:3] for x in range(width)] for y in range(height)]


def far_from_edges(mask, x, y):
    """Is the mask the same at all neighbours?"""
    around = [mask[j][i] for j in range(max(y - 1, 0), min(y + 2, HEIGHT)) for i in range(max(x - 1, 0), min(x + 2, WIDTH))]
    return all(m == around[0] for m in around)


@unittest.skipUnless(shutil.which("povray"), "povray is not installed")
class PovExport(InFolder):
    def povray(self, scene, out, *words, warned=r"Warning: |Error: "):
        done = subprocess.run(["povray", f"+I{scene}", f"+O{out}", f"+W{WIDTH}", f"+H{HEIGHT}", "+FP", "-A", "-D", "+WT1", *words],
                              cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        self.assertNotRegex(done.stderr, warned)
        return read_ppm(self.folder / out)

    def ours(self, scene, out, *words):
        done = run("render", scene, "-o", out, "--size", f"{WIDTH}x{HEIGHT}", *words, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return read_ppm(self.folder / out)

    def convert(self, scene):
        done = run("convert", scene, "out.pov", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def check(self, scene):
        self.convert(scene)
        theirs, own = self.povray("out.pov", "theirs.ppm"), self.ours(scene, "own.ppm", "--spp", 16 if scene.name in LIT_BY_SKY else 1)
        means = [sum(p[2]) / len(p[2]) for p in (own, theirs)]
        self.assertGreater(means[0], 5, "the picture shows something")
        if os.environ.get("ALIDADE_FIGURES"):
            print(f"{scene.name:15} mean codes {means[0]:.2f} {means[1]:.2f}", flush=True)
        self.assertLess(abs(means[1] / means[0] - 1), MEAN.get(scene.name, 0.03), f"mean codes {means}")
        with open(self.folder / "out.pov", "a") as text:
            text.write("background { color rgb <1,0,1> }\n")
        flat = pixels(self.povray("out.pov", "flat.ppm", "+Q9" if scene.name in CUT_OUT else "+Q1"))
        integrator = "whitted" if scene.name in CUT_OUT else "cast"   # which sees no transparency
        mask = pixels(self.ours(scene, "mask.ppm", "--integrator", integrator, "--environment", "#ff00ff", "--spp", 1))
        masks = [[[pixel != MAGENTA for pixel in row] for row in picture] for picture in (mask, flat)]
        differ = [(x, y) for y in range(HEIGHT) for x in range(WIDTH) if masks[0][y][x] != masks[1][y][x] and far_from_edges(masks[0], x, y)]
        if os.environ.get("ALIDADE_FIGURES"):
            print(f"{scene.name:15} coverage differs in {len(differ)} of {WIDTH * HEIGHT}", flush=True)
        self.assertLessEqual(len(differ), 0.0005 * WIDTH * HEIGHT, differ[:10])

    def test_assets(self):
        scenes = sorted(p for p in ASSETS.iterdir() if p.suffix in (".glb", ".obj", ".ply", ".stl", ".off"))
        self.assertGreater(len(scenes), 7)
        for scene in scenes:
            with self.subTest(scene.name):
                self.check(scene)

    def test_what_pov_ray_has_words_for_is_the_same(self):
        (self.folder / "plain.glb").write_bytes(without_highlights(ASSETS / "materials.glb"))
        self.assertNotIn("highlight", self.convert("plain.glb"))
        theirs, own = self.povray("out.pov", "theirs.ppm"), self.ours("plain.glb", "own.ppm", "--spp", 1)
        light = [sum(map(linear, p[2])) for p in (own, theirs)]
        self.assertLess(abs(light[1] / light[0] - 1), 0.01)
        over = sum(abs(a - b) > 8 for a, b in zip(own[2], theirs[2]))
        self.assertLess(over, 0.02 * len(own[2]), "what is over are edges")

    def compared(self, scene):
        """What `compare` says of a scene beside POV-Ray's picture of it."""
        done = run("compare", scene, "--size", f"{WIDTH}x{HEIGHT}", "--json", "--cache", self.folder / "cache", cwd=self.folder)
        return json.loads(done.stdout)

    def assert_the_same_read_again(self, scene):
        self.convert(scene)
        for name, picture in ((scene, "own.exr"), ("out.pov", "again.exr")):
            self.assertEqual(run("render", name, "-o", picture, "--size", f"{WIDTH}x{HEIGHT}", "--spp", 1, cwd=self.folder).returncode, 0)
        again = json.loads(run("diff", "own.exr", "again.exr", "--json", cwd=self.folder).stdout)
        self.assertLessEqual(again["metrics"]["flip"]["mean"], 0.02)

    def check_expressed(self, scene):
        """Where all materials are expressed, POV-Ray's picture and ours of what was read again are the scene's."""
        (self.folder / "plain.glb").write_bytes(without_highlights(scene))
        document = self.compared("plain.glb")
        expressed, lost = document["expressed"], {m["name"]: m["lost"] for m in document["materials"] if m["lost"]}
        if os.environ.get("ALIDADE_FIGURES"):
            print(f"{scene.name:15} expressed: {expressed}", flush=True)
        self.assertFalse([name for name, what in lost.items() if what != ["faint mirror images under the vertex colours"]], lost)
        self.assertGreater(expressed["pixels"], 0.03 * WIDTH * HEIGHT)
        self.assertLessEqual(expressed["flip"], 0.005)
        self.assertLessEqual(abs(expressed["brighter"]), 0.002)
        self.assert_the_same_read_again("plain.glb")

    def test_what_is_expressed_is_close_in_scenes_as_they_are(self):
        """Mirrors and glass among materials that lose their highlights."""
        for name in ("hero.glb", "materials.glb"):
            with self.subTest(name):
                expressed = self.compared(ASSETS / name)["expressed"]
                if os.environ.get("ALIDADE_FIGURES"):
                    print(f"{name:15} as it is: {expressed}", flush=True)
                self.assertGreater(expressed["pixels"], 0.08 * WIDTH * HEIGHT)
                self.assertLessEqual(expressed["flip"], 0.02)
                self.assertLessEqual(abs(expressed["brighter"]), 0.01)
                self.assert_the_same_read_again(ASSETS / name)

    def test_materials_that_lose_nothing(self):
        scenes = sorted(ASSETS.glob("*.glb")) + [BLENDER / name for name in ("prims.glb", "textured.glb", "instances.glb") if BLENDER.is_dir()]
        self.assertGreater(len(scenes), 4)
        for scene in scenes:
            with self.subTest(scene.name):
                self.check_expressed(scene)

    def test_each_material_is_told(self):
        document = self.compared(ASSETS / "materials.glb")
        rows = {m["name"]: m for m in document["materials"]}
        self.assertEqual(rows["unlit"]["lost"], [])
        self.assertLess(rows["unlit"]["flip"], 0.01)
        self.assertEqual(rows["plastic"]["lost"], ["the GGX highlight"])
        self.assertEqual(document["expressed"]["pixels"], sum(m["pixels"] for m in rows.values() if not m["lost"]))

    def test_exports_of_blender(self):
        if not BLENDER.is_dir():
            self.skipTest("the shared data is not there")
        for name in ("prims.glb", "textured.glb", "instances.glb"):
            with self.subTest(name):
                self.check(BLENDER / name)

    def test_instances_stay_small(self):
        if not BLENDER.is_dir():
            self.skipTest("the shared data is not there")
        self.convert(BLENDER / "instances.glb")
        self.assertLess((self.folder / "out.pov").stat().st_size, 10e6, "3.8 million triangles of 7 meshes")

    def gltf(self, material, image="", vertices=((-1, -1, 0), (1, -1, 0), (0, 1, 0))):
        """A triangle with texture coordinates before a camera and a lamp."""
        body = b"".join(struct.pack("<3f", *v) for v in vertices) + struct.pack("<6f", 0, 1, 1, 1, 0.5, 0)
        document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}], "extensionsUsed": ["KHR_materials_unlit"],
                    "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 4]}], "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}],
                    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}], "materials": [material],
                    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
                    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
                    "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64," + base64.b64encode(body).decode()}]}
        if image:
            document.update(images=[{"uri": image}], textures=[{"source": 0}])
        self.scene.write_text(json.dumps(document))
        return self.scene

    def assert_alike(self, scene):
        self.convert(scene)
        theirs, own = self.povray("out.pov", "theirs.ppm"), self.ours(scene, "own.ppm", "--spp", 1)
        self.assertGreater(max(own[2]), 20)
        self.assertLess(sum(abs(a - b) > 4 for a, b in zip(own[2], theirs[2])), 0.01 * len(own[2]))

    def test_a_spot_has_gltfs_rim(self):
        """A Lambert floor under spots: with and without light of one strength in the middle, and a rim so narrow that POV-Ray's floats are told."""
        for inner, outer, flip in ((0.3, 0.6, 0.001), (0, 0.7, 0.001), (0.5, 0.6, 0.001), (0.59, 0.6, 0.02)):
            with self.subTest((inner, outer)):
                self.gltf({"pbrMetallicRoughness": {"baseColorFactor": [0.7, 0.7, 0.7, 1], "metallicFactor": 0}, "extensions": {"KHR_materials_specular": {"specularFactor": 0}}},
                          vertices=((-9, -9, 0), (9, -9, 0), (0, 9, 0)))
                document = json.loads(self.scene.read_text())
                document["extensionsUsed"] = ["KHR_lights_punctual", "KHR_materials_specular"]
                document["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "spot", "intensity": 2 * 683, "spot": {"innerConeAngle": inner, "outerConeAngle": outer}}]}}
                document["nodes"].append({"translation": [0.3, 0.2, 1.5], "extensions": {"KHR_lights_punctual": {"light": 0}}})
                document["scenes"][0]["nodes"].append(2)
                self.scene.write_text(json.dumps(document))
                compared = self.compared(self.scene)
                if os.environ.get("ALIDADE_FIGURES"):
                    print(f"spot {inner} {outer}: flip {compared['metrics']['flip']['mean']:.5f}", flush=True)
                self.assertLess(compared["metrics"]["flip"]["mean"], flip)
                self.assertEqual("rims of spot lights" in self.convert(self.scene), flip > 0.001)

    def test_what_is_unlit_needs_no_lamp(self):
        self.assert_alike(self.gltf({"pbrMetallicRoughness": {"baseColorFactor": [0.2, 0.5, 0.8, 1]}, "extensions": {"KHR_materials_unlit": {}}}))

    def test_alpha_is_the_factors_and_the_pictures(self):
        write(self.folder / "half é.png", png_bytes([[(0.9, 0.5, 0.1, 1.0), (0.1, 0.5, 0.9, 0.25)], [(0.3, 0.9, 0.3, 0.5), (0.9, 0.9, 0.9, 1.0)]]))
        for factor in (1, 0.5):
            self.assert_alike(self.gltf({"alphaMode": "BLEND", "doubleSided": True, "extensions": {"KHR_materials_unlit": {}}, "pbrMetallicRoughness":
                                         {"baseColorFactor": [1, 1, 1, factor], "baseColorTexture": {"index": 0}}}, "half%20é.png"))

    def test_what_is_approximated_is_told_by_material(self):
        said = self.convert(ASSETS / "materials.glb")
        self.assertRegex(said, r"lost: the GGX highlight of material 'plastic' \(1\); instead: lobes of Blinn's and Phong's")
        self.assertNotIn("'unlit'", said)

    def test_nothing_but_a_camera(self):
        self.scene.write_text('{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"camera": 0}], '
                              '"cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}]}')
        self.convert(self.scene)
        self.povray("out.pov", "theirs.ppm")

    def test_further_cameras_are_declared(self):
        document = json.loads(self.gltf({}).read_text())
        document["nodes"].append({"camera": 0, "translation": [0, 0, 40]})
        document["scenes"][0]["nodes"].append(2)
        self.scene.write_text(json.dumps(document))
        self.assertRegex(self.convert(self.scene), r"lost: further cameras \(1\); instead: declared, as Camera_2")
        near = self.povray("out.pov", "near.ppm")
        with open(self.folder / "out.pov", "a") as text:
            text.write("camera { Camera_2 }\n")
        far = self.povray("out.pov", "far.ppm", warned="Error: ")   # of the second camera
        covered = [sum(pixel != rows[0][0] for row in rows for pixel in row) for rows in (pixels(near), pixels(far))]
        self.assertGreater(covered[0], 20 * covered[1])
        self.assertGreater(covered[1], 0)

    def test_an_empty_scene(self):
        self.scene.write_text('{"asset": {"version": "2.0"}}')
        self.convert(self.scene)
        self.povray("out.pov", "theirs.ppm")


if __name__ == "__main__":
    if SANITIZED:
        raise SystemExit(77)
    unittest.main()
