# SPDX-License-Identifier: MIT
"""The add-on for Blender, by the module bpy: pictures equal nicol-render's of the exported scene; lights, cameras, textures and the
world are Cycles' own; passes and files hold the same numbers.

usage: blender_test.py SAMPLES NICOL_RENDER"""

import importlib.util
import math
import os
import subprocess
import sys
import tempfile
import unittest

try:
    import bpy
    import numpy
except ModuleNotFoundError as absent:
    print(f"skipped: {sys.executable} has no module {absent.name}; NICOL_PEER_PYTHON names an interpreter that has bpy and numpy")
    sys.exit(77)

SAMPLES, RENDERER = (os.path.abspath(argument) for argument in sys.argv[1:3])
del sys.argv[1:3]
sys.path[:0] = [os.path.join(SAMPLES, "blender"), os.path.join(SAMPLES, "bench"), os.path.join(SAMPLES, "..", "tests", "programs")]

import images  # noqa: E402
import stokes_images  # noqa: E402
from blender_scenes import (  # noqa: E402
    SIZE, add, add_camera, add_light, by_cycles, check_board, colors, finish, principled, render, srgb_image, start, test_scene, world,
)  # fmt: skip
from nicol_blender import engine, read_scene, settings, viewport  # noqa: E402


class RenderTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.scene = test_scene()
        cls.scene.nicol.samples, cls.scene.nicol.max_depth = 1, 2
        cls.scene.nicol.polarizer_angle = math.radians(30)
        cls.scene.nicol.stokes_path = os.path.join(cls.folder.name, "stokes_##.exr")
        cls.passes = render()

    @classmethod
    def tearDownClass(cls):
        finish()
        cls.folder.cleanup()

    def stokes_file(self):
        with open(os.path.join(self.folder.name, "stokes_01.exr"), "rb") as file:
            channels = images.read_exr(file.read())
        return {name: numpy.array(numbers, "f").reshape(SIZE[1], SIZE[0]) for name, numbers in channels.items()}

    def test_passes_are_the_stokes_image(self):
        file = self.stokes_file()
        stokes = [numpy.stack([file[f"S{i}.{c}"] for c in "RGB"], -1) for i in range(4)]
        for i in range(4):
            self.assertTrue((colors(self.passes, f"S{i}") == stokes[i]).all())
        linear = numpy.hypot(stokes[1], stokes[2])
        self.assertGreater(linear.max(), 0.05)
        self.assertLess(numpy.abs(colors(self.passes, "DoLP") * stokes[0] - linear).max(), 1e-5)
        angle = colors(self.passes, "AoLP")
        self.assertLess(numpy.abs(linear * numpy.cos(2 * angle) - stokes[1]).max(), 1e-5)
        behind = 0.5 * (stokes[0] + math.cos(math.radians(60)) * stokes[1] + math.sin(math.radians(60)) * stokes[2])
        self.assertLess(numpy.abs(colors(self.passes, "Polarizer") - behind).max(), 1e-5)
        self.assertTrue((colors(self.passes, "Combined") == stokes[0]).all())

    def test_equals_nicol_render_of_the_exported_scene(self):
        path = os.path.join(self.folder.name, "scene.xml")
        self.assertEqual(bpy.ops.nicol.export(filepath=path), {"FINISHED"})
        theirs = os.path.join(self.folder.name, "theirs.exr")
        subprocess.run([RENDERER, path, "-o", theirs], check=True)
        with open(theirs, "rb") as file:
            channels = images.read_exr(file.read())
        ours = self.stokes_file()
        for name in (f"S{i}.{c}" for i in range(4) for c in "RGB"):
            other = numpy.array(channels[name], "f").reshape(ours[name].shape)
            self.assertLess(numpy.abs(ours[name] - other).max(), 1e-5)

    def test_a_film_colours_the_metal(self):
        thickness = bpy.data.materials["metal"].node_tree.nodes["Principled BSDF"].inputs["Thin Film Thickness"]
        self.addCleanup(setattr, thickness, "default_value", thickness.default_value)
        self.addCleanup(setattr, self.scene.nicol, "stokes_path", self.scene.nicol.stokes_path)
        thickness.default_value, self.scene.nicol.stokes_path = 0, ""
        difference = numpy.abs(colors(render(), "S0") - colors(self.passes, "S0")).max(2)
        self.assertGreater((difference > 0.02).sum(), 30)

    def test_a_viewport_shows_the_same(self):
        depsgraph = bpy.context.evaluated_depsgraph_get()
        camera, options = read_scene.scene_camera(depsgraph, SIZE), settings.render_options(self.scene.nicol)

        def picture(what="s0", of=None):
            return (of or view).picture(camera, SIZE, options, what, 0.5)[::-1, :, :3]

        view = viewport.Viewport()
        view.update(depsgraph)
        self.assertLess(numpy.abs(picture() - colors(self.passes, "S0")).max(), 1e-5)
        dolp = numpy.hypot(*(colors(self.passes, f"S{i}").mean(2) for i in (1, 2))) / colors(self.passes, "S0").mean(2)
        self.assertLess(numpy.abs(picture("dolp")[..., 0] - dolp).max(), 1e-5)
        self.assertLess(numpy.abs(picture("aolp").max(2) - dolp).max(), 1e-5)
        stokes = [colors(self.passes, f"S{i}") for i in range(3)]
        behind = 0.5 * (stokes[0] + math.cos(1) * stokes[1] + math.sin(1) * stokes[2])
        self.assertLess(numpy.abs(picture("polarizer") - behind).max(), 1e-5)
        cube = bpy.data.objects["Cube"]
        # Blender says what has changed to handlers, as to an engine's view_update.
        bpy.app.handlers.depsgraph_update_post.append(lambda scene, graph: view.update(graph))
        self.addCleanup(bpy.app.handlers.depsgraph_update_post.clear)
        stage = view._stage
        for location in ((0.5, 0.2, 0.6), tuple(cube.location)):
            before = picture()
            cube.location = location
            bpy.context.view_layer.update()
            self.assertIs(view._stage, stage)
            self.assertGreater(numpy.abs(picture() - before).max(), 0.01)
            fresh = viewport.Viewport()
            fresh.update(bpy.context.evaluated_depsgraph_get())
            self.assertLess(numpy.abs(picture() - picture(of=fresh)).mean(), 0.003)
        bpy.data.lights["POINT"].energy *= 2
        bpy.context.view_layer.update()
        self.assertIsNot(view._stage, stage)
        bpy.data.lights["POINT"].energy /= 2


