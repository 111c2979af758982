#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes assets/scenes/motion.glb: a bar that two bones bend, a ball that two targets morph, and a spinning, jumping, growing box.

    python3 assets/make_motion.py assets/scenes/motion.glb

Two seconds of one animation, with every interpolation. The tests compare it with what Blender makes of it, so it keeps to what both mean alike: rotations
have a key every 22.5 degrees (Blender moves the numbers of a quaternion, not its angle), and the spline has tangents of 0 (Blender forgets them).
"""
import math, sys

from gltf_writer import Gltf
from surfaces import unit


class Moving(Gltf):
    """With skins, morph targets and one animation."""

    def __init__(self):
        super().__init__("assets/make_motion.py")
        self.doc.update(skins=[], animations=[{"name": "motion", "samplers": [], "channels": []}])

    def bytes(self, rows, **more):
        return self.accessor(bytes(x for row in rows for x in row), 5121, len(rows), "VEC4", **more)

    def body(self, name, color, surface, targets=(), **attributes):
        points, normals, triangles = surface
        primitive = {"material": self.material(name, color, 0, 0.6), "indices": self.indices(triangles),
                     "attributes": {"POSITION": self.floats(points, True), "NORMAL": self.floats(normals), **attributes}}
        if targets:
            primitive["targets"] = [{"POSITION": self.floats(p, True), "NORMAL": self.floats(n)} for p, n in targets]
        self.doc["meshes"].append({"name": name, "primitives": [primitive]})
        return len(self.doc["meshes"]) - 1

    def child(self, **fields):
        self.doc["nodes"].append(fields)
        return len(self.doc["nodes"]) - 1

    def animate(self, target, path, interpolation, times, rows):
        a = self.doc["animations"][0]
        a["samplers"].append({"input": self.floats([[t] for t in times], True), "output": self.floats(rows), "interpolation": interpolation})
        a["channels"].append({"sampler": len(a["samplers"]) - 1, "target": {"node": target, "path": path}})


def about(axis, degrees):
    half = math.radians(degrees) / 2
    return [*(math.sin(half) * x for x in axis), math.cos(half)]


def box(lo, hi, rings=1):
    """The six sides of a box, those along y cut into `rings`; sharp edges."""
    points, normals, triangles = [], [], []
    for axis in range(3):
        for side in (0, 1):
            across = [a for a in range(3) if a != axis]
            steps = [rings if a == 1 else 1 for a in across]
            first = len(points)
            for j in range(steps[1] + 1):
                for i in range(steps[0] + 1):
                    p = [0, 0, 0]
                    p[axis] = (lo, hi)[side][axis]
                    for a, k, n in ((across[0], i, steps[0]), (across[1], j, steps[1])):
                        p[a] = lo[a] + (hi[a] - lo[a]) * k / n
                    points.append(p)
                    normals.append([(2 * side - 1) * (a == axis) for a in range(3)])
            outwards = (side == 1) == (axis != 1)
            for j in range(steps[1]):
                for i in range(steps[0]):
                    a = first + j * (steps[0] + 1) + i
                    b, c, d = a + 1, a + steps[0] + 2, a + steps[0] + 1
                    triangles += [(a, b, c), (a, c, d)] if outwards else [(a, c, b), (a, d, c)]
    return points, normals, triangles


def ball(radius, nu=32, nv=16):
    normals = [[math.sin(math.pi * j / nv) * math.cos(2 * math.pi * i / nu), math.cos(math.pi * j / nv), math.sin(math.pi * j / nv) * math.sin(2 * math.pi * i / nu)]
               for j in range(nv + 1) for i in range(nu + 1)]
    at = lambda i, j: j * (nu + 1) + i
    triangles = [t for j in range(nv) for i in range(nu) for t in ((at(i, j), at(i + 1, j + 1), at(i, j + 1)), (at(i, j), at(i + 1, j), at(i + 1, j + 1)))
                 if len({tuple(round(x, 9) for x in normals[k]) for k in t}) == 3]
    return [[radius * x for x in n] for n in normals], normals, triangles


def bar(g):
    points, normals, triangles = box((-0.25, 0, -0.2), (0.25, 3, 0.2), 24)
    upper = [round(255 * min(max(y - 1, 0), 1)) for _, y, _ in points]   # the middle third goes with both bones
    body = g.body("bar", (0.8, 0.3, 0.2), (points, normals, triangles), JOINTS_0=g.bytes([[0, 1, 0, 0]] * len(points)),
                  WEIGHTS_0=g.bytes([[255 - w, w, 0, 0] for w in upper], normalized=True))
    tip = g.child(name="upper bone", translation=[0, 1.5, 0])
    foot = g.child(name="lower bone", children=[tip])
    bind = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, y, 0, 1] for y in (0, -1.5)]
    g.doc["skins"].append({"joints": [foot, tip], "inverseBindMatrices": g.floats(bind)})
    # The mesh's own place says nothing: bones move it.
    g.node(name="skeleton", translation=[-2.3, -1.5, 0], children=[foot, g.child(name="bar", mesh=body, skin=0, translation=[9, 9, 9])])
    g.animate(foot, "rotation", "LINEAR", [0, 1, 2], [about((0, 0, 1), a) for a in (0, 11.25, -11.25)])
    g.animate(tip, "rotation", "LINEAR", [k / 2 for k in range(5)], [about((0, 0, 1), 22.5 * k) for k in range(5)])


def morphing_ball(g):
    points, normals, triangles = ball(0.9)
    def target(point, normal):
        return [[q - x for q, x in zip(point(p), p)] for p in points], [[q - x for q, x in zip(unit(normal(n)), n)] for n in normals]
    flat = target(lambda p: (1.3 * p[0], 0.4 * p[1], 1.3 * p[2]), lambda n: (n[0] / 1.3, n[1] / 0.4, n[2] / 1.3))
    lean = target(lambda p: (p[0] + 0.5 * p[1], p[1], p[2]), lambda n: (n[0], n[1] - 0.5 * n[0], n[2]))
    body = g.body("ball", (0.2, 0.6, 0.3), (points, normals, triangles), (flat, lean))
    at = g.node(name="ball", mesh=body, translation=[0.1, 0, 0], weights=[0, 0])
    g.animate(at, "weights", "LINEAR", [0, 1, 2], [[w] for pair in ((0, 0), (1, 0), (0.25, 1)) for w in pair])


def spinner(g):
    body = g.body("spinner", (0.2, 0.3, 0.8), box((-0.9, -0.25, -0.15), (0.9, 0.25, 0.15)))
    at = g.node(name="spinner", mesh=body, translation=[2.4, -1, 0])
    g.animate(at, "rotation", "LINEAR", [k / 4 for k in range(9)], [about(unit((0.2, 0.1, 1)), 22.5 * k) for k in range(9)])
    flat = [0, 0, 0]
    g.animate(at, "translation", "CUBICSPLINE", [0, 1.25, 2], [r for y in (-1, 1.2, 0) for r in (flat, [2.4, y, 0], flat)])
    g.animate(at, "scale", "STEP", [0, 0.75, 1.5], [[1, 1, 1], [0.6, 1.5, 1], [1.2, 0.7, 1]])


def main(path):
    g = Moving()
    bar(g), morphing_ball(g), spinner(g)
    g.light("sun", "directional", [1, 1, 1], 3, rotation=about(unit((-1, 0.6, 0)), 50))
    g.camera("camera", (0, 0.2, 10), (0, 0.2, 0), perspective={"yfov": 0.6, "aspectRatio": 4 / 3, "znear": 0.1, "zfar": 100})
    g.write(path)


if __name__ == "__main__":
    main(sys.argv[1])
