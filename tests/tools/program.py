# SPDX-License-Identifier: Apache-2.0
"""What the tests of the program share: running it, a small scene, and reading PNG files without a library."""
import base64
import json
import os
import pathlib
import struct
import subprocess
import tempfile
import unittest
import zlib

PROGRAM = os.environ.get("ALIDADE_PROGRAM", str(pathlib.Path(__file__).resolve().parents[2] / "build/release/tools/alidade"))
SANITIZED = bool(os.environ.get("ALIDADE_SANITIZED"))


def run(*words, timeout=120, **keywords):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, timeout=timeout, **keywords)


def triangle_gltf(**more):
    """A white triangle that fills the middle of a camera's view, with a light behind the camera."""
    positions = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0)
    document = {
        "asset": {"version": "2.0", "generator": "alidade tests"},
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "name": "sun", "intensity": 3}]}},
        "scene": 0,
        "scenes": [{"nodes": [0, 1, 2]}],
        "nodes": [
            {"mesh": 0, "name": "triangle"},
            {"camera": 0, "translation": [0, 0, 3]},
            {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0, 0, 3]},
        ],
        "cameras": [{"type": "perspective", "name": "front", "perspective": {"yfov": 1, "znear": 0.1}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": len(positions)}],
        "buffers": [{"byteLength": len(positions), "uri": "data:application/octet-stream;base64," + base64.b64encode(positions).decode()}],
    }
    document.update(more)
    return json.dumps(document)


def read_png(path):
    """(width, height, channels, rows of bytes, still filtered) of an 8-bit PNG; fails if a chunk's checksum or the amount of data is wrong."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "not a PNG"
    at, pixels, header = 8, b"", None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        assert struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0] == zlib.crc32(kind + body), "wrong checksum"
        header = struct.unpack(">IIBBBBB", body) if kind == b"IHDR" else header
        pixels += body if kind == b"IDAT" else b""
        at += 12 + size
    width, height, depth, color = header[:4]
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[color]
    raw = zlib.decompress(pixels)
    assert depth == 8 and len(raw) == height * (1 + width * channels), "wrong amount of data"
    return width, height, channels, [raw[y * (1 + width * channels):][:1 + width * channels] for y in range(height)]


class InFolder(unittest.TestCase):
    """Each test has an empty folder of its own, with the small scene in it."""

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        self.scene = self.folder / "triangle.gltf"
        self.scene.write_text(triangle_gltf())
