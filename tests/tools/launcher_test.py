# SPDX-License-Identifier: Apache-2.0
"""The launcher's own logic, in a small tree with stand-ins for cmake, dpkg-query, apt-get and sudo that write down how they were called."""
import os
import pathlib
import re
import subprocess
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

# The stand-in program prints where it runs and its words; a configure step writes build.ninja, a build step the program.
CMAKE = r'''#!/bin/bash
echo "cmake $*" >>"$CALLS"
echo "noise on stdout"; echo "noise on stderr" >&2
[ -z "${BREAK_BUILD:-}" ] || { echo "x.cpp:1: error: broken"; exit 1; }
if [ "$1" = --preset ]; then mkdir -p build/release && touch build/release/build.ninja; exit; fi
mkdir -p "$2/tools"
printf '#!/bin/bash\necho "in $PWD: $*"\nexit 7\n' >"$2/tools/alidade"
chmod +x "$2/tools/alidade"
'''
DPKG_QUERY = '#!/bin/bash\nfor each; do [[ $each == -* || " ${MISSING:-} " == *" $each "* ]] || echo "installed $each"; done\n'
APT_GET = '''#!/bin/bash
echo "apt-get $*" >>"$CALLS"
echo "noise of apt-get"
[[ "$*" != *--assume-no* ]] || { echo "Need to get 12.3 MB of archives."; exit 1; }
[ -z "${BREAK_APT:-}" ] || { echo "E: no network" >&2; exit 100; }
'''
ID = '#!/bin/bash\necho "${AS_USER:-0}"\n'
SUDO = '#!/bin/bash\nexit 1\n'


