#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Does `alidade tradeoff` say the same twice? Two glTF scenes, two of POV-Ray's with its own curve beside ours, and one whose picture is known; each measured in two runs.

    python3 bench/tradeoff_again.py [--short] [SCENE ...]      all scenes, some minutes, or those that are named; --short: the closed form alone, seconds

Errors and counted work must be equal to the last bit, instructions within 1 %, and of all recommended settings nine of ten must cost in the second run what the first one said: its 95 %
interval, widened by 5 %. Exit code 1 if one of these does not hold."""
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = os.environ.get("ALIDADE_PROGRAM", str(ROOT / "build/release/tools/alidade"))
POVRAY = "povray +I{scene} +L{folder} +W{width} +H{height} +AM1 +A{aa} +R3 -J +WT1 -D +O{out}"
WIDEN, OF_ALL, OF_INSTRUCTIONS = 0.05, 0.9, 0.01

SCENES = {
    "assets/scenes/hero.glb": ("--size", "40x30", "--spp", 4, "--vary", "spp=1,4,16", "--vary", "light-samples=1,4", "--metric", "flip", "--reference", "self:64"),
    "assets/scenes/materials.glb": ("--size", "40x30", "--spp", 4, "--vary", "spp=1,4,16", "--vary", "max-depth=2,8", "--reference", "self:64"),
    "bench/scenes/edges.pov": ("--size", "80x60", "--vary", "spp=1,4,9", "--vary", "aa=0.3,0.1,0.03", "--external", POVRAY, "--reference", "self:64"),
    "bench/scenes/glass.pov": ("--size", "40x30", "--vary", "spp=1,4,9", "--vary", "aa=0.3,0.03", "--external", POVRAY, "--reference", "self:36"),
    "analytic:disc-disc": ("--size", "32x32", "--vary", "spp=4,16,64", "--vary", "sampler=random,sobol", "--seeds", 8),
}
SHORT = {"analytic:disc-disc": ("--size", "32x32", "--vary", "spp=4,64", "--seeds", 8)}


def tradeoff(scene, words, rounds):
    done = subprocess.run([PROGRAM, "tradeoff", scene, "--repeat", str(rounds), "--instructions", "--isa", "scalar", "--progress", "none", "--json", *map(str, words)], capture_output=True, text=True, cwd=ROOT)
    if done.returncode:
        sys.exit(f"{scene}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def recommended(document):
    chosen = document["recommended"]
    return sorted({chosen[name] for name in ("fastest_within_error", "best_within_time", "knee")} - {None})


def compare(scene, first, second):
    """Complaints; and of each recommended setting whether its cost came again, in words."""
    wrong, costs = [], []
    for a, b in zip(first["rows"], second["rows"], strict=True):
        for what in ("name", "errors", "counts", "noise"):
            if a[what] != b[what]:
                wrong.append(f"{scene}: {a['name']}: {what} {a[what]}, then {b[what]}")
        if a["program"] == "alidade" and abs(b["instructions"] / a["instructions"] - 1) > OF_INSTRUCTIONS:
            wrong.append(f"{scene}: {a['name']}: {a['instructions']} instructions, then {b['instructions']}")
    for i in recommended(first):
        a, b = first["rows"][i], second["rows"][i]
        low, high = a["cpu_seconds_95"]
        holds = low * (1 - WIDEN) <= b["cpu_seconds"] <= high * (1 + WIDEN)
        costs.append((holds, f"{scene}: {a['name']}: {a['cpu_seconds']:.4g} s ({low:.4g} to {high:.4g}), then {b['cpu_seconds']:.4g} s{'' if holds else ': OUTSIDE'}"))
    return wrong, costs


def main(words):
    scenes, rounds = (SHORT, 5) if "--short" in words else (SCENES, 15)
    if named := [word for word in words if word != "--short"]:
        scenes = {name: SCENES[name] for name in named}
    wrong, costs, most = [], [], 0
    for scene, options in scenes.items():
        first, second = (tradeoff(scene, options, rounds) for _ in range(2))
        complaints, again = compare(scene, first, second)
        wrong += complaints
        costs += again
        ours = [(a, b) for a, b in zip(first["rows"], second["rows"]) if a["program"] == "alidade"]
        moved = max(abs(b["instructions"] / a["instructions"] - 1) for a, b in ours)
        most = max(most, moved)
        print(f"{scene}: {len(first['rows'])} settings, {len(first['rows']) - len(ours)} of another program; instructions within {100 * moved:.3f} %", *(line for _, line in again), sep="\n    ", flush=True)
    share = sum(holds for holds, _ in costs) / max(len(costs), 1)
    print(f"errors and counts: {'the same' if not wrong else 'DIFFERENT'}; instructions within {100 * most:.3f} %; {sum(holds for holds, _ in costs)} of {len(costs)} recommended costs came again ({100 * share:.0f} %)")
    print(*wrong, sep="\n")
    return bool(wrong) or ("--short" not in words and share < OF_ALL)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