class CyclesTest(unittest.TestCase):
    """Cycles is Blender's own renderer of physical light."""

    def setUp(self):
        self.scene = start()
        self.scene.nicol.samples, self.scene.nicol.max_depth = 4, 2

    def tearDown(self):
        finish()

    def white_floor(self):
        material = bpy.data.materials.new("white")
        material.use_nodes = True
        tree = material.node_tree
        diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
        diffuse.inputs["Color"].default_value = (0.6, 0.6, 0.6, 1)
        tree.links.new(diffuse.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
        add("plane", material, size=6)
        add_camera((0, 0, 6), (0, 0, 0), lens=50)

    def assert_as_cycles(self, tolerance, samples=64, mask=None):
        ours, cycles = colors(render(), "S0"), by_cycles(samples)
        theirs = numpy.stack([cycles[f"ViewLayer.Combined.{c}"] for c in "RGB"], -1)
        self.assertGreater(theirs.std(), 0.02 * theirs.mean())
        error = numpy.sqrt(((ours - theirs) ** 2).mean() / (theirs**2).mean())
        self.assertLess(error, tolerance, f"means {ours.mean():g} and {theirs.mean():g}")

    def test_lights(self):
        self.white_floor()
        for kind, energy, fields in (
            ("SUN", 2, {"rotation": (0.8, 0.2, 0), "angle": 0.01}),
            ("POINT", 100, {"location": (1, 0.5, 2), "shadow_soft_size": 0}),
            ("SPOT", 300, {"location": (1, 0, 3), "rotation": (0.2, 0.4, 0), "spot_size": 0.9, "spot_blend": 0.2, "shadow_soft_size": 0}),
            ("AREA", 100, {"location": (2, 1.5, 1.5), "rotation": (0.3, 0.9, 0), "shape": "RECTANGLE", "size": 0.9, "size_y": 0.5}),
            ("AREA", 100, {"location": (-2.4, 1, 1.5), "rotation": (0, -0.9, 0), "shape": "ELLIPSE", "size": 0.9, "size_y": 0.5}),
        ):
            with self.subTest(kind):
                light = add_light(kind, energy, **fields)
                block = add("cube", bpy.data.materials["white"], size=0.7, location=(-0.5, -0.3, 0.35))
                self.assert_as_cycles(0.05)
                for thing in (light, block):
                    bpy.data.objects.remove(thing)

    def test_world_and_camera(self):
        pixels = numpy.repeat(numpy.repeat(check_board((0.8, 0.3, 0.1)), 4, 0), 8, 1)
        for kind in ({"type": "PERSP", "lens": 18, "shift_x": 0.2}, {"type": "PERSP", "sensor_fit": "VERTICAL", "lens": 20}):
            with self.subTest(kind):
                world(image=srgb_image("board", pixels, is_float=True), strength=0.7, turn=0.9)
                add_camera((0, 0, 0), (1.3, 0.2, 0.4), **kind)
                self.assert_as_cycles(0.1, 16)

    def test_textures_and_orthographic_cameras(self):
        board = srgb_image("board", check_board((0.8, 0.3, 0.1)))
        material = principled("lamp", Emission_Color=board, Emission_Strength=1.5, Base_Color=(0, 0, 0))
        tree = material.node_tree
        texture = next(node for node in tree.nodes if node.type == "TEX_IMAGE")
        mapping, coordinates = tree.nodes.new("ShaderNodeMapping"), tree.nodes.new("ShaderNodeTexCoord")
        for name, value in (("Location", (0.1, 0.2, 0)), ("Rotation", (0, 0, 0.3)), ("Scale", (1.5, 0.8, 1))):
            mapping.inputs[name].default_value = value
        tree.links.new(coordinates.outputs["UV"], mapping.inputs["Vector"])
        tree.links.new(mapping.outputs["Vector"], texture.inputs["Vector"])
        add("plane", material, size=4)
        self.scene.nicol.samples = 16
        add_camera((0.3, -0.2, 6), (0.1, 0, 0.2), type="ORTHO", ortho_scale=3.5, shift_x=0.1, shift_y=-0.05)
        self.assert_as_cycles(0.1, 16)


class MitsubaTest(unittest.TestCase):
    RENDER = """
import sys, numpy, peer_mitsuba as peer
peer.choose_variant()
scene = peer.mitsuba_scene(sys.argv[1])
numpy.save(sys.argv[2], [peer.mitsuba_image(scene, 1024, seed) for seed in (1, 2)])
"""

    def test_mitsuba_agrees(self):
        if importlib.util.find_spec("mitsuba") is None:
            self.skipTest("mitsuba is absent")
        scene = start()
        scene.nicol.samples, scene.nicol.max_depth = 16, 2
        add("plane", principled("floor", Base_Color=srgb_image("board", check_board((0.8, 0.3, 0.1))), Roughness=0.5), size=6)
        add("uv_sphere", principled("metal", Base_Color=(0.9, 0.6, 0.3), Metallic=1.0, Roughness=0.6), location=(-0.9, 0, 1), segments=48, ring_count=24)
        bpy.ops.object.shade_smooth()
        add("cube", principled("plastic", Base_Color=(0.1, 0.3, 0.6), Roughness=0.5, IOR=1.7), location=(1.2, 0.5, 0.6), rotation=(0, 0, 0.6), size=1.2)
        add_light("POINT", 80, (1, -2, 3), shadow_soft_size=0)
        add_light("AREA", 60, (0, 2, 3), (-0.5, 0, 0), shape="RECTANGLE", size=1.5, size_y=0.7)
        world(image=srgb_image("sky", numpy.linspace(0.1, 1, 32 * 16 * 3, dtype="f").reshape(16, 32, 3), is_float=True), strength=0.4, turn=0.8)
        add_camera((0, -6, 3.5), (1.05, 0, 0), lens=40, shift_x=0.05, shift_y=-0.03)
        passes = render()
        with tempfile.TemporaryDirectory() as folder:
            path, images_of = os.path.join(folder, "scene.xml"), os.path.join(folder, "images.npy")
            bpy.ops.nicol.export(filepath=path)
            finish()
            # Mitsuba and bpy bring libraries of the same names.
            subprocess.run([sys.executable, "-c", self.RENDER, path, images_of], check=True)
            theirs = numpy.load(images_of)
        ours = numpy.stack([colors(passes, f"S{i}") for i in range(4)], -1).transpose(0, 1, 3, 2) @ stokes_images.LUMINANCE
        squared, noise = stokes_images.squared_error((ours, ours), tuple(theirs))
        for component, most in enumerate((0.045, 0.006, 0.006, 0.006)):
            self.assertLess(squared[component], most**2, f"s{component} differs by {math.sqrt(max(0, squared[component])):.4f}")
        # The comparison sees a wrong sign.
        for component in (1, 2):
            wrong = ours.copy()
            wrong[..., component] *= -1
            squared, _ = stokes_images.squared_error((wrong, wrong), tuple(theirs))
            self.assertGreater(squared[component], 4 * 0.006**2)


class NoticeTest(unittest.TestCase):
    def setUp(self):
        start()

    def tearDown(self):
        finish()

    def notices(self):
        return read_scene.read_scene(bpy.context.evaluated_depsgraph_get()).notices

    def test_what_is_not_followed_is_named(self):
        material = principled("coated", Coat_Weight=0.5, Transmission_Weight=0.3, Alpha=0.5)
        tree = material.node_tree
        noise = tree.nodes.new("ShaderNodeTexNoise")
        tree.links.new(noise.outputs["Fac"], tree.nodes["Principled BSDF"].inputs["Roughness"])
        add("cube", material)
        add_light("POINT", 10, shadow_soft_size=0.1)
        wanted = (
            "material coated: Coat Weight is not followed",
            "material coated: the node Noise Texture before Roughness is not followed, the socket's value is taken",
            "material coated: Transmission 0.3 is taken as 0",
            "material coated: Alpha 0.5 is taken as 1; a texture cuts holes",
            "light POINT: its radius is not followed, so that its shadows have sharp edges",
        )
        self.assertEqual(sorted(self.notices()), sorted(wanted))

    def test_each_object_is_read_once(self):
        bpy.ops.object.text_add()
        bpy.ops.object.metaball_add()
        add("cube", principled("textured", Base_Color=srgb_image("board", check_board((0.8, 0.3, 0.1)))))
        uv_layers = bpy.context.object.data.uv_layers
        uv_layers.remove(uv_layers[0])
        add("cube").scale = (0, 1, 1)
        description = read_scene.read_scene(bpy.context.evaluated_depsgraph_get())
        self.assertEqual(sorted(instance.key[0] for instance in description.instances), ["Cube", "Mball", "Text"])
        add_light("SUN", 2)
        add_camera((0, -6, 3.5), (1.05, 0, 0))
        self.assertGreater(render()["ViewLayer.Combined.R"].max(), 0.1)

    def test_a_plain_scene_has_none(self):
        add("cube", principled("plain"))
        add_light("SUN", 1)
        self.assertEqual(self.notices(), [])

    def test_errors_are_reported(self):
        with self.assertRaisesRegex(RuntimeError, "the scene has no active camera"):
            bpy.ops.nicol.export(filepath="/nowhere/scene.xml")
        add_camera((0, 0, 0), (0, 0, 0), type="PANO")
        with self.assertRaisesRegex(RuntimeError, "camera camera is panoramic; it must be perspective or orthographic"):
            bpy.ops.render.render()
        bpy.context.scene.camera.data.type = "PERSP"
        with self.assertRaisesRegex(RuntimeError, "No such file or directory: '/nowhere/scene.xml'"):
            bpy.ops.nicol.export(filepath="/nowhere/scene.xml")

    def test_the_frame_is_in_the_path(self):
        self.assertEqual(engine.frame_path("/a/b_###.exr", 7), "/a/b_007.exr")
        self.assertEqual(engine.frame_path("/a/b.exr", 7), "/a/b.exr")


if __name__ == "__main__":
    unittest.main()
