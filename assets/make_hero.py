#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes assets/scenes/hero.glb: an alidade on its plane table, with a mirror ball, a glass ball and a torus knot.

    python3 assets/make_hero.py assets/scenes/hero.glb

Plain glTF 2.0 with KHR_lights_punctual and KHR_materials_transmission; the table's chequered cloth is a PNG made here.
"""
import math, sys

from gltf_writer import Gltf, png
from surfaces import boxes, grid, knot, lathe, look_at, sphere


def cloth(x, y):
    grain = ((x * 131 + y * 71 + (x * y) % 17 * 29) % 23) - 11
    line = x % 64 < 2 or y % 64 < 2
    base = (92, 52, 40) if line else (196, 178, 148) if (x // 64 + y // 64) % 2 else (170, 150, 120)
    return tuple(max(0, min(255, c + grain // 3)) for c in base)


def main(path):
    g = Gltf("assets/make_hero.py")
    cloth_texture = g.texture(png(256, 256, cloth))
    table = g.material("cloth", (1, 1, 1), 0, 0.8, texture=cloth_texture)
    brass, copper = g.material("brass", (0.89, 0.69, 0.30), 1, 0.22), g.material("copper", (0.93, 0.50, 0.34), 1, 0.12)
    chrome, glass = g.material("chrome", (0.92, 0.93, 0.95), 1, 0.0), g.material("glass", (0.96, 1.0, 0.98), 0, 0.0, extensions={"transmission": {"transmissionFactor": 1}})
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
    g.camera("view", eye, target, perspective={"yfov": 0.52, "aspectRatio": 16 / 9, "znear": 0.1})
    g.light("sun", "directional", [1.0, 0.93, 0.82], 2.6, rotation=look_at((-3, 5.5, 2.2), (0, 0, 0)))
    g.light("lamp", "point", [0.75, 0.85, 1.0], 26, translation=[4.5, 5.0, 4.0])
    g.write(path)


main(sys.argv[1])
