# SPDX-License-Identifier: Apache-2.0
"""Reads the JUnit file of a ctest run; prints the output of each test that failed, and what was skipped and why."""
import collections
import re
import sys
import xml.etree.ElementTree as ElementTree


def reason(output):
    """What a skipped test said: the lines after GoogleTest's "file:line: Skipped", or the last line of another program."""
    said = re.search(r": Skipped\n(.*?)\n\s*\n?\[", output, re.S)
    lines = said[1].split("\n") if said else output.strip().split("\n")[-1:]
    return " ".join(line.strip() for line in lines if line.strip()) or "no reason given"


def main(path):
    skipped = collections.defaultdict(list)
    for case in ElementTree.parse(path).getroot().iter("testcase"):
        output = case.findtext("system-out") or ""
        if case.get("status") == "fail":
            print(f"---- FAILED {case.get('name')}\n{output.rstrip()}\n")
        if case.get("status") in ("notrun", "disabled"):
            skipped[reason(output)].append(case.get("name"))
    for why, names in skipped.items():
        print(f"skipped {len(names)}: {', '.join(names[:3])}{', ...' if len(names) > 3 else ''}: {why}")
    if not skipped:
        print("skipped: nothing")


if __name__ == "__main__":
    main(sys.argv[1])
