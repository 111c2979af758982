# SPDX-License-Identifier: Apache-2.0
"""`alidade povray`: POV-Ray's own words."""
import re
import struct
import subprocess
import unittest
import zlib

from program import PROGRAM, InFolder, run

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
        (self.folder / "a.ini").write_text("; frames\n # of all sizes\nWidth = 20\nHeight=20\n+FP +KFF10\n[large] # of frames\nWidth=30# pixels\n")
        self.render("a.ini", "+Is.pov", "+SF9", "+EF10")
        self.assertEqual(sorted(p.name for p in self.folder.glob("*.ppm")), ["s09.ppm", "s10.ppm"])
        self.assertNotEqual(self.picture("s09.ppm")[2], self.picture("s10.ppm")[2])
        self.assertEqual(self.picture("s10.ppm")[2][10 * 20 + 19], 255, "the clock is 1 in the last frame")
        self.render("a.ini[LARGE]", "+Is.pov", "+SF1", "+EF1")
        self.assertEqual(self.picture("s01.ppm")[0], 30)

    def test_numbers_that_scenes_are_told_are_rounded_as_pov_ray_rounds_them(self):
        """The clock is a float; the others have six digits, and the first of a name holds (probed)."""
        (self.folder / "s.pov").write_text(SCENE + '#ifndef (FOO) #declare FOO = 0; #end #debug concat("told ", vstr(5, <clock, clock_delta, initial_clock, final_clock, FOO>, " ", 0, 17), "\\n")\n')
        for words, told in ((["+K0.7", "Declare=FOO=123456.789", "Declare=FOO=2"], [0.69999998807907104, 0, 0, 0, 123457]),
                            (["+KFF4", "+KI0.1", "+KF0.7", "+SF2", "+EF2"], [0.29999998211860657, 0.2, 0.1, 0.7, 0]),
                            (["+KFF3", "+KC", "+KF0.9", "+SF3", "+EF3", "Declare=FOO=16777217"], [0.59999996423721313, 0.3, 0, 0.9, 16777200])):
            said = self.render("+Is.pov", "+W8", "+H6", *words)
            self.assertEqual([float(x) for x in re.search("told (.*)", said)[1].split()], told, words)

    def test_an_include_without_an_ending_and_a_folder_without_a_slash(self):
        (self.folder / "part").write_text("#declare R = 0;")
        (self.folder / "part.inc").write_text("#declare F = function(q) { q*image_width + frame_number } #declare R = F(1);")
        (self.folder / "UP.POV").write_text('#include "part"\n' + SCENE)
        (self.folder / "out").mkdir()
        self.render("+IUP", "+W8", "+H6", "+FP", "+Oout")
        self.assertEqual(set(self.picture("out.ppm")[2]), {255}, "the part.inc that POV-Ray prefers")
        self.render("+IUP", "+W8", "+H6", "+FP", "+Oout/")
        self.assertTrue((self.folder / "out/UP.ppm").exists())

    def test_jitter_ends_at_one(self):
        def grey(*words):
            self.render("+Is.pov", "+W16", "+H16", "+FP", "+A0.01", *words)
            return self.picture("s.ppm")[2]
        self.assertEqual(grey("+J5"), grey("+J1"))
        self.assertNotEqual(grey("+J5"), grey("-J"))

    def test_rows_are_counted_from_one(self):
        for word in ("+EC0", "+ER0", "+SC-3", "Start_Row=-1"):
            self.assertIn("has no value", self.render("+Is.pov", "+W8", "+H6", word, code=1))

    def test_a_part_that_is_none_is_told_in_the_words_that_were_given(self):
        for words, told in ((["+SC20", "+EC10"], "+SC20 +EC10: of 40 columns none is between them"), (["+SC20", "+EC0.2"], "+SC20 +EC0.2: of 40 columns"), (["+EC900"], "+EC900: the picture has 40 columns"),
                            (["Start_Row=31"], "+SR31: the picture has 30 rows"), (["+EC1e30"], "End_Column can take: a number above 0, up to 65536")):
            self.assertIn(told, self.render("+Is.pov", "+W40", "+H30", *words, code=1))

    def test_the_range_of_a_value_is_told(self):
        for word, told in (("+W100000", "Width can take: a whole number from 1 to 65536"), ("+W1e2", "without an exponent"), ("+WT-1", "from 0 to 4096"), ("+Ax", "on, off, or a number from 0"), ("+K1e31", "from -1e+30 to 1e+30"),
                           ("+Qx", "from 0 to 9"), ("+FX", "one of N P E T J S B C H"), ("+FN0", "from 1 to 100"), ("Cyclic_Animation=maybe", "on, true, yes or 1"), ("+SF1e10", "up to 1e+09"), ("Input_File_Name=", "the name of a scene")):
            self.assertIn(told, self.render("+Is.pov", word, code=1), word)

    def test_declarations_are_identifiers_and_finite_numbers(self):
        for value in ("1=2", "a.b=1", "=1", "a", "a=", "a=2x", "a=1e999", "a=1e39", "a=nan", "\u00e9=1"):
            self.assertIn("an identifier, = and a number that a float can hold", self.render("+Is.pov", "Declare=" + value, code=1))
        self.assertIn("no word of the language", self.render("+Is.pov", "Declare=sphere=1", code=1))
        self.render("+Is.pov", "-F", "+W8", "+H8", "Declare=_R2=-1.5e3", "Declare=a=0x10")

    def test_faults_of_ini_files_have_their_places(self):
        (self.folder / "a.ini").write_text("Width=8\n[b]\nHeight=6\n[c\nInclude_INI=d.ini\n")
        (self.folder / "d.ini").write_text("\n\nWidht=3\n")
        self.assertIn("d.ini:3: 'Widht=3' is no word of POV-Ray", self.render("+Is.pov", "d.ini", code=1))
        self.assertIn("a.ini:5: d.ini:3: ", self.render("+Is.pov", "a.ini[c]", code=1))
        self.assertIn("a.ini:4: '[c' has no ]", self.render("+Is.pov", "-F", "a.ini[b]"))
        self.assertIn("a.ini has no section [e]; it has [b], [c]", self.render("+Is.pov", "-F", "a.ini[e]"))
        self.assertIn("has no ]", self.render("+Is.pov", "a.ini[b", code=1))

    def test_quotes_that_are_not_closed_are_left_out(self):
        (self.folder / "a.ini").write_text("[a]Width=9\nHeight='7\nInput_File_Name=\"s.pov\nOutput_File_Type=P\n")
        said = self.render("a.ini[a]")
        self.assertIn("a.ini:2: 'Height='7': the quote is not closed", said)
        self.assertEqual(self.picture("s.ppm")[:2], (9, 7))

    def test_a_part_of_the_picture(self):
        self.render("+Is.pov", "Declare=R=9", "+W10", "+H10", "+SC3", "+EC4", "+SR0.5", "+FP")
        grey = self.picture("s.ppm")[2]
        self.assertEqual([x for x in range(10) if grey[90 + x]], [2, 3])
        self.assertEqual([y for y in range(10) if grey[10 * y + 2]], [5, 6, 7, 8, 9])

    def test_fractions_of_a_picture_are_cut(self):
        """Where parts begin and end in POV-Ray, from 0; 1 is the first column, but as an end the last."""
        for words, columns in ((["+EC0.6"], (0, 27)), (["+EC0.61"], (0, 28)), (["+EC0.999"], (0, 46)), (["+EC1"], (0, 47)), (["+SC0.6"], (28, 47)), (["+SC1"], (0, 47)), (["+SC2", "+EC28"], (1, 27))):
            self.render("+Is.pov", "Declare=R=9", "+W48", "+H2", "+FP", *words)
            seen = [x for x, grey in enumerate(self.picture("s.ppm")[2][:48]) if grey]
            self.assertEqual((seen[0], seen[-1]), columns, words)

    def test_bits_of_files(self):
        for word, bits in (("+FN", 8), ("+FN8", 8), ("+FN16", 16), ("Bits_Per_Color=16", 16)):
            self.render("+Is.pov", "+W8", "+H8", word)
            self.assertEqual((self.folder / "s.png").read_bytes()[24], bits, word)
        self.assertIn("its number is left out", self.render("+Is.pov", "+W8", "+H8", "Output_File_Type=N16"))
        self.assertEqual((self.folder / "s.png").read_bytes()[24], 8)
        for word, most in (("+FP", b"255"), ("+FP16", b"65535")):
            self.render("+Is.pov", "+W8", "+H6", word)
            self.assertEqual((self.folder / "s.ppm").read_bytes().split()[:4], [b"P6", b"8", b"6", most])

    def chunks(self, name):
        """Names of the chunks of a PNG file, whose checksums are right, and the gamma that it says."""
        data, at, names, gamma = (self.folder / name).read_bytes(), 8, [], None
        while at < len(data):
            size = struct.unpack(">I", data[at:at + 4])[0]
            kind, content = data[at + 4:at + 8], data[at + 8:at + 8 + size]
            self.assertEqual(struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0], zlib.crc32(kind + content), kind)
            names.append(kind.decode())
            gamma = struct.unpack(">I", content)[0] if kind == b"gAMA" else gamma
            at += 12 + size
        return names, gamma

    def test_the_curve_of_files(self):
        """Codes, and gAMA of PNG files, are those that POV-Ray 3.7 wrote of these scenes with the same words."""
        wrote = {
            ("3.7", "assumed_gamma 1", "1.0"): (100000, "8 24 40 56 72 88 104 120 135 151 167 183 199 215 231 247"),
            ("3.7", "assumed_gamma 1", "2.2"): (45455, "53 87 110 128 143 157 169 181 191 201 211 219 228 236 244 251"),
            ("3.7", "assumed_gamma 1", "sRGB"): (None, "49 86 110 129 145 158 171 182 193 202 212 220 229 237 244 251"),
            ("3.7", "assumed_gamma 1", "0.5"): (200000, "0 2 6 12 20 30 42 56 72 90 110 132 156 182 209 239"),
            ("3.6", "assumed_gamma 2.2", "1.8"): (55556, "4 14 26 40 54 69 85 101 118 135 152 170 189 207 226 245"),
            ("3.6", "", "1.8"): (None, "8 24 40 56 72 88 104 120 135 151 167 183 199 215 231 247"),
        }
        for (version, settings, gamma), (chunk, codes) in wrote.items():
            (self.folder / "g.pov").write_text(f"#version {version}; global_settings {{ max_trace_level 5 {settings} }} camera {{ orthographic location -z direction z right x up y }}\n"
                                               "plane { z, 0 pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } translate -.5*x } finish { ambient 1 diffuse 0 } }\n")
            self.render("+Ig.pov", "+W16", "+H1", "+FP", "-A", "File_Gamma=" + gamma)
            self.assertEqual(list(self.picture("g.ppm")[2]), [int(code) for code in codes.split()], (version, settings, gamma))
            self.render("+Ig.pov", "+W16", "+H1", "-A", "File_Gamma=" + gamma)
            names, said = self.chunks("g.png")
            if chunk:
                self.assertEqual((said, "sRGB" in names), (chunk, False), gamma)
            else:
                self.assertIn("sRGB", names)
        for wrong in ("0", "-1", "abc"):
            self.assertIn("sRGB, or a number above 0", self.render("+Ig.pov", "File_Gamma=" + wrong, code=1))

    def test_values_are_read_as_by_povray(self):
        """Fractions of whole numbers are cut, a line of an INI file is one setting, and a scene may have any name."""
        (self.folder / "a.ini").write_text('Width=24 Height=18\nHeight="12.9"\n"s.pov"\nDeclare=clock=1\n+FP\n')
        said = self.render("a.ini")
        self.assertEqual(self.picture("s.ppm")[:2], (24, 12))
        for told in ("'Width=24 Height=18': what follows the value is left out", "12.9 is taken as 12", "Declare=clock changes nothing"):
            self.assertIn(told, said)
        (self.folder / "bare").write_text(SCENE)
        self.render("+Ibare", "+W8", "+H6", "+FP")
        self.assertEqual(self.picture("bare.ppm")[:2], (8, 6))
        for word in ("+W0.5", "+W65537", "+W1e2", "+Wnan", "+W8 +H6", "Width=8 Height=6"):
            self.assertIn("has no value that Width can take", self.render("+Is.pov", word, code=1))
        said = self.render("+Is.pov", "+W8", "+H6.9", "+H6.9", "+FP", "Antialias_Depth=3.5", "Quality=9.5", "+Q12", "+AM3")
        self.assertEqual((self.picture("s.ppm")[:2], said.count("6.9 is taken as 6")), ((8, 6), 1))

    def test_a_line_of_an_ini_file_is_one_setting(self):
        (self.folder / "two words.pov").write_text(SCENE.replace("R = .5", "R = Clock"))
        (self.folder / "a.ini").write_text("Input_File_Name=two words.pov +W40\nWidth='8' Height=9\nHeight=6 7\nDeclare=Clock=2 Declare=R=0\nOutput_File_Type=p Display=on\nOutput_To_File=off Display=off\n")
        said = self.render("a.ini")
        self.assertEqual(said.count("what follows the value is left out"), 6)
        self.assertEqual(list(self.folder.glob("*.p[np]*")), [], "it is switched off")
        (self.folder / "s - b -2.pov").write_text(SCENE)
        (self.folder / "b.ini").write_text("Input_File_Name=s - b -2.pov\nWidth=8\nHeight=6\nOutput_File_Type=p\n")
        self.render("b.ini")
        self.assertTrue((self.folder / "s - b -2.ppm").exists())
        self.render("a.ini", "+F")
        self.assertEqual((self.picture("two words.ppm")[:2], set(self.picture("two words.ppm")[2])), ((8, 6), {255}), "a name of one's own that differs from a keyword by a capital")

    def test_slips_exit_with_1_and_the_nearest_word(self):
        self.assertIn("did you mean 'Width='?", self.render("+Is.pov", "Widht=3", code=1))
        self.assertIn("'+~' is no word of POV-Ray", self.render("+Is.pov", "+~", code=1))
        self.assertIn("'+Wx' has no value that Width can take", self.render("+Is.pov", "+Wx", code=1))
        self.assertIn("no scene is named", self.render(code=1))
        self.assertIn("gone.pov: error: there is no such file", self.render("+Igone", code=1))
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_files_of_the_working_directory_and_of_the_library_are_found(self):
        for folder in ("scenes", "library"):
            (self.folder / folder).mkdir()
        (self.folder / "scenes/t.pov").write_text('#version 3.7;\n#include "common.inc"\n')
        (self.folder / "common.inc").write_text(SCENE)
        self.render("+Iscenes/t.pov", "+W8", "+H6", "+FP")
        self.assertEqual(self.picture("scenes/t.ppm")[:2], (8, 6), "beside the scene")
        (self.folder / "library/far.pov").write_text(SCENE)
        self.render("+Ifar", "+Llibrary", "+W8", "+H6", "+FP")
        self.assertEqual(self.picture("far.ppm")[:2], (8, 6))

    def test_what_stands_in_several_folders_is_taken_where_povray_takes_it(self):
        for number, folder in enumerate(("scenes", "library", "."), 1):
            (self.folder / folder).mkdir(exist_ok=True)
            (self.folder / folder / "n.inc").write_text(f'#debug "told {number}\\n"\n')
        (self.folder / "scenes/t.pov").write_text('#version 3.7;\n#include "n.inc"\n' + SCENE)
        words = ("+Iscenes/t.pov", "+Llibrary", "+W8", "+H6", "-F")
        self.assertIn("told 3", self.render(*words))
        (self.folder / "n.inc").unlink()
        self.assertIn("told 2", self.render(*words))
        (self.folder / "library/n.inc").unlink()
        self.assertIn("told 1", self.render(*words))
        (self.folder / "scenes/n.inc").unlink()
        self.assertIn("+LDIR", self.render(*words, code=1))

    def test_a_header_is_included_before_the_scene(self):
        (self.folder / "head.inc").write_text("#declare Told = 7;\n")
        (self.folder / "t.pov").write_text(SCENE + '#debug concat("told ", str(Told, 0, 0))\n')
        for word in ("+HIhead.inc", "Include_Header=head.inc", "Include_Header='head.inc'"):
            self.assertIn("told 7", self.render("+It.pov", "+W8", "+H6", "-F", word))
        self.assertIn("gone.inc is not found", self.render("+It.pov", "+W8", "+H6", "-F", "+HIgone.inc", code=1))

    def test_a_place_that_cannot_be_written_to_is_told_before_the_picture_is_rendered(self):
        (self.folder / "folder.png").mkdir()
        self.assertIn("there is no folder 'gone'", self.render("+Is.pov", "+W60000", "+H60000", "+Ogone/s.png", code=1))
        self.assertIn("is a folder", self.render("+Is.pov", "+W60000", "+H60000", "+Ofolder.png", code=1))
        self.assertEqual(list(self.folder.glob("*.pov-state")), [])

    def test_quotes_around_names_in_switches(self):
        (self.folder / "two words.pov").write_text(SCENE)
        (self.folder / "a.ini").write_text("+W8 +H6 +FP +I\"two words.pov\" +O'a picture'\n")
        self.render("a.ini")
        self.assertEqual(self.picture("a picture.ppm")[:2], (8, 6))
        (self.folder / "it's.pov").write_text(SCENE)
        (self.folder / "b.ini").write_text("+Iit's.pov +W8 +H6 +FP   ; a comment\n")
        self.render("b.ini")
        self.assertEqual(self.picture("it's.ppm")[:2], (8, 6))
        self.render('+I"two words.pov"', "+W8", "+H6", "+FP")
        self.assertEqual(self.picture("two words.ppm")[:2], (8, 6))

    def test_scripts_ask_for_the_version(self):
        self.assertIn("alidade", run("povray", "--version", cwd=self.folder).stdout)

    def test_a_picture_goes_to_stdout(self):
        said = subprocess.run([PROGRAM, "povray", "+Is.pov", "+W8", "+H6", "+FP", "+O-"], cwd=self.folder, capture_output=True)
        self.assertEqual((said.returncode, said.stdout[:2], len(said.stdout)), (0, b"P6", len(b"P6\n8 6\n255\n") + 8 * 6 * 3), said.stderr)
        self.assertEqual(list(self.folder.glob("*.p?m")), [])
        subprocess.run([PROGRAM, "povray", "+Is.pov", "+W8", "+H6", "+O-", "+GSs.txt"], cwd=self.folder, capture_output=True, check=True)
        self.assertIn("8x6", (self.folder / "s.txt").read_text())
        said = subprocess.run([PROGRAM, "povray", "+Is.pov", "+W8", "+H6", "+FP", "+O-", "+KFF3"], cwd=self.folder, capture_output=True)
        self.assertEqual(said.stdout.count(b"P6\n8 6\n255\n"), 3, "frames follow one another, for a pipe")

    def test_steps_between_frames(self):
        self.render("+Is.pov", "+W8", "+H6", "+FP", "+KFF5", "Frame_Step=2")
        self.assertEqual(sorted(p.name for p in self.folder.glob("*.ppm")), ["s1.ppm", "s3.ppm", "s5.ppm"])
        self.render("+Is.pov", "+W8", "+H6", "+FP", "+KFF6", "Frame_Step=2", "+SF2", "+EF5", "+Ot")
        self.assertEqual(sorted(p.name for p in self.folder.glob("t*.ppm")), ["t2.ppm", "t4.ppm"], "steps begin with the subset, as POV-Ray's")
        self.render("+Is.pov", "+W8", "+H6", "+FP", "+SF2", "+EF3")
        self.assertTrue((self.folder / "s.ppm").exists(), "a subset is one of an animation's")

    def test_subsets_of_frames(self):
        for number, (words, first, last) in enumerate([("+KFF10 +SF0.5 +EF0.7", 5, 7), ("+KFF10 Subset_Start_Frame=.65", 6, 10), ("+KFI5 +KFF14 +SF0.8", 8, 14), ("+KFI5 +KFF14 +EF0.8", 5, 8), ("+KFI20 +KFF29 +SF0.5 +EF0.8", 20, 20),
                                                       ("+KFF10 +EF0.99", 1, 9), ("+KFF10 +EF0", 1, 1), ("+KFF10 +SF3 +EF0", 3, 3), ("+KFF10 +SF2.7 +EF4.2", 2, 4), ("+KFF10 +SF5 +EF3", 5, 5), ("+KFF10 +SF12 +EF14", 12, 14), ("+KFF10 +SF12", 12, 12), ("+KFF10 +EF-2", 1, 1), ("+KFF1000000000 +EF-1e8", 1, 1), ("+KFI5 +KFF14 +SF2 +EF4", 5, 5),
                                                       ("+KFI3 +KFF1", 3, 3), ("+KFI-1 +KFF2", 0, 2), ("+KFF2 +STP0", 1, 2)]):
            self.render("+Is.pov", "+W4", "+H3", "+FP", f"+Or{number}_", *words.split())
            self.assertEqual(sorted(int(p.stem.split("_")[1]) for p in self.folder.glob(f"r{number}_*.ppm")), list(range(first, last + 1)), words)

    def test_the_clock_of_a_still_is_on(self):
        (self.folder / "s.pov").write_text(SCENE + '#debug concat("clock_on ", str(clock_on, 0, 0))\n')
        self.assertIn("clock_on 1", self.render("+Is.pov", "+W8", "+H6", "Clock=0.5"))
        self.assertIn("clock_on 0", self.render("+Is.pov", "+W8", "+H6"))

    def test_streams_go_to_files(self):
        (self.folder / "s.pov").write_text(SCENE + '#debug "said\\n"\n#warning "warned\\n"\n')
        self.render("+Is.pov", "+W8", "+H6", "+GDd.txt", "+GWw.txt", "+GFf.txt", "All_File=a.txt", "Statistic_File=on")
        text = {name: (self.folder / name).read_text() for name in ("d.txt", "w.txt", "f.txt", "a.txt", "STATS.OUT")}
        for name, wanted, other in (("d.txt", "said", "warned"), ("w.txt", "warned", "said"), ("STATS.OUT", "s.png: 8x6", "said")):
            self.assertIn(wanted, text[name], name)
            self.assertNotIn(other + "\n", text[name], name)
        self.assertEqual(text["d.txt"], "said\n", "as it is")
        self.assertEqual(text["f.txt"], "")
        self.assertTrue(all(word in text["a.txt"] for word in ("said", "warned", "s.png: 8x6")), text["a.txt"])
        (self.folder / "s.pov").write_text("sphere { 0, 1 pigmnt { } }\n")
        self.render("+Is.pov", "+GFf.txt", code=1)
        self.assertIn("error", (self.folder / "f.txt").read_text())
        self.assertIn("cannot be written", self.render("+Is.pov", "+GDnowhere/d.txt", code=1))

    def test_what_scenes_print_is_shown_as_it_is(self):
        (self.folder / "s.pov").write_text(SCENE + '#for (I, 1, 200) #debug concat(str(I, 0, 0), ",") #end #render "r\\n" #debug "open"\n')
        all_of_it = "".join(f"{i}," for i in range(1, 201))
        shown = self.render("+Is.pov", "+W8", "+H6")
        self.assertTrue(shown.startswith(f"{all_of_it}r\nopen\ns.png: 8x6"), shown)
        for words, wanted in (("-GD", "s.png"), ("Debug_Console=off", "s.png"), ("-GDd.txt +GAa.txt -GA", "s.png"), ("-GR -GS", all_of_it), ("-GA +GD", all_of_it)):
            self.assertTrue(self.render("+Is.pov", "+W8", "+H6", *words.split()).startswith(wanted), words)
        self.assertEqual((self.folder / "d.txt").read_text(), all_of_it + "r\nopen", "#render and #statistics are of POV-Ray's debug stream, too")
        self.assertTrue((self.folder / "a.txt").read_text().startswith(all_of_it + "r\nopen\ns.png"))

    def test_a_cyclic_animation_counts_the_frame_that_is_not_made(self):
        (self.folder / "s.pov").write_text(SCENE + '#debug concat(str(final_frame, 0, 0), ",")\n')
        self.assertTrue(self.render("+Is.pov", "+W8", "+H6", "+KC", "+KFF2").startswith("3,\n"))
        self.assertTrue(self.render("+Is.pov", "+W8", "+H6", "+KFF2").startswith("2,\n"))

    def test_scenes_write_where_they_may(self):
        (self.folder / "s.pov").write_text(SCENE + '#fopen F "out.txt" write #write(F, 12) #fclose F\n')
        self.assertIn("is not written", self.render("+Is.pov", "+W8", "+H6"))
        self.assertFalse((self.folder / "out.txt").exists())
        self.render("+Is.pov", "+W8", "+H6", "--allow-write=.")
        self.assertEqual((self.folder / "out.txt").read_text(), "12")

    def test_what_a_scene_may_ask_for_is_raised(self):
        (self.folder / "s.pov").write_text(SCENE + "#for(I, 1, 30) #declare A = I; #end\n")
        self.assertIn("--limit turns=", self.render("+Is.pov", "+W8", "+H6", "--limit=turns=20", code=1))
        self.render("+Is.pov", "+W8", "+H6", "--limit=turns=40")
        self.assertIn("there is no limit 'turn'", self.render("+Is.pov", "--limit=turn=30", code=1))

    def test_the_language_of_scenes_that_do_not_say_theirs(self):
        (self.folder / "s.pov").write_text('#debug concat(str(version, 0, 2), "\\n")\nobject { sphere { <0 0 0> 2 } texture { ambient 0.2 color red 1 } }\n')
        for word in ("+MV1.0", "Version=1.0"):
            self.assertTrue(self.render("+Is.pov", "+W8", "+H6", word).startswith("1.00\n"), word)
        self.assertIn("error", self.render("+Is.pov", "+W8", "+H6", code=1), "a texture has no ambient any more")
        self.assertIn("+MVx", self.render("+Is.pov", "+MVx", code=1))

    def test_version_3_7_goes_before_the_scenes_own_in_gamma(self):
        (self.folder / "s.pov").write_text("#version 3.5; background { rgb .5 } camera { location -z look_at 0 }\n")
        for words, code in (((), 128), (("+MV3.62",), 128), (("+MV3.7",), 188)):       # POV-Ray's codes
            self.render("+Is.pov", "+W4", "+H4", "+FP", *words)
            self.assertEqual(set(self.picture("s.ppm")[2]), {code}, words)

    def test_the_ini_file_of_all_renders_is_read_first(self):
        (self.folder / "povray.ini").write_text("Width=12\nHeight=9\nOutput_File_Type=P\n")
        self.render("+Is.pov", "+H7")
        self.assertEqual(self.picture("s.ppm")[:2], (12, 7))
        (self.folder / "other.ini").write_text("Width=5\nHeight=4\nOutput_File_Type=P\n")
        said = run("povray", "+Is.pov", cwd=self.folder, env={"POVINI": "other.ini"})
        self.assertEqual((said.returncode, self.picture("s.ppm")[:2]), (0, (5, 4)), said)

    def test_words_without_effect_are_told_once(self):
        said = self.render("+Is.pov", "+W8", "+H8", "+UF", "+FNg", "+FNg")
        self.assertEqual(said.count("Grayscale_Output"), 1)

    def test_pictures_have_alpha_where_it_is_asked_for(self):
        """By the colour type of the PNG file: 2 is RGB, 6 RGBA. Files that have none: it is told. tests/scenes/pov_alpha_pictures.cpp compares pictures with POV-Ray."""
        for words, kind in (([], 2), (["+UA"], 6), (["+UA", "-UA"], 2), (["Output_Alpha=on"], 6)):
            self.assertNotIn("alpha", self.render("+Is.pov", "+Oa.png", "+W8", "+H8", *words))
            self.assertEqual((self.folder / "a.png").read_bytes()[25], kind, words)
        for file_type in "JP":
            self.assertIn("have no alpha", self.render("+Is.pov", "+W8", "+H8", "+UA", "+F" + file_type))

    def test_quality_leaves_out_what_takes_time(self):
        """Below 4 shadows: one picture is another, all others stay. tests/scenes/pov_quality_pictures.cpp compares each quality with POV-Ray."""
        (self.folder / "s.pov").write_text("camera { location <0, 2, -6> look_at 0 } light_source { <3, 9, -3>, 1 } plane { y, -1 pigment { rgb 1 } } sphere { 0, 1 pigment { rgb 1 } }\n")
        seen = {}
        for word in ("+Q3", "+Q4", "Quality=9", "+Q11"):
            self.assertNotIn("Quality", self.render("+Is.pov", "+W32", "+H24", "+FP", word))
            seen[word] = (self.folder / "s.ppm").read_bytes()
        self.assertEqual(len(set(seen.values())), 2)
        self.assertNotEqual(seen["+Q3"], seen["+Q4"])


if __name__ == "__main__":
    unittest.main()
