# SPDX-License-Identifier: MIT
"""polanalyser computes of Nicol's Stokes vectors what Nicol does, and reads its image files.

usage: polanalyser_test.py ASSETS, the folder samples/assets"""

import pathlib
import sys
import tempfile
import unittest
import warnings

try:
    import numpy
    import polanalyser
except ModuleNotFoundError as absent:
    print(f"skipped: {sys.executable} has no module {absent.name}; NICOL_PEER_PYTHON names an interpreter that has polanalyser with opencv and matplotlib")
    sys.exit(77)

import nicol

ASSETS = pathlib.Path(sys.argv.pop(1)).resolve()


class PolanalyserTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with nicol.Context.create() as context, nicol.Scene.load(context, str(ASSETS / "snail_sky.xml")) as scene:
            framebuffer = nicol.Framebuffer.create(context, 96, 72, scene.get_channels())
            nicol.render(scene, scene.get_camera(), None, framebuffer)
        cls.framebuffer = framebuffer
        cls.stokes = cls.plane(nicol.PLANE_STOKES)  # (72, 96, 3, 4)

    @classmethod
    def plane(cls, plane):
        return cls.framebuffer.plane(plane, nicol.ALL_CHANNELS).astype(float)

    def assert_close(self, ours, theirs, largest=1.0):
        self.assertEqual(ours.shape, theirs.shape)
        self.assertLess(abs(ours - theirs).max(), 1e-6 * largest)

    def test_dolp(self):
        self.assertGreater(self.plane(nicol.PLANE_DOLP).max(), 0.5)
        self.assert_close(self.plane(nicol.PLANE_DOLP), polanalyser.cvtStokesToDoLP(self.stokes))

    def test_aolp(self):
        theirs = polanalyser.cvtStokesToAoLP(self.stokes)
        self.assert_close(self.plane(nicol.PLANE_AOLP) % numpy.pi, theirs)
        self.assertGreater(theirs.max(), numpy.pi / 2)

    def test_stokes_of_intensities(self):
        """Intensities behind polanalyser's polarizer at four angles follow Nicol's conventions."""
        angles = numpy.radians([0, 45, 90, 135])
        s0, s1, s2, _ = numpy.moveaxis(self.stokes, -1, 0)
        intensities = [(s0 + s1 * numpy.cos(2 * a) + s2 * numpy.sin(2 * a)) / 2 for a in angles]
        self.assert_close(self.stokes[..., :3], polanalyser.calcStokes(intensities, angles), s0.max())
        for angle, intensity in zip(angles, intensities):
            self.assert_close(intensity, (self.stokes @ polanalyser.polarizer(angle).T)[..., 0], s0.max())

    def test_image_file(self):
        with tempfile.TemporaryDirectory() as folder:
            self.framebuffer.write_exr(folder + "/image.exr")
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # the image has no property files
                (image,), _ = polanalyser.imreadMultiple(folder)
        self.assert_close(self.plane(nicol.PLANE_S0), image[..., ::-1], self.stokes[..., 0].max())


if __name__ == "__main__":
    unittest.main()
