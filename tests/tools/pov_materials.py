# SPDX-License-Identifier: Apache-2.0
"""Prints the table of docs/compare.md: how far POV-Ray's picture of each material of each asset is from ours. Usage: pov_materials.py PROGRAM SCENE ..."""
import json
import pathlib
import subprocess
import sys


def rows(program, scene):
    done = subprocess.run([program, "compare", scene, "--size", "320x240", "--json"], capture_output=True, text=True, timeout=600)
    name = pathlib.Path(scene).name
    for material in json.loads(done.stdout)["materials"]:
        lost = ", ".join(material["lost"]) or "nothing"
        yield f"| {name} | {material['name']} | {material['pixels']} | {material['flip']:.3f} | {100 * material['brighter']:+.1f} % | {lost} |"


if __name__ == "__main__":
    print("| scene | material | pixels | mean FLIP | ours brighter by | lost |\n|---|---|---|---|---|---|")
    for path in sys.argv[2:]:
        print("\n".join(rows(sys.argv[1], path)))
