# SPDX-License-Identifier: MIT
"""Lenses: pixels show the directions of OpenCV's formulas, and Stokes vectors have the frames of those directions."""

import math
import unittest

import nicol
import numpy
from nicol import lens
from nicol.lens import Lens

SIZE = (96, 64)
K = numpy.array([[80.0, 0, 50], [0, 78, 30], [0, 0, 1]])


def opencv(directions, k1, k2, p1, p2, k3=0, k4=0, k5=0, k6=0):
    """The pixels of directions by the formulas of OpenCV's documentation."""
    x, y = directions[..., 0] / directions[..., 2], directions[..., 1] / directions[..., 2]
    r = x**2 + y**2
    radial = (1 + k1 * r + k2 * r**2 + k3 * r**3) / (1 + k4 * r + k5 * r**2 + k6 * r**3)
    u = x * radial + 2 * p1 * x * y + p2 * (r + 2 * x**2)
    v = y * radial + p1 * (r + 2 * y**2) + 2 * p2 * x * y
    return K[0, 0] * u + K[0, 2], K[1, 1] * v + K[1, 2]


def fisheye(directions, k1, k2, k3, k4):
    x, y, z = numpy.moveaxis(directions, -1, 0)
    r = numpy.hypot(x, y)
    angle = numpy.arctan2(r, z)
    bent = angle * (1 + k1 * angle**2 + k2 * angle**4 + k3 * angle**6 + k4 * angle**8)
    return K[0, 0] * bent * x / r + K[0, 2], K[1, 1] * bent * y / r + K[1, 2]


class DirectionsTest(unittest.TestCase):
    def assert_pixels(self, found):
        columns, rows = numpy.meshgrid(numpy.arange(SIZE[0]), numpy.arange(SIZE[1]))
        shown = numpy.isfinite(found[0])
        self.assertLess(abs(found[0] - columns)[shown].max(), 1e-6)
        self.assertLess(abs(found[1] - rows)[shown].max(), 1e-6)
        return shown

    def test_opencv(self):
        for distortion in ([0, 0, 0, 0], [-0.3, 0.1, 0.002, -0.003], [-0.2, 0.05, 0.01, 0.004, 0.02], [0.2, 0.1, 0, 0.001, 0.01, 0.3, 0.02, 0.01]):
            with self.subTest(distortion):
                self.assertTrue(self.assert_pixels(opencv(Lens.opencv(K, SIZE, distortion).directions, *distortion)).all())

    def test_fisheye(self):
        for distortion in ([0, 0, 0, 0], [0.05, -0.01, 0.003, -0.0005]):
            with self.subTest(distortion):
                directions = Lens.fisheye(K, SIZE, distortion).directions
                with numpy.errstate(invalid="ignore"):
                    found = fisheye(directions, *distortion)
                found[0][30, 50], found[1][30, 50] = 50, 30  # the middle, where r is 0
                self.assertTrue(self.assert_pixels(found).all())
                numpy.testing.assert_allclose(directions[30, 50], [0, 0, 1], atol=1e-9)
        wide = Lens.fisheye([[10, 0, 47.5], [0, 10, 31.5], [0, 0, 1]], SIZE)
        self.assertTrue(numpy.isnan(wide.directions[32, 0]).all())  # 272 degrees from the view
        self.assertLess(wide.directions[32, 20, 2], 0)  # 158 degrees

    def test_equirectangular(self):
        directions = Lens.equirectangular((8, 4)).directions
        angle = math.pi / 8
        numpy.testing.assert_allclose(directions[0, 4], [math.sin(angle) * math.sin(angle), -math.cos(angle), math.sin(angle) * math.cos(angle)])
        self.assertLess(directions[1, 0, 2], 0)  # the border is behind the camera

    def test_refused(self):
        with self.assertRaisesRegex(ValueError, "distortion has 3 numbers; it must have 4, 5 or 8"):
            Lens.opencv(K, SIZE, [0, 0, 0])
        with self.assertRaisesRegex(ValueError, "no direction is shown at column 0, row 0"):
            Lens.opencv(K, SIZE, [-0.8, 0, 0, 0])


class RenderTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        context = nicol.Context.create()
        cls.scene = nicol.Scene.create(context)
        sky = nicol.Sky(sun_direction=(1, 0.5, 0.6), turbidity=3)
        cls.scene.set_environment(nicol.Environment.create_sky(context, sky), None, 1.0)
        material = nicol.Material.create_pplastic(context, nicol.Pplastic(alpha=0.3, diffuse_reflectance=0.3))
        for x, y, z in ((0, 0, -3), (3, 1, 0), (-3, 0, 1), (0.3, 3, 0.4), (0.2, -3, 0.1), (0, 1, 4)):
            place = [0.8, 0, 0, x, 0, 0.8, 0, y, 0, 0, 0.8, z, 0, 0, 0, 1]
            cls.scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_sphere(context), material=material, to_world=place))
        # Looks along -z, not quite level.
        cls.camera = nicol.Camera(fov=90).look_at((0, 0, 0), (0.2, 0.3, -1), (0.1, 1, 0.2))
        cls.options = nicol.RenderOptions(pixel_samples=8, aovs=nicol.AOV_ALL)

    def pinhole(self, camera, size):
        framebuffer = nicol.Framebuffer.create(self.scene.context, *size, 3)
        nicol.render(self.scene, camera, self.options, framebuffer)
        return nicol.Picture(framebuffer)

    def assert_close(self, picture, stokes, shown):
        error = numpy.sqrt(((picture - stokes)[shown] ** 2).mean())
        self.assertLess(error, 0.03 * numpy.sqrt((stokes[shown][..., 0] ** 2).mean()))

    def test_no_distortion_is_the_pinhole(self):
        K, _, _ = self.camera.to_opencv(SIZE)
        aovs = ("position", "instance", "distance", "normal", "alpha")
        found = lens.render(self.scene, self.camera, Lens.opencv(K, SIZE, [0, 0, 0, 0]), self.options, aovs, sharpness=2)
        self.assertEqual(self.options.aovs, nicol.AOV_ALL)
        expected = self.pinhole(self.camera, SIZE)
        self.assert_close(found["stokes"], expected.stokes, numpy.full(SIZE[::-1], True))
        self.assertGreater((found["instance"] == expected.instance).mean(), 0.97)
        same = (found["instance"] == expected.instance) & (expected.instance != nicol.NO_INSTANCE)
        self.assertGreater(same.sum(), 500)
        # The camera is at the origin; surfaces are those of a sample beside the pixel's middle.
        numpy.testing.assert_allclose(numpy.linalg.norm(found["position"], axis=2)[same], found["distance"][same], rtol=5e-3)

    def test_all_directions_have_the_frames_of_the_camera(self):
        """Pixels of an equirectangular view are those of cameras that look there and have the same up."""
        size = (256, 128)
        view = Lens.equirectangular(size)
        found = lens.render(self.scene, self.camera, view, self.options, sharpness=2)["stokes"]
        _, R, t = self.camera.to_opencv(size)
        for row, column in ((64, 128), (64, 200), (60, 2), (20, 130), (10, 30), (110, 220), (122, 90)):
            with self.subTest(row=row, column=column):
                forward = view.directions[row, column]
                right = numpy.cross(forward, [0, -1, 0])
                right /= numpy.linalg.norm(right)
                axes = numpy.array([right, numpy.cross(forward, right), forward])
                # In the middle of this image, x is horizontal for the lens's camera.
                small = nicol.Camera.from_opencv([[41, 0, 1], [0, 41, 1], [0, 0, 1]], axes @ R, axes @ t, (3, 3))
                expected = self.pinhole(small, (3, 3)).stokes[1, 1]
                self.assertLess(abs(found[row, column] - expected).max(), 0.06 * expected[..., 0].max())

    def test_pixels_without_a_direction(self):
        view = Lens.fisheye([[10, 0, 47.5], [0, 10, 31.5], [0, 0, 1]], SIZE)
        found = lens.render(self.scene, self.camera, view, self.options, ("instance",))
        outside = numpy.isnan(view.directions[..., 0])
        self.assertTrue((found["stokes"][outside] == 0).all() and (found["instance"][outside] == nicol.NO_INSTANCE).all())
        self.assertTrue((found["stokes"][~outside][..., 0] > 0).all())


if __name__ == "__main__":
    unittest.main()
