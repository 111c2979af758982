# SPDX-License-Identifier: Apache-2.0
"""The layers test itself: every form of a wrong include is found in a tree that has one, and right ones are left alone."""
import pathlib
import tempfile
import unittest

import layers


def complaints_about(**files):
    """Of a tree with one file a folder, given as folder="its text"."""
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        for folder, text in files.items():
            (root / folder / "deep").mkdir(parents=True)
            (root / folder / "deep" / "file.cpp").write_text("// first line\n" + text + "\n")
        return list(layers.complaints(root))


class Layers(unittest.TestCase):
    def test_every_form_of_a_wrong_include_is_found(self):
        for form in ('#include "tracer/render.h"', "#include <tracer/render.h>", '#include "../tracer/render.h"', '#include "../../tracer/render.h"',
                     '  #  include   "tracer/render.h"'):
            self.assertEqual(complaints_about(scene=form), ["scene/deep/file.cpp:2: scene may not include tracer/"], form)

    def test_siblings_never_see_each_other(self):
        self.assertEqual(len(complaints_about(accel='#include "scene/scene.h"')), 1)
        self.assertEqual(len(complaints_about(importers='#include "tracer/film.h"')), 1)
        self.assertEqual(len(complaints_about(tracer='#include "importers/importer.h"')), 1)

    def test_the_program_does_not_see_its_tests(self):
        self.assertEqual(len(complaints_about(core='#include "tests/support/rays.h"')), 1)

    def test_right_includes_are_left_alone(self):
        self.assertEqual(complaints_about(tools='#include "tracer/render.h"', eval='#include "core/ray.h"', core="#include <vector>",
                                          tracer='#include "tracer/film.h"'), [])

    def test_glm_has_one_door(self):
        self.assertEqual(complaints_about(scene="#include <glm/vec3.hpp>"), ["scene/deep/file.cpp:2: GLM is included by core/vec.h alone"])


if __name__ == "__main__":
    unittest.main()
