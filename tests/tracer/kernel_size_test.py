# SPDX-License-Identifier: Apache-2.0
"""A kernel without features is a small one: at most a third of the code of the kernel with all of them. Counted are the functions that exist once a mask; what all share
(POV-Ray's surfaces, shadow grids, fog) is called by every kernel, where there is something of it."""
import collections
import os
import re
import shutil
import subprocess
import sys

for reason, holds in (("sanitizers add code of their own", os.environ.get("ALIDADE_SANITIZED")), ("nm is not installed", not shutil.which("nm")),
                      ("without optimisation nothing is left out", os.environ.get("ALIDADE_CONFIG") == "Debug")):
    if holds:
        print(reason)
        sys.exit(77)
sizes = collections.Counter()
for line in subprocess.run(["nm", "-SC", os.environ["ALIDADE_KERNEL_COST"]], capture_output=True, text=True, check=True).stdout.splitlines():
    if found := re.match(r"[0-9a-f]+ ([0-9a-f]+) \w .*?(Cast)?<(\d+)u>", line):
        sizes["cast" if found[2] else int(found[3])] += int(found[1], 16)
del sizes["cast"]
print(f"bytes of the kernels: {sizes[0]} without features, {sizes[31]} with all ({sizes[0] / sizes[31]:.2f}); of all masks {min(sizes.values())} to {max(sizes.values())}")
sys.exit(len(sizes) != 32 or sizes[0] != min(sizes.values()) or 3 * sizes[0] > sizes[31])
