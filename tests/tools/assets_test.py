# SPDX-License-Identifier: Apache-2.0
"""The scenes of assets/README.md and the README's tour: each command does its work and complains of nothing, and the scenes are what their scripts write."""
import filecmp
import json
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

from program import SANITIZED, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "assets" / "scenes"
PAGE = (ROOT / "assets" / "README.md").read_text()
COMMANDS = [shlex.split(line) for line in re.findall(r"`\./alidade (.*?)`", PAGE)]
TOUR = (ROOT / "README.md").read_text().split("## A tour of sixty seconds")[1].split("\n## ")[0]
TOUR_COMMANDS = [shlex.split(line) for line in re.findall(r"^    \./alidade (.*?)   .*$", TOUR, re.M)]
SMALL = {"--size": "64x48", "--spp": "1"}


def made_small(words):
    """The command with a small picture, and its files found from any folder."""
    words = [str(ROOT / word) if word.startswith("assets/") else word for word in words]
    if SANITIZED:
        words = [word.replace("..1e5", "..1e4") for word in words]
    for option, value in SMALL.items() if words[0] == "render" else ():
        if option in words:
            at = words.index(option)
            del words[at:at + 2]
        words += [option, value]
    return words


class Glb:
    def __init__(self, path):
        data = path.read_bytes()
        size = struct.unpack("<I", data[12:16])[0]
        self.document, self.bytes = json.loads(data[20:20 + size]), data[28 + size:]

    def values(self, index):
        """The rows of an accessor."""
        accessor = self.document["accessors"][index]
        view = self.document["bufferViews"][accessor["bufferView"]]
        width, code = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]], {5121: "B", 5123: "H", 5125: "I", 5126: "f"}[accessor["componentType"]]
        flat = struct.unpack_from(f"<{accessor['count'] * width}{code}", self.bytes, view.get("byteOffset", 0) + accessor.get("byteOffset", 0))
        return [flat[i:i + width] for i in range(0, len(flat), width)]


def wound_against_normals(glb, primitive):
    """How many triangles' corners go round the other way than their normals say."""
    points, normals = (glb.values(primitive["attributes"][name]) for name in ("POSITION", "NORMAL"))
    corners = [row[0] for row in glb.values(primitive["indices"])]
    count = 0
    for i in range(0, len(corners), 3):
        a, b, c = (points[k] for k in corners[i:i + 3])
        (ux, uy, uz), (vx, vy, vz) = ([y - x for x, y in zip(a, p)] for p in (b, c))
        across = (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)
        count += sum(n * sum(normals[k][j] for k in corners[i:i + 3]) for j, n in enumerate(across)) < 0
    return count


class Assets(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def test_every_command_runs(self):
        self.assertGreater(len(COMMANDS), 5)
        self.assertGreater(len(TOUR_COMMANDS), 5)
        for words in COMMANDS + TOUR_COMMANDS:
            if words[0] == "compare" and not shutil.which("blender" if "cycles" in words else "povray"):
                continue
            with self.subTest(" ".join(words)):
                done = run(*made_small(words), "--json", cwd=self.folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotIn("warning", done.stderr)
                said = json.loads(done.stdout)
                if words[0] == "render":
                    self.assertGreater(said["render"]["shadow_rays"], 0.01 * said["render"]["camera_rays"], "something is seen")

    def test_every_scene_has_a_command(self):
        named = {pathlib.Path(word).name for words in COMMANDS for word in words}
        parts = {".mtl", ".png"}   # of another file
        self.assertEqual([f.name for f in SCENES.iterdir() if f.suffix not in parts and f.name not in named], [])

    def test_meshes_are_wound_as_their_normals_say(self):
        meshes = 0
        for path in SCENES.glob("*.glb"):
            glb = Glb(path)
            for mesh in glb.document["meshes"]:
                for primitive in mesh["primitives"]:
                    if "NORMAL" in primitive["attributes"]:
                        meshes += 1
                        self.assertEqual(wound_against_normals(glb, primitive), 0, f"{path.name}: {mesh.get('name')}")
        self.assertGreater(meshes, 20)

    def test_the_scripts_write_them(self):
        for line in re.findall(r"^    python3 (.*)$", PAGE, re.M):
            script, target = line.split()
            subprocess.run([sys.executable, ROOT / script, self.folder / pathlib.Path(target).relative_to("assets/scenes")], check=True)
        for made in self.folder.iterdir():
            self.assertTrue(filecmp.cmp(made, SCENES / made.name, shallow=False), made.name)


if __name__ == "__main__":
    unittest.main()
