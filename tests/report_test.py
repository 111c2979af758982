# SPDX-License-Identifier: Apache-2.0
"""What tests/run says of a run: each failure's output, and the reason of each skip once."""
import contextlib
import io
import pathlib
import tempfile
import unittest

import report

SKIPPED = "[ RUN      ] A.One\n/src/a.cpp:2: Skipped\nthe reference scenes\nare not there\n[  SKIPPED ] A.One (0 ms)\n"


def case(name, status, output):
    return f'<testcase name="{name}" status="{status}"><system-out>{output}</system-out></testcase>'


def said(*cases):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "tests.xml"
        path.write_text(f"<testsuite>{''.join(cases)}</testsuite>")
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            report.main(path)
        return out.getvalue()


class Report(unittest.TestCase):
    def test_the_output_of_a_failure_is_shown_and_no_other(self):
        text = said(case("A.Bad", "fail", "expected 1"), case("A.Good", "run", "fine"))
        self.assertEqual(text, "---- FAILED A.Bad\nexpected 1\n\nskipped: nothing\n")

    def test_skips_are_told_by_reason(self):
        text = said(case("A.One", "notrun", SKIPPED), case("A.Two", "notrun", SKIPPED), case("Tool", "notrun", "line\nno such tool\n"))
        self.assertEqual(text, "skipped 2: A.One, A.Two: the reference scenes are not there\nskipped 1: Tool: no such tool\n")


if __name__ == "__main__":
    unittest.main()
