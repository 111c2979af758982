#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the scenes of assets/README.md into assets/scenes: materials.glb, foliage.glb, lens.glb, house.obj and .mtl, shell.ply, gear.stl, star.off.

    python3 assets/make_scenes.py assets/scenes
"""
import math, pathlib, random, struct, sys

from gltf_writer import Gltf, png
from surfaces import boxes, cross, grid, look_at, sphere, sub, unit

GENERATOR = "assets/make_scenes.py"


def tiles(light, dark, step=32):
    return lambda x, y: light if (x // step + y // step) % 2 else dark


def ground(g, size, repeat, png_file):
    """A square of 2 * size with a texture that repeats, by KHR_texture_transform."""
    texture = {"index": g.texture(png_file), "extensions": {"KHR_texture_transform": {"scale": [repeat, repeat], "rotation": 0.3}}}
    material = g.material("ground", (1, 1, 1), 0, 0.9, texture=texture)
    corners = [(-size, 0, -size), (-size, 0, size), (size, 0, size), (size, 0, -size)]
    g.node(name="ground", mesh=g.mesh("ground", (corners, [(0, 1, 0)] * 4, [(0, 0), (0, 1), (1, 1), (1, 0)], [(0, 1, 2), (0, 2, 3)]), material))


def materials(path):
    """A row of balls for each thing that a glTF surface can be."""
    g = Gltf(GENERATOR)
    ground(g, 12, 12, png(64, 64, tiles((205, 200, 190), (120, 118, 112))))
    ball = sphere(0.5)
    glass = {"transmission": {"transmissionFactor": 1}}
    rows = [
        [g.material(f"metal, roughness {r}", (0.95, 0.78, 0.42), 1, r) for r in (0, 0.15, 0.3, 0.5, 0.8)],
        [g.material(f"glass, ior {ior}", (1, 1, 1), 0, 0, extensions={**glass, "ior": {"ior": ior}}) for ior in (1.1, 1.3, 1.5, 1.8, 2.4)],
        [g.material("plastic", (0.1, 0.25, 0.7), 0, 0.3),
         g.material("no highlight", (0.1, 0.25, 0.7), 0, 0.3, extensions={"specular": {"specularFactor": 0}}),
         g.material("tinted glass", (0.5, 0.9, 0.6), 0, 0, extensions=glass),
         g.material("lamp", (0, 0, 0), 0, 1, emissiveFactor=[1, 0.6, 0.25], extensions={"emissive_strength": {"emissiveStrength": 3}}),
         g.material("unlit", (0.75, 0.2, 0.2), 0, 1, extensions={"unlit": {}})]]
    for j, row in enumerate(rows):
        for i, material in enumerate(row):
            g.node(name=f"ball {j} {i}", mesh=g.mesh(f"ball {j} {i}", ball, material), translation=[1.25 * (i - 2), 0.5, 1.5 * (j - 1)])
    g.camera("view", (0, 4.6, 8), (0, 0.3, 0), perspective={"yfov": 0.6, "aspectRatio": 4 / 3, "znear": 0.1})
    g.light("key", "directional", [1, 0.95, 0.88], 2.2, rotation=look_at((-3, 6, 4), (0, 0, 0)))
    g.light("spot", "spot", [0.8, 0.9, 1], 60, spot={"innerConeAngle": 0.2, "outerConeAngle": 0.45}, translation=[5, 6, 1], rotation=look_at((5, 6, 1), (0.5, 0, 0)))
    g.write(path)


def leaf(x, y):
    u, v = (x - 31.5) / 32, (63 - y) / 64
    width = 0.85 * math.sin(math.pi * min(1, v * 1.05)) * (1 - 0.35 * v)
    inside = abs(u) < width
    vein = abs(u) < 0.04 or abs((v * 9 + abs(u) * 4) % 1 - 0.5) < 0.06
    return (70, 120, 40, 255 * inside) if vein else (96, 160, 52, 255 * inside)


def foliage(path):
    """Leaves cut out of quads by an alpha mask, a pane of coloured glass by alpha blending, a pot in vertex colours: all of them cast the right shadows."""
    g, dice = Gltf(GENERATOR), random.Random(7)
    ground(g, 8, 10, png(64, 64, tiles((214, 206, 190), (190, 180, 160))))
    leaf_material = g.material("leaf", (1, 1, 1), 0, 0.6, texture=g.texture(png(64, 64, leaf)), alphaMode="MASK", alphaCutoff=0.5, doubleSided=True)
    quad = ([(-0.25, 0, 0), (0.25, 0, 0), (0.25, 1, 0), (-0.25, 1, 0)], [(0, 0, 1)] * 4, [(0, 1), (1, 1), (1, 0), (0, 0)], [(0, 1, 2), (0, 2, 3)])
    blade = g.mesh("leaf", quad, leaf_material)
    for k in range(60):
        turn, tilt, size = 2.399963 * k, 0.25 + 0.9 * dice.random(), 0.6 + 0.5 * dice.random()
        c, s, a, b = math.cos(turn / 2), math.sin(turn / 2), math.cos(tilt / 2), math.sin(tilt / 2)
        g.node(name="leaf", mesh=blade, translation=[0, 0.75, 0], rotation=[c * b, s * a, -s * b, c * a], scale=[size] * 3)   # turned about y after x
    pot = grid(lambda u, v: ((0.35 + 0.15 * v) * math.cos(2 * math.pi * u), 0.8 * v, (0.35 + 0.15 * v) * math.sin(2 * math.pi * u)), 48, 4, True)
    colors = [(0.75, 0.3 + 0.25 * v, 0.15 + 0.1 * math.sin(12 * math.pi * u) ** 2, 1) for u, v in pot[2]]
    g.node(name="pot", mesh=g.mesh("pot", pot, g.material("pot", (1, 1, 1), 0, 0.7, doubleSided=True), colors))
    for k, color in enumerate([(0.9, 0.2, 0.15), (0.95, 0.8, 0.2), (0.15, 0.4, 0.85)]):
        pane = g.mesh(f"pane {k}", boxes([((1.1, 0.05, -0.9 + 0.6 * k), (1.13, 1.6, -0.35 + 0.6 * k))]),
                      g.material(f"pane {k}", color, 0, 0.4, alpha=0.55, alphaMode="BLEND"))
        g.node(name=f"pane {k}", mesh=pane)
    g.camera("view", (2.6, 2.2, 5), (0.25, 0.85, 0), perspective={"yfov": 0.5, "aspectRatio": 4 / 3, "znear": 0.1})
    g.light("sun", "directional", [1, 0.96, 0.9], 3, rotation=look_at((4, 5, 2.5), (0, 0.6, 0)))
    g.write(path)


def lens(path):
    """Beads in a row from near to far, for --aperture and --focus; an orthographic camera is the second."""
    g = Gltf(GENERATOR)
    ground(g, 40, 60, png(64, 64, tiles((180, 186, 196), (98, 104, 116))))
    bead = sphere(0.4)
    for k in range(9):
        hue = [0.5 + 0.45 * math.cos(2 * math.pi * (k / 9 + s / 3)) for s in range(3)]
        g.node(name=f"bead {k}", mesh=g.mesh(f"bead {k}", bead, g.material(f"bead {k}", hue, 0, 0.25)), translation=[0.75 * (k - 3), 0.4, -1.6 * (k - 3)])
    g.camera("view", (-0.9, 1.5, 7), (0.2, 0.3, 0), perspective={"yfov": 0.5, "aspectRatio": 4 / 3, "znear": 0.1})
    g.camera("plan", (0, 20, 0.01), (0, 0, 0), orthographic={"xmag": 6, "ymag": 4.5, "znear": 0.1, "zfar": 100})
    g.light("sun", "directional", [1, 0.97, 0.92], 2.6, rotation=look_at((-4, 6, 5), (0, 0, 0)))
    g.write(path)


def house(folder):
    """OBJ as people write it: a concave gable, indices counted from the end, smoothing groups, a line that goes on, PBR fields and a texture in the MTL."""
    n, out = 24, ["# assets/make_scenes.py", "mtllib house.mtl", "o house"]
    gable = [(-2, 0), (-0.4, 0), (-0.4, 1.2), (0.4, 1.2), (0.4, 0), (2, 0), (2, 2), (0, 3.4), (-2, 2)]   # concave: the door is cut out
    for z in (1.5, -1.5):
        out += [f"v {x} {y} {z}" for x, y in gable] + [f"vt {x / 2} {y / 2}" for x, y in gable]
    out += ["usemtl brick", "s off", "f " + " ".join(f"{i}/{i}" for i in range(1, 10)), "f " + " ".join(f"{i}/{i}" for i in range(18, 9, -1))]
    for i, j in ((0, 8), (6, 5)):   # the side walls, then the roof
        a, b = i + 1, j + 1
        out += ["vt 0 0", "vt 1.5 0", "vt 1.5 1", "vt 0 1", f"f {a}/-4 {b}/-1 {b + 9}/-2 {a + 9}/-3"]
    out += ["usemtl slate", "f 9 8 17 18", "f 8 7 16 17", "o tower", "usemtl plaster", "s 1"]
    for y in (0, 3.6):
        out += [f"v {3.4 + 0.9 * math.cos(2 * math.pi * k / n):.6f} {y} {0.9 * math.sin(2 * math.pi * k / n):.6f}" for k in range(n)]
    for k in range(n):   # counted from the end: -2n is the first of the ring below
        a, b = k - 2 * n, (k + 1) % n - 2 * n
        out.append(f"f {a} {a + n} \\\n  {b + n} {b}")
    out += ["o spire", "usemtl copper", "s 2"]
    out += [f"v {3.4 + 1.1 * math.cos(2 * math.pi * k / n):.6f} 3.6 {1.1 * math.sin(2 * math.pi * k / n):.6f}" for k in range(n)] + ["v 3.4 5.6 0"]
    out += [f"f {k - n - 1} -1 {(k + 1) % n - n - 1}" for k in range(n)]
    out += ["o meadow", "usemtl meadow", "s off"]
    out += [f"v {x} 0 {z} {0.25 + 0.02 * (x + 4)} 0.45 0.12" for x, z in ((-4, -4), (-4, 4), (6, 4), (6, -4))] + ["f -4 -3 -2 -1"]
    (folder / "house.obj").write_text("\n".join(out) + "\n")
    (folder / "house.mtl").write_text("""# assets/make_scenes.py
