# SPDX-License-Identifier: Apache-2.0
"""What POV-Ray has words for is drawn by it as by us: each case is a wall of one material that stands over a floor, beside a lamp.

`compare` says of each material what was lost and how far its pixels are apart. Where nothing is lost, FLIP is at most 0.02 and luminance the same to 1 %; here
the bounds are tighter. The floor shows the wall's shadow."""
import base64
import json
import os
import shutil
import struct
import unittest
import zlib

from pictures import changed, png_bytes, scene
from program import SANITIZED, InFolder, run

ALPHA_PICTURE = [[(0.9, 0.2 + 0.02 * x, 0.1, x / 31) for x in range(32)] for y in range(32)]
COLOURS = scene(32, 32)


def chunk(name, body):
    return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))


def with_chunk(png, name, body):
    """The PNG file with one more chunk behind its head."""
    return png[:33] + chunk(name, body) + png[33:]


def grey(level):
    return png_bytes([[(level / 255,)] * 4] * 4)


def lambert(**more):
    base = {"metallicFactor": 0, "roughnessFactor": 1, **more.pop("base", {})}
    return {"pbrMetallicRoughness": base, "extensions": {"KHR_materials_specular": {"specularFactor": 0}, **more.pop("extensions", {})}, **more}


def textured(**more):
    return lambert(base={"baseColorTexture": {"index": 0}, **more.pop("base", {})}, **more)


class Buffers:
    def __init__(self):
        self.bytes, self.views, self.accessors = b"", [], []

    def add(self, rows, kind="f", shape=None):
        data = b"".join(struct.pack(f"<{len(row)}{kind}", *row) for row in rows)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)})
        self.bytes += data
        accessor = {"bufferView": len(self.views) - 1, "componentType": {"f": 5126, "H": 5123}[kind], "count": len(rows), "type": shape or f"VEC{len(rows[0])}"}
        if len(rows[0]) == 3:
            accessor.update(min=[min(c) for c in zip(*rows)], max=[max(c) for c in zip(*rows)])
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def quad(buffers, corners, normal, material, **attributes):
    named = {"POSITION": buffers.add(corners), "NORMAL": buffers.add([normal] * 4), **{name: buffers.add(rows) for name, rows in attributes.items()}}
    return {"attributes": named, "indices": buffers.add([(i,) for i in (0, 1, 2, 0, 2, 3)], "H", "SCALAR"), "material": material}


UNIT_UVS = [(0, 1), (1, 1), (1, 0), (0, 0)]


def wall_scene(materials, picture=None, sampler=None, size=1.0, **attributes):
    """glTF: the floor, and a wall of each material. `size` makes all of it larger or smaller."""
    k, buffers = size, Buffers()
    attributes.setdefault("TEXCOORD_0", UNIT_UVS)
    floor = quad(buffers, [(-4 * k, 0, 4 * k), (4 * k, 0, 4 * k), (4 * k, 0, -4 * k), (-4 * k, 0, -4 * k)], (0, 1, 0), 0)
    walls, width = [], 2 / len(materials)
    for i in range(len(materials)):
        left, right = (-1 + i * width) * k, (-1 + (i + 1) * width) * k
        walls.append(quad(buffers, [(left, 0.1 * k, 0), (right, 0.1 * k, 0), (right, 2 * k, 0), (left, 2 * k, 0)], (0, 0, 1), 1 + i, **attributes))
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3]}],
        "extensionsUsed": sorted({"KHR_lights_punctual", "KHR_texture_transform", *(name for m in materials for name in m.get("extensions", {})), "KHR_materials_specular"}),
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 40 * k * k * 683}]}},
        "nodes": [{"mesh": 0}, {"mesh": 1}, {"camera": 0, "translation": [0, 2.2 * k, 5 * k], "rotation": [-0.13, 0, 0, 0.9915]},
                  {"translation": [2 * k, 3.5 * k, 2.5 * k], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.01 * k}}],
        "materials": [{"name": "floor", **lambert(base={"baseColorFactor": [0.6, 0.6, 0.55, 1]})}, *({"name": f"wall{i or ''}", "doubleSided": True, **m} for i, m in enumerate(materials))],
        "meshes": [{"primitives": [floor]}, {"primitives": walls}], "accessors": buffers.accessors, "bufferViews": buffers.views,
        "buffers": [{"byteLength": len(buffers.bytes), "uri": "data:application/octet-stream;base64," + base64.b64encode(buffers.bytes).decode()}]}
    if picture:
        document.update(images=[{"uri": "data:image/png;base64," + base64.b64encode(picture).decode()}], textures=[{"source": 0, **({"sampler": 0} if sampler else {})}])
    if sampler:
        document["samplers"] = [sampler]
    return json.dumps(document)


