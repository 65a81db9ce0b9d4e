# SPDX-License-Identifier: MIT
"""The scenes of the gallery render, and show what their page says. usage: gallery_test.py GALLERY_FOLDER"""

import importlib
import sys
import unittest

sys.path.insert(0, sys.argv.pop(1))

import nicol  # noqa: E402
import numpy  # noqa: E402
import scenes  # noqa: E402

SIZE = 48, 27


class GalleryTest(unittest.TestCase):
    def render(self, name):
        """Returns Stokes vectors of a scene and its view."""
        view = importlib.import_module(name).make_view(nicol.default_context())
        stokes = view.render(SIZE, 1)
        self.assertEqual(stokes.shape, (27, 48, 3, 4))
        self.assertTrue(numpy.isfinite(stokes).all())
        self.assertGreater(stokes[..., 0].mean(), 0.001)
        for image in scenes.panels(stokes, view):
            self.assertGreater(image.std(), 0.01)
        return stokes, view

    def test_scenes(self):
        for name in ("car_lamp", "still_life", "gold_bowl", "bubbles"):
            with self.subTest(name):
                self.render(name)

    def test_the_beetle_is_left_circular(self):
        stokes, _ = self.render("beetle")
        lit = stokes[stokes[..., 0] > 0.01]
        degree = lit[:, 3] / lit[:, 0]
        self.assertLess(degree.min(), -0.5)
        self.assertLess(lit[:, 3].sum(), 0)

    def test_stress_has_colours_behind_a_crossed_polarizer(self):
        stokes, view = self.render("ruler")
        dark = stokes[2:6, 2:6]
        angle = numpy.radians(2 * view.polarizer)
        crossed = stokes[..., 0] + numpy.cos(angle) * stokes[..., 1] + numpy.sin(angle) * stokes[..., 2]
        self.assertLess(crossed[2:6, 2:6].max(), 0.02 * dark[..., 0].min())
        middle = crossed[12:15, 8:40] / stokes[12:15, 8:40, :, 0]
        self.assertGreater(numpy.abs(middle[..., 0] - middle[..., 2]).max(), 0.3)

    def test_the_street_is_polarized_by_its_lamps(self):
        stokes, _ = self.render("wet_street")
        road = stokes[20:, 20:44].mean((0, 1, 2))
        self.assertGreater(road[1], 0.5 * road[0])


if __name__ == "__main__":
    unittest.main()
