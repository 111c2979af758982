# SPDX-License-Identifier: Apache-2.0
"""Surfaces as (points, normals, texture coordinates, triangles), and the little vector algebra that they need."""
import math


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
    triangles = [t for t in triangles if len({points[i] for i in t}) == 3]   # at a pole every second one has no area
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
            if r0: triangles.append((a, a + 2, a + 1))
            if r1: triangles.append((a + 1, a + 2, a + 3))
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


def look_at(eye, target):
    """The quaternion that turns -z from `eye` to `target`."""
    z = unit(sub(eye, target))
    x = unit(cross((0, 1, 0), z))
    y = cross(z, x)
    m = [[x[k], y[k], z[k]] for k in range(3)]
    w = math.sqrt(max(0, 1 + m[0][0] + m[1][1] + m[2][2])) / 2
    return [(m[2][1] - m[1][2]) / (4 * w), (m[0][2] - m[2][0]) / (4 * w), (m[1][0] - m[0][1]) / (4 * w), w]
