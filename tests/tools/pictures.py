# SPDX-License-Identifier: Apache-2.0
"""Pictures for tests, made and written without a library. A picture is rows of pixels, a pixel a tuple of numbers: 0 .. 1 as displayed (sRGB-encoded)
for PNG, linear for PFM."""
import math
import pathlib
import random
import struct
import zlib

WIDTH, HEIGHT = 96, 64


def scene(width=WIDTH, height=HEIGHT):
    """Something with slopes, edges, texture and colours, without symmetry."""
    def pixel(x, y):
        wave = 0.5 + 0.5 * math.sin(0.9 * x + 0.3 * y) * math.cos(0.17 * y * y / height)
        r = 0.15 + 0.6 * x / width + 0.1 * wave
        g = 0.2 + 0.4 * y / height + 0.2 * wave
        b = 0.75 - 0.5 * x / width + 0.05 * wave
        if (x - 30) ** 2 + (y - 26) ** 2 < 150:
            r, g, b = 0.9, 0.35 + 0.01 * y, 0.15
        if 56 < x < 80 and 30 < y < 52 - 0.3 * (x - 56):
            r, g, b = 0.12, 0.25, 0.6 - 0.005 * x
        return tuple(round(v * 255) / 255 for v in (r, g, b))
    return [[pixel(x, y) for x in range(width)] for y in range(height)]


def changed(picture, change):
    """change(x, y, pixel) -> pixel."""
    return [[change(x, y, pixel) for x, pixel in enumerate(row)] for y, row in enumerate(picture)]


def clip(value):
    return min(max(value, 0.0), 1.0)


def of_channels(picture, function):
    return changed(picture, lambda x, y, pixel: tuple(clip(function(v)) for v in pixel))


def noisy(picture, size, seed, bias=0.0):
    rng = random.Random(seed)
    return changed(picture, lambda x, y, pixel: tuple(clip(v + bias + size * (rng.random() + rng.random() - 1)) for v in pixel))


def linear(v):
    return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4


def png_bytes(picture, bits=8, gamma=None, level=6):
    kind = {1: 0, 2: 4, 3: 2, 4: 6}[len(picture[0][0])]
    most, code = (255, "B") if bits == 8 else (65535, "H")
    rows = b"".join(b"\0" + struct.pack(f">{len(row) * len(row[0])}{code}", *(int(v * most + 0.5) for pixel in row for v in pixel)) for row in picture)

    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
    out = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(picture[0]), len(picture), bits, kind, 0, 0, 0))
    if gamma:
        out += chunk(b"gAMA", struct.pack(">I", round(gamma * 100000)))
    return out + chunk(b"IDAT", zlib.compress(rows, level)) + chunk(b"IEND", b"")


def pfm_bytes(picture):
    head = f"{'PF' if len(picture[0][0]) == 3 else 'Pf'}\n{len(picture[0])} {len(picture)}\n-1.0\n".encode()
    return head + b"".join(struct.pack(f"<{len(row) * len(row[0])}f", *(v for pixel in row for v in pixel)) for row in reversed(picture))


def write(path, data):
    pathlib.Path(path).write_bytes(data)
    return path
