#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What accuracy costs, shown: runs `alidade tradeoff` on each experiment of docs/tradeoff.md and draws its plot into docs/tradeoff/.

    python3 bench/tradeoffs.py [NAME ...]        all, or those that are named; a few minutes

The numbers behind each plot are written beside it, as CSV."""
import csv
import html
import itertools
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = os.environ.get("ALIDADE_PROGRAM", str(ROOT / "build/release/tools/alidade"))
OUT = ROOT / "docs" / "tradeoff"
POVRAY = "povray +I{scene} +L{folder} +W{width} +H{height} +AM{am} +A{aa} +R4 -J +WT1 -D +O{out}"
INK = {"Alidade, polynomial": "#0b57b0", "POV-Ray, polynomial": "#5b3fb0", "POV-Ray, accuracy": "#9a4a00", "POV-Ray, gradient": "#2d7d46", "Alidade, level": "#0b57b0", "Alidade, bailout": "#5b3fb0", "POV-Ray, level": "#9a4a00", "POV-Ray, bailout": "#2d7d46", "Alidade": "#0b57b0", "POV-Ray, method 1": "#9a4a00", "POV-Ray, method 2": "#2d7d46", "float": "#0b57b0", "double": "#9a4a00", "random": "#9a4a00", "sobol": "#0b57b0", "BVH": "#0b57b0", "grid": "#2d7d46", "octree": "#9a4a00"}


def tradeoff(*words, scene):
    done = subprocess.run([PROGRAM, "tradeoff", scene, "--progress", "none", "--json", *map(str, words)], capture_output=True, text=True, cwd=ROOT)
    if done.returncode:
        sys.exit(f"{scene}: {done.stderr.strip()}")
    return json.loads(done.stdout)["rows"]


def points(rows, series, label, error="rmse", x="cpu_seconds"):
    """[(series, cost, error, label)] of the rows that `series` gives a name to."""
    out = []
    for row in rows:
        if name := series(row):
            out.append((name, row[x] if x in row else row["counts"][x], row["errors"][error], label(row)))
    return out


def antialiasing():
    rows = tradeoff("--size", "240x180", "--vary", "spp=1,4,9,16,25,36", "--vary", "am=1,2", "--vary", "aa=0.3,0.1,0.03,0.01", "--external", POVRAY, "--reference", "self:400", "--repeat", 5,
                    scene="bench/scenes/edges.pov")
    name = lambda row: "POV-Ray, method " + row["setting"]["am"] if row["program"] == "povray" else "Alidade" if "spp" in row["setting"] else None
    return "CPU seconds", "RMSE", points(rows, name, lambda row: row["setting"].get("spp") or row["setting"]["aa"])


def depth():
    with tempfile.TemporaryDirectory() as folder:
        reference = pathlib.Path(folder) / "reference.exr"
        subprocess.run([PROGRAM, "povray", "+Ibench/scenes/glass.pov", "+W240", "+H180", "-A", "-D", "+FE", f"+O{reference}", "Declare=Level=40", "Declare=Bailout=0.0001"], check=True, cwd=ROOT, stderr=subprocess.DEVNULL)
        found = []
        for axis, values, other in (("level", "1,2,3,4,5,6,8,10", "Bailout=0"), ("bailout", "0.5,0.3,0.1,0.03,0.01,0.003,0.001", "Level=40")):
            words = f" +I{{scene}} +L{{folder}} +W{{width}} +H{{height}} -A -J +WT1 -D +O{{out}} Declare={axis.title()}={{{axis}}} Declare={other}"
            rows = tradeoff("--size", "240x180", "--vary", f"{axis}={values}", "--external", "povray" + words, "--external", f"{PROGRAM} povray" + words, "--reference", reference, "--repeat", 3, scene="bench/scenes/glass.pov")
            name = lambda row: (f"POV-Ray, {axis}" if row["program"] == "povray" else f"Alidade, {axis}") if axis in row["setting"] else None
            found += points(rows, name, lambda row: row["setting"][axis])
    return "CPU seconds", "RMSE", found


def implicit():
    """One surface as a polynomial and, in POV-Ray, as an isosurface; against POV-Ray's polynomial, whose roots Sturm's theorem isolates."""
    words = " +Ibench/scenes/heart.pov +W160 +H120 -A -J +WT1 -D"
    with tempfile.TemporaryDirectory() as folder:
        reference = pathlib.Path(folder) / "reference.png"
        subprocess.run(["povray", *words.split(), f"+O{reference}", "Declare=Sturm=1"], check=True, cwd=ROOT, stderr=subprocess.DEVNULL)
        found = []
        words = words.replace("bench/scenes/heart.pov", "{scene} +L{folder}") + " +O{out}"
        for axis, values, other in (("accuracy", "0.1,0.03,0.01,0.001,0.0001", "Gradient=60"), ("gradient", "20,25,30,40,60,100", "Accuracy=0.001")):
            rows = tradeoff("--size", "160x120", "--vary", f"{axis}={values}", "--external", f"povray{words} Declare=Polynomial=0 Declare={axis.title()}={{{axis}}} Declare={other}", "--reference", reference, "--repeat", 3, scene="bench/scenes/heart.pov")
            found += points(rows, lambda row: f"POV-Ray, {axis}" if axis in row["setting"] else None, lambda row: row["setting"][axis], error="over4")
        both = f"{words} Declare=Sturm={{sturm}}"
        rows = tradeoff("--size", "160x120", "--vary", "sturm=0", "--external", "povray" + both, "--external", f"{PROGRAM} povray{both}", "--reference", reference, "--repeat", 3, scene="bench/scenes/heart.pov")
        found += points(rows, lambda row: ("POV-Ray" if row["program"] == "povray" else "Alidade") + ", polynomial" if "sturm" in row["setting"] else None, lambda row: "", error="over4")
    return "CPU seconds", "share of pixels that differ by more than 4/255", found


def accelerators():
    rows = tradeoff("--size", "160x120", "--vary", "accel=bvh,grid,octree", "--vary", "spp=1,4,16", "--reference", "self:128", "--repeat", 3, scene="assets/scenes/hero.glb")
    names = {"bvh": "BVH", "grid": "grid", "octree": "octree"}
    return "CPU seconds", "FLIP", points(rows, lambda row: names.get(row["setting"].get("accel")), lambda row: row["setting"]["spp"], error="flip")   # a few bright pixels decide RMSE


def decimation():
    rows = tradeoff("--size", "160x120", "--spp", 16, "--vary", "decimate=0.01,0.02,0.05,0.1,0.2,0.5,1", "--reference", "self:64", "--repeat", 1, scene="assets/scenes/shell.ply")
    found = points(rows, lambda row: "Alidade" if "decimate" in row["setting"] else None, lambda row: row["setting"]["decimate"], error="over4")
    return "part of the triangles that is kept", "share of pixels that differ by more than 4/255", [(name, float(label), error, label) for name, _, error, label in found]


def samples():
    rows = tradeoff("--size", "32x32", "--vary", "spp=4,16,64,256,1024", "--vary", "sampler=random,sobol", "--seeds", 8, "--repeat", 1, scene="analytic:disc-disc")
    return "samples a pixel", "RMSE", [(row["setting"]["sampler"], float(row["setting"]["spp"]), row["errors"]["rmse"], row["setting"]["spp"]) for row in rows if "spp" in row["setting"]]


def precision():
    """Wrong answers of the suite's rows that are about triangles, over the time of the rays of all made scenes."""
    cost = pathlib.Path(PROGRAM).resolve().parents[1] / "bench" / "intersect_cost"
    said = subprocess.run([cost, "--precision", "both", "--rounds", "9", "--scale", "0.1", "--rays", "64"], capture_output=True, text=True, check=True).stdout
    times = {"fast float": 1.0}
    for line in said.splitlines():
        kind, name, *numbers = (cell.strip() for cell in line.split("|"))
        if kind == "mean":
            times[name] = 1 + float(numbers[0]) / 100
    found = []
    for kind, test in itertools.product(("float", "double"), ("fast", "robust", "exact")):
        run = subprocess.run([PROGRAM, "selftest", "--numerics", "T01", "T02", "T03", "T04", "T05", "T06", "--intersect", test, "--precision", kind, "--share", "0.1", "--json"], capture_output=True, text=True)
        rates = [1e6 * row["wrong"] / row["asked"] for row in json.loads(run.stdout)["rows"]]
        found.append((kind, times[f"{test} {kind}"], sum(rates) / len(rates), test))
    return "time of a ray, over that of fast in float", "wrong answers of a million, mean of T01 to T06", found


