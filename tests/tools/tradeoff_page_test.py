# SPDX-License-Identifier: Apache-2.0
"""The page of `alidade tradeoff` in a real browser: its points stand where the numbers say, and tell what they are."""
import json
import math

from browser import PageTest, main
from program import run


class Page(PageTest):
    @classmethod
    def make(cls, folder):
        words = ["tradeoff", "analytic:mirror-sphere", "--size", "24x24", "--repeat", "2", "--vary", "spp=1,4,16,64", "--vary", "max-depth=0,4",
                 "--external", "cp " + str(folder / "flat<b>.pfm") + " {out.pfm}"]
        (folder / "flat<b>.pfm").write_bytes(b"PF\n24 24\n-1.0\n" + bytes(24 * 24 * 12))
        said = run(*words, "--json", "--report", folder / "page.html")
        assert said.returncode == 0, said
        cls.document = json.loads(said.stdout)
        return folder / "page.html"

    def setUp(self):
        self.show()

    def points(self):
        return self.browser.run("""[...document.querySelectorAll('.point')].map(one => ({row: Number(one.dataset.row), front: one.classList.contains('front'), shape: one.tagName,
            x: Number(one.getAttribute('cx') ?? Number(one.getAttribute('x')) + 6), y: Number(one.getAttribute('cy') ?? Number(one.getAttribute('y')) + 6)}))""")

    def test_points_stand_where_the_numbers_say(self):
        points = {point["row"]: point for point in self.points()}
        rows = self.document["rows"]
        self.assertEqual(set(points), set(range(len(rows))))
        self.assertEqual([points[i]["front"] for i in range(len(rows))], [row["front"] for row in rows])
        self.assertEqual([points[i]["shape"] for i in range(len(rows))], ["circle" if row["program"] == "alidade" else "rect" for row in rows])
        places = [(math.log(rows[i]["cpu_seconds"]), math.log(rows[i]["errors"]["rmse"]), points[i]["x"], points[i]["y"]) for i in points]
        a, b = min(places), max(places)
        per_x = (b[2] - a[2]) / (b[0] - a[0])
        low, high = min(places, key=lambda p: p[1]), max(places, key=lambda p: p[1])
        per_y = (high[3] - low[3]) / (high[1] - low[1])
        self.assertLess(per_y, 0, "more error is higher")
        for cost, error, x, y in places:
            self.assertAlmostEqual(x, a[2] + per_x * (cost - a[0]), delta=0.5)
            self.assertAlmostEqual(y, low[3] + per_y * (error - low[1]), delta=0.5)

    def test_the_front_is_a_line_through_its_points(self):
        line = self.browser.run("document.querySelector('.front-line').getAttribute('points')")
        corners = [tuple(map(float, pair.split(","))) for pair in line.split()]
        expected = sorted((point["x"], point["y"]) for point in self.points() if point["front"])
        self.assertEqual(len(corners), len(expected))
        for got, want in zip(corners, expected):
            self.assertAlmostEqual(got[0], want[0], places=6)
            self.assertAlmostEqual(got[1], want[1], places=6)

    def test_the_mouse_shows_a_setting(self):
        i = next(i for i, row in enumerate(self.document["rows"]) if row["name"] == "spp=4 max-depth=0")
        place = self.browser.run(f"(({{x, y, width, height}}) => [x + width / 2, y + height / 2])(document.querySelector('.point[data-row=\"{i}\"]').getBoundingClientRect())")
        self.browser.mouse("mouseMoved", *place)
        self.assertEqual(self.browser.run("document.querySelector('#details h2').textContent"), "spp=4 max-depth=0")
        self.browser.wait("[...document.querySelectorAll('#details img')].every(one => one.naturalWidth === 24)")
        self.assertEqual(self.browser.run("document.querySelectorAll('#details img').length"), 2)
        self.assertIn("max_abs", self.browser.run("document.querySelector('#details').textContent"))
        self.assertEqual(self.browser.run("document.querySelector('tr.chosen').dataset.row"), str(i))

    def test_keys_reach_every_point_and_names_are_text(self):
        i = next(i for i, row in enumerate(self.document["rows"]) if row["program"] == "cp")
        self.browser.run(f"document.querySelector('.point[data-row=\"{i}\"]').focus()")
        self.assertIn("flat<b>", self.browser.run("document.querySelector('#details code').textContent"))
        self.assertEqual(self.browser.run("document.querySelectorAll('#details b').length"), 0)
        unnamed = self.browser.run("[...document.querySelectorAll('.point')].filter(one => !one.getAttribute('aria-label') || one.tabIndex !== 0).length")
        self.assertEqual(unnamed, 0)

    def test_numbers_are_shown_to_four_digits(self):
        for value, shown in ((1000, "1000"), (1230, "1230"), (1234.5, "1235"), (0.125, "0.125"), (1.5e7, "1.5e7"), (2e-5, "2e-5"), (0, "0"), (None, "-")):
            self.assertEqual(self.browser.run(f"number({json.dumps(value)})"), shown)

    def test_the_table_has_a_line_for_each(self):
        self.assertEqual(self.browser.run("document.querySelectorAll('#rows tr').length"), len(self.document["rows"]))
        self.assertIn("knee of the front", self.browser.run("document.getElementById('recommended').textContent"))


if __name__ == "__main__":
    main()
