# SPDX-License-Identifier: MIT
"""The Python package's pictures: load(), render() and Picture, and what arrays may be."""

import math
import os
import subprocess
import sys
import tempfile
import unittest
from types import SimpleNamespace

import nicol
import numpy

RENDERER, SCENE = sys.argv.pop(1), sys.argv.pop(1)
SIZE = (40, 30)


class PictureTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = nicol.load(SCENE)
        cls.picture = nicol.render(cls.scene, size=SIZE)

    def test_a_picture_is_that_of_nicol_render(self):
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = os.path.join(folder, "ours.exr"), os.path.join(folder, "theirs.exr")
            for quality in (None, "preview"):
                nicol.render(SCENE, size=SIZE, quality=quality, aovs=()).save(ours)
                wanted = ["--quality", quality] if quality else []
                subprocess.run([RENDERER, SCENE, "-o", theirs, "--size", "40x30", *wanted], check=True, capture_output=True)
                with open(ours, "rb") as a, open(theirs, "rb") as b:
                    self.assertEqual(a.read(), b.read())

    def test_what_it_shows(self):
        picture = self.picture
        self.assertEqual(picture.stokes.shape, (30, 40, 3, 4))
        self.assertTrue((picture.stokes == numpy.stack([picture.s0, picture.s1, picture.s2, picture.s3], -1)).all())
        linear = numpy.hypot(picture.s1, picture.s2)
        self.assertLess(numpy.abs(picture.dolp * picture.s0 - linear).max(), 1e-5 * picture.s0.max())
        for angle in (0, 30, 90):
            across = picture.polarizer(angle) + picture.polarizer(angle + 90)
            self.assertLess(numpy.abs(across - picture.s0).max(), 1e-5 * picture.s0.max())
        along = 0.5 * (picture.s0 + linear * numpy.cos(2 * (picture.aolp - math.radians(20))))
        self.assertLess(numpy.abs(picture.polarizer(20) - along).max(), 1e-5 * picture.s0.max())
        seen = picture.alpha == 1
        self.assertTrue(numpy.isfinite(picture.depth[seen]).all() and seen.any())
        self.assertEqual(picture.normal.shape, (30, 40, 3))
        self.assertIn(picture.instance[seen][0], self.scene.get_instance_ids())
        self.assertGreater(picture.statistics.predicted_error, 0)

    def test_bytes_give_the_picture_of_the_file(self):
        folder, asked = os.path.dirname(SCENE), []
        with open(SCENE, "rb") as file:
            scene = file.read()

        def find(name):
            asked.append(name)
            path = os.path.join(folder, name)
            if os.path.isfile(path):
                with open(path, "rb") as file:
                    return file.read()

        loaded = nicol.load(scene, files=find)
        self.assertGreater(len(asked), 0)
        mapping = {name: find(name) for name in list(asked) if find(name) is not None}
        for again in (loaded, nicol.load(bytearray(scene), files=mapping)):
            self.assertTrue((nicol.render(again, size=SIZE).stokes == self.picture.stokes).all())
        with self.assertRaises(nicol.Error) as raised:
            nicol.load(scene, files={})
        self.assertEqual(raised.exception.code, nicol.ERROR_FILE_NOT_FOUND)
        with self.assertRaises(TypeError):
            nicol.load(SCENE, files=mapping)

        def breaks(name):
            raise KeyError(name)

        with self.assertRaises(KeyError):
            nicol.load(scene, files=breaks)
        film = b"""<scene version="3.0.0"><integrator type="path"><integer name="max_depth" value="3"/></integrator>
            <sensor type="perspective"><sampler type="independent"><integer name="sample_count" value="2"/></sampler>
            <film type="hdrfilm"><rfilter type="gaussian"/></film></sensor><emitter type="constant"/>
            <shape type="sphere"><point name="center" x="0.1" y="0" z="5"/></shape></scene>"""
        with tempfile.TemporaryDirectory() as out:
            path = os.path.join(out, "film.xml")
            with open(path, "wb") as file:
                file.write(film)
            of_file, of_bytes = (nicol.render(nicol.load(scene), size=SIZE) for scene in (path, film))
        self.assertEqual(of_bytes.statistics.pixel_samples, 2)
        self.assertTrue((of_bytes.stokes == of_file.stokes).all())
        triangle = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        mesh = nicol.Mesh.load_memory(nicol.default_context(), nicol.memory_file(triangle, "a.obj"))
        self.assertEqual(mesh.get_size(), (3, 1))

    def test_images_in_memory_have_the_bytes_of_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, made in {"a.exr": self.picture.exr(), "a.png": self.picture.png()}.items():
                self.picture.save(os.path.join(folder, name))
                with open(os.path.join(folder, name), "rb") as file:
                    self.assertEqual(file.read(), made)
        with self.assertRaises(nicol.Error) as raised:
            self.picture.framebuffer.encode_exr(lambda address, size: False)
        self.assertEqual(raised.exception.code, nicol.ERROR_WRITE_FAILED)

    def test_other_libraries_take_it(self):
        self.assertTrue((numpy.from_dlpack(self.picture) == self.picture.stokes).all())
        self.assertTrue((numpy.asarray(self.picture) == self.picture.stokes).all())
        self.assertEqual(self.picture._repr_png_()[1:4], b"PNG")

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, wanted in {"a.npy": {}, "a.PNG": {}, "b.png": {"show": "polarizer", "polarizer_angle": 45}}.items():
                self.picture.save(os.path.join(folder, name), **wanted)
            self.assertEqual(numpy.load(os.path.join(folder, "a.npy")).shape, (30, 40, 3, 4))
            self.assertEqual(sorted(os.listdir(folder)), ["a.PNG", "a.npy", "b.png"])
            with self.assertRaisesRegex(ValueError, "a.jpg: the name must end in .exr, .png"):
                self.picture.save(os.path.join(folder, "a.jpg"))

    def test_what_is_refused(self):
        scene, options = self.scene, nicol.RenderOptions()
        framebuffer = nicol.Framebuffer.create(nicol.default_context(), *SIZE, 3)
        for error, text, wanted in (
            (ValueError, "shade_at is 'pixel'; it must be one of automatic, vertices, pixels", {"shade_at": "pixel"}),
            (ValueError, "quality is 'best'; it must be one of realtime, preview, final", {"quality": "best"}),
            (ValueError, "aov is 'z'; it must be one of depth", {"aovs": ["z"]}),
            (AttributeError, "no field sice", {"sice": SIZE}),
            (TypeError, "either options are given", {"options": options, "tolerance": 0.1}),
            (TypeError, "the framebuffer has the size", {"framebuffer": framebuffer, "size": SIZE}),
        ):
            with self.assertRaisesRegex(error, text):
                nicol.render(scene, **wanted)
        with self.assertRaisesRegex(AttributeError, "no depht; it has stokes"):
            self.picture.depht
        with self.assertRaisesRegex(nicol.Error, "did not ask for it"):
            self.picture.variance

    def test_the_c_function_is_still_there(self):
        for render in (nicol.render, nicol.capi.render):
            framebuffer = nicol.Framebuffer.create(nicol.default_context(), *SIZE, 3)
            self.assertIsNone(render(self.scene, self.scene.get_camera(), None, framebuffer))
            self.assertGreater(nicol.Picture(framebuffer).s0.max(), 0)

    def test_scenes_that_no_file_describes(self):
        context = nicol.default_context()
        scene = nicol.Scene.create(context)
        scene.set_environment(nicol.Environment.create_constant(context, [0.5, 0.5, 0.5]), None, 1)
        picture = nicol.render(scene, nicol.Camera(), size=SIZE, quality="realtime")
        self.assertTrue(numpy.allclose(picture.s0, 0.5, atol=1e-3))
        self.assertTrue(numpy.allclose(nicol.render(scene, nicol.Camera(), size=SIZE).s0, 0.5, atol=1e-3))

    def test_keywords_replace_defaults_of_the_file(self):
        turned = nicol.render(nicol.load(SCENE, light_angle=200), size=SIZE)
        self.assertGreater(numpy.abs(turned.s0 - self.picture.s0).max(), 0.01)


