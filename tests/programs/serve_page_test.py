# SPDX-License-Identifier: MIT
# Tests of nicol-serve's page in a browser. The command line: the program, then the arguments of unittest.
import json
import os
import struct
import sys
import tempfile
import unittest

from serve_browser import Browser, find_browser
from serve_client import Server, write_scenes
from images import read_png

PROGRAM = os.path.abspath(sys.argv.pop(1))
SHIFT = 8


@unittest.skipUnless(find_browser(), "no Chromium here")
class Page(unittest.TestCase):
    size = (1000, 700)
    mobile = False

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        write_scenes(folder.name)
        cls.server = Server(PROGRAM, folder.name)
        cls.addClassCleanup(cls.server.stop)
        cls.browser = Browser(*cls.size, mobile=cls.mobile)
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.browser.errors.clear()
        self.open(samples=1)
        self.settle()

    def tearDown(self):
        self.assertEqual(self.browser.errors, [])
        self.assertEqual(self.browser.evaluate("document.getElementById('message').textContent"), "")

    def open(self, samples):
        """Opens the page, which then asks for no more samples per pixel."""
        self.samples = samples
        self.browser.open(f"http://127.0.0.1:{self.server.port}/?samples={samples}")

    def settle(self):
        """Waits until the last requested image is drawn with all its samples, and the row of thumbnails has its size."""
        self.browser.wait("(() => { const all = [...document.querySelectorAll('#scenes img')], list = document.getElementById('scene');"
                          "return list && (list.options.length < 2 || "
                          "(all.length === list.options.length && all.every((one) => one.complete))); })()")  # fmt: skip
        self.browser.wait("document.body !== null && 'shown' in document.body.dataset && "
                          "document.body.dataset.shown === document.body.dataset.wanted && "
                          f"document.body.dataset.samples === '{self.samples}'")  # fmt: skip
        self.browser.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def image(self, scale=0.25):
        """Returns a screenshot of the canvas, without the crosshair of the probe."""
        self.browser.evaluate("document.getElementById('cross').style.visibility = 'hidden'")
        return self.browser.screenshot(*self.box(), scale)

    def rows(self):
        # A smaller screenshot depends on where the canvas lies on the page.
        width, height, pixels = read_png(self.image(scale=1))
        stride = len(pixels) // height
        return [pixels[y * stride : (y + 1) * stride] for y in range(height)]

    def box(self):
        return self.browser.evaluate("(() => { const b = document.getElementById('image').getBoundingClientRect();"
                                     "return [b.left, b.top, b.width, b.height].map(Math.round); })()")  # fmt: skip

    def centre(self):
        left, top, width, height = self.box()
        return [left + width / 2, top + height / 2]

    def asked(self):
        """Returns the address of the image that was fetched last."""
        return self.browser.evaluate("performance.getEntriesByType('resource').filter((e) => e.name.includes('stokes')).at(-1).name")

    def text(self, name):
        return self.browser.evaluate(f"document.getElementById('{name}').textContent")


