# SPDX-License-Identifier: MIT
"""Mueller images against other lamps, and converters between conventions against their definitions."""

import math
import unittest

import nicol
import numpy
from nicol import conventions
from nicol.mueller import mueller_image

SIZE = (40, 40)


class MuellerTest(unittest.TestCase):
    def setUp(self):
        self.context = nicol.Context.create()
        self.scene = nicol.Scene.create(self.context)
        plastic = nicol.Material.create_pplastic(self.context, nicol.Pplastic(alpha=0.3))
        metal = nicol.Material.create_conductor(self.context, nicol.Conductor(metal="gold", alpha=0.3))
        for x, material in ((-1, plastic), (1, metal)):
            place = [0.9, 0, 0, x, 0, 0.9, 0, 0, 0, 0, 0.9, 0, 0, 0, 0, 1]
            mesh = nicol.Mesh.create_sphere(self.context)
            self.scene.add_instance(nicol.Instance(mesh=mesh, material=material, to_world=place))
        to_world = nicol.Camera().look_at((4, 3, 4), (0, 0, 0), (0, 1, 0)).to_world
        self.lamp = nicol.Light(value=[60, 50, 40], to_world=list(to_world))
        self.id = self.scene.add_light(self.lamp)
        self.camera = nicol.Camera(fov=45).look_at((0, 1, 6), (0, 0, 0), (0, 1, 0))
        self.options = nicol.RenderOptions(physical=0)
        self.framebuffer = nicol.Framebuffer.create(self.context, *SIZE, self.scene.get_channels())

    def render(self, **polarization):
        self.lamp.polarization = nicol.Polarization(**polarization)
        self.scene.set_light(self.id, self.lamp)
        nicol.render(self.scene, self.camera, self.options, self.framebuffer)
        return self.framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS)

    def image(self):
        return mueller_image(self.scene, self.camera, self.options, self.framebuffer, self.id)

    def test_any_lamp_is_the_matrix_times_its_state(self):
        image = self.image()
        self.assertEqual(image.shape, (*SIZE, 3, 4, 4))
        self.assertGreater(image[..., 0, 0].max(), 1)
        for dolp, aolp, docp in ((0.5, 0.7, 0), (0.6, -1.2, 0.8), (0, 0, -1), (0.3, 2, 0.1)):
            state = numpy.array([1, dolp * math.cos(2 * aolp), dolp * math.sin(2 * aolp), docp])
            found = self.render(dolp=dolp, aolp=aolp, docp=docp)
            self.assertLess(abs(image @ state - found).max(), 2e-5 * found.max())

    def test_metal_does_not_depolarize(self):
        image = self.image()
        lit = image[..., 0, 0] > 0.1
        # The sum of squares is 4 m00^2 for a matrix that keeps light fully polarized, and less for the plastic's base.
        purity = (image**2).sum(axis=(-2, -1))[lit] / (4 * image[lit][:, 0, 0] ** 2)
        self.assertLess(purity.max(), 1 + 1e-3)
        self.assertGreater((purity > 0.999).mean(), 0.2)
        self.assertGreater((purity < 0.9).mean(), 0.2)

    def test_the_lamp_stays_and_physical_is_refused(self):
        before = self.render(dolp=0.4, aolp=0.3)
        self.image()
        nicol.render(self.scene, self.camera, self.options, self.framebuffer)
        numpy.testing.assert_array_equal(before, self.framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS))
        self.options.physical = 1
        with self.assertRaisesRegex(ValueError, "options.physical is 1; it must be 0"):
            self.image()


