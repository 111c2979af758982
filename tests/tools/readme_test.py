# SPDX-License-Identifier: Apache-2.0
"""The README says what the program says: its tables are those of `alidade info --features`.

    python3 tests/tools/readme_test.py --write     puts the present tables into it
"""
import json
import pathlib
import re
import sys
import unittest

from program import run

README = pathlib.Path(__file__).resolve().parents[2] / "README.md"
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
    else:
        unittest.main()
