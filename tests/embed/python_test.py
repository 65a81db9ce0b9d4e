# SPDX-License-Identifier: MIT
"""The Python package: errors, lifetimes, descriptors, buffers and callbacks."""

import array
import ctypes
import gc
import math
import os
import pickle
import re
import subprocess
import sys
import tempfile
import unittest

import nicol
import reader

try:
    import numpy
except ImportError:
    numpy = None

MODEL = reader.read(os.environ["NICOL_INCLUDE"])
GREY = 0.25


def scene_of_sphere(context, material=None):
    scene = nicol.Scene.create(context)
    material = material or nicol.Material.create_diffuse(context, GREY)
    scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_sphere(context), material=material))
    scene.set_environment(nicol.Environment.create_constant(context, 2.0), None, 1)
    return scene


def planes_of(framebuffer, pixels, **wanted):
    framebuffer.read_plane(nicol.PlaneBuffer(pixels=pixels, byte_size=memoryview(pixels).nbytes, **wanted))
    return pixels


def camera():
    return nicol.Camera(fov=40).look_at((0, 0, 4), (0, 0, 0), (0, 1, 0))


class AbiTest(unittest.TestCase):
    def test_layout_is_the_headers(self):
        for name, struct in MODEL.structs.items():
            offsets, size, _ = MODEL.layout(name)
            class_ = getattr(nicol, "".join(part.capitalize() for part in name.split("_")[1:]))
            self.assertEqual(ctypes.sizeof(class_), size, name)
            for field, offset in zip(struct.fields, offsets):
                self.assertEqual(getattr(class_, field.name).offset, offset, f"{name}.{field.name}")

    def test_version(self):
        self.assertEqual(nicol.version(), nicol.VERSION)
        self.assertEqual(nicol.__version__, nicol.version_string())
        self.assertIsNone(nicol.build_info(10000))

    def test_missing_library(self):
        code = "import nicol"
        environment = {**os.environ, "NICOL_LIBRARY": "/nowhere/libnicol.so"}
        ended = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
        self.assertIn("ImportError: libnicol was not found", ended.stderr)
        self.assertIn("NICOL_LIBRARY", ended.stderr)


