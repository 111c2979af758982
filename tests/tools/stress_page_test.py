# SPDX-License-Identifier: Apache-2.0
"""The page of `alidade stress` in a real browser: its numbers are those of the document, its axes are logarithmic, and mouse and keys tell points."""
import json
import math

from browser import PageTest, main
from program import run

WORDS = ["--side", "16", "--rounds", "1", "--accel", "bvh,grid"]


class InBrowser(PageTest):
    @classmethod
    def make(cls, folder):
        done = run("stress", *cls.WORDS, "--report", folder / "out.html", "--json", folder / "out.json")
        assert done.returncode == 0, done
        cls.document = json.loads((folder / "out.json").read_text())
        return folder / "out.html"

    def setUp(self):
        self.show()

    def all(self, selector, value):
        return self.browser.run(f"[...document.querySelectorAll({json.dumps(selector)})].map(one => {value})")


class Growth(InBrowser):
    WORDS = ["--generate", "soup:100..10000", "--precision", "float", *WORDS]

    def test_points_are_those_of_the_document_on_logarithmic_axes(self):
        sizes = self.document["scenes"][0]["sizes"]
        wanted = {"Build": lambda one, size: one["build_seconds"]["median"], "Memory": lambda one, size: one["bytes"] / size["triangles"],
                  "Time of a ray: diffuse": lambda one, size: 1e6 / one["rays"][2]["rays_per_second"], "Tests of a ray: random": lambda one, size: one["rays"][3]["boxes"] + one["rays"][3]["triangles"]}
        for title, value in wanted.items():
            points = self.all(f'[data-title="{title}"] g[data-peer="grid float"] circle', "[one.dataset.x, one.dataset.y, one.getAttribute('cx'), one.getAttribute('cy')].map(Number)")
            self.assertEqual([point[0] for point in points], [size["triangles"] for size in sizes])
            for point, size in zip(points, sizes):
                self.assertAlmostEqual(point[1], value(size["structures"][1], size), delta=1e-9 * point[1])
            for at, place in ((0, 2), (1, 3)):
                logs = [(math.log(point[at]), point[place]) for point in points]
                (x0, p0), (x1, p1) = min(logs), max(logs)
                for x, p in logs:
                    self.assertAlmostEqual(p, p0 + (p1 - p0) * (x - x0) / ((x1 - x0) or 1), delta=0.01)

    def test_the_mouse_tells_the_nearest_point(self):
        circle = '[data-title="Build"] g[data-peer="bvh float"] circle:last-of-type'
        self.browser.run(f"document.querySelector('{circle}').scrollIntoView()")
        x, y = self.browser.run(f"(box => [box.x + box.width / 2, box.y + box.height / 2])(document.querySelector('{circle}').getBoundingClientRect())")
        self.browser.mouse("mouseMoved", x, y)
        one = self.document["scenes"][0]["sizes"][-1]
        text = self.browser.run("document.querySelector('[data-title=\"Build\"] output').textContent")
        self.assertTrue(text.startswith(f"bvh float, {one['triangles']} triangles: "), text)
        self.assertAlmostEqual(float(text.split()[-2]), one["structures"][0]["build_seconds"]["median"], delta=1e-3 * one["structures"][0]["build_seconds"]["median"])

    def test_arrows_go_from_point_to_point(self):
        self.browser.run("document.querySelector('[data-title=\"Memory\"] svg').focus()")
        said = []
        for key in ("ArrowRight", "ArrowRight", "ArrowDown", "ArrowLeft"):
            self.browser.press(key)
            said.append(self.browser.run("document.querySelector('[data-title=\"Memory\"] output').textContent.split(':')[0]"))
        self.assertEqual(said, ["bvh float, 100 triangles", "bvh float, 316 triangles", "grid float, 316 triangles", "grid float, 100 triangles"])

    def test_series_can_be_hidden(self):
        self.browser.run("document.querySelector('input[data-peer=\"grid float\"]').click()")
        self.assertEqual(set(self.all('g[data-peer="grid float"]', "one.style.display")), {"none"})
        self.assertEqual(set(self.all('g[data-peer="bvh float"]', "one.style.display")), {""})

    def test_exponents_are_told(self):
        cells = self.all("#growth tbody tr", "[one.children[0].textContent, one.children[2].textContent, JSON.parse(one.children[3].dataset.value)]")
        self.assertEqual(cells, [[one["accelerator"], one["cost"], one["exponent"]] for one in self.document["scenes"][0]["growth"]])
        self.assertEqual(self.all("details .agreement .pass", "1"), [1] * 5)


class OneSize(InBrowser):
    WORDS = ["--generate", "zoo:2000", "--generate", "scan:2000", *WORDS]

    def test_bars_and_tables(self):
        self.assertEqual(self.all("section.scene h2", "one.firstChild.textContent"), ["zoo", "scan"])
        bars = self.all('section[aria-label="scan"] [data-title="Build"] rect', "[one.dataset.peer, Number(one.dataset.value), Number(one.getAttribute('width'))]")
        structures = self.document["scenes"][1]["sizes"][0]["structures"]
        self.assertEqual([bar[:2] for bar in bars], [[f"{one['accelerator']} {one['precision']}", one["build_seconds"]["median"]] for one in structures])
        for bar in bars:
            self.assertAlmostEqual(bar[2] / bars[0][2], bar[1] / bars[0][1], delta=1e-6)
        self.assertEqual(len(self.all('section[aria-label="zoo"] table:last-of-type tbody tr', "1")) > 0, True)
        self.assertEqual(self.browser.run("document.getElementById('commands').textContent"), self.document["command"])

    def test_everything_has_a_name(self):
        nodes = [node for node in self.browser.call("Accessibility.getFullAXTree")["nodes"] if not node["ignored"] and node["role"]["value"] in {"image", "img", "checkbox", "button", "link"}]
        self.assertGreater(len(nodes), 5)
        self.assertEqual([node["role"]["value"] for node in nodes if not node.get("name", {}).get("value")], [])


if __name__ == "__main__":
    main()