newmtl brick
Kd 1 1 1
map_Kd -s 2 2 1 brick.png
Pr 0.9
newmtl slate
Kd 0.16 0.18 0.22
Pr 0.5
newmtl plaster
Kd 0.82 0.78 0.7
Pr 0.8
newmtl copper
Kd 0.72 0.42 0.3
Pm 1
Pr 0.25
newmtl meadow
Kd 1 1 1
Pr 1
""")

    def brick(x, y):
        x += 16 * (y // 16 % 2)
        return (200, 190, 175) if y % 16 < 2 or x % 32 < 2 else (150 + x // 32 % 3 * 12, 66 + y // 16 % 4 * 6, 48)
    (folder / "brick.png").write_bytes(png(128, 128, brick))


def shell(path):
    """A binary PLY with vertex colours: a conch."""
    def f(u, v):
        a, grow = 12 * math.pi * u, math.exp(2.2 * u) / 9
        b = 2 * math.pi * v
        r = grow * (1 + 0.75 * math.cos(b))
        return (r * math.cos(a), 1.8 - 2.2 * grow + 0.75 * grow * math.sin(b), r * math.sin(a))
    points, _, at, triangles = grid(f, 480, 40)
    rgb = [tuple(int(255 * c) for c in (0.95 - 0.35 * s, 0.82 - 0.45 * s, 0.65 - 0.45 * s)) for s in (math.sin(math.pi * (9 * u + 2 * v)) ** 6 for u, v in at)]
    head = f"ply\nformat binary_little_endian 1.0\ncomment assets/make_scenes.py\nelement vertex {len(points)}\n"
    head += "".join(f"property float {c}\n" for c in "xyz") + "".join(f"property uchar {c}\n" for c in ("red", "green", "blue"))
    head += f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    body = b"".join(struct.pack("<3f3B", *p, *c) for p, c in zip(points, rgb)) + b"".join(struct.pack("<B3i", 3, *t) for t in triangles)
    path.write_bytes(head.encode() + body)


def gear(path, teeth=18):
    """A binary STL: triangles without shared corners, as slicers write them."""
    rim = []
    for k in range(4 * teeth):
        r, a = (1.0, 0.82)[k % 4 >= 2], 2 * math.pi * (k + 0.5 * (k % 2)) / (4 * teeth)
        rim.append((r * math.cos(a), r * math.sin(a)))
    n, triangles = len(rim), []
    hole = [(0.3 * math.cos(2 * math.pi * k / n), 0.3 * math.sin(2 * math.pi * k / n)) for k in range(n)]
    for k in range(n):
        (ax, ay), (bx, by), (cx, cy), (dx, dy) = rim[k], rim[(k + 1) % n], hole[(k + 1) % n], hole[k]
        for z, order in ((0.15, 1), (-0.15, -1)):
            triangles += [[(ax, ay, z), (bx, by, z), (cx, cy, z)][::order], [(ax, ay, z), (cx, cy, z), (dx, dy, z)][::order]]
        for (px, py), (qx, qy) in (((ax, ay), (bx, by)), ((cx, cy), (dx, dy))):
            triangles += [[(px, py, -0.15), (qx, qy, -0.15), (qx, qy, 0.15)], [(px, py, -0.15), (qx, qy, 0.15), (px, py, 0.15)]]
    records = b"".join(struct.pack("<12fH", *unit(cross(sub(b, a), sub(c, a))), *a, *b, *c, 0) for a, b, c in triangles)
    path.write_bytes(b"assets/make_scenes.py".ljust(80, b"\0") + struct.pack("<I", len(triangles)) + records)


def star(path):
    """OFF with ten-sided faces, which are concave, and side walls."""
    ring = [((1, 0.42)[k % 2] * math.sin(math.pi * k / 5), (1, 0.42)[k % 2] * math.cos(math.pi * k / 5)) for k in range(10)]
    lines = ["OFF", "20 12 30"] + [f"{x:.6f} {y:.6f} {z}" for z in (0.12, -0.12) for x, y in ring]
    lines += ["10 " + " ".join(str(k) for k in range(9, -1, -1)), "10 " + " ".join(str(10 + k) for k in range(10))]
    lines += [f"4 {k} {(k + 1) % 10} {10 + (k + 1) % 10} {10 + k}" for k in range(10)]
    path.write_text("\n".join(lines) + "\n")


def main(folder):
    materials(folder / "materials.glb")
    foliage(folder / "foliage.glb")
    lens(folder / "lens.glb")
    house(folder)
    shell(folder / "shell.ply")
    gear(folder / "gear.stl")
    star(folder / "star.off")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