@unittest.skipIf(numpy is None, "numpy is absent")
class CameraTest(unittest.TestCase):
    K = [[30.0, 0, 11], [0, 31.0, 9], [0, 0, 1]]
    SIZE = (24, 16)
    R = [[0.8, 0, 0.6], [0, 1, 0], [-0.6, 0, 0.8]]
    t = [0.1, -0.2, 4]

    def assert_near(self, found, wanted):
        self.assertEqual(numpy.shape(found), numpy.shape(wanted))
        self.assertLess(numpy.abs(numpy.subtract(found, wanted)).max(), 1e-9)

    def test_conventions_come_back(self):
        camera = nicol.Camera.from_opencv(self.K, self.R, self.t, self.SIZE)
        for found, wanted in zip(camera.to_opencv(self.SIZE), (self.K, self.R, self.t)):
            self.assert_near(found, wanted)
        K, R, t = camera.to_colmap(self.SIZE)
        self.assert_near(K, numpy.add(self.K, [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]]))
        self.assert_near(nicol.Camera.from_colmap(K, R, t, self.SIZE).to_opencv(self.SIZE)[0], self.K)
        to_world, K = camera.to_opengl(self.SIZE)
        again = nicol.Camera.from_opengl(numpy.array(to_world), K, self.SIZE)
        self.assert_near(list(again.to_world), list(camera.to_world))
        # OpenGL's camera looks along its -z, with +y up.
        ahead = numpy.array(to_world) @ [0, 0, -1, 1]
        self.assert_near((numpy.array(self.R) @ ahead[:3] + self.t), [0, 0, 1])

    def test_projection_matrices(self):
        P = numpy.array(self.K) @ numpy.column_stack([self.R, self.t])
        for scale in (1, -3):
            for found, wanted in zip(nicol.Camera.from_projection(scale * P, self.SIZE).to_opencv(self.SIZE), (self.K, self.R, self.t)):
                self.assert_near(found, wanted)
        # OpenGL's: what is at (x, y) of the pixels is at (2 x + 1) / width - 1, 1 - (2 y + 1) / height.
        (width, height), w = self.SIZE, P[2]
        clip = [(2 * P[0] + w) / width - w, w - (2 * P[1] + w) / height, 1.5 * w - [0, 0, 0, 0.2], w]
        for found, wanted in zip(nicol.Camera.from_projection(clip, self.SIZE).to_opencv(self.SIZE), (self.K, self.R, self.t)):
            self.assert_near(found, wanted)
        skewed = numpy.array([[30, 2, 11], [0, 31, 9], [0, 0, 1.0]]) @ numpy.column_stack([self.R, self.t])
        with self.assertRaisesRegex(nicol.Error, "without skew"):
            nicol.Camera.from_projection(skewed, self.SIZE)
        with self.assertRaisesRegex(ValueError, "P has 9 numbers; it must be 3 x 4 or 4 x 4"):
            nicol.Camera.from_projection(numpy.eye(3), self.SIZE)

    def test_pixels_are_where_opencv_has_them(self):
        with nicol.Context.create() as context:
            scene = scene_of_sphere(context)
            camera = nicol.Camera.from_opencv(self.K, self.R, self.t, self.SIZE)
            framebuffer = nicol.Framebuffer.create(context, *self.SIZE, 1)
            nicol.render(scene, camera, nicol.RenderOptions(aovs=nicol.AOV_POSITION | nicol.AOV_ALPHA), framebuffer)
            seen = numpy.asarray(framebuffer.plane(nicol.PLANE_ALPHA)) > 0
            places = numpy.asarray(framebuffer.plane(nicol.PLANE_POSITION))[seen]
            self.assertGreater(len(places), 20)
            x = (places @ numpy.transpose(self.R) + self.t) @ numpy.transpose(self.K)
            rows, columns = numpy.nonzero(seen)
            self.assertLess(numpy.abs(x[:, 0] / x[:, 2] - columns).max(), 1e-3)
            self.assertLess(numpy.abs(x[:, 1] / x[:, 2] - rows).max(), 1e-3)
            lower, upper = scene.get_bounds()
            self.assertTrue((places >= numpy.subtract(lower, 1e-5)).all() and (places <= numpy.add(upper, 1e-5)).all())
            self.assertEqual(len(scene.get_bounds()), 2)


