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
from nicol import conventions

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
        self.assert_close(conventions.positive(self.plane(nicol.PLANE_AOLP)), theirs)
        self.assert_close(conventions.positive(conventions.aolp(self.stokes)), theirs)
        self.assertGreater(theirs.max(), numpy.pi / 2)

    def test_stokes_of_intensities(self):
        """Intensities behind polanalyser's polarizer at four angles follow Nicol's conventions."""
        angles = numpy.radians([0, 45, 90, 135])
        s0, s1, s2, _ = numpy.moveaxis(self.stokes, -1, 0)
        intensities = [(s0 + s1 * numpy.cos(2 * a) + s2 * numpy.sin(2 * a)) / 2 for a in angles]
        self.assert_close(self.stokes[..., :3], polanalyser.calcStokes(intensities, angles), s0.max())
        self.assert_close(conventions.angles(self.stokes), numpy.array(intensities), s0.max())
        for angle, intensity in zip(angles, intensities):
            self.assert_close(intensity, (self.stokes @ polanalyser.polarizer(angle).T)[..., 0], s0.max())

    def test_mosaic(self):
        """polanalyser's demosaicing of a sensor without noise gives back Stokes vectors where light varies little."""
        light = self.stokes.mean(axis=2, keepdims=True)
        scale = 1 / light[..., 0].max()
        sensor = nicol.Sensor(bits=16, shot_noise=0, read_noise=0)
        raw = sensor.capture(numpy.ascontiguousarray(light * scale, numpy.float32))
        pictures = polanalyser.demosaicing(numpy.asarray(raw), polanalyser.COLOR_PolarMono)
        stokes = polanalyser.calcStokes(pictures, numpy.radians([0, 45, 90, 135])) / 65535 / 2
        error = abs(stokes - light[:, :, 0, :3] * scale)[2:-2, 2:-2]
        own = abs(sensor.stokes(raw) / scale - light)[2:-2, 2:-2, 0, :3] * scale
        # The mosaic's own resolution limits both: half of the pixels are within 0.005, as by Nicol's demosaicing.
        self.assertLess(numpy.median(error), 0.005)
        self.assertLess(error.mean(), 1.2 * own.mean())

    def test_rim_of_a_dielectric_ball(self):
        """By polanalyser, the raw numbers of a camera show what a black ball reflects as polarized along its rim."""
        with nicol.Context.create() as context:
            scene = nicol.Scene.create(context)
            scene.set_environment(nicol.Environment.create_constant(context, [1.0]), None, 1.0)
            black = nicol.Material.create_pplastic(context, nicol.Pplastic(alpha=0.1, diffuse_reflectance=0))
            scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_sphere(context), material=black))
            framebuffer = nicol.Framebuffer.create(context, 128, 128, 1)
            nicol.render(scene, nicol.Camera(fov=12).look_at((0, 0, 11), (0, 0, 0), (0, 1, 0)), None, framebuffer)
            raw = nicol.Sensor(bits=16, shot_noise=0, read_noise=0).capture(framebuffer)
        pictures = polanalyser.demosaicing(numpy.asarray(raw), polanalyser.COLOR_PolarMono)
        aolp = polanalyser.cvtStokesToAoLP(polanalyser.calcStokes(pictures, numpy.radians([0, 45, 90, 135])))
        row, column = numpy.indices(aolp.shape) + 0.5 - 64
        ring = abs(numpy.hypot(row, column) - 0.8 * 64 / (11 * numpy.tan(numpy.radians(6)))) < 3
        off = conventions.wrapped(aolp - numpy.arctan2(-row, column) - numpy.pi / 2)[ring]
        self.assertGreater(ring.sum(), 500)
        self.assertLess(numpy.degrees(numpy.median(abs(off))), 2)
        self.assertLess(numpy.degrees(abs(off)).max(), 20)

    def test_image_file(self):
        with tempfile.TemporaryDirectory() as folder:
            self.framebuffer.write_exr(folder + "/image.exr")
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # the image has no property files
                (image,), _ = polanalyser.imreadMultiple(folder)
        self.assert_close(self.plane(nicol.PLANE_S0), image[..., ::-1], self.stokes[..., 0].max())


def quiet(**fields):
    """A sensor of 16 bits without noise, whose numbers are 30000 I for the light I behind a polarizer."""
    return nicol.Sensor(bits=16, shot_noise=0, read_noise=0, gain=1, full_well=1e6, exposure=60000, quantum_efficiency=0.5, **fields)


