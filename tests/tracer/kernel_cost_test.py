# SPDX-License-Identifier: Apache-2.0
"""A feature that a scene does not use costs it nothing: the kernel without it and the kernel with all features make the same bytes, with the same
instructions but for a hundredth. Counted by callgrind inside of render() alone, in one thread: no clock, no scheduler, no import.

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


def complaints(scene, features):
    (asked, lean), bits, least = rendered(scene, "lean")
    (_, full), full_bits, most = rendered(scene, "full")
    print(f"{scene:22} mask {lean:2} {least:11} instructions, mask {full} {most:11}: {100 * (most / least - 1):+.2f} %", flush=True)
    if not asked == lean == features or full == lean:
        yield f"{scene}: the scene asks for the features {asked}, not {features}; the kernels are {lean} and {full}"
    if bits != full_bits or len(set(bits.split())) < 100:
        yield f"{scene}: the pictures differ, or there is nothing in them"
    if least < 1e6 or abs(most / least - 1) > MOST:
        yield f"{scene}: {least} and {most} instructions"


for reason, holds in (("sanitizers do not run under valgrind", os.environ.get("ALIDADE_SANITIZED")), ("valgrind is not installed", not shutil.which("valgrind")),
                      ("without optimisation nothing is free", os.environ.get("ALIDADE_CONFIG") == "Debug")):
    if holds:
        print(reason)
        sys.exit(77)
scenes = [line.split() for line in subprocess.run([PROGRAM, "list"], capture_output=True, text=True, check=True).stdout.splitlines()]
wrong = [complaint for scene, features in scenes for complaint in complaints(scene, int(features))]
print("\n".join(wrong))
sys.exit(bool(wrong) or len(scenes) < 6)