class StructTest(unittest.TestCase):
    def test_fields_have_their_comments(self):
        for struct, text in (
            (nicol.Camera, "fov: horizontal field of view if perspective, degrees, above 0, below 180, default 45"),
            (nicol.RenderOptions, "shade_at: place of shading, default automatic"),
            (nicol.StokesImage, "height: size, pixels, 1 to NICOL_MAX_SIZE"),
            (nicol.Pplastic, "diffuse_reflectance_texture: Texture that replaces diffuse_reflectance"),
        ):
            self.assertIn(text, struct.__doc__)
        self.assertNotIn("struct_size", nicol.Camera.__doc__)

    def test_lists_are_accepted_where_arrays_are(self):
        with nicol.Context.create() as context:
            nested = nicol.MeshData(vertex_count=3, triangle_count=1, positions=[[0, 0, 0], [1, 0, 0], [0, 1, 0]], indices=[[0, 1, 2]])
            self.assertEqual(nicol.Mesh.create(context, nested).get_bounds(), ((0, 0, 0), (1, 1, 0)))
            instance = nicol.Instance(to_world=[[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
            self.assertEqual(instance.to_world[3], 2)
            nicol.Environment.create_psh(context, 1, 1, [[1, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0]])

    def test_fields(self):
        options = nicol.RenderOptions(order_low=4)
        self.assertEqual(options.struct_size, ctypes.sizeof(nicol.RenderOptions))
        self.assertEqual((options.order_low, options.order_high), (4, nicol.ORDER_AUTOMATIC))
        self.assertIn("order_low=4", repr(options))
        with self.assertRaisesRegex(AttributeError, "no field order_lwo; it has .*order_low"):
            nicol.RenderOptions(order_lwo=4)
        with self.assertRaises(TypeError):
            nicol.RenderOptions(order_low="four")

    def test_spectra(self):
        sky = nicol.Sky(radiance=(0.5, 0.25, 1), sun_direction=[1, 2, 3])
        self.assertEqual(sky.radiance.count, 3)
        self.assertEqual(list(sky.radiance.values)[:4], [0.5, 0.25, 1, 0])
        self.assertEqual(list(sky.sun_direction), [1, 2, 3])
        self.assertEqual(nicol.Sky(radiance=0.5).radiance.count, 1)
        with self.assertRaisesRegex(ValueError, "at most 16"):
            nicol.Sky(radiance=[1] * 17)
        with self.assertRaisesRegex(ValueError, "2 numbers where 3"):
            nicol.Sky(sun_direction=[1, 2])

    def test_strings(self):
        self.assertEqual(nicol.Conductor(metal="Au").metal, "Au")

    def test_nested_arrays(self):
        rows = [[1, 0, 0, 7], [0, 1, 0, 8], [0, 0, 1, 9], [0, 0, 0, 1]]
        self.assertEqual(list(nicol.Instance(to_world=rows).to_world), sum(rows, []))


class CallTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.context = nicol.Context.create()
        cls.scene = scene_of_sphere(cls.context)

    def test_errors(self):
        with self.assertRaisesRegex(nicol.Error, "nowhere.exr") as caught:
            nicol.Environment.load(self.context, "nowhere.exr")
        self.assertEqual(caught.exception.code, nicol.ERROR_FILE_NOT_FOUND)
        with self.assertRaisesRegex(ctypes.ArgumentError, "nicol.Context is wanted"):
            nicol.Scene.create(nicol.Mesh.create_cube(self.context))

    def test_errors_and_values_are_pickled(self):
        with self.assertRaises(nicol.Error) as caught:
            nicol.Environment.load(self.context, "nowhere.exr")
        copy = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual((copy.code, str(copy)), (caught.exception.code, str(caught.exception)))
        for value in (camera(), nicol.RenderOptions(samples=7)):
            # Functions that are not set have an address in their text, since Python 3.13 a different one each.
            texts = [re.sub("0x[0-9a-f]+", "0x", repr(each)) for each in (pickle.loads(pickle.dumps(value)), value)]
            self.assertEqual(*texts)
        with self.assertRaisesRegex(TypeError, "mesh of a nicol.Instance"):
            pickle.dumps(nicol.Instance(mesh=nicol.Mesh.create_cube(self.context)))
        with self.assertRaisesRegex(TypeError, "a nicol.Mesh belongs to this process and cannot be pickled"):
            pickle.dumps(nicol.Mesh.create_cube(self.context))

    def test_released_handles(self):
        with nicol.Mesh.create_cube(self.context) as mesh:
            self.assertEqual(len(mesh.get_size()), 2)
        self.assertIn("released", repr(mesh))
        mesh.release()
        with self.assertRaises(nicol.Error) as caught:
            mesh.get_size()
        self.assertEqual(caught.exception.code, nicol.ERROR_INVALID_HANDLE)

    def test_results(self):
        scene = scene_of_sphere(self.context)
        environment, to_world, scale = scene.get_environment()
        self.assertEqual((environment.get_info().channels, to_world[0::5], scale), (1, (1, 1, 1, 1), 1))
        scene.set_environment(None, None, 1)
        self.assertIsNone(scene.get_environment()[0])
        self.assertIsInstance(self.context.get_info().renderer, str)

    def test_lights(self):
        scene = scene_of_sphere(self.context)
        vertical = nicol.Polarization(dolp=1, axis=(0, 1, 0))
        spot = nicol.Light(kind=nicol.LIGHT_SPOT, value=3, cutoff_angle=30, polarization=vertical,
                           texture=nicol.Texture.create_checkerboard(self.context, 1, 0, None))  # fmt: skip
        self.assertEqual([scene.add_light(nicol.Light()), scene.add_light(spot)], [0, 1])
        told, texture = scene.get_light(1)
        self.assertEqual((told.kind, told.value.values[0]), (nicol.LIGHT_SPOT, 3))
        self.assertAlmostEqual(told.cutoff_angle, 30)
        self.assertEqual((told.polarization.dolp, list(told.polarization.axis)), (1, [0, 1, 0]))
        self.assertIsInstance(texture, nicol.Texture)
        self.assertIsNone(scene.get_light(0)[1])
        self.assertEqual(list(scene.get_light(0)[0].polarization.axis), [1, 0, 0])
        scene.set_light(0, told)
        scene.remove_light(1)
        ids = array.array("I", bytes(4 * scene.get_light_count()))
        scene.get_light_ids(ids)
        self.assertEqual(list(ids), [0])
        with self.assertRaisesRegex(nicol.Error, "dolp is 2"):
            scene.add_light(nicol.Light(polarization=nicol.Polarization(dolp=2)))
        with self.assertRaisesRegex(TypeError, "nicol.Polarization is wanted"):
            nicol.Light(polarization=1)
        scene.set_emission(0, nicol.Emission(radiance=4))
        self.assertEqual(scene.get_emission(0)[0].radiance.values[0], 4)
        scene.set_emission(0, None)
        self.assertEqual(scene.get_emission(0)[0].radiance.values[0], 0)

    def render(self, size=32, options=None, scene=None):
        framebuffer = nicol.Framebuffer.create(self.context, size, size, 1)
        nicol.render(scene or self.scene, camera(), options, framebuffer)
        return framebuffer

    def test_planes(self):
        framebuffer = self.render()
        stokes = framebuffer.plane()
        self.assertEqual(tuple(stokes.shape), (32, 32, 4))
        # A white furnace of this albedo: radiance 2 times 0.25.
        self.assertAlmostEqual(float(stokes[16, 16, 0]), 2 * GREY, places=4)

    def test_plane_into_a_callers_buffer(self):
        framebuffer = self.render()
        pixels = array.array("f", bytes(4 * 32 * 32))
        framebuffer.read(nicol.PLANE_S0, 0, pixels)
        rows = ((ctypes.c_float * 32) * 32)()  # a memoryview of which says "<f"
        framebuffer.plane(nicol.PLANE_S0, out=rows)
        self.assertEqual(rows[16][16], pixels[16 * 32 + 16])
        self.assertAlmostEqual(pixels[16 * 32 + 16], 2 * GREY, places=4)
        for wrong in (memoryview(bytes(4 * 32 * 32)).cast("f"), array.array("d", bytes(8 * 32 * 32)), [0.0] * 1024):
            with self.assertRaises(TypeError):
                framebuffer.read(nicol.PLANE_S0, 0, wrong)
        with self.assertRaisesRegex(nicol.Error, "byte_size"):
            framebuffer.read(nicol.PLANE_S0, 0, array.array("f", bytes(4 * 32 * 31)))
        with self.assertRaisesRegex(ValueError, "shape"):
            framebuffer.plane(nicol.PLANE_S0, out=memoryview(bytearray(16)).cast("f", (2, 2)))

    def test_planes_of_surfaces_and_formats(self):
        framebuffer = nicol.Framebuffer.create(self.context, 32, 32, 1)
        nicol.render(self.scene, camera(), nicol.RenderOptions(aovs=nicol.AOV_ALL), framebuffer)
        ids = planes_of(framebuffer, array.array("I", bytes(4 * 1024)), plane=nicol.PLANE_INSTANCE)
        self.assertEqual((ids[0], ids[16 * 32 + 16]), (nicol.NO_INSTANCE, 0))
        for plane, last in ((nicol.PLANE_NORMAL, (3,)), (nicol.PLANE_POSITION, (3,)), (nicol.PLANE_DEPTH, ()),
                            (nicol.PLANE_INSTANCE, ()), (nicol.PLANE_ALPHA, ()), (nicol.PLANE_STOKES, (4,))):  # fmt: skip
            self.assertEqual(tuple(framebuffer.plane(plane).shape), (32, 32, *last))
        self.assertEqual(framebuffer.plane(nicol.PLANE_INSTANCE)[0, 0], nicol.NO_INSTANCE)
        alpha = framebuffer.plane(nicol.PLANE_ALPHA)
        self.assertEqual((float(alpha[0, 0]), float(alpha[16, 16])), (0, 1))
        self.assertAlmostEqual(float(framebuffer.plane(nicol.PLANE_NORMAL)[16, 16, 2]), 1, places=2)
        self.assertEqual(tuple(framebuffer.plane(channel=nicol.ALL_CHANNELS).shape), (32, 32, 1, 4))
        options = nicol.RenderOptions(method=nicol.METHOD_REFERENCE, samples=2, aovs=nicol.AOV_VARIANCE)
        nicol.render(self.scene, camera(), options, framebuffer)
        variance = framebuffer.plane(nicol.PLANE_VARIANCE, channel=nicol.ALL_CHANNELS)
        self.assertEqual(tuple(variance.shape), (32, 32, 1, 4))
        self.assertEqual(float(variance[0, 0, 0, 0]), 0)
        nicol.render(self.scene, camera(), None, framebuffer)
        half = planes_of(framebuffer, array.array("H", bytes(2 * 1024)), plane=nicol.PLANE_S0, format=nicol.FORMAT_FLOAT16)
        self.assertEqual(half[0], 0x4000)
        with self.assertRaises(TypeError):
            planes_of(framebuffer, bytes(4096), plane=nicol.PLANE_S0)

    def test_jobs(self):
        framebuffer, seen = nicol.Framebuffer.create(self.context, 32, 32, 1), []
        options = nicol.RenderOptions(method=nicol.METHOD_REFERENCE, samples=1, progress=lambda verb, _: seen.append(verb))
        job = nicol.render_async(self.scene, camera(), options, framebuffer)
        del options
        gc.collect()
        job.wait(nicol.WAIT_FOREVER)
        self.assertEqual(job.poll().state, nicol.JOB_DONE)
        self.assertEqual(set(seen), {"trace"})

    @unittest.skipIf(numpy is None, "numpy is absent")
    def test_arrays_of_numpy(self):
        square = numpy.array([[0, 0, 0, 9], [1, 0, 0, 9], [0, 1, 0, 9]], numpy.float64)
        mesh = nicol.Mesh.create(self.context, nicol.mesh_data(square[:, :3], numpy.arange(3)))
        self.assertEqual(mesh.get_size(), (3, 1))
        pixels = numpy.ones((4, 8, 3))
        self.assertEqual(nicol.Environment.create_image(self.context, nicol.image(pixels)).get_info().channels, 3)
        out = numpy.zeros((32, 32, 4), numpy.float16)
        self.assertAlmostEqual(float(self.render().plane(out=out)[16, 16, 0]), 2 * GREY, places=3)
        with self.assertRaisesRegex(TypeError, "numbers of kind 'd'"):
            self.render().plane(out=out.astype(numpy.float64))

    @unittest.skipIf(numpy is None, "numpy is absent")
    def test_plane_into_a_part_of_an_array(self):
        framebuffer = self.render()
        sheet = numpy.full((40, 100), -1, numpy.float32)
        part = sheet[4:36, 50:82]
        self.assertIs(framebuffer.plane(nicol.PLANE_S0, out=part), part)
        self.assertTrue((part == framebuffer.plane(nicol.PLANE_S0)).all())
        part[...] = -1
        self.assertTrue((sheet == -1).all())
        with self.assertRaisesRegex(TypeError, "within its rows"):
            framebuffer.plane(nicol.PLANE_S0, out=sheet[:32, 0:64:2])
        with self.assertRaisesRegex(TypeError, "within its rows"):
            framebuffer.plane(nicol.PLANE_S0, out=sheet[31::-1, :32])

    def test_progress(self):
        seen = []
        scene = scene_of_sphere(self.context)
        options = nicol.RenderOptions(progress=lambda verb, fraction: seen.append(verb))
        self.render(options=options, scene=scene)
        self.assertIn(seen[0], ["project", "bake", "relight", "shade", "draw"])
        with self.assertRaises(nicol.Error) as caught:
            stop = nicol.RenderOptions(progress=lambda verb, fraction: False, method=nicol.METHOD_REFERENCE)
            self.render(options=stop, scene=scene)
        self.assertEqual(caught.exception.code, nicol.ERROR_CANCELLED)

    def test_exceptions_in_callbacks(self):
        def stop(verb, fraction):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            self.render(options=nicol.RenderOptions(progress=stop, method=nicol.METHOD_REFERENCE))
        self.render()

    def test_material_of_a_function(self):
        def lambertian(channel, towards_light, towards_viewer, mueller):
            self.assertAlmostEqual(sum(x * x for x in towards_light), 1)
            for entry in range(16):
                mueller[entry] = 0
            mueller[0] = GREY / math.pi

        scene = scene_of_sphere(
            self.context, nicol.Material.create_callback(self.context, nicol.CallbackMaterial(mueller=lambertian))
        )
        gc.collect()
        stokes = self.render(scene=scene).plane()
        self.assertAlmostEqual(float(stokes[16, 16, 0]), 2 * GREY, places=3)
        lent = len(nicol._runtime._lent)
        scene.release()
        gc.collect()
        self.assertLess(len(nicol._runtime._lent), lent)

    def test_image_of_a_buffer(self):
        pixels = array.array("f", [1, 2, 3] * 8 * 5)
        before = len(nicol._runtime._lent)
        environment = nicol.Environment.create_image(self.context, nicol.image(memoryview(pixels).cast("B").cast("f", (5, 8, 3))))
        self.assertEqual(environment.get_info().channels, 3)
        coefficients = array.array("d", bytes(8 * 3 * 4 * 4))
        nicol.psh_project_environment(environment, 1, coefficients)
        for channel in range(3):
            expected = (channel + 1) * math.sqrt(4 * math.pi)
            self.assertAlmostEqual(coefficients[channel * 16], expected, places=6)
        environment.release()
        gc.collect()
        self.assertEqual(len(nicol._runtime._lent), before)

    def test_image_must_have_a_shape(self):
        with self.assertRaisesRegex(ValueError, "shape"):
            nicol.image(array.array("f", [1, 2, 3] * 8 * 5))
        image = nicol.image(memoryview(bytes(4 * 5 * 8 * 2 * 4)).cast("f", (5, 8, 2, 4)))
        self.assertEqual((image.width, image.height, image.channels, image.components), (8, 5, 2, 4))

    def test_mesh_of_buffers(self):
        positions = array.array("f", [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0])
        indices = array.array("I", [0, 1, 2, 2, 1, 3])
        mesh = nicol.Mesh.create(self.context, nicol.mesh_data(positions, indices))
        self.assertEqual(mesh.get_size(), (4, 2))
        wide = nicol.mesh_data(array.array("d", positions), array.array("q", indices))
        self.assertEqual(nicol.Mesh.create(self.context, wide).get_size(), (4, 2))
        with self.assertRaisesRegex(ValueError, "cannot hold"):
            nicol.mesh_data(positions, array.array("i", [0, 1, -2]))
        with self.assertRaisesRegex(ValueError, "positions takes 3"):
            nicol.mesh_data(positions[1:], indices)
        with self.assertRaisesRegex(ValueError, "3 normals for 4 positions"):
            nicol.mesh_data(positions, indices, positions[3:])
        with self.assertRaisesRegex(TypeError, "'f' where one of 'I'"):
            nicol.mesh_data(positions, positions)

    def test_textured_mesh(self):
        positions = array.array("f", [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0])
        indices = array.array("I", [0, 1, 2, 2, 1, 3])
        texcoords = array.array("f", [0, 0, 1, 0, 0, 1, 1, 1])
        mesh = nicol.Mesh.create(self.context, nicol.mesh_data(positions, indices, texcoords=texcoords, colors=positions))
        pixels = memoryview(bytes(range(24))).cast("B", (2, 4, 3))
        image = nicol.texture_image(pixels)
        self.assertEqual((image.width, image.height, image.channels, image.type), (4, 2, 3, nicol.TEXEL_UINT8))
        options = nicol.TextureOptions(filter=nicol.TEXTURE_FILTER_NEAREST, raw=1)
        texture = nicol.Texture.create_image(self.context, image, options)
        material = nicol.Material.create_scaled(self.context, nicol.Material.create_diffuse(self.context, 1), texture)
        scene = nicol.Scene.create(self.context)
        scene.add_instance(nicol.Instance(mesh=mesh, material=material))
        plastic = nicol.Pplastic(diffuse_reflectance_texture=texture)
        texture.release()
        with self.assertRaisesRegex(nicol.Error, "released"):
            nicol.Material.create_pplastic(self.context, plastic)
        plain = nicol.Mesh.create(self.context, nicol.mesh_data(positions, indices))
        with self.assertRaisesRegex(nicol.Error, "texture coordinates"):
            scene.add_instance(nicol.Instance(mesh=plain, material=material))
        of_faces = nicol.Texture.create_face_colors(self.context)
        white = nicol.Material.create_diffuse(self.context, 1)
        painted = nicol.Material.create_scaled(self.context, white, of_faces)
        colors = array.array("f", [1, 0.5, 0, 0, 0.5, 1])
        mesh = nicol.Mesh.create(self.context, nicol.mesh_data(positions, indices, face_colors=colors))
        scene.add_instance(nicol.Instance(mesh=mesh, material=painted))
        with self.assertRaisesRegex(nicol.Error, "colours of faces"):
            scene.add_instance(nicol.Instance(mesh=plain, material=painted))
        with self.assertRaisesRegex(ValueError, "4 face_colors for 2 indices"):
            nicol.mesh_data(positions, indices, face_colors=positions)
        seam = array.array("f", [0, 0, 1, 0, 0, 1])
        mesh = nicol.mesh_data(positions, indices, texcoords=seam, texcoord_indices=array.array("I", [0, 1, 2, 2, 1, 0]))
        self.assertEqual(mesh.texcoord_count, 3)
        with self.assertRaisesRegex(ValueError, "3 texcoords for 4 positions"):
            nicol.mesh_data(positions, indices, texcoords=seam)
        with self.assertRaisesRegex(TypeError, "kind 'd'"):
            nicol.texture_image(memoryview(bytes(64)).cast("d", (2, 4)))
        with self.assertRaisesRegex(ValueError, "shape"):
            nicol.texture_image(bytes(24))

    def test_glass(self):
        mesh, black = nicol.Mesh.create_rectangle(self.context), nicol.Material.create_diffuse(self.context, 0)
        scene = nicol.Scene.create(self.context)
        wall = scene.add_instance(nicol.Instance(mesh=mesh, material=black))
        scene.set_emission(wall, nicol.Emission(radiance=1))
        tinted = nicol.Dielectric(thin=1, int_ior=1, ext_ior=1, specular_transmittance=[0.5, 0.25, 1])
        pane = nicol.Instance(mesh=mesh, material=nicol.Material.create_dielectric(self.context, tinted))
        pane.to_world = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.5, 0, 0, 0, 1]
        scene.add_instance(pane)
        with nicol.Framebuffer.create(self.context, 8, 8, scene.get_channels()) as framebuffer:
            nicol.render(scene, camera(), None, framebuffer)
            for channel, wanted in enumerate([0.5, 0.25, 1]):
                self.assertAlmostEqual(float(framebuffer.plane(nicol.PLANE_S0, channel)[4, 4]), wanted, places=3)
        with self.assertRaisesRegex(nicol.Error, "int_ior"):
            nicol.Material.create_dielectric(self.context, nicol.Dielectric(int_ior=0))

    def test_mathematics(self):
        transform = nicol.PshTransform.create(nicol.PshSampling(order=3))
        rows, columns = transform.get_size()
        theta, weight = array.array("d", bytes(8 * rows)), array.array("d", bytes(8 * rows))
        transform.get_rows(theta, weight)
        self.assertAlmostEqual(sum(weight), 2)
        with self.assertRaisesRegex(ValueError, "must agree"):
            transform.get_rows(theta, weight[1:])
        self.assertEqual(columns, 7)
        bands = array.array("d", bytes(8 * 16 * 4))
        nicol.psh_project_kernel(lambda angle, mueller: mueller.__setitem__(0, 1.0), 3, 0, bands)
        self.assertAlmostEqual(bands[0], math.sqrt(4 * math.pi))

    def test_definitions_and_log(self):
        lines = []
        options = nicol.ContextOptions(log=lambda severity, code, message: lines.append(message), cache_folder="/dev/null/x")
        with nicol.Context.create(options) as context, tempfile.TemporaryDirectory() as folder:
            del options
            gc.collect()
            path = os.path.join(folder, "scene.xml")
            with open(path, "w") as file:
                file.write('<scene version="3.0.0"><default name="w" value="3"/><sensor type="perspective">'
                           '<film type="hdrfilm"><integer name="width" value="$w"/><integer name="height" value="2"/></film>'
                           '</sensor><emitter type="constant"/><shape type="cube"><bsdf type="diffuse"/></shape></scene>')  # fmt: skip
            with nicol.Scene.load(context, path, ["w=17"]) as scene:
                self.assertEqual(scene.get_film_size(), (17, 2))
                self.assertEqual(scene.get_sample_count(), 0)
                nicol.render(scene, camera(), None, nicol.Framebuffer.create(context, 17, 2, scene.get_channels()))
                replaced = []
                context.set_log(lambda severity, code, message: replaced.append(message))
                gc.collect()
                stokes = array.array("f", [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -0.1, *11 * [0]])
                image = nicol.Image(width=2, height=3, channels=1, components=4, pixels=stokes, byte_size=96)
                nicol.Environment.create_image(context, image)
                context.set_log(None)
                nicol.Environment.create_image(context, image)
        self.assertTrue(any("/dev/null/x" in line for line in lines), lines)
        self.assertEqual(len(replaced), 1, replaced)
        self.assertIn("negative radiance", replaced[0])

    def test_cache_folder(self):
        before = dict(os.environ)
        self.addCleanup(os.environ.update, before)
        with tempfile.TemporaryDirectory() as folder:
            os.environ["XDG_CACHE_HOME"] = folder
            for kept, options in ((False, None), (True, None), (True, nicol.ContextOptions(threads=1))):
                os.environ["NICOL_CACHE"] = ""
                if kept:
                    del os.environ["NICOL_CACHE"]
                with nicol.Context.create(options) as context:
                    material = nicol.Material.create_pplastic(context, nicol.Pplastic())
                    scene = nicol.Scene.create(context)
                    scene.set_environment(nicol.Environment.create_constant(context, 1.0), None, 1.0)
                    scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_cube(context), material=material))
                    framebuffer = nicol.Framebuffer.create(context, 8, 8, scene.get_channels())
                    nicol.render(scene, camera(), nicol.RenderOptions(order_low=2, order_high=2), framebuffer)
                made = os.path.join(folder, "nicol")
                names = os.listdir(made) if os.path.isdir(made) else []
                self.assertEqual(any(name.endswith(".response") for name in names), kept)
                if options is not None:
                    self.assertFalse(options.cache_folder)


