#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes assets/scenes/hero.glb: an alidade on its plane table, with a mirror ball, a glass ball and a torus knot.

    python3 assets/make_hero.py assets/scenes/hero.glb

Plain glTF 2.0 with KHR_lights_punctual and KHR_materials_transmission; the table's chequered cloth is a PNG made here.
"""
import json, math, struct, sys, zlib


class Gltf:
    def __init__(self):
        self.blob, self.doc = bytearray(), {
            "asset": {"version": "2.0", "generator": "assets/make_hero.py"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
            "materials": [], "accessors": [], "bufferViews": [], "buffers": [], "images": [], "textures": [], "samplers": [{"wrapS": 10497, "wrapT": 10497}],
            "cameras": [], "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_transmission"], "extensions": {"KHR_lights_punctual": {"lights": []}}}

    def view(self, data):
        while len(self.blob) % 4:
            self.blob.append(0)
        self.doc["bufferViews"].append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data)})
        self.blob += data
        return len(self.doc["bufferViews"]) - 1

    def floats(self, rows, bounds=False):
        kind = {2: "VEC2", 3: "VEC3"}[len(rows[0])]
        rows = [struct.unpack(f"{len(r)}f", struct.pack(f"{len(r)}f", *r)) for r in rows]
        a = {"bufferView": self.view(b"".join(struct.pack(f"<{len(r)}f", *r) for r in rows)), "componentType": 5126, "count": len(rows), "type": kind}
        if bounds:
            a["min"], a["max"] = [min(c) for c in zip(*rows)], [max(c) for c in zip(*rows)]
        self.doc["accessors"].append(a)
        return len(self.doc["accessors"]) - 1

    def indices(self, triangles):
        flat = [i for t in triangles for i in t]
        self.doc["accessors"].append({"bufferView": self.view(struct.pack(f"<{len(flat)}H", *flat)), "componentType": 5123, "count": len(flat), "type": "SCALAR"})
        return len(self.doc["accessors"]) - 1

    def mesh(self, name, surface, material):
        points, normals, uvs, triangles = surface
        self.doc["meshes"].append({"name": name, "primitives": [{"material": material, "indices": self.indices(triangles), "attributes": {
            "POSITION": self.floats(points, True), "NORMAL": self.floats(normals), "TEXCOORD_0": self.floats(uvs)}}]})
        return len(self.doc["meshes"]) - 1

    def material(self, name, color, metallic, roughness, transmission=0, texture=None):
        m = {"name": name, "pbrMetallicRoughness": {"baseColorFactor": [*color, 1], "metallicFactor": metallic, "roughnessFactor": roughness}}
        if transmission:
            m["extensions"] = {"KHR_materials_transmission": {"transmissionFactor": transmission}}
        if texture is not None:
            m["pbrMetallicRoughness"]["baseColorTexture"] = {"index": texture}
        self.doc["materials"].append(m)
        return len(self.doc["materials"]) - 1

    def texture(self, png):
        self.doc["images"].append({"bufferView": self.view(png), "mimeType": "image/png"})
        self.doc["textures"].append({"source": len(self.doc["images"]) - 1, "sampler": 0})
        return len(self.doc["textures"]) - 1

    def node(self, **fields):
        self.doc["nodes"].append(fields)
        self.doc["scenes"][0]["nodes"].append(len(self.doc["nodes"]) - 1)

    def light(self, name, kind, color, intensity, **place):
        lights = self.doc["extensions"]["KHR_lights_punctual"]["lights"]
        lights.append({"name": name, "type": kind, "color": color, "intensity": intensity})
        self.node(name=name, extensions={"KHR_lights_punctual": {"light": len(lights) - 1}}, **place)

    def write(self, path):
        self.doc["buffers"] = [{"byteLength": len(self.blob)}]
        text = json.dumps(self.doc, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        blob = bytes(self.blob) + b"\0" * (-len(self.blob) % 4)
        with open(path, "wb") as f:
            f.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(blob)))
            f.write(struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(blob), 0x004E4942) + blob)


def sub(a, b): return tuple(x - y for x, y in zip(a, b))
def cross(a, b): return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def unit(a):
    n = math.sqrt(sum(x * x for x in a))
    return tuple(x / n for x in a)


def grid(f, nu, nv, flip=False):
    """The parametric surface f(u, v) on [0, 1]^2, with normals by differences."""
    def normal(u, v):
        e = 1e-4
        n = cross(sub(f(u + e, v), f(u - e, v)), sub(f(u, v + e), f(u, v - e)))
        return unit(tuple(-x for x in n) if flip else n)
    at = [(i / nu, j / nv) for j in range(nv + 1) for i in range(nu + 1)]
    quads = [(j * (nu + 1) + i, j * (nu + 1) + i + 1, (j + 1) * (nu + 1) + i + 1, (j + 1) * (nu + 1) + i) for j in range(nv) for i in range(nu)]
    triangles = [t for a, b, c, d in quads for t in ([(a, c, b), (a, d, c)] if flip else [(a, b, c), (a, c, d)])]
    return [f(*p) for p in at], [normal(*p) for p in at], at, triangles


def sphere(r, nu=64, nv=32):
    def f(u, v):
        t, p = math.pi * (0.002 + 0.996 * v), 2 * math.pi * u
        return (r * math.sin(t) * math.cos(p), r * math.cos(t), -r * math.sin(t) * math.sin(p))
    points, _, uvs, triangles = grid(f, nu, nv, True)
    # Closed at the poles and along the seam, so that light does not leak into the glass.
    exact = [(math.pi * v, 2 * math.pi * (u % 1)) for u, v in uvs]
    points = [(0, r * math.cos(t), 0) if t in (0, math.pi) else (r * math.sin(t) * math.cos(p), r * math.cos(t), -r * math.sin(t) * math.sin(p)) for t, p in exact]
    return points, [unit(p) for p in points], uvs, triangles


def knot(p, q, big, small, tube, nu=400, nv=20):
    def centre(u):
        a = 2 * math.pi * u
        r = big + small * math.cos(q * a)
        return (r * math.cos(p * a), small * math.sin(q * a), r * math.sin(p * a))
    def f(u, v):
        c, ahead = centre(u), centre(u + 1e-3)
        t = unit(sub(ahead, c))
        n = unit(cross(t, (0, 1, 0)))
        b = cross(t, n)
        a = 2 * math.pi * v
        return tuple(c[k] + tube * (math.cos(a) * n[k] + math.sin(a) * b[k]) for k in range(3))
    return grid(f, nu, nv, True)


def lathe(profile, n=96):
    """A polyline of (radius, height), turned about y, with sharp edges."""
    points, normals, uvs, triangles = [], [], [], []
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        nr, ny = unit((y0 - y1, r1 - r0, 0))[:2]
        base = len(points)
        for i in range(n + 1):
            c, s = math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)
            for r, y in ((r0, y0), (r1, y1)):
                points.append((r * c, y, r * s)), normals.append((nr * c, ny, nr * s)), uvs.append((i / n, y))
        for i in range(n):
            a = base + 2 * i
            if r0: triangles.append((a, a + 1, a + 2))
            if r1: triangles.append((a + 1, a + 3, a + 2))
    return points, normals, uvs, triangles


def boxes(list_of_boxes):
    points, normals, uvs, triangles = [], [], [], []
    for lo, hi in list_of_boxes:
        for axis in range(3):
            for side in (0, 1):
                u, v = (axis + 1) % 3, (axis + 2) % 3
                base, n = len(points), [0, 0, 0]
                n[axis] = 1 if side else -1
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p = [0, 0, 0]
                    p[axis], p[u], p[v] = (hi if side else lo)[axis], (hi if a else lo)[u], (hi if b else lo)[v]
                    points.append(tuple(p)), normals.append(tuple(n)), uvs.append((a, b))
                triangles += [(base, base + 1, base + 2), (base, base + 2, base + 3)] if side else [(base, base + 2, base + 1), (base, base + 3, base + 2)]
    return points, normals, uvs, triangles


def png(width, height, pixel):
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in pixel(x, y)) for y in range(height))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def cloth(x, y):
    grain = ((x * 131 + y * 71 + (x * y) % 17 * 29) % 23) - 11
    line = x % 64 < 2 or y % 64 < 2
    base = (92, 52, 40) if line else (196, 178, 148) if (x // 64 + y // 64) % 2 else (170, 150, 120)
    return tuple(max(0, min(255, c + grain // 3)) for c in base)


def look_at(eye, target):
    """The quaternion that turns -z from `eye` to `target`."""
    z = unit(sub(eye, target))
    x = unit(cross((0, 1, 0), z))
    y = cross(z, x)
    m = [[x[k], y[k], z[k]] for k in range(3)]
    w = math.sqrt(max(0, 1 + m[0][0] + m[1][1] + m[2][2])) / 2
    return [(m[2][1] - m[1][2]) / (4 * w), (m[0][2] - m[2][0]) / (4 * w), (m[1][0] - m[0][1]) / (4 * w), w]


def main(path):
    g = Gltf()
    cloth_texture = g.texture(png(256, 256, cloth))
    table = g.material("cloth", (1, 1, 1), 0, 0.8, texture=cloth_texture)
    brass, copper = g.material("brass", (0.89, 0.69, 0.30), 1, 0.22), g.material("copper", (0.93, 0.50, 0.34), 1, 0.12)
    chrome, glass = g.material("chrome", (0.92, 0.93, 0.95), 1, 0.0), g.material("glass", (0.96, 1.0, 0.98), 0, 0.0, 1)
    enamel, ivory = g.material("enamel", (0.55, 0.04, 0.05), 0, 0.15), g.material("ivory", (0.9, 0.86, 0.74), 0, 0.45)
    dark = g.material("ebony", (0.03, 0.025, 0.02), 0, 0.3)
    s = 14
    g.node(name="table", mesh=g.mesh("table", ([(-s, 0, -s), (-s, 0, s), (s, 0, s), (s, 0, -s)], [(0, 1, 0)] * 4, [(-3, -3), (-3, 3), (3, 3), (3, -3)], [(0, 1, 2), (0, 2, 3)]), table))
    g.node(name="base", mesh=g.mesh("base", lathe([(0, 0.34), (1.9, 0.34), (2.0, 0.26), (2.0, 0.06), (2.1, 0.0)]), ivory))
    ticks = []
    for k in range(72):
        a, r0 = 2 * math.pi * k / 72, 1.45 if k % 6 == 0 else 1.62
        ticks.append((a, r0))
    tick_mesh = {r0: g.mesh("tick", boxes([((r0, 0.339, -0.012), (1.8, 0.347, 0.012))]), dark) for r0 in (1.45, 1.62)}
    for a, r0 in ticks:
        g.node(name="tick", mesh=tick_mesh[r0], rotation=[0, math.sin(a / 2), 0, math.cos(a / 2)])
    rule = [((-2.5, 0.36, -0.16), (2.5, 0.46, 0.16))]
    for x in (-2.35, 2.35):   # two sight vanes with a slit
        rule += [((x - 0.04, 0.46, -0.30), (x + 0.04, 1.75, -0.05)), ((x - 0.04, 0.46, 0.05), (x + 0.04, 1.75, 0.30)),
                 ((x - 0.04, 1.55, -0.05), (x + 0.04, 1.75, 0.05)), ((x - 0.04, 0.46, -0.05), (x + 0.04, 0.72, 0.05))]
    turn = [0, math.sin(0.21), 0, math.cos(0.21)]
    g.node(name="rule", mesh=g.mesh("rule", boxes(rule), brass), rotation=turn)
    g.node(name="pivot", mesh=g.mesh("pivot", lathe([(0, 0.74), (0.14, 0.74), (0.2, 0.66), (0.2, 0.58), (0.34, 0.54), (0.34, 0.46)]), brass))
    ball = sphere(1.0)
    for name, material, at, r in (("mirror ball", chrome, (-2.1, 1.0, -2.6), 1.0), ("glass ball", glass, (1.75, 0.72, 2.05), 0.72), ("enamel ball", enamel, (3.5, 0.62, -0.9), 0.62)):
        g.node(name=name, mesh=g.mesh(name, ball, material), translation=at, scale=[r, r, r])
    g.node(name="knot", mesh=g.mesh("knot", knot(2, 3, 0.85, 0.36, 0.17), copper), translation=[1.5, 1.02, -2.9], rotation=[math.sin(0.55), 0, 0, math.cos(0.55)])
    eye, target = (-4.6, 3.5, 7.2), (0.25, 0.62, -0.2)
    g.doc["cameras"].append({"name": "view", "type": "perspective", "perspective": {"yfov": 0.52, "aspectRatio": 16 / 9, "znear": 0.1}})
    g.node(name="view", camera=0, translation=eye, rotation=look_at(eye, target))
    g.light("sun", "directional", [1.0, 0.93, 0.82], 2.6, rotation=look_at((-3, 5.5, 2.2), (0, 0, 0)))
    g.light("lamp", "point", [0.75, 0.85, 1.0], 26, translation=[4.5, 5.0, 4.0])
    g.write(path)


main(sys.argv[1])
