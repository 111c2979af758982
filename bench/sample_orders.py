#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Looks for the orders in which a light's and a lens's samples take Sobol's (0, 2)-sequence (tracer/sampler.cpp), and prints them.

    python3 bench/sample_orders.py        a minute or two; the same each time

An order is a triangular matrix over GF(2) that an index is multiplied with: aligned blocks of 2^k are permuted, so that the pair stays a (0, 2)-sequence. Columns are chosen one after the other, by a beam
search, so that 2^m points of the coordinates together are a (t, m, s)-net of small t: pixel and light for the light's; then pixel and lens, light and lens, and all six for the lens's.
"""
import random

DIGITS = 16
IDENTITY = [1 << row for row in range(DIGITS)]   # row r: which digits of the index (bit k: the k-th) add up to digit r of the coordinate, the most significant first
PASCAL = [sum(1 << k for k in range(r, DIGITS) if (k & r) == r) for r in range(DIGITS)]   # Sobol's second dimension


def product(a, b):
    rows = []
    for row in a:
        total = 0
        for k in range(DIGITS):
            if row >> k & 1:
                total ^= b[k]
        rows.append(total)
    return rows


def independent(vectors):
    basis = []
    for vector in vectors:
        for other in basis:
            vector = min(vector, vector ^ other)
        if not vector:
            return False
        basis.append(vector)
    return True


def shares(total, parts):
    """All ways to write `total` as a sum of `parts` numbers."""
    if parts == 1:
        yield (total,)
        return
    for first in range(total + 1):
        for rest in shares(total - first, parts - 1):
            yield (first, *rest)


def quality(coordinates, m):
    """The least t for which the first 2^m points are a (t, m, s)-net (Niederreiter 1987)."""
    mask = (1 << m) - 1
    return next(t for t in range(m + 1)
                if all(independent([rows[r] & mask for rows, n in zip(coordinates, cut) for r in range(n)]) for cut in shares(m - t, len(coordinates))))


def search(others, levels, width, tries):
    """Rows of the matrix with the least sum of weight * 2^t over m and the sets `others`, (coordinates, weight), together with its pair."""
    beam = [(0, [0] * DIGITS)]
    for k in range(levels):
        found = {}
        for cost, rows in beam:
            # The second column is 3: with four points two coordinates of each set go together, and those that cross do less harm than x with x.
            for above in [1] if k == 1 else range(1 << k) if 1 << k <= tries else [random.getrandbits(k) for _ in range(tries)]:
                column = above | 1 << k
                grown = tuple(row | (column >> r & 1) << k for r, row in enumerate(rows))
                if grown not in found:
                    pair = [list(grown), product(PASCAL, grown)]
                    found[grown] = cost + sum(weight * 2 ** quality(some + pair, k + 1) for some, weight in others)
        beam = sorted(((cost, list(rows)) for rows, cost in found.items()), key=lambda one: one[0])[:width]
    return [row | 1 << r for r, row in enumerate(beam[0][1])]


def main():
    random.seed(7)
    pixel = [IDENTITY, PASCAL]
    light = search([(pixel, 1)], DIGITS, 24, 60)
    light_pair = [light, product(PASCAL, light)]
    lens = search([(pixel, 2), (light_pair, 1), (pixel + light_pair, 0.5)], 14, 8, 30)
    lens_pair = [lens, product(PASCAL, lens)]
    for name, rows in (("light", light), ("lens", lens)):
        print(name, ", ".join(f"0x{sum((row >> k & 1) << r for r, row in enumerate(rows)):04x}" for k in range(DIGITS)))
    for name, coordinates in (("pixel and light", pixel + light_pair), ("pixel and lens", pixel + lens_pair), ("all", pixel + light_pair + lens_pair)):
        print(f"t of {name}, m = 1 to 12:", *(quality(coordinates, m) for m in range(1, 13)))


if __name__ == "__main__":
    main()
