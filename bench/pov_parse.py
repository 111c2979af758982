#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How long a POV-Ray scene takes to parse, here and in POV-Ray: medians of alternated runs, in CPU seconds.

    bench/pov_parse.py build/release/bench/pov_parse_time [--runs 5] [--only WORD] [--compile]

POV-Ray   the parse time that it prints, in CPU milliseconds. It holds reading the files and its includes, running the program, building the objects, pictures
          that are read, and the bounding of each mesh; not its start, not the bounding of the scene, which it prints beside it.
Alidade   `import`: import_scene, from the file to the validated scene graph. `process`: from the start of the program, so with what the system does to load it.
          The ratio is POV-Ray's time over `import`. --compile adds what follows before the first ray: accelerators, also those of meshes, and pictures. It is
          of the whole scene, hence more than what POV-Ray does while it parses; it stands beside and is in no ratio.

The scenes are the twenty of Debian's povray-examples with the longest parse, and four programs that are made here. Of the twenty, most have something that
is left out here (meshes of cameras, height fields, media ...), which POV-Ray builds: they are starred, and count in the mean of all alone.
Exit code 1: the mean of those that are read whole, or any ratio, is below its goal.
"""
import argparse
import math
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

SCENES = """language/tracevines camera/mesh_camera/meshcam_persp_demo camera/mesh_camera/meshcam_ortho_demo camera/mesh_camera/meshcam_stereo_demo advanced/landscape
advanced/wallstucco camera/mesh_camera/meshcam_persp_demo_uv advanced/isocacti camera/mesh_camera/ess/ess-persp-camera camera/mesh_camera/meshcam_persp_compare
camera/mesh_camera/meshcam_ortho_demo_uv advanced/benchmark/benchmark advanced/blocks/stackertransp advanced/blocks/stackernight advanced/blocks/stackerday incdemo/shapes
advanced/balcony/balcony camera/mesh_camera/ess/ess-ortho-camera templates/Basic_Scenes/Orthographic_isometric bsp/Tango""".split()
HEAD = "#version 3.7; global_settings { assumed_gamma 1 } camera { location -5*z }\n"
PROGRAMS = {
    "loops": """#declare S = 0; #for (I, 1, 500000) #declare S = S + I*0.5; #end
#declare I = 0; #while (I < 500000) #declare S = S + I*0.5; #declare I = I + 1; #end sphere { 0, S/S }""",
    "macros": "#macro Twice(A, B) #local C = A + B; C*2 #end #declare S = 0; #for (I, 1, 100000) #declare S = S + Twice(I, S)*1e-9; #end sphere { 0, 1 }",
    "recursion": "#macro Sum(N) #local R = 0; #if (N > 0) #local R = N + Sum(N - 1); #end R #end #declare S = 0; #for (I, 1, 1000) #declare S = S + Sum(80); #end sphere { 0, S/S }",
}
GOAL_MEAN, GOAL_WORST = 5, 2


def mesh(rows=707):
    """About a million triangles, with the numbers as programs write them."""
    def vertex(i, j): return f"<{i/rows:.4f},{math.sin(i*.1)*.1:.4f},{j/rows:.4f}>"
    yield "mesh {\n"
    for i in range(rows):
        for j in range(rows):
            a, b, c, d = vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)
            yield f"triangle {{ {a},{b},{c} }} triangle {{ {a},{c},{d} }}\n"
    yield "pigment { rgb 1 } }\n"


def examples():
    files = subprocess.run(["dpkg", "-L", "povray-examples"], capture_output=True, text=True).stdout.split("\n")
    return pathlib.Path(next(f for f in files if f.endswith("/examples")))


def sources(made):
    """Name -> path of the scenes, and of the programs, which are written to the folder `made`."""
    out = {name: examples() / f"{name}.pov" for name in SCENES}
    for name, text in {**PROGRAMS, "mesh": "".join(mesh())}.items():
        out[name] = made / name / f"{name}.pov"
        out[name].parent.mkdir()
        out[name].write_text(HEAD + text)
    return out


def in_fresh_copy(scene, measure):
    """Some scenes write files (both programs may), which later runs would find and read instead of doing the work."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(scene.parent, pathlib.Path(folder, "scene"))
        return measure(pathlib.Path(folder, "scene", scene.name))


def povray(scene):
    words = ["povray", f"+I{scene.name}", "+W160", "+H120", "+SC1", "+EC1", "+SR1", "+ER1", "-A", "-D", "+WT1", "+Opicture.png"]   # one pixel is traced
    said = subprocess.run(words, cwd=scene.parent, capture_output=True, text=True, errors="replace")
    times = re.search(r"Parse Time:.*?seconds \(([\d.]+) seconds\)(?:\s*using \d+ thread\(s\) with ([\d.]+) CPU-seconds)?", said.stderr, re.S)
    if not times: sys.exit(f"povray does not read {scene}:\n{said.stderr[-500:]}")
    return float(times[2] or times[1])


def ours(program, scene, compiles):
    said = subprocess.run([program, scene.name] + ["--compile"] * compiles, cwd=scene.parent, capture_output=True, text=True, errors="replace")
    if said.returncode: sys.exit(f"{program} {scene}:\n{said.stderr[-500:]}")
    return [float(x) for x in said.stdout.split()], "left out" in said.stderr or "not modelled" in said.stderr


def measured(program, scene, runs, compiles):
    """Medians of POV-Ray's time and our three, and whether something was left out."""
    rows = []
    for _ in range(runs):
        theirs = in_fresh_copy(scene, povray)
        times, partly = in_fresh_copy(scene, lambda copy: ours(program, copy, compiles))
        rows.append([theirs, *times])
    return [statistics.median(column) for column in zip(*rows)], partly


def mean(ratios):
    return math.exp(statistics.fmean(map(math.log, ratios))) if ratios else math.nan


def main():
    wish = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    wish.add_argument("program", type=os.path.abspath)
    wish.add_argument("--runs", type=int, default=5)
    wish.add_argument("--only", default="", help="scenes whose name has this in it")
    wish.add_argument("--compile", action="store_true")
    o = wish.parse_args()
    ratios, whole = [], []
    print(f"{'POV-Ray':>8} {'import':>8} {'process':>8} {'compile':>8} {'ratio':>7}")
    with tempfile.TemporaryDirectory() as made:
        for name, scene in sources(pathlib.Path(made)).items():
            if o.only not in name: continue
            times, partly = measured(o.program, scene, o.runs, o.compile)
            ratios.append(times[0] / times[1])
            if not partly: whole.append(ratios[-1])
            print(f"{times[0]:8.3f} {times[1]:8.4f} {times[2]:8.4f} {times[3]:8.4f} {ratios[-1]:7.2f}{'*' if partly else ' '} {name}", flush=True)
    if not whole: sys.exit("none of these scenes is read whole" if ratios else f"no scene has {o.only} in its name")
    print(f"geometric mean of the {len(whole)} that are read whole {mean(whole):.2f}, of all {len(ratios)} {mean(ratios):.2f} (goal {GOAL_MEAN}); worst {min(ratios):.2f} (goal {GOAL_WORST})")
    return mean(whole) < GOAL_MEAN or min(ratios) < GOAL_WORST


if __name__ == "__main__":
    sys.exit(main())
