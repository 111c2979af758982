# SPDX-License-Identifier: Apache-2.0
"""Fails when a folder includes one that stands above or beside it (docs/architecture.md), or when GLM is included past core/vec.h."""
import pathlib
import re
import sys

MAY = {
    "core": "",
    "scene": "core",
    "accel": "core",
    "stress": "core accel",
    "topology": "core scene",
    "eval": "core scene accel",
    "numerics": "core scene accel eval importers exporters tracer",
    "importers": "core scene eval",
    "exporters": "core scene eval",
    "tracer": "core scene accel eval",
    "tools": "core scene accel stress eval topology numerics importers exporters tracer",
}
INCLUDE = re.compile(r'\s*#\s*include\s+["<](?:\.\./)*([^">]+)[">]')


def complaints(root):
    for top, allowed in MAY.items():
        for path in sorted((root / top).rglob("*")):
            if path.suffix not in (".h", ".hpp", ".cpp", ".cc", ".inl", ".inc"):
                continue
            name = path.relative_to(root).as_posix()
            for number, line in enumerate(path.read_text().splitlines(), 1):
                included = INCLUDE.match(line)
                folder = included[1].split("/")[0] if included and "/" in included[1] else ""
                if folder in MAY and folder != top and folder not in allowed.split():
                    yield f"{name}:{number}: {top} may not include {folder}/"
                if folder in ("tests", "bench"):
                    yield f"{name}:{number}: {top} may not include {folder}/"
                if folder == "glm" and name != "core/vec.h":
                    yield f"{name}:{number}: GLM is included by core/vec.h alone"


if __name__ == "__main__":
    found = list(complaints(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "layers: every include keeps the order of the folders")
    sys.exit(1 if found else 0)