@unittest.skipUnless(shutil.which("povray"), "povray is not installed")
class PovExpressed(InFolder):
    def compared(self, text):
        self.scene.write_text(text)
        done = run("compare", self.scene, "--size", "120x90", "--json", "--cache", self.folder / "cache", cwd=self.folder)
        self.assertTrue(done.stdout, done.stderr)
        document = json.loads(done.stdout)
        self.assertIn("materials", document, done.stderr + done.stdout[:500])
        rows = {m["name"]: m for m in document["materials"]}
        if os.environ.get("ALIDADE_FIGURES"):
            for name, row in rows.items():
                print(f"{self._subtest.params.get('case') if self._subtest else '':24} {name:8} {row['pixels']:6} flip {row['flip']:.4f} {100 * row['brighter']:+.2f} % {row['lost']}", flush=True)
        return rows

    def assert_same(self, text, lost=(), flip=0.003, brighter=0.003):
        for name, row in self.compared(text).items():
            self.assertEqual(row["lost"], list(lost) if name.startswith("wall") else [], name)
            self.assertGreater(row["pixels"], 100)
            self.assertLess(row["flip"], flip, name)
            self.assertLess(abs(row["brighter"]), brighter, name)

    def assert_told(self, text, lost):
        self.assertIn(lost, self.compared(text)["wall"]["lost"])

    def test_files_of_pictures_that_pov_ray_reads_otherwise(self):
        """tRNS of grey makes it crash, of RGB it is not seen; of grey of 8 bits a step is lost."""
        greys = png_bytes([[((x * 8) / 255,) for x in range(32)] for _ in range(32)])
        files = {"grey with tRNS": with_chunk(greys, b"tRNS", struct.pack(">H", 80)),
                 "RGB with tRNS": with_chunk(png_bytes(changed(COLOURS, lambda x, y, p: (1, 1, 0) if x > 20 else p)), b"tRNS", struct.pack(">3H", 255, 255, 0)),
                 "grey": greys, "grey and alpha": png_bytes([[(x / 31, y / 31) for x in range(32)] for y in range(32)]),
                 "RGBA": png_bytes(ALPHA_PICTURE), "RGB of 16 bits": png_bytes(COLOURS, 16), "RGBA of 16 bits": png_bytes(ALPHA_PICTURE, 16),
                 "grey with tRNS of 16 bits": with_chunk(png_bytes([[((x * 8) / 255,) for x in range(32)] for _ in range(32)], 16), b"tRNS", struct.pack(">H", 80 * 257))}
        for case, file in files.items():
            for mode in ("OPAQUE", "MASK", "BLEND"):
                with self.subTest(case=f"{case} {mode}"):
                    self.assert_same(wall_scene([textured(alphaMode=mode)], file))

    def test_levels_of_grey(self):
        for level in (50, 60, 84, 100, 120, 150):
            with self.subTest(case=level):
                self.assert_same(wall_scene([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "extensions": {"KHR_materials_unlit": {}}}], grey(level)), flip=0.002, brighter=0.001)

    def test_pictures_that_are_clamped_or_mirrored(self):
        """By both axes, by one, filtered and not, moved by a transform, and within a picture that is cut out."""
        uvs = [(-0.75, 1.75), (1.6, 1.75), (1.6, -0.5), (-0.75, -0.5)]
        clamp, mirror, repeat = 33071, 33648, 10497
        turned = {"index": 0, "extensions": {"KHR_texture_transform": {"offset": [0.3, -0.2], "rotation": 0.4, "scale": [1.2, 0.8]}}}
        for wrap in ((clamp, clamp), (clamp, repeat), (repeat, mirror), (mirror, clamp), (mirror, mirror)):
            for picture, alpha, nearest, bits in ((COLOURS, {}, False, 8), (COLOURS, {}, True, 16), (ALPHA_PICTURE, {"alphaMode": "MASK"}, False, 8)):
                for texture in ({"index": 0}, turned):
                    with self.subTest(case=f"{wrap} {alpha} {len(texture)} {nearest} {bits}"):
                        sampler = {"wrapS": wrap[0], "wrapT": wrap[1], "magFilter": 9728 if nearest else 9729}
                        self.assert_same(wall_scene([textured(base={"baseColorTexture": texture}, **alpha)], png_bytes(picture, bits), sampler, TEXCOORD_0=uvs))

    def test_a_clamped_picture_that_is_looked_up_far_away_is_told(self):
        uvs = [(0, 100), (100, 100), (100, 0), (0, 0)]
        self.assert_told(wall_scene([textured()], png_bytes(COLOURS), {"wrapS": 33071, "wrapT": 33071}, TEXCOORD_0=uvs), "the clamping or mirroring of pictures at their edges")

    def test_what_glows_by_a_picture_throws_the_shadow_of_its_alpha(self):
        for alpha in (0.1, 0.4, 0.9):
            with self.subTest(case=alpha):
                glowing = lambert(base={"baseColorFactor": [0.8, 0.5, 0.3, alpha]}, alphaMode="BLEND", emissiveFactor=[0.6, 0.8, 1], emissiveTexture={"index": 0})
                self.assert_same(wall_scene([glowing], png_bytes(COLOURS)))

    def test_what_is_cut_out_glows(self):
        """Alone, and by a picture in another place than the one that cuts it out."""
        turned = {"index": 0, "extensions": {"KHR_texture_transform": {"offset": [0.3, -0.2], "rotation": 0.4, "scale": [1.2, 0.8]}}}
        for glow in ({}, {"emissiveTexture": {"index": 0}}, {"emissiveTexture": turned}):
            for base in ({"index": 0}, turned):
                for mode, factor in (("MASK", 1), ("MASK", 0.7), ("BLEND", 0.6)):
                    with self.subTest(case=f"{len(glow)} {mode} {factor} {len(base)}"):
                        cut = textured(base={"baseColorFactor": [1, 1, 1, factor], "baseColorTexture": base}, alphaMode=mode, emissiveFactor=[0.2, 0.4, 0.6], **glow)
                        self.assert_same(wall_scene([cut], png_bytes(ALPHA_PICTURE)))

    def test_a_black_colour_of_highlights_takes_no_light_away(self):
        """Blender writes so what is matte. What is left of the highlight at grazing angles is told."""
        black = lambert(extensions={"KHR_materials_specular": {"specularColorFactor": [0, 0, 0]}})
        for roughness, lost in ((0, ()), (1, ["the highlight at grazing angles"])):
            with self.subTest(case=roughness):
                self.assert_same(wall_scene([{**black, "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": roughness}}]), lost, flip=0.01)

    def test_what_pov_ray_cannot_is_told(self):
        mirror = {"pbrMetallicRoughness": {"roughnessFactor": 0, "baseColorTexture": {"index": 0}}}
        self.assert_told(wall_scene([mirror], png_bytes(COLOURS)), "a picture's mirror image at grazing angles")
        glass = {"pbrMetallicRoughness": {"roughnessFactor": 0, "metallicFactor": 0, "baseColorFactor": [1, 1, 1, 0.5]}, "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}}
        self.assert_told(wall_scene([{**glass, "alphaMode": "BLEND"}]), "the alpha of glass")

    def test_each_material_has_its_set_of_texture_coordinates(self):
        """Three materials of one mesh: of the first set, of the second, and by the second alone."""
        glowing = lambert(base={"baseColorFactor": [0.1, 0.1, 0.1, 1]}, emissiveFactor=[0.6, 0.8, 1], emissiveTexture={"index": 0, "texCoord": 1})
        materials = [textured(), textured(base={"baseColorTexture": {"index": 0, "texCoord": 1}}), glowing]
        second = [(0.2, 0.9), (0.1, 0.2), (0.9, 0.4), (0.8, 1.3)]
        self.assert_same(wall_scene(materials, png_bytes(COLOURS), TEXCOORD_0=UNIT_UVS, TEXCOORD_1=second))
        both = textured(emissiveFactor=[0.6, 0.8, 1], emissiveTexture={"index": 0, "texCoord": 1})
        self.assert_told(wall_scene([both], png_bytes(COLOURS), TEXCOORD_0=UNIT_UVS, TEXCOORD_1=second), "the texture coordinates of the picture of emission")

    def test_a_tinted_picture_keeps_its_steps(self):
        """Dark colours, lit brightly: a tinted picture of 8 bits had a FLIP of 0.06 and 0.01."""
        for factor, flip in (((0.5, 0.7, 0.2), 0.015), ((0.9, 0.5, 0.6), 0.003)):
            for mode in ("OPAQUE", "BLEND"):
                with self.subTest(case=f"{factor} {mode}"):
                    self.assert_same(wall_scene([textured(alphaMode=mode, base={"baseColorFactor": [*factor, 0.8]})], png_bytes([[p[:3] for p in row] for row in ALPHA_PICTURE])), flip=flip)

    def test_one_vertex_colour_tints_a_picture(self):
        for mode in ("OPAQUE", "MASK", "BLEND"):
            with self.subTest(case=mode):
                self.assert_same(wall_scene([textured(alphaMode=mode)], png_bytes(ALPHA_PICTURE), COLOR_0=[(0.5, 0.7, 0.9, 0.9)] * 4), ["faint mirror images under the vertex colours"])
        self.assert_told(wall_scene([textured()], png_bytes(COLOURS), COLOR_0=[(0.5, 0.7, 0.2, 1)] * 3 + [(1, 1, 1, 1)]), "the vertex colours")

    def test_vertex_colours_whose_alpha_cuts_are_told(self):
        told = "the border of what the alpha of vertex colours cuts out"
        for alphas, there in (((1, 1, 0.1, 0.1), True), ((1, 0.9, 0.6, 0.6), False)):
            lost = self.compared(wall_scene([lambert(alphaMode="MASK")], COLOR_0=[(1, 0.5, 0.2, a) for a in alphas]))["wall"]["lost"]
            self.assertEqual(told in lost, there)

    def test_what_pov_ray_misses_in_small_scenes_is_told(self):
        """The scene is eight times `size` wide."""
        told = "the light that POV-Ray misses in so small a scene"
        clear, opaque = lambert(alphaMode="BLEND", base={"baseColorFactor": [0.9, 0.2, 0.2, 0.5]}), lambert()
        for material, size, lost in ((clear, 0.013, []), (clear, 0.012, [told]), (opaque, 0.0026, []), (opaque, 0.0024, [told])):
            with self.subTest(case=f"{size} {len(lost)}"):
                wall = self.compared(wall_scene([material], size=size))["wall"]
                self.assertEqual(wall["lost"], lost)
                if not lost:
                    self.assertLess(wall["flip"], 0.02)
                    self.assertLess(abs(wall["brighter"]), 0.01)


if __name__ == "__main__":
    if SANITIZED:
        raise SystemExit(77)
    unittest.main()
