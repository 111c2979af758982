# SPDX-License-Identifier: Apache-2.0
"""The sizes test itself: what is too long is found, and a reason is heard."""
import contextlib
import io
import pathlib
import tempfile
import unittest

import sizes


def function(name, lines, above=""):
    return above + f"int {name}(int x) {{\n" + "    x += 1;\n" * (lines - 3) + "    return x;\n}\n"


def outcome(text):
    """(exit code, what is printed) for a tree with one file of that text, and forty short functions."""
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        (root / "core").mkdir()
        (root / "core" / "file.cpp").write_text(text)
        (root / "core" / "short.cpp").write_text("".join(function(f"short{i}", 4) for i in range(40)))
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            code = sizes.main(root)
        return code, said.getvalue()


class Sizes(unittest.TestCase):
    def test_short_things_pass(self):
        self.assertEqual(outcome(function("fine", 120))[0], 0)

    def test_a_long_function_needs_a_reason(self):
        code, said = outcome(function("endless", 121))
        self.assertEqual(code, 1)
        self.assertIn("file.cpp:1: endless has 121 lines, more than 120", said)
        self.assertEqual(outcome(function("endless", 121, "// long: a table of facts\n"))[0], 0)

    def test_a_long_file_needs_a_reason(self):
        self.assertIn("401 lines, more than 400", outcome("\n" * 401)[1])
        self.assertEqual(outcome("// long: one table\n" + "\n" * 401)[0], 0)

    def test_the_95th_percentile_counts_all_functions(self):
        self.assertIn("95th percentile of functions is 41", outcome("".join(function(f"f{i}", 41) for i in range(4)))[1])



if __name__ == "__main__":
    unittest.main()