class Desktop(Page):
    def test_drag_orbits_and_shift_drag_rotations_the_light(self):
        first = self.image()
        self.assertGreater(len(set(read_png(first)[2])), 30)
        x, y = self.centre()
        self.browser.drag((x, y), (x + 120, y + 30))
        self.settle()
        rotated = self.image()
        self.assertNotEqual(first, rotated)
        self.assertIn("azimuth=", self.asked())
        self.assertNotIn("light=", self.asked())
        self.browser.drag((x, y), (x + 120, y), modifiers=SHIFT)
        self.settle()
        self.assertNotEqual(rotated, self.image())
        self.assertIn("light=", self.asked())

    def test_the_polarizer_rotations_without_the_service(self):
        before = self.image()
        asked = self.server.metric("answer_seconds_count")
        left, top, width, height = self.browser.evaluate(
            "(() => { const b = document.getElementById('dial').getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()")
        x, y = left + width / 2, top + height / 2
        self.browser.drag((x + width / 3, y), (x, y - height / 3))
        self.assertEqual(self.text("angle"), "90°")
        self.settle()
        self.assertNotEqual(before, self.image())
        self.assertEqual(self.server.metric("answer_seconds_count"), asked)

    def test_more_samples_while_nothing_moves(self):
        coarse = self.image()
        self.assertNotIn("samples=", self.asked())
        self.open(samples=16)
        self.settle()
        self.assertIn("samples=16", self.asked())
        self.assertNotEqual(coarse, self.image())
        x, y = self.centre()
        self.browser.drag((x, y), (x + 120, y + 30))
        self.browser.drag((x + 120, y + 30), (x, y))
        self.settle()
        self.assertIn("samples=16", self.asked())

    def test_views(self):
        images = []
        for key in "1234567":
            self.browser.key(key)
            self.settle()
            images.append(self.image())
        self.assertEqual(len(set(images)), 7)
        self.assertFalse(self.browser.evaluate("document.getElementById('wheel').hidden"))
        self.browser.evaluate("document.getElementById('split').click()")
        self.settle()
        split = self.rows()
        self.browser.evaluate("document.getElementById('split').click()")
        self.browser.key("2")
        self.settle()
        # The left half shows s0, and the right half the previous view.
        half, whole = len(split[0]) // 2 - 120, self.rows()
        self.assertEqual([row[:half] for row in split], [row[:half] for row in whole])
        self.assertNotEqual([row[-half:] for row in split], [row[-half:] for row in whole])

    def test_keys(self):
        self.browser.evaluate("document.getElementById('image').focus()")
        seen = [self.image()]
        for key, modifiers in (("ArrowLeft", 0), ("ArrowUp", 0), ("ArrowRight", SHIFT), ("+", 0), ("]", 0)):
            self.browser.key(key, modifiers)
            self.settle()
            seen.append(self.image())
        for one, other in zip(seen, seen[1:]):
            self.assertNotEqual(one, other)
        pixel = self.text("pixel")
        self.browser.key("l")
        self.assertNotEqual(self.text("pixel"), pixel)
        self.browser.key("0")
        self.browser.key("[")
        self.settle()
        self.assertEqual(self.image(), seen[0])

    def test_probe_tells_the_numbers_of_the_service(self):
        self.browser.mouse("mouseMoved", *self.centre())
        x, y = map(int, self.text("pixel").split(", "))
        width, height = self.browser.evaluate("[image.width, image.height]")
        halves = self.server.get(f"/scenes/box/stokes.f16?size={width}x{height}").body
        planes = [struct.unpack_from("<4e", halves, 8 * (c * width * height + y * width + x)) for c in range(3)]
        means = [sum(plane[p] for plane in planes) / 3 for p in range(4)]
        for p in range(4):
            self.assertAlmostEqual(float(self.text(f"s{p}")), means[p], delta=1e-3 * means[0])
        degree = 100 * (means[1] ** 2 + means[2] ** 2) ** 0.5 / means[0]
        self.assertAlmostEqual(float(self.text("dolp").rstrip(" %")), degree, delta=0.1)
        self.assertTrue(self.browser.evaluate("document.getElementById('path').getAttribute('d').startsWith('M')"))
        self.assertIn("ms to render and fetch", self.text("time"))

    def test_crosshair_stands_at_the_probe(self):
        x, y = (a + b for a, b in zip(self.centre(), (40, -30)))
        self.browser.mouse("mouseMoved", x, y)
        place = "(() => { const b = document.getElementById('cross').getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]; })()"
        for wanted, found in zip((x, y), self.browser.evaluate(place)):
            self.assertAlmostEqual(wanted, found, delta=2)

    def test_thumbnails_choose_scenes(self):
        count = len(json.loads(self.server.get("/scenes").body)["scenes"])
        self.browser.wait(f"document.querySelectorAll('#scenes img').length === {count} && "
                          "[...document.querySelectorAll('#scenes img')].every((i) => i.naturalWidth > 0)")  # fmt: skip
        pressed = "[...document.querySelectorAll('#scenes button')].map((b) => b.getAttribute('aria-pressed'))"
        self.assertEqual(self.browser.evaluate(pressed), ["true"] + (count - 1) * ["false"])
        before = self.image()
        self.browser.evaluate("document.querySelectorAll('#scenes button')[1].click()")
        self.settle()
        self.assertEqual(self.browser.evaluate(pressed)[:2], ["false", "true"])
        self.assertEqual(self.browser.evaluate("document.getElementById('scene').selectedIndex"), 1)
        self.assertNotEqual(before, self.image())

    def test_scenes(self):
        before = self.image()
        self.browser.evaluate("(() => { const s = document.getElementById('scene'); s.selectedIndex = 1; s.dispatchEvent(new Event('change')); })()")
        self.settle()
        self.assertNotEqual(before, self.image())


class Phone(Page):
    size = (390, 800)
    mobile = True

    def test_layout(self):
        self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), 390)
        _, top, width, height = self.box()
        self.assertGreater(width, 350)
        self.assertLess(top + height, 800)
        panel = self.browser.evaluate("document.getElementById('panel').getBoundingClientRect().top")
        self.assertGreaterEqual(panel, top + height - 1)
        size = self.browser.evaluate("parseFloat(getComputedStyle(document.body).fontSize)")
        self.assertGreaterEqual(size, 16)

    def test_the_light_by_touch(self):
        before = self.image()
        self.browser.evaluate("document.getElementById('light').click()")
        x, y = self.centre()
        touch = lambda kind, *points: self.browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": a, "y": b} for a, b in points])  # noqa: E731
        touch("touchStart", (x, y))
        for step in range(1, 5):
            touch("touchMove", (x + 20 * step, y))
        touch("touchEnd")
        self.settle()
        self.assertNotEqual(before, self.image())
        self.assertIn("light=", self.asked())


if __name__ == "__main__":
    unittest.main()
