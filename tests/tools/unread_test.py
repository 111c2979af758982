# SPDX-License-Identifier: Apache-2.0
"""What a scene does not show is not read: files of textures and meshes that no shown node uses are not opened. The kernel is asked (strace), not the program."""
import hashlib
import json
import re
import shutil
import struct
import subprocess
import unittest

from pictures import png_bytes
from program import PROGRAM, SANITIZED, InFolder, run

POSITIONS = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0)


def mesh(number, material, **more):
    return {"primitives": [{"attributes": {"POSITION": number}, "material": material, **more}]}


def gltf(**more):
    """Of three meshes, each in a buffer of its own, the first is shown, the second belongs to another scene, the third to a hidden node. Materials alike."""
    names = ["shown", "other", "hidden"]
    return {
        "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_node_visibility"], "scene": 0, "scenes": [{"nodes": [0, 2]}, {"nodes": [1]}],
        "nodes": [{"mesh": 0}, {"mesh": 1}, {"mesh": 2, "extensions": {"KHR_node_visibility": {"visible": False}}}],
        "meshes": [mesh(i, i) for i in range(3)],
        "accessors": [{"bufferView": i, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]} for i in range(3)],
        "bufferViews": [{"buffer": i, "byteLength": len(POSITIONS)} for i in range(3)],
        "buffers": [{"byteLength": len(POSITIONS), "uri": name + ".bin"} for name in names],
        "materials": [{"name": name, "pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i, name in enumerate(names)],
        "textures": [{"source": i} for i in range(3)], "images": [{"uri": name + ".png"} for name in names], **more,
    }


class Unread(InFolder):
    def setUp(self):
        super().setUp()
        for name in ("shown", "other", "hidden"):
            (self.folder / f"{name}.bin").write_bytes(POSITIONS)
            (self.folder / f"{name}.png").write_bytes(png_bytes([[(1, 0.5, 0.25)] * 4] * 4))
        (self.folder / "three.gltf").write_text(json.dumps(gltf()))

    def render(self, scene, *words):
        said = run("render", scene, "--size", "16x12", "--spp", 1, "-o", "out.pfm", *words, cwd=self.folder)
        self.assertEqual(said.returncode, 0, said)
        return hashlib.sha256((self.folder / "out.pfm").read_bytes()).hexdigest()

    def opened(self, *words):
        """The names of the files in the folder that were opened."""
        subprocess.run(["strace", "-f", "-qq", "-e", "trace=open,openat,openat2", "-o", "trace", PROGRAM, *map(str, words)], cwd=self.folder, check=True, capture_output=True)
        calls = (self.folder / "trace").read_text()
        self.assertIn("three.gltf" if "three.gltf" in words else "scene.pov", calls, "strace saw the scene itself")
        return {name for name in re.findall(r'"(?:[^"]*/)?([^"/]+\.(?:bin|png))"', calls)}

    @unittest.skipIf(shutil.which("strace") is None or SANITIZED, "needs strace")
    def test_of_gltf(self):
        self.assertEqual(self.opened("render", "three.gltf", "--size", "16x12", "-o", "out.pfm"), {"shown.bin", "shown.png"})
        self.assertEqual(self.opened("tradeoff", "three.gltf", "--size", "8x6", "--vary", "spp=1,2", "--reference", "self:4", "--repeat", 1), {"shown.bin", "shown.png"})

    @unittest.skipIf(shutil.which("strace") is None or SANITIZED, "needs strace")
    def test_of_pov(self):
        picture = lambda name: f'texture {{ pigment {{ image_map {{ png "{name}.png" }} }} }}'
        (self.folder / "scene.pov").write_text(f"#declare Unused = {picture('other')};\ncamera {{ location -4*z look_at 0 }} light_source {{ -9*z, 1 }}\nsphere {{ 0, 1 {picture('shown')} }}\n")
        self.assertEqual(self.opened("render", "scene.pov", "--size", "16x12", "-o", "out.pfm"), {"shown.png"})

    def test_what_is_not_read_may_be_missing(self):
        whole = self.render("three.gltf")
        for name in ("other", "hidden"):
            (self.folder / f"{name}.bin").unlink()
        self.assertEqual(self.render("three.gltf"), whole)
        said = run("info", "three.gltf", cwd=self.folder)
        self.assertIn("cannot read", said.stderr, "who asks for the whole file is told")

    def test_info_says_what_was_left_out_and_why(self):
        document = gltf()
        document["materials"][0]["occlusionTexture"] = {"index": 3}
        document["textures"].append({"source": 3})
        document["images"] += [{"uri": "ao.png"}, {"uri": "nobody.png"}]
        for name in ("ao", "nobody"):
            (self.folder / f"{name}.png").write_bytes(png_bytes([[(1, 1, 1)]]))
        (self.folder / "four.gltf").write_text(json.dumps(document))
        told = lambda rows: {(row["what"], row["name"].split("/")[-1]): row["why"] for row in rows}
        said = json.loads(run("info", "four.gltf", "--json", cwd=self.folder).stdout)
        self.assertEqual(told(said["decoded"]), {("image", "shown.png"): "material 'shown' reads it"})
        left = told(said["left out"])
        for row, why in {("mesh", "number 1"): "its nodes are hidden, or not of this scene", ("material", "other"): "no surface that is shown has it",
                         ("image", "hidden.png"): "no surface that is shown has material 'hidden'", ("image", "nobody.png"): "nothing reads it",
                         ("image", "ao.png"): "only the occlusion of material 'shown' is in it, which a ray tracer finds itself",
                         ("feature", "transmission"): "nothing needs it: the kernel has no code for it",
                         ("structure", "instances that let light through"): "there are none: a shadow ray asks whether there is a hit, not which"}.items():
            self.assertEqual(left.get(row), why, row)
        self.assertNotIn(("feature", "textures"), left)
        self.assertNotIn(("structure", "number 0"), left)
        lazy = json.loads(run("info", "four.gltf", "--lazy", "--full-kernel", "--json", cwd=self.folder).stdout)
        self.assertEqual(told(lazy["left out"])["structure", "number 0"], "it is built when a ray enters its box (--lazy)")
        self.assertEqual(lazy["compiled"]["structures_waiting"], 1)
        self.assertEqual([row for row in lazy["left out"] if row["what"] == "feature"], [])
        self.assertIn("left out:\n", run("info", "four.gltf", cwd=self.folder).stdout)

    def test_one_buffer_for_all_is_read(self):
        views = [{"buffer": 0, "byteOffset": i * len(POSITIONS), "byteLength": len(POSITIONS)} for i in range(3)]
        (self.folder / "all.bin").write_bytes(3 * POSITIONS)
        (self.folder / "one.gltf").write_text(json.dumps(gltf(buffers=[{"byteLength": 3 * len(POSITIONS), "uri": "all.bin"}], bufferViews=views)))
        self.assertEqual(self.render("one.gltf"), self.render("three.gltf"))

    def expect_unreadable(self, scene, missing):
        (self.folder / missing).rename(self.folder / "away")
        said = run("render", scene, "-o", "out.pfm", cwd=self.folder)
        (self.folder / "away").rename(self.folder / missing)
        self.assertEqual(said.returncode, 1, said)
        self.assertIn(f"cannot read \"{missing}\"", said.stderr)

    def test_what_else_leads_to_a_buffer_is_read(self):
        """An accessor that a hidden mesh shares with an animation of what is shown; without scenes, everything."""
        keys = struct.pack("<2f", 0, 1) + struct.pack("<6f", 0, 0, 0, 0.5, 0, 0)
        (self.folder / "hidden.bin").write_bytes(POSITIONS + keys)
        document = gltf()
        document["buffers"][2]["byteLength"] = len(POSITIONS + keys)
        document["bufferViews"] += [{"buffer": 2, "byteOffset": len(POSITIONS), "byteLength": 8}, {"buffer": 2, "byteOffset": len(POSITIONS) + 8, "byteLength": 24}]
        document["accessors"] += [{"bufferView": 3, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]}, {"bufferView": 4, "componentType": 5126, "count": 2, "type": "VEC3"}]
        document["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}], "samplers": [{"input": 3, "output": 4}]}]
        (self.folder / "moves.gltf").write_text(json.dumps(document))
        self.render("moves.gltf", "--time", 1)
        self.expect_unreadable("moves.gltf", "hidden.bin")
        document = gltf()
        for gone in ("scene", "scenes"):
            del document[gone]
        (self.folder / "all.gltf").write_text(json.dumps(document))
        self.expect_unreadable("all.gltf", "other.bin")


if __name__ == "__main__":
    unittest.main()