class Lent:
    """An array of another library, which has DLPack and nothing else."""

    def __init__(self, array):
        self.array = array

    def __dlpack__(self, **wanted):
        return self.array.__dlpack__(**wanted)

    def __dlpack_device__(self):
        return self.array.__dlpack_device__()


class ArrayTest(unittest.TestCase):
    POSITIONS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    FACES = [[0, 1, 2], [0, 2, 3]]

    def test_meshes(self):
        positions, faces = numpy.array(self.POSITIONS, "f"), numpy.array(self.FACES, "I")
        scene = SimpleNamespace(vertices=positions.astype("d"), faces=faces.astype("q"))
        for given in ((self.POSITIONS, self.FACES), (positions, faces), (scene,)):
            data = nicol.mesh_data(*given)
            self.assertEqual((data.vertex_count, data.triangle_count), (4, 2))
            self.assertEqual(data.positions[:12], [float(x) for row in self.POSITIONS for x in row])
            self.assertEqual(data.indices[:6], [0, 1, 2, 0, 2, 3])

    def test_images(self):
        context = nicol.default_context()
        pixels = numpy.full((8, 16, 3), 0.5, "f")
        for given in (pixels.tolist(), pixels, Lent(pixels)):
            self.assertEqual(nicol.image(given).width, 16)
            nicol.Environment.create_image(context, nicol.image(given))
            self.assertEqual(nicol.texture_image(given).type, nicol.TEXEL_FLOAT32)


if __name__ == "__main__":
    unittest.main()
