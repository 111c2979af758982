# SPDX-License-Identifier: Apache-2.0
"""A glTF 2.0 file, written piece by piece: for the scripts beside this one."""
import json, struct, zlib

from surfaces import look_at


def rounded(value):
    """Numbers without the last digits, in which sine and cosine differ from one processor to the next."""
    if isinstance(value, dict):
        return {key: rounded(inner) for key, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(inner) for inner in value]
    exact = not isinstance(value, float) or struct.unpack("f", struct.pack("f", value))[0] == value   # a bound of an accessor
    return value if exact else round(value, 7)


class Gltf:
    def __init__(self, generator):
        self.blob, self.doc = bytearray(), {
            "asset": {"version": "2.0", "generator": generator}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "materials": [],
            "accessors": [], "bufferViews": [], "buffers": [], "images": [], "textures": [], "samplers": [{"wrapS": 10497, "wrapT": 10497}], "cameras": []}
        self.lights, self.surfaces = [], {}

    def view(self, data):
        while len(self.blob) % 4:
            self.blob.append(0)
        self.doc["bufferViews"].append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data)})
        self.blob += data
        return len(self.doc["bufferViews"]) - 1

    def accessor(self, data, component, count, kind, **more):
        self.doc["accessors"].append({"bufferView": self.view(data), "componentType": component, "count": count, "type": kind, **more})
        return len(self.doc["accessors"]) - 1

    def floats(self, rows, bounds=False):
        rows = [struct.unpack(f"{len(r)}f", struct.pack(f"{len(r)}f", *r)) for r in rows]
        limits = {"min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]} if bounds else {}
        return self.accessor(b"".join(struct.pack(f"<{len(r)}f", *r) for r in rows), 5126, len(rows), {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}[len(rows[0])], **limits)

    def indices(self, triangles):
        flat = [i for t in triangles for i in t]
        return self.accessor(struct.pack(f"<{len(flat)}H", *flat), 5123, len(flat), "SCALAR")

    def mesh(self, name, surface, material, colors=None):
        if id(surface) not in self.surfaces:   # written once, however many meshes share it
            points, normals, uvs, triangles = surface
            attributes = {"POSITION": self.floats(points, True), "NORMAL": self.floats(normals), "TEXCOORD_0": self.floats(uvs)}
            self.surfaces[id(surface)] = surface, attributes, self.indices(triangles)
        _, attributes, indices = self.surfaces[id(surface)]
        if colors:
            attributes = {**attributes, "COLOR_0": self.floats(colors)}
        self.doc["meshes"].append({"name": name, "primitives": [{"material": material, "indices": indices, "attributes": attributes}]})
        return len(self.doc["meshes"]) - 1

    def material(self, name, color, metallic, roughness, texture=None, alpha=1, extensions={}, **fields):
        """`extensions`: name of a KHR_materials extension without that prefix -> its object."""
        m = {"name": name, "pbrMetallicRoughness": {"baseColorFactor": [*color, alpha], "metallicFactor": metallic, "roughnessFactor": roughness}, **fields}
        if extensions:
            m["extensions"] = {f"KHR_materials_{key}": value for key, value in extensions.items()}
        if texture is not None:
            m["pbrMetallicRoughness"]["baseColorTexture"] = texture if isinstance(texture, dict) else {"index": texture}
        self.doc["materials"].append(m)
        return len(self.doc["materials"]) - 1

    def texture(self, png):
        self.doc["images"].append({"bufferView": self.view(png), "mimeType": "image/png"})
        self.doc["textures"].append({"source": len(self.doc["images"]) - 1, "sampler": 0})
        return len(self.doc["textures"]) - 1

    def node(self, **fields):
        self.doc["nodes"].append(fields)
        self.doc["scenes"][0]["nodes"].append(len(self.doc["nodes"]) - 1)
        return len(self.doc["nodes"]) - 1

    def camera(self, name, eye, target, **kind):
        """`kind`: perspective={...} or orthographic={...}, as glTF has them."""
        self.doc["cameras"].append({"name": name, "type": next(iter(kind)), **kind})
        self.node(name=name, camera=len(self.doc["cameras"]) - 1, translation=eye, rotation=look_at(eye, target))

    def light(self, name, kind, color, intensity, spot=None, **place):
        self.lights.append({"name": name, "type": kind, "color": color, "intensity": intensity, **({"spot": spot} if spot else {})})
        self.node(name=name, extensions={"KHR_lights_punctual": {"light": len(self.lights) - 1}}, **place)

    def _declare_extensions(self):
        used = {"KHR_lights_punctual"} if self.lights else set()

        def find(value):
            for key, inner in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
                if key == "extensions":
                    used.update(inner)
                find(inner)
        find(self.doc)
        if used:
            self.doc["extensionsUsed"] = sorted(used)
        if self.lights:
            self.doc["extensions"] = {"KHR_lights_punctual": {"lights": self.lights}}

    def write(self, path):
        self._declare_extensions()
        self.doc["buffers"] = [{"byteLength": len(self.blob)}]
        doc = {key: rounded(value) for key, value in self.doc.items() if value != []}   # glTF allows no empty lists
        text = json.dumps(doc, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        blob = bytes(self.blob) + b"\0" * (-len(self.blob) % 4)
        with open(path, "wb") as f:
            f.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(blob)))
            f.write(struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(blob), 0x004E4942) + blob)


def png(width, height, pixel):
    """`pixel(x, y)` gives 3 or 4 bytes: RGB, or RGBA."""
    kind = {3: 2, 4: 6}[len(pixel(0, 0))]
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in pixel(x, y)) for y in range(height))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