class ConventionsTest(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(2)
        self.stokes = random.normal(size=(5, 7, 4)) + [4, 0, 0, 0]

    def test_ranges_and_directions(self):
        for degrees, positive, clockwise, from_up in ((30, 30, -30, -60), (-30, 150, 30, 60), (90, 90, 90, 0), (0, 0, 0, 90)):
            angle = math.radians(degrees)
            self.assertAlmostEqual(math.degrees(conventions.positive(angle)), positive)
            self.assertAlmostEqual(math.degrees(conventions.clockwise(angle)), clockwise)
            self.assertAlmostEqual(math.degrees(conventions.from_up(angle)), from_up)

    def test_angles_and_back(self):
        found = conventions.from_angles(*conventions.angles(self.stokes))
        numpy.testing.assert_allclose(found[..., :3], self.stokes[..., :3], atol=1e-12)
        # Malus: light polarized at 30 degrees passes a polarizer at 30 degrees, and none at 120 degrees.
        light = numpy.array([[1, math.cos(math.radians(60)), math.sin(math.radians(60)), 0]])
        numpy.testing.assert_allclose(conventions.angles(light, [30, 120]), [[1], [0]], atol=1e-12)

    def test_rotation_is_of_the_frame(self):
        turned = conventions.rotated(self.stokes, 0.4)
        difference = conventions.wrapped(conventions.aolp(self.stokes) - conventions.aolp(turned))
        numpy.testing.assert_allclose(difference, 0.4, atol=1e-12)

    def test_mirrored_is_an_angle_the_other_way(self):
        found = conventions.aolp(conventions.mirrored(self.stokes))
        numpy.testing.assert_allclose(found, conventions.clockwise(conventions.aolp(self.stokes)))

    def test_image_right(self):
        # Both axes of each pixel by cross products, for a camera of 90 degrees.
        angle = conventions.to_image_right(nicol.Camera(fov=90), SIZE)
        for row, column in ((0, 0), (0, 39), (39, 5), (11, 27)):
            ray = numpy.array([(column + 0.5) / 20 - 1, 1 - (row + 0.5) / 20, -1])
            ray /= numpy.linalg.norm(ray)
            x = numpy.cross(ray, [0, 1, 0])
            x /= numpy.linalg.norm(x)
            y = numpy.cross(-ray, x)
            right = numpy.array([1, 0, 0]) - ray * ray[0]
            self.assertAlmostEqual(angle[row, column], math.atan2(right @ y, right @ x))
        self.assertAlmostEqual(abs(math.degrees(conventions.to_image_right(nicol.Camera(fov=90), (2000, 2000))[0, 0])), 30, 1)

    def test_image_right_of_a_rendered_sky(self):
        # A clear sky is polarized along sun x view; its angle from the image's right projected across each ray is known.
        sun = numpy.array([0.8, 0.5, 0.4])
        camera = nicol.Camera(fov=90).look_at((0, 0, 0), (0, 0, -1), (0, 1, 0))
        with nicol.Context.create() as context:
            scene = nicol.Scene.create(context)
            scene.set_environment(nicol.Environment.create_sky(context, nicol.Sky(sun_direction=list(sun))), None, 1.0)
            framebuffer = nicol.Framebuffer.create(context, *SIZE, scene.get_channels())
            nicol.render(scene, camera, nicol.RenderOptions(), framebuffer)
            stokes = framebuffer.plane(nicol.PLANE_STOKES, 0)
        places = (numpy.arange(40) + 0.5) / 20 - 1
        ray = numpy.stack([*numpy.meshgrid(places, -places), -numpy.ones(SIZE)], axis=-1)
        ray /= numpy.linalg.norm(ray, axis=-1, keepdims=True)
        right = [1, 0, 0] - ray * ray[..., :1]
        right /= numpy.linalg.norm(right, axis=-1, keepdims=True)
        up, field = numpy.cross(-ray, right), numpy.cross(sun, ray)
        expected = numpy.arctan2((field * up).sum(axis=-1), (field * right).sum(axis=-1))
        found = conventions.aolp(conventions.rotated(stokes, conventions.to_image_right(camera, SIZE)))
        self.assertLess(abs(conventions.wrapped(found - expected)).max(), 0.01)
        # Without the rotation it is wrong by up to 30 degrees.
        self.assertGreater(abs(conventions.wrapped(conventions.aolp(stokes) - expected)).max(), 0.4)


class RimTest(unittest.TestCase):
    """A dielectric ball in light from everywhere, as the raw numbers of a polarization camera show it. What its surface reflects
    is polarized along the rim, and what comes out of its body across the rim, whatever a program calls these angles."""

    MIDDLE, RADIUS = 64, 64 / (11 * math.tan(math.radians(6)))  # of the ball, pixels

    def raw(self, **plastic):
        """Returns the numbers of a sensor with Sony's mosaic, 90 45 / 135 0."""
        with nicol.Context.create() as context:
            scene = nicol.Scene.create(context)
            scene.set_environment(nicol.Environment.create_constant(context, [1.0]), None, 1.0)
            material = nicol.Material.create_pplastic(context, nicol.Pplastic(alpha=0.1, **plastic))
            scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_sphere(context), material=material))
            framebuffer = nicol.Framebuffer.create(context, 2 * self.MIDDLE, 2 * self.MIDDLE, scene.get_channels())
            nicol.render(scene, nicol.Camera(fov=12).look_at((0, 0, 11), (0, 0, 0), (0, 1, 0)), None, framebuffer)
            return numpy.asarray(nicol.Sensor(shot_noise=0, read_noise=0).capture(framebuffer))

    def brightest(self, raw, degrees):
        """Returns the angle of the polarizers whose pixels are brightest at a place near the rim, degrees counter-clockwise from
        the right of the ball's middle."""
        angle = math.radians(degrees)
        column = self.MIDDLE + 0.88 * self.RADIUS * math.cos(angle)
        row = self.MIDDLE - 0.88 * self.RADIUS * math.sin(angle)
        row, column = (int(at) // 2 * 2 - 2 for at in (row, column))
        cell = raw[row : row + 6, column : column + 6].reshape(3, 2, 3, 2).mean(axis=(0, 2))
        return (90, 45, 135, 0)[int(cell.argmax())]

    def test_reflected_light_is_polarized_along_the_rim(self):
        raw = self.raw(diffuse_reflectance=0)
        for degrees in range(0, 360, 45):
            self.assertEqual(self.brightest(raw, degrees), (degrees + 90) % 180)

    def test_light_from_the_body_is_polarized_across_the_rim(self):
        raw = self.raw(diffuse_reflectance=0.8, specular_reflectance=0)
        for degrees in range(0, 360, 45):
            self.assertEqual(self.brightest(raw, degrees), degrees % 180)


if __name__ == "__main__":
    unittest.main()
