#!/usr/bin/env python3
"""What the tests of triangles get wrong and what they cost: bench/results/intersect.md.

    python3 bench/intersect.py BUILD              all of it: some ten minutes
    python3 bench/intersect.py BUILD --quick      a hundredth of the cases, three rounds: to see that it works

Failures are counted by `alidade selftest --numerics --intersect`, times by intersect_cost in interleaved rounds, instructions of the same rays by callgrind (AVX2 at the most).
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

ROWS = "T01 T02 T03 T04 T05 T06 T15 T16 T17 T18".split()
TESTS = ("exact", "robust", "fast")
HERE = pathlib.Path(__file__).parent


def said(*words, codes=(0,)):
    run = subprocess.run(list(map(str, words)), capture_output=True, text=True)
    if run.returncode not in codes:
        raise SystemExit(f"{' '.join(map(str, words))}: {run.returncode}\n{run.stderr}")
    return run.stdout


def failures(program, share):
    """Of a million answers, by row and test."""
    table = {row: {} for row in ROWS}
    for test in TESTS:
        document = json.loads(said(program, "selftest", "--numerics", *ROWS, "--intersect", test, "--share", share, "--json", codes=(0, 1)))
        for row in document["rows"]:
            table[row["id"]][test] = row
    return table


def failure_lines(table):
    yield "| row | answers of each | " + " | ".join(TESTS) + " |"
    yield "|---|---|" + "---|" * len(TESTS)
    for row, by_test in table.items():
        rates = (f"{1e6 * one['wrong'] / one['asked']:.0f}" for one in by_test.values())
        yield f"| {row} {by_test['fast']['name']} | {by_test['fast']['asked']:,} | " + " | ".join(rates) + " |"


def cost_lines(program, words):
    lines = [[cell.strip() for cell in line.split("|")] for line in said(program, *words).splitlines()]
    yield "| scene | rays | exact, % more time than fast | robust |"
    yield "|---|---|---|---|"
    for line in lines:
        if line[0] == "row":
            yield "| " + " | ".join(line[1:]) + " |"
    yield ""
    for line in lines:
        if line[0] == "mean":
            yield f"Geometric mean of all, {line[1]} over fast: **{line[2]} %**, the 95 % interval over rounds is {line[3]} to {line[4]} %."


def instructions(program, test, words):
    with tempfile.TemporaryDirectory() as folder:
        counts = pathlib.Path(folder, "counts")
        said("valgrind", "-q", "--tool=callgrind", "--toggle-collect=intersect_cost_counted", f"--callgrind-out-file={counts}", program, "--count", test, *words)
        return next(int(line.split()[1]) for line in counts.read_text().splitlines() if line.startswith("totals:"))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("--quick", action="store_true")
    options.add_argument("--out", type=pathlib.Path, default=HERE / "results" / "intersect.md")
    given = options.parse_args()
    program, cost = given.build / "tools" / "alidade", given.build / "bench" / "intersect_cost"
    words = ["--rounds", "3", "--scale", "0.01", "--rays", "32"] if given.quick else ["--rounds", "21", "--scale", "0.3", "--rays", "96"]
    counted = ["--scale", "0.01", "--rays", "32"] if given.quick else ["--scale", "0.05", "--rays", "48"]
    counts = {test: instructions(cost, test, counted) for test in TESTS}
    lines = ["# The tests of triangles beside each other", "", "Made by `python3 bench/intersect.py build/release`.", "",
             "## Wrong answers of a million", "",
             "Of rows of the numerical suite (docs/numerics.md), which ask what is hardest: rays at edges and vertices, sizes of 1e-30, grazing triangles. All accelerators but in T17 and T18, in float and in double.", "",
             *failure_lines(failures(program, "0.01" if given.quick else "0.1")), "",
             "## Time", "", f"The BVH in float, CPU time of one thread: `intersect_cost {' '.join(words)}`.", "", *cost_lines(cost, words), "",
             f"Instructions of the same rays through smaller scenes (`intersect_cost --count TEST {' '.join(counted)}` in callgrind): "
             + ", ".join(f"{test} {counts[test]:,} ({100 * (counts[test] / counts['fast'] - 1):+.1f} %)" for test in TESTS) + "."]
    given.out.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
