#!/usr/bin/env python3
"""Takes into bench/results/numerics what runs of the numerical suite found, for the tables of docs/numerics.md.

    alidade selftest --numerics --full --state STATE [ROW...]    hours; what was ended goes on
    python3 bench/numerics.py STATE [--again]                    then tests/tools/readme_test.py --write renews the page

A row is taken if STATE asked it at least as many cases as were kept before; with --again in any case: the row itself is another one now.
"""
import argparse
import json
import pathlib
import sys

KEPT = pathlib.Path(__file__).parent / "results" / "numerics" / "measured.jsonl"


def lines(path):
    """The last of each key; a line that is cut off is none."""
    found = {}
    for line in path.read_text().splitlines() if path.exists() else []:
        try:
            entry = json.loads(line)
            found[entry["key"]] = entry["value"]
        except (ValueError, KeyError, TypeError):
            print(f"{path}: a line cannot be read: {line[:60]}", file=sys.stderr)
    return found


if __name__ == "__main__":
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("state", type=pathlib.Path)
    words.add_argument("--again", action="store_true")
    asked = words.parse_args()
    kept, state = lines(KEPT), lines(asked.state / "measured.jsonl")
    head = state.pop("head", {})
    if (head.get("intersect"), head.get("precision")) != ("exact", "both"):
        sys.exit(f"{asked.state}: not a run of the suite as it is: {head or 'nothing is said of what it asked'}")
    kept["head"] = {"kept": "rows of several runs", "intersect": "exact", "precision": "both"}
    for key, found in state.items():
        if asked.again or key not in kept or found["cases"] >= kept[key]["cases"]:
            kept[key] = found
            print(f"{key}: {found['cases']} cases, {found['wrong']} wrong")
    KEPT.parent.mkdir(exist_ok=True)
    KEPT.write_text("".join(json.dumps({"key": key, "value": kept[key]}) + "\n" for key in sorted(kept)))