class SensorTest(unittest.TestCase):
    def test_framebuffer_and_array(self):
        with nicol.Context.create() as context:
            framebuffer = nicol.Framebuffer.create(context, 8, 4, 3)
            scene = scene_of_sphere(context, nicol.Material.create_diffuse(context, (0.2, 0.4, 0.6)))
            nicol.render(scene, camera(), None, framebuffer)
            sensor = nicol.Sensor(seed=3, mosaic=nicol.MOSAIC_POLARIZED_BAYER, bits=10)
            raw = sensor.capture(framebuffer, 2)
            self.assertEqual(memoryview(raw).shape, (4, 8))
            self.assertLess(max(map(max, memoryview(raw).tolist())), 1024)
            again = sensor.capture(framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS), 2)
            self.assertEqual(bytes(memoryview(raw)), bytes(memoryview(again)))
            self.assertEqual(memoryview(sensor.stokes(raw)).shape, (4, 8, 3, 4))
            self.assertEqual(memoryview(sensor.stokes(raw, nicol.DEMOSAIC_BLOCKS)).shape, (1, 2, 3, 4))

    def test_files_and_presets(self):
        sensor = nicol.Sensor(seed=9).set_preset(nicol.SENSOR_PRESET_IMX250MZR)
        light = memoryview(array.array("f", [0.5, 0.2, 0, 0] * 4)).cast("B").cast("f", (2, 2, 1, 4))
        raw = sensor.capture(light)
        with tempfile.TemporaryDirectory() as folder:
            sensor.save(raw, folder + "/raw.png")
            self.assertEqual(bytes(nicol.Sensor().load(folder + "/raw.png")), bytes(sensor))

    def test_wrong_arrays(self):
        sensor = nicol.Sensor()
        doubles = memoryview(array.array("d", [0.0] * 16)).cast("B").cast("d", (2, 2, 1, 4))
        with self.assertRaisesRegex(TypeError, "kind 'd'; it must be 'f'"):
            sensor.capture(doubles)
        flat = memoryview(array.array("f", [0.0] * 16)).cast("B").cast("f", (2, 2, 4))
        with self.assertRaisesRegex(ValueError, r"shape \(2, 2, 4\); it must be \(height, width, channels, 4\)"):
            sensor.capture(flat)
        with self.assertRaisesRegex(nicol.Error, "1 x 1 pixels; both sides must be multiples of 2"):
            sensor.capture(memoryview(array.array("f", [0.0] * 4)).cast("B").cast("f", (1, 1, 1, 4)))


if __name__ == "__main__":
    unittest.main()
