# SPDX-License-Identifier: Apache-2.0
"""`alidade compare --against cycles`: Blender's picture beside ours, and both beside what is known in closed form."""
import base64
import json
import math
import os
import shutil
import struct
import sys
import unittest

from program import InFolder, run

SIZE = (96, 72)


def plate(light, camera=None, material=None, **more):
    """A square of 4 x 4 at y = 0, seen from straight above, under one light."""
    data = struct.pack("<12f6H", -2, 0, -2, 2, 0, -2, 2, 0, 2, -2, 0, 2, 0, 2, 1, 0, 3, 2)
    lambert = {"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.5, 0.2, 1], "metallicFactor": 0, "roughnessFactor": 1},
               "extensions": {"KHR_materials_specular": {"specularFactor": 0, "specularColorFactor": [0, 0, 0]}}}
    down = [-math.sqrt(0.5), 0, 0, math.sqrt(0.5)]
    return {
        "asset": {"version": "2.0", "generator": "Alidade"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
        "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_specular"],
        "extensions": {"KHR_lights_punctual": {"lights": [light]}},
        "nodes": [{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0.2, 1.5, -0.3], "rotation": down},
                  {"camera": 0, "translation": [0, 3, 0], "rotation": down}],
        "cameras": [camera or {"type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1}}],
        "materials": [material or lambert],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-2, 0, -2], "max": [2, 0, 2]},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}], **more}


def without_light():
    scene = plate({"type": "point"})
    scene["scenes"][0]["nodes"] = [0, 2]
    return scene