class SensorTest(unittest.TestCase):
    """Mosaics of Nicol's sensors, taken apart by polanalyser."""

    ANGLES = numpy.radians([0, 45, 90, 135])
    INSIDE = (slice(4, -4), slice(4, -4))  # OpenCV repeats rows and columns at the borders
    STEP = 3 / 30000  # sums of numbers that were rounded twice

    @staticmethod
    def light(channels):
        """Light whose brightness, degree and angle (30 to 60 degrees) of polarization vary from pixel to pixel."""
        y, x, c = numpy.mgrid[:48, :64, :channels] / 64.0
        s0 = 0.4 + 0.3 * x + 0.2 * y * (c + 0.5)
        angle = numpy.radians(30 + 30 * x)
        dolp = 0.3 + 0.3 * y
        planes = [s0, s0 * dolp * numpy.cos(2 * angle), s0 * dolp * numpy.sin(2 * angle), 0 * s0]
        return numpy.ascontiguousarray(numpy.stack(planes, -1), numpy.float32)

    def assert_taken_apart(self, sensor, light, code):
        raw = sensor.capture(light)
        images = [numpy.asarray(i, float).reshape(light.shape[:3])[..., ::-1] for i in polanalyser.demosaicing(raw, code)]
        theirs = polanalyser.calcStokes(images, self.ANGLES)[self.INSIDE] / 30000
        ours = sensor.stokes(raw)[self.INSIDE]
        self.assertLess(abs(ours[..., :3] - theirs).max(), self.STEP)
        # Error of the interpolation between pixels whose light differs.
        self.assertLess(abs(theirs - light[self.INSIDE][..., :3]).max(), 0.004)
        aolp = polanalyser.cvtStokesToAoLP(theirs)
        wanted = numpy.arctan2(light[..., 2], light[..., 1])[self.INSIDE] / 2
        self.assertLess(numpy.degrees(abs(aolp - wanted)).max(), 1)

    def test_mosaic(self):
        self.assert_taken_apart(quiet(), self.light(1), polanalyser.COLOR_PolarMono)

    def test_colour_mosaic(self):
        self.assert_taken_apart(quiet(mosaic=nicol.MOSAIC_POLARIZED_BAYER), self.light(3), polanalyser.COLOR_PolarRGB)

    def test_even_light_comes_back_exactly(self):
        light = numpy.zeros((8, 8, 1, 4), numpy.float32)
        light[...] = (0.75, 0.25, -0.5, 0)
        images = polanalyser.demosaicing(quiet().capture(light))
        stokes = polanalyser.calcStokes([i.astype(float) for i in images], self.ANGLES) / 30000
        self.assertLess(abs(stokes - light[:, :, 0, :3]).max(), 1e-12)

    def test_rotating_plates(self):
        """polanalyser finds the Mueller matrix of elements from what a sensor behind polanalyser's plates measures."""
        plate = nicol.PolarizationElement(kind=nicol.POLARIZATION_ELEMENT_RETARDER, angle=25, retardance=70, transmittance=0.8)
        polarizer = nicol.PolarizationElement(angle=-40)
        sample = quiet(mosaic=nicol.MOSAIC_PLAIN).add_element(polarizer, 6).add_element(plate, 0)
        sample = numpy.array(sample.optics).reshape(4, 4)
        light = numpy.zeros((64, 64, 1, 4), numpy.float32)
        light[..., 0] = 1
        generators, analysers, measured = [], [], []
        for n, angle in enumerate(numpy.radians(numpy.arange(0, 180, 5))):
            generators.append(polanalyser.qwp(angle) @ polanalyser.polarizer(0))
            analysers.append(polanalyser.polarizer(0) @ polanalyser.qwp(5 * angle))
            sensor = quiet(mosaic=nicol.MOSAIC_PLAIN, optics=(analysers[-1] @ sample @ generators[-1]).ravel().tolist())
            sensor.read_noise = 1  # spreads the steps of the numbers
            measured.append(sensor.capture(light, n).mean() / 30000)
        found = polanalyser.calcMueller([numpy.array([[m]]) for m in measured], generators, analysers)
        self.assertLess(abs(found.reshape(4, 4) - sample).max(), 1e-5)
        self.assertLess(abs(numpy.array(quiet().add_element(plate, 0).optics).reshape(4, 4)
                            - 0.8 * polanalyser.retarder(numpy.radians(70), numpy.radians(25))).max(), 1e-9)  # fmt: skip


if __name__ == "__main__":
    unittest.main()
