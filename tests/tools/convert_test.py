# SPDX-License-Identifier: Apache-2.0
"""`alidade convert`: the files it leaves, what it says is lost, and what it refuses."""
import json
import unittest

from program import InFolder, run


class Convert(InFolder):
    def convert(self, *words):
        return run("convert", *words, cwd=self.folder)

    def test_every_format_and_back(self):
        listed = json.loads(run("info", "--features", "--json").stdout)["exporters"]
        for ending in (ending for row in listed for ending in row["extensions"].split()):
            said = self.convert(self.scene, f"first{ending}")
            self.assertEqual(said.returncode, 0, said.stderr)
            self.assertEqual(said.stdout, "")
            said = self.convert(f"first{ending}", f"again{ending}")
            self.assertEqual(said.returncode, 0, said.stderr)

    def test_what_is_lost(self):
        said = self.convert(self.scene, "out.ply", "--json")
        self.assertRegex(said.stderr, r"out\.ply: lost: lights \(1\)\n")
        told = json.loads(said.stdout)
        self.assertEqual(told["exporter"], "ply")
        self.assertEqual(told["files"], ["out.ply"])
        self.assertIn({"what": "lights", "count": 1, "instead": ""}, told["lost"])

    def test_what_is_no_mesh_becomes_one(self):
        (self.folder / "solid.pov").write_text("#version 3.7;\ncamera { location -5*z } light_source { -9*z, 1 }\n"
                                               "difference { box { -1, 1 } sphere { <1, 1, 1>, 1 } pigment { rgb 0.5 } } sphere { 3*x, 1 }\n")
        for ending in (".glb", ".obj", ".ply"):
            coarse, fine = (json.loads(self.convert("solid.pov", f"{name}{ending}", "--segments", str(n), "--json").stdout) for name, n in (("coarse", 16), ("fine", 64)))
            self.assertIn({"what": "solids (intersections, differences, merges, clips)", "count": 1, "instead": "meshes of 16 cells along their longest side"}, coarse["lost"])
            self.assertIn({"what": "spheres, planes, boxes and other closed forms", "count": 1, "instead": "meshes of 64 segments a circle"}, fine["lost"])
            triangles = [json.loads(run("info", f"{name}{ending}", "--json", cwd=self.folder).stdout)["compiled"]["triangles"] for name in ("coarse", "fine")]
            self.assertGreater(triangles[0], 16 * 16)
            self.assertGreater(triangles[1], 10 * triangles[0])
        self.assertEqual(self.convert("solid.pov", "out.glb", "--segments", "2").returncode, 64)
        self.assertEqual(json.loads(self.convert("solid.pov", "out.pov", "--json").stdout)["lost"], [], "POV-Ray has them all")

    def test_the_files_are_listed(self):
        told = json.loads(self.convert(self.scene, "out.gltf", "--json").stdout)
        self.assertEqual(told["files"], ["out.gltf", "out.bin"])
        self.assertEqual({path.name for path in self.folder.glob("out*")}, set(told["files"]))

    def test_an_unknown_ending_is_a_usage_error(self):
        said = self.convert(self.scene, "out.fbx")
        self.assertEqual(said.returncode, 64)
        self.assertIn(".gltf .glb .obj .ply", said.stderr)

    def test_the_input_is_never_overwritten(self):
        before = (self.folder / self.scene).read_bytes()
        said = self.convert(self.scene, self.scene)
        self.assertEqual(said.returncode, 1)
        self.assertIn("not overwritten", said.stderr)
        self.assertEqual((self.folder / self.scene).read_bytes(), before)

    def test_a_folder_that_is_not_there(self):
        self.assertEqual(self.convert(self.scene, "nowhere/out.glb").returncode, 1)


if __name__ == "__main__":
    unittest.main()