POINT = {"type": "point", "intensity": 683 * 6, "color": [1, 0.7, 0.4]}
SPOT = {"type": "spot", "intensity": 683 * 6, "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}}
SUN = {"type": "directional", "intensity": 683 * 2}


class CompareWithCycles(InFolder):
    def compare(self, scene, *words, **keywords):
        (self.folder / "plate.gltf").write_text(json.dumps(scene))
        return run("compare", "plate.gltf", "--against", "cycles", "--cache", self.folder / "cache", "--size", "{}x{}".format(*SIZE), *words, cwd=self.folder, **keywords)

    def document(self, scene, *words):
        said = self.compare(scene, *words, "--json")
        self.assertTrue(said.stdout, said.stderr)
        return json.loads(said.stdout)

    def assert_equal_light(self, scene, *words):
        told = self.document(scene, *words)
        self.assertEqual(told["values"], "linear")
        self.assertLess(told["metrics"]["flip"]["mean"], 0.005, told["metrics"])
        bias = told["metrics"]["bias"]
        for channel in "RGB":
            self.assertLess(abs(bias[channel]), 0.001, bias)
        return told

    def test_lamberts_plate_under_each_kind_of_light(self):
        for light in (POINT, SPOT, SUN):
            with self.subTest(light["type"]):
                self.assert_equal_light(plate(light))

    def test_the_plate_is_as_bright_as_lambert_says(self):
        """Albedo / pi, times I cos / d^2: the brightest point is below the light, 1.5 away."""
        told = self.document(plate({"type": "point", "intensity": 683 * 6}), "--require", "max_abs<0.01")
        self.assertEqual(told["verdict"], "pass", told["reason"])
        rendered = run("render", "plate.gltf", "-o", "ours.pfm", "--size", "{}x{}".format(*SIZE), cwd=self.folder)
        self.assertEqual(rendered.returncode, 0, rendered.stderr)
        data = (self.folder / "ours.pfm").read_bytes().split(b"\n", 3)[3]
        brightest = max(struct.unpack(f"<{len(data) // 4}f", data)[::3])
        self.assertAlmostEqual(brightest, 0.8 / math.pi * 6 / 1.5**2, delta=0.002)

    def test_light_and_camera_that_we_add_are_cycles_too(self):
        self.assert_equal_light(without_light())
        scene = plate(POINT)
        scene["scenes"][0]["nodes"] = [0, 1]   # no camera: one that frames everything
        self.assert_equal_light(scene, "--spp", "64")

    def test_cameras(self):
        self.assert_equal_light(plate(POINT, {"type": "orthographic", "orthographic": {"xmag": 1.5, "ymag": 1, "znear": 0.1, "zfar": 10}}))
        self.assert_equal_light(plate(POINT, {"type": "perspective", "perspective": {"yfov": 0.6, "aspectRatio": 2.5, "znear": 0.1}}))

    def test_noise_is_measured_in_both(self):
        told = self.document(plate(POINT), "--noise=9", "--spp", "4")
        self.assertEqual((told["verdict"], told["noise"]["reference_noise"], told["noise"]["reference_seeds"]), ("pass", "measured", 9), told["noise"])
        kept = next(path for path in (self.folder / "cache").glob("*.seconds"))
        brighter = self.document(plate({**POINT, "intensity": POINT["intensity"] * 1.05}), "--noise=9", "--spp", "4")
        self.assertEqual(brighter["verdict"], "pass", brighter["noise"])
        other = next(path for path in (self.folder / "cache").glob("*.seconds") if path != kept)
        for seed in ["", *(f"-{i}" for i in range(1, 9))]:   # another scene's pictures in the place of this one's
            shutil.copy(other.with_name(other.stem + seed + ".exr"), kept.with_name(kept.stem + seed + ".exr"))
        wrong = self.document(plate(POINT), "--noise=9", "--spp", "4")
        self.assertTrue(wrong["reference_render"]["from_cache"])
        self.assertEqual((wrong["verdict"], wrong["exit_code"]), ("fail", 2))
        self.assertGreater(wrong["noise"]["share"], 0.5)

    def test_the_reference_is_kept_by_what_is_in_it(self):
        self.assertFalse(self.document(plate(POINT), "--spp", "1")["reference_render"]["from_cache"])
        self.assertTrue(self.document(plate(POINT), "--spp", "1")["reference_render"]["from_cache"])
        self.assertFalse(self.document(plate(POINT), "--spp", "2")["reference_render"]["from_cache"])
        self.assertFalse(self.document(plate({**POINT, "intensity": 1}), "--spp", "1")["reference_render"]["from_cache"])

    def test_a_list(self):
        (self.folder / "plate.gltf").write_text(json.dumps(plate(POINT)))
        (self.folder / "list.csv").write_text("path\nplate.gltf\nabsent.glb\n")
        said = run("compare", "--corpus", "list.csv", "--out", "out", "--against", "cycles", "--cache", self.folder / "cache", "--size", "32x24", cwd=self.folder)
        self.assertEqual(said.returncode, 2, said.stderr)
        self.assertRegex(said.stdout, r"exact +pass +plate.gltf")
        self.assertIn("Cycles", (self.folder / "out/report.html").read_text())

    def test_what_cannot_be_compared(self):
        said = self.compare(plate(POINT), "--spp", "1000000", "--timeout", "1")
        self.assertEqual(said.returncode, 2)
        self.assertIn("no picture in 1 s", said.stderr)
        (self.folder / "bin").mkdir()
        said = self.compare(plate(POINT), env={**os.environ, "PATH": str(self.folder / "bin")})
        self.assertEqual(said.returncode, 4)
        self.assertIn("package is blender", said.stderr)
        (self.folder / "fish.pov").write_text("camera { fisheye angle 180 } sphere { z, 0.5 }\n")
        said = run("compare", "fish.pov", "--against", "cycles", "--cache", self.folder / "cache", cwd=self.folder)
        self.assertEqual(said.returncode, 2)
        self.assertIn("perspective and orthographic cameras only", said.stderr)


if __name__ == "__main__":
    if not shutil.which("blender"):
        print("skipped: blender is not installed")
        sys.exit(77)
    unittest.main()
