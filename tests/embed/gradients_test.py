# SPDX-License-Identifier: MIT
"""Gradients from Python: shapes, refusals, and the examples that recover light and reflectances from a picture.

usage: gradients_test.py RECOVER_LIGHT_PY RECOVER_ALBEDO_PY
"""

import os
import re
import subprocess
import sys
import unittest

import nicol
import numpy

LIGHT, ALBEDO = (os.path.abspath(sys.argv.pop(1)) for _ in range(2))
SIZE, ORDER = 8, 2


def errors_of(program, *options):
    """Returns the numbers of the last line that a program prints."""
    ended = subprocess.run([sys.executable, program, *options], capture_output=True, text=True, timeout=300)
    if ended.returncode != 0:
        raise AssertionError(ended.stderr)
    return [float(number) for number in re.findall(r"\d\.\d+e[+-]\d+", ended.stdout.splitlines()[-1])]


class GradientsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        context = nicol.default_context()
        cls.scene = nicol.Scene.create(context)
        cls.texture = nicol.Texture.create_image(context, nicol.texture_image(numpy.linspace(0, 1, 6, dtype="f4").reshape(2, 3)))
        material = nicol.Material.create_scaled(context, nicol.Material.create_diffuse(context, [0.5, 0.4, 0.3]), cls.texture)
        cls.scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_cube(context), material=material))
        cls.scene.add_light(nicol.Light(value=2))
        cls.scene.set_environment(nicol.Environment.create_constant(context, 1), None, 1)
        cls.scene.hide_emitters(1)
        cls.camera = nicol.Camera().look_at((2, 3, 4), (0, 0, 0), (0, 1, 0))
        cls.options = nicol.RenderOptions(order_low=ORDER, order_high=ORDER, physical=0, shade_at="pixels")
        cls.picture = numpy.ones((SIZE, SIZE, 3, 4))

    def found(self, **changes):
        arguments = {"camera": self.camera, "options": self.options, "picture": self.picture, **changes}
        return nicol.gradients(self.scene, **arguments)

    def test_shapes(self):
        found = self.found(wanted=("environment", "lights", "instances"), texture=self.texture, shape=(2, 3, 1))
        self.assertEqual(found.environment.shape, (3, (ORDER + 1) ** 2, 4))
        self.assertEqual(found.lights.shape, (1, 3, 4))
        self.assertEqual(found.instances.shape, (1, 3))
        self.assertGreater(found.environment[0, 0, 0], 0)
        # A factor of all texels changes the picture as a factor of the whole instance does.
        values = numpy.linspace(0, 1, 6).reshape(2, 3, 1)
        self.assertAlmostEqual((values * found.texels).sum(), found.instances.sum(), delta=1e-4 * found.instances.sum())
        self.assertIsNone(self.found().lights)

    def test_refusals(self):
        with self.assertRaisesRegex(ValueError, "'light'"):
            self.found(wanted=["light"])
        with self.assertRaisesRegex(ValueError, "order_low"):
            self.found(options=nicol.RenderOptions(physical=0))
        with self.assertRaisesRegex(nicol.Error, "physical"):
            self.found(options=nicol.RenderOptions(order_low=ORDER, order_high=ORDER))
        for picture in (self.picture[:, :, :1], numpy.full_like(self.picture, numpy.nan)):
            with self.assertRaises(nicol.Error):
                self.found(picture=picture)
        picture = numpy.ascontiguousarray(self.picture, numpy.float32)
        picture = nicol.StokesImage(width=SIZE, height=SIZE, channels=3, pixels=picture, byte_size=picture.nbytes)
        room = numpy.zeros(5)
        for name in ("environment", "lights", "instances", "texels"):
            gradient = nicol.Gradient(**{name: room, f"{name}_count": room.size})
            if name == "texels":
                gradient.texture = self.texture
            with self.assertRaisesRegex(nicol.Error, f"{name}_count is 5"):
                nicol.render_adjoint(self.scene, self.camera, self.options, picture, gradient)
        with self.assertRaisesRegex(nicol.Error, "no room"):
            nicol.render_adjoint(self.scene, self.camera, self.options, picture, nicol.Gradient())
        with self.assertRaisesRegex(nicol.Error, "both or neither"):
            nicol.render_adjoint(self.scene, self.camera, self.options, picture, nicol.Gradient(texture=self.texture))
        with self.assertRaisesRegex(ValueError, "shape"):
            self.found(texture=self.texture)
        self.assertEqual(abs(room).max(), 0)

    def test_light_is_recovered(self):
        s0, linear, circular = errors_of(LIGHT, "--order", "2", "--size", "48x48", "--steps", "40")
        self.assertLess(max(s0, linear, circular), 0.02)

    def test_reflectances_are_recovered(self):
        largest, rms = errors_of(ALBEDO, "--texels", "6", "--size", "48x36", "--steps", "60")
        self.assertLess(largest, 1e-3)
        self.assertLessEqual(rms, largest)


if __name__ == "__main__":
    unittest.main()