class Launcher(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.top = pathlib.Path(kept.name)
        self.tree, self.calls = self.top / "a tree", self.top / "calls"
        for folder in ("tools", "core", "cmake"):
            (self.tree / folder).mkdir(parents=True)
        for name in ("alidade", "cmake/packages.sh", "cmake/packages.txt"):
            (self.tree / name).write_bytes((ROOT / name).read_bytes())
        (self.tree / "alidade").chmod(0o755)
        (self.tree / "core" / "x.cpp").write_text("")
        stand_ins = self.top / "bin"
        stand_ins.mkdir()
        for name, text in {"cmake": CMAKE, "dpkg-query": DPKG_QUERY, "apt-get": APT_GET, "id": ID, "sudo": SUDO}.items():
            (stand_ins / name).write_text(text)
            (stand_ins / name).chmod(0o755)
        self.environment = {"PATH": f"{stand_ins}:{os.environ['PATH']}", "CALLS": str(self.calls)}

    def launch(self, *words, program=None, cwd=None, **environment):
        self.calls.write_text("")
        return subprocess.run([program or self.tree / "alidade", *words], cwd=cwd or self.top, env={**self.environment, **environment},
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)

    def called(self):
        return self.calls.read_text().splitlines()

    def test_builds_once_and_hands_over(self):
        first = self.launch("render", "a b.glb", "-o", "x")
        self.assertEqual((first.returncode, first.stdout), (7, f"in {self.top}: render a b.glb -o x\n"))
        self.assertEqual(first.stderr, "alidade: building (once)\n")
        self.assertEqual(self.called(), ["cmake --preset release", f"cmake --build {self.tree}/build/release --target alidade"])
        second = self.launch("info")
        self.assertEqual((second.returncode, second.stdout, second.stderr, self.called()), (7, f"in {self.top}: info\n", "", []))

    def test_builds_again_when_a_source_changed_or_went(self):
        self.launch()
        (self.tree / "core" / "x.cpp").write_text("changed")
        self.launch()
        self.assertEqual(len(self.called()), 1)
        (self.tree / "core" / "x.cpp").unlink()
        self.launch()
        self.assertEqual(len(self.called()), 1)
        self.launch()
        self.assertEqual(self.called(), [])

    def test_all_folders_of_the_program_are_watched(self):
        folders = set(re.search(r"set\(ALIDADE_FOLDERS ([^)]*)\)", (ROOT / "CMakeLists.txt").read_text())[1].split())
        self.assertEqual(folders - set(re.search(r"for each in (.*); do", (ROOT / "alidade").read_text())[1].split()), set())
        for script in ("layers", "sizes"):
            text = (ROOT / "tests" / f"{script}.py").read_text()
            self.assertEqual([folder for folder in sorted(folders) if not re.search(rf"\b{folder}\b", text)], [], script)

    def test_a_link_and_another_folder(self):
        elsewhere = self.top / "elsewhere"
        elsewhere.mkdir()
        (elsewhere / "link").symlink_to(self.tree / "alidade")
        self.assertEqual(self.launch("info", program="./link", cwd=elsewhere).stdout, f"in {elsewhere}: info\n")

    def test_a_failed_build_shows_its_log_and_is_tried_again(self):
        said = self.launch(BREAK_BUILD="1")
        self.assertEqual((said.returncode, said.stdout), (1, ""))
        self.assertIn("x.cpp:1: error: broken", said.stderr)
        self.assertIn("the build failed", said.stderr)
        self.assertEqual(self.launch().returncode, 7)
        (self.tree / "core" / "x.cpp").write_text("changed")
        self.assertEqual(self.launch(BREAK_BUILD="1").returncode, 1, "an old program is not run instead")

    def test_missing_packages_are_installed_by_root(self):
        said = self.launch(MISSING="libfmt-dev ccache")
        self.assertEqual((said.returncode, said.stdout), (7, f"in {self.top}: \n"))
        self.assertEqual(said.stderr.splitlines()[:2], ["alidade: looking up 2 missing Debian packages (apt-get update)",
                                                        "alidade: installing them (12.3 MB to download): ccache libfmt-dev"])
        self.assertNotIn("noise", said.stderr)
        self.assertEqual(self.called()[0], "apt-get update")
        self.assertEqual(self.called()[2], "apt-get install -y --no-install-recommends ccache libfmt-dev")

    def test_a_failed_installation_is_shown(self):
        said = self.launch(MISSING="ccache", BREAK_APT="1")
        self.assertEqual((said.returncode, said.stdout), (1, ""))
        self.assertIn("E: no network", said.stderr)
        self.assertFalse(any(call.startswith("cmake") for call in self.called()))

    def test_who_is_not_root_is_told_the_command(self):
        said = self.launch(MISSING="ccache", AS_USER="1000")
        self.assertEqual((said.returncode, said.stdout, self.called()), (1, "", []))
        self.assertIn("sudo apt-get update && sudo apt-get install -y --no-install-recommends ccache\n", said.stderr)

    def test_only_what_the_program_needs_is_installed(self):
        self.launch(MISSING="libgtest-dev clang")   # of the sections for tests and CI
        self.assertFalse(any(call.startswith("apt-get") for call in self.called()))

    def test_a_script_that_ends_at_its_first_error_installs_too(self):
        script = self.top / "script"
        script.write_text(f'set -euo pipefail\nroot="{self.tree}"\n. "$root/cmake/packages.sh"\nneed_packages build test\necho went on\n')
        said = self.launch(script, program="bash", MISSING="ccache libgtest-dev")
        self.assertEqual((said.returncode, said.stdout), (0, "went on\n"), said.stderr)
        self.assertEqual(self.called()[2], "apt-get install -y --no-install-recommends ccache libgtest-dev")

    def test_starting_what_is_built_costs_little(self):
        self.launch()
        def seconds():
            start = time.perf_counter()
            self.launch()
            return time.perf_counter() - start
        least = min(seconds() for _ in range(10))
        print(f"launcher without work: {1000 * least:.0f} ms (least of 10 runs)")
        self.assertLess(least, 0.05)


if __name__ == "__main__":
    unittest.main()
