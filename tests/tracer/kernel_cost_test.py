# SPDX-License-Identifier: Apache-2.0
"""A feature that a scene does not use costs it nothing: the kernel without it and the kernel with all features make the same bytes, with the same
instructions but for a hundredth; for each of the things that a scene can require there is a scene without it among those that are counted. And what is in a file
but hidden costs no more than if it were not there. Counted by callgrind inside of render() alone, in one thread: no clock, no scheduler, no import.

The depth of field is no bit of the mask: a camera without a lens takes the middle of it, which is one comparison a camera ray in any kernel."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PROGRAM = os.environ["ALIDADE_KERNEL_COST"]
MOST = 0.01


def rendered(scene, kernel):
    """(masks of scene and kernel, bits of the picture, instructions)."""
    with tempfile.TemporaryDirectory() as folder:
        counts = pathlib.Path(folder) / "counts"
        said = subprocess.run(["valgrind", "-q", "--tool=callgrind", "--toggle-collect=kernel_cost_counted", f"--callgrind-out-file={counts}", PROGRAM, scene, kernel],
                              capture_output=True, text=True, check=True)
        masks, bits = said.stdout.split("\n", 1)
        return tuple(map(int, masks.split())), bits, int(re.search(r"^totals: (\d+)", counts.read_text(), re.M)[1])


def compared(what, base, other, least=1e6):
    """Complaints about two runs of rendered() that must make the same bytes at the same cost."""
    (_, few), (_, many) = base[0], other[0]
    print(f"{what:22} mask {few:2} {base[2]:11} instructions, mask {many} {other[2]:11}: {100 * (other[2] / base[2] - 1):+.2f} %", flush=True)
    if base[1] != other[1] or len(set(base[1].split())) < 100:
        yield f"{what}: the pictures differ, or there is nothing in them"
    if base[2] < least or abs(other[2] / base[2] - 1) > MOST:
        yield f"{what}: {base[2]} and {other[2]} instructions"


def complaints(scene, features, known):
    known[scene] = lean = rendered(scene, "lean")
    full = rendered(scene, "full")
    (asked, kernel), (_, most) = lean[0], full[0]
    if not asked == kernel == features or most == kernel:
        yield f"{scene}: the scene asks for the features {asked}, not {features}; the kernels are {kernel} and {most}"
    yield from compared(scene, lean, full)


for reason, holds in (("sanitizers do not run under valgrind", os.environ.get("ALIDADE_SANITIZED")), ("valgrind is not installed", not shutil.which("valgrind")),
                      ("without optimisation nothing is free", os.environ.get("ALIDADE_CONFIG") == "Debug")):
    if holds:
        print(reason)
        sys.exit(77)
rows = [line.split(";") for line in subprocess.run([PROGRAM, "list"], capture_output=True, text=True, check=True).stdout.splitlines()]
lacking, known = {name: set(missing) for name, _, *missing in rows}, {}
wrong = [complaint for name, features, *_ in rows for complaint in complaints(name, int(features), known)]
wrong += compared("plain, and unused", known["plain"], known["unused"])
everything = set.union(*lacking.values())
print(f"{len(everything)} things that a scene can require, each missing in a scene that was counted")
if len(everything) != 30 or any(len(missing) == 30 for missing in lacking.values()):
    wrong.append(f"scenes without {sorted(everything)} were counted; that are not all")
print("\n".join(wrong))
sys.exit(bool(wrong) or len(rows) < 10)
