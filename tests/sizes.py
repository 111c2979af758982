# SPDX-License-Identifier: Apache-2.0
"""Prints how long the functions and files are, folder by folder; fails where clarity is at risk.

Limits: the 95th percentile of functions 40 lines; one function 120 and one file 400 lines, unless `// long: the reason` stands in the line above
the function, in its first line, or in the first five lines of the file. Functions are measured by universal-ctags, from the line of the name to the
closing brace; a lambda is part of the function around it.
"""
import json
import pathlib
import subprocess
import sys

FOLDERS = "core scene topology eval accel stress importers exporters tracer numerics tools tests bench".split()
P95, FUNCTION, FILE = 40, 120, 400


def sources(root):
    return [path for folder in FOLDERS for path in sorted((root / folder).rglob("*")) if path.suffix in (".h", ".cpp")]


def functions(paths):
    """(lines, name, path, first line) of every function."""
    command = ["ctags", "--output-format=json", "--fields=+ne", "--languages=C++", "--language-force=C++", "--kinds-C++=f", "-L", "-", "-o", "-"]
    tags = subprocess.run(command, input="\n".join(map(str, paths)), capture_output=True, text=True, check=True).stdout
    for tag in map(json.loads, tags.splitlines()):
        if "end" in tag and not tag["name"].startswith("__anon"):
            yield tag["end"] - tag["line"] + 1, tag["name"], pathlib.Path(tag["path"]), tag["line"]


def percentile(values, p):
    return sorted(values)[min(len(values) - 1, int(p * len(values)))] if values else 0


def explained(lines):
    return any("// long:" in line for line in lines)


def row(name, lengths, files):
    longest = max(lengths, default=(0, "-"))
    sizes = [length for length, *_ in lengths]
    largest = max(files.items(), key=lambda item: len(item[1]), default=(pathlib.Path("-"), []))
    return (f"{name:10} {len(sizes):9} {percentile(sizes, 0.5):5} {percentile(sizes, 0.95):5} {longest[0]:8} {longest[1][:36]:36} "
            f"{len(files):6} {sum(map(len, files.values())):7} {len(largest[1]):8} {largest[0].name}")


def complaints(every, text):
    p95 = percentile([length for length, *_ in every], 0.95)
    if p95 > P95:
        yield f"the 95th percentile of functions is {p95} lines, more than {P95}"
    for length, name, path, line in every:
        if length > FUNCTION and not explained(text[path][max(0, line - 2):line]):
            yield f"{path}:{line}: {name} has {length} lines, more than {FUNCTION}"
    for path, lines in text.items():
        if len(lines) > FILE and not explained(lines[:5]):
            yield f"{path}: {len(lines)} lines, more than {FILE}"


def main(root):
    text = {path: path.read_text().splitlines() for path in sources(root)}
    every = list(functions(text))
    print(f"{'folder':10} {'functions':>9} {'p50':>5} {'p95':>5} {'longest':>8} {'its name':36} {'files':>6} {'lines':>7} {'largest':>8} its name")
    for folder in FOLDERS:
        inside = {path: lines for path, lines in text.items() if path.relative_to(root).parts[0] == folder}
        if inside:
            print(row(folder, [f for f in every if f[2] in inside], inside))
    print(row("all", every, text))
    found = list(complaints(every, text))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
