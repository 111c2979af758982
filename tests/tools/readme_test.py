# SPDX-License-Identifier: Apache-2.0
"""Documents say what the program says: the README's tables are those of `alidade info --features`, those of docs/numerics.md of `alidade selftest --told`,
and what `info` tells of the tests of triangles was measured.

    python3 tests/tools/readme_test.py --write     puts the present tables into them
"""
import json
import pathlib
import re
import sys
import unittest

from program import run

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = ROOT / "README.md"
NUMERICS = ROOT / "docs/numerics.md"
TABLES = {   # the README's marker: (the registry, its columns)
    "verbs": ("verbs", ["usage", "doc", "exits"]),
    "importers": ("importers", ["name", "extensions", "doc"]),
    "exporters": ("exporters", ["name", "extensions", "doc"]),
    "accelerators": ("accelerators", ["name", "doc"]),
    "metrics": ("metrics", ["name", "unit", "doc"]),
}


def markdown(rows, columns):
    cells = [columns, ["---"] * len(columns)] + [[row[column].replace("|", "\\|") for column in columns] for row in rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in cells)


def with_tables(text):
    """`text` with what stands between <!-- table X --> and <!-- end --> made anew."""
    features = json.loads(run("info", "--features", "--json").stdout)
    for marker, (registry, columns) in TABLES.items():
        pattern = re.compile(rf"(<!-- table {marker} -->\n).*?(<!-- end -->)", re.S)
        text, count = pattern.subn(lambda found: found[1] + markdown(features[registry], columns) + found[2], text)
        assert count == 1, f"the README must have one table {marker}"
    return text


def with_numerics(text):
    """`text` with what bench/results/numerics holds between <!-- table numerics --> and <!-- end -->."""
    told = run("selftest", "--numerics", "--told", "--state", ROOT / "bench/results/numerics", "--markdown").stdout
    text, count = re.subn(r"(<!-- table numerics -->\n).*?(<!-- end -->)", lambda found: found[1] + told + found[2], text, flags=re.S)
    assert count == 1, "docs/numerics.md must have one table numerics"
    return text


class Numerics(unittest.TestCase):
    def test_its_tables_are_those_of_the_kept_run(self):
        self.assertEqual(NUMERICS.read_text(), with_numerics(NUMERICS.read_text()), "renew them with tests/tools/readme_test.py --write")

    def test_every_row_was_run(self):
        rows = json.loads(run("selftest", "--numerics", "--told", "--state", ROOT / "bench/results/numerics", "--json").stdout)["rows"]
        self.assertEqual([row["id"] for row in rows], [f"T{i:02}" for i in range(1, 27)])
        told = re.findall(r"\bT\d\d\b", re.search(r"\*\*Not mended yet\*\*.*?\n\n", NUMERICS.read_text(), re.S)[0]) if "**Not mended yet**" in NUMERICS.read_text() else []
        for row in rows:
            self.assertGreater(row["asked"], 0, row["id"])
        self.assertEqual([row["id"] for row in rows if row["wrong"] > row["excused"]], sorted(set(told)), "wrong answers that no row excuses are told below the table")


class Intersect(unittest.TestCase):
    def test_what_info_tells_was_measured(self):
        page = (ROOT / "bench/results/intersect.md").read_text()
        rows = {line.split()[1]: [float(cell) for cell in line.split("|")[3:6]] for line in page.splitlines() if re.match(r"\| T\d\d ", line)}
        more = {name: float(re.search(rf"{name} over fast: \*\*([\d.]+) %", page)[1]) / 100 for name in ("exact", "robust")} | {"fast": 0}
        told = json.loads(run("info", "--features", "--json").stdout)["intersect"]
        self.assertEqual([row["name"] for row in told], ["exact", "robust", "fast"])
        for i, row in enumerate(told):
            self.assertEqual(row["leaks at edges, of a million"], rows["T01"][i])
            self.assertEqual(row["leaks at vertices, of a million"], rows["T02"][i])
            self.assertEqual(row["wrong decisions, of a million"], rows["T05"][i])
            self.assertAlmostEqual(row["time over exact's"], (1 + more[row["name"]]) / (1 + more["exact"]), delta=0.005)


class Readme(unittest.TestCase):
    def test_its_tables_are_current(self):
        text = README.read_text()
        self.assertEqual(text, with_tables(text), "renew them with tests/tools/readme_test.py --write")

    def test_the_files_it_names_are_there(self):
        named = re.findall(r"\]\((?!http)([^)#]+)", README.read_text())
        self.assertGreater(len(named), 3)
        self.assertEqual([name for name in named if not (README.parent / name).exists()], [])


if __name__ == "__main__":
    if "--write" in sys.argv:
        README.write_text(with_tables(README.read_text()))
        NUMERICS.write_text(with_numerics(NUMERICS.read_text()))
    else:
        unittest.main()
