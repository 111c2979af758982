# SPDX-License-Identifier: Apache-2.0
"""`alidade povray`: POV-Ray's own words."""
import re
import unittest

from program import InFolder, run

SCENE = """#version 3.7;
camera { orthographic location -5*z right 2*x up 2*y }
#ifndef (R) #declare R = .5; #end
sphere { clock*x, R pigment { rgb 1 } finish { ambient 1 diffuse 0 } }
"""


class Povray(InFolder):
    def setUp(self):
        super().setUp()
        (self.folder / "s.pov").write_text(SCENE)

    def render(self, *words, code=0):
        said = run("povray", *words, cwd=self.folder)
        self.assertEqual((said.returncode, said.stdout), (code, ""), said)
        return said.stderr

    def picture(self, name):
        """Width, height and the grey codes of a PPM file."""
        data = (self.folder / name).read_bytes()
        header = re.match(rb"(P6)\s(\d+)\s(\d+)\s(\d+)\s", data)
        magic, width, height, most = header.groups()
        pixels = data[header.end():]
        self.assertEqual((magic, most), (b"P6", b"255"))
        return int(width), int(height), pixels[::3]

    def test_switches_and_keys_mean_the_same(self):
        self.render("+Is.pov", "+W16", "+H12", "-A", "+WT1", "-D", "-P", "+FP", "+Oa.ppm")
        self.render("Input_File_Name=s.pov", "Width=16", "height=12", "Antialias=off", "Work_Threads=1", "Output_File_Type=p", 'Output_File_Name="b.ppm"')
        self.assertEqual((self.folder / "a.ppm").read_bytes(), (self.folder / "b.ppm").read_bytes())
        width, height, grey = self.picture("a.ppm")
        self.assertEqual((width, height), (16, 12))
        self.assertEqual((grey[6 * 16 + 8], grey[0]), (255, 0))

    def test_declared_numbers_reach_the_scene(self):
        self.render("s.pov", "Declare=R=2", "+FP", "+W8", "+H8")
        self.assertEqual(set(self.picture("s.ppm")[2]), {255}, "the sphere is larger than the window")

    def test_the_clock_moves_and_frames_are_numbered(self):
        (self.folder / "a.ini").write_text("; frames\nWidth = 20\nHeight=20\n+FP +KFF10\n[large]\nWidth=30\n")
        self.render("a.ini", "+Is.pov", "+SF9", "+EF10")
        self.assertEqual(sorted(p.name for p in self.folder.glob("*.ppm")), ["s09.ppm", "s10.ppm"])
        self.assertNotEqual(self.picture("s09.ppm")[2], self.picture("s10.ppm")[2])
        self.assertEqual(self.picture("s10.ppm")[2][10 * 20 + 19], 255, "the clock is 1 in the last frame")
        self.render("a.ini[LARGE]", "+Is.pov", "+SF1", "+EF1")
        self.assertEqual(self.picture("s01.ppm")[0], 30)

    def test_a_part_of_the_picture(self):
        self.render("+Is.pov", "Declare=R=9", "+W10", "+H10", "+SC3", "+EC4", "+SR0.5", "+FP")
        grey = self.picture("s.ppm")[2]
        self.assertEqual([x for x in range(10) if grey[90 + x]], [2, 3])
        self.assertEqual([y for y in range(10) if grey[10 * y + 2]], [5, 6, 7, 8, 9])

    def test_bits_of_png_files(self):
        for word, bits in (("+FN", 8), ("+FN8", 8), ("+FN16", 16), ("Bits_Per_Color=16", 16)):
            self.render("+Is.pov", "+W8", "+H8", word)
            self.assertEqual((self.folder / "s.png").read_bytes()[24], bits, word)

    def test_slips_exit_with_1_and_the_nearest_word(self):
        self.assertIn("did you mean 'Width='?", self.render("+Is.pov", "Widht=3", code=1))
        self.assertIn("'+~' is no word of POV-Ray", self.render("+Is.pov", "+~", code=1))
        self.assertIn("'+Wx' has no value that Width can take", self.render("+Is.pov", "+Wx", code=1))
        self.assertIn("no scene is named", self.render(code=1))
        self.assertIn("gone.pov: error: there is no such file", self.render("+Igone", code=1))
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_words_without_effect_are_told_once(self):
        said = self.render("+Is.pov", "+W8", "+H8", "+UA", "+UA", "+Q5", "+Q9")
        self.assertEqual(said.count("Output_Alpha"), 1)
        self.assertEqual(said.count("Quality"), 1)
        self.assertNotIn("Quality", self.render("+Is.pov", "+W8", "+H8", "+Q11"))


if __name__ == "__main__":
    unittest.main()