EXPERIMENTS = {"precision": precision, "antialiasing": antialiasing, "depth": depth, "implicit": implicit, "accelerators": accelerators, "decimation": decimation, "samples": samples}


class Axis:
    """Logarithmic, from `start` to `end` on the picture."""

    def __init__(self, values, start, end):
        low, high = math.log10(min(values)), math.log10(max(values))
        room = 0.06 * max(high - low, 0.3)
        self.low, self.high, self.start, self.end = low - room, high + room, start, end

    def __call__(self, value):
        return self.start + (math.log10(value) - self.low) / (self.high - self.low) * (self.end - self.start)

    def ticks(self):
        if self.high - self.low < 0.3:
            low, high = 10 ** self.low, 10 ** self.high
            exponent = math.floor(math.log10(high - low))
            return [float(f"{k}e{exponent}") for k in range(math.ceil(low / 10.0 ** exponent), math.floor(high / 10.0 ** exponent) + 1)]
        factors = (1, 2, 5) if self.high - self.low < 2.5 else (1,)
        return [f * 10.0 ** e for e in range(math.floor(self.low), math.ceil(self.high) + 1) for f in factors if self.low <= math.log10(f * 10.0 ** e) <= self.high]


def text(x, y, words, **more):
    extra = "".join(f' {key.replace("_", "-")}="{value}"' for key, value in more.items())
    return f'<text x="{x:.1f}" y="{y:.1f}"{extra}>{html.escape(str(words))}</text>'


