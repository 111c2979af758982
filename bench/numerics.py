#!/usr/bin/env python3
"""Takes into bench/results/numerics what runs of the numerical suite found, for the tables of docs/numerics.md.

    alidade selftest --numerics --full --state STATE [ROW...]    hours, in as many goes as it takes
    python3 bench/numerics.py STATE [--again]                    then tests/tools/readme_test.py --write renews the page

A row is taken if STATE asked it at least as many cases as were kept before; with --again in any case: the row itself is another one now.
"""
import argparse
import json
import pathlib

KEPT = pathlib.Path(__file__).parent / "results" / "numerics" / "measured.jsonl"


def rows(path):
    """The last line of each row."""
    lines = [json.loads(line) for line in path.read_text().splitlines() if line.strip()] if path.exists() else []
    return {line["key"]: line["value"] for line in lines if line["key"] != "head"}


if __name__ == "__main__":
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("state", type=pathlib.Path)
    words.add_argument("--again", action="store_true")
    asked = words.parse_args()
    kept = rows(KEPT)
    for key, found in rows(asked.state / "measured.jsonl").items():
        if asked.again or key not in kept or found["cases"] >= kept[key]["cases"]:
            kept[key] = found
            print(f"{key}: {found['cases']} cases, {found['wrong']} wrong")
    KEPT.parent.mkdir(exist_ok=True)
    KEPT.write_text("".join(json.dumps({"key": key, "value": kept[key]}) + "\n" for key in sorted(kept)))