def svg(cost, error, found):
    found = [point for point in found if point[1] > 0]
    exact = any(p[2] == 0 for p in found)   # a line of its own below the axis
    x, y_axis = Axis([p[1] for p in found], 70, 700), Axis([p[2] for p in found if p[2] > 0], 310 if exact else 350, 20)
    y = lambda value: y_axis(value) if value else 340
    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 410" font-family="sans-serif" font-size="13">', '<rect width="720" height="410" fill="#ffffff"/>']
    for tick in x.ticks():
        out += [f'<line x1="{x(tick):.1f}" x2="{x(tick):.1f}" y1="20" y2="350" stroke="#dfe2e7"/>', text(x(tick), 368, f"{tick:g}", text_anchor="middle")]
    for tick in y_axis.ticks() + ([0] if exact else []):
        out += [f'<line x1="70" x2="700" y1="{y(tick):.1f}" y2="{y(tick):.1f}" stroke="#dfe2e7"/>', text(64, y(tick) + 4, f"{tick:g}" if tick < 1e5 else f"{tick:.0e}".replace("e+0", "e"), text_anchor="end")]
    out += [text(385, 396, cost, text_anchor="middle"), text(16, 185, error, text_anchor="middle", transform="rotate(-90 16 185)")]
    for number, name in enumerate(dict.fromkeys(point[0] for point in found)):
        ink, line = INK[name], [point for point in found if point[0] == name]
        out.append(f'<polyline fill="none" stroke="{ink}" stroke-width="2" points="{" ".join(f"{x(p[1]):.1f},{y(p[2]):.1f}" for p in line)}"/>')
        for point in line:
            out += [f'<circle cx="{x(point[1]):.1f}" cy="{y(point[2]):.1f}" r="4" fill="{ink}"/>', text(x(point[1]) + 7, y(point[2]) - 6, point[3], fill=ink, font_size=11)]
        out.append(text(692, 36 + 17 * number, name, fill=ink, text_anchor="end", font_weight="bold"))
    return "\n".join([*out, "</svg>", ""])


def main(names):
    OUT.mkdir(exist_ok=True)
    for name in names or EXPERIMENTS:
        cost, error, found = EXPERIMENTS[name]()
        (OUT / f"{name}.svg").write_text(svg(cost, error, found))
        with open(OUT / f"{name}.csv", "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([("series", cost, error, "setting"), *((a, f"{b:.4g}", f"{c:.4g}", d) for a, b, c, d in found)])
        print(f"{name}: {len(found)} points")


if __name__ == "__main__":
    main(sys.argv[1:])
