# SPDX-License-Identifier: MIT
"""Nicol uses its own libraries, whatever the host's process defines under their names: Embree, opened at run time, in version 4
or 3, and pugixml, linked into it.

usage: foreign_test.py TEST_GEOMETRY SAVE_STOKES SAVE_STOKES_OF_A_HOST_WITH_BOTH
"""

import ctypes
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

# Arguments after "render" are libraries that a child process loads before Nicol.
for library in sys.argv[2:] if sys.argv[1] == "render" else []:
    ctypes.CDLL(library, ctypes.RTLD_GLOBAL)

import nicol  # noqa: E402

TIMEOUT = 200
SCENE = """<scene version="3.0.0"><emitter type="constant"/><shape type="cube"/>
    <shape type="sphere"><point name="center" x="2" y="1" z="0"/></shape>
    <sensor type="perspective"><transform name="to_world"><lookat origin="3, 4, 9" target="1, 0, 0" up="0, 1, 0"/></transform>
        <film type="hdrfilm"><integer name="width" value="32"/><integer name="height" value="24"/></film></sensor></scene>"""


def embree_4():
    """Returns the libraries of the package embreex, Embree 4 first, or an empty list if it is not installed."""
    package = importlib.util.find_spec("embreex")
    if package is None:
        return []
    folder = pathlib.Path(package.origin).parent.parent / "embreex.libs"
    return sorted(folder.glob("*.so*"))


def render():
    """Renders a ball in a box with the reference method, which traces rays with Embree, and returns s0 as hexadecimal
    text."""
    with nicol.Context.create() as context:
        scene = nicol.Scene.create(context)
        material = nicol.Material.create_diffuse(context, 0.5)
        for mesh in (nicol.Mesh.create_sphere(context), nicol.Mesh.create_cube(context)):
            scene.add_instance(nicol.Instance(mesh=mesh, material=material))
        scene.set_environment(nicol.Environment.create_constant(context, 1.0), None, 1)
        framebuffer = nicol.Framebuffer.create(context, 9, 9, 1)
        camera = nicol.Camera(fov=40).look_at((0, 2, 6), (0, 0, 0), (0, 1, 0))
        nicol.render(scene, camera, nicol.RenderOptions(method=nicol.METHOD_REFERENCE, samples=4), framebuffer)
        return bytes(framebuffer.plane(nicol.PLANE_S0)).hex()


def child(*arguments, libraries="", cache=""):
    environment = dict(os.environ, LD_LIBRARY_PATH=libraries, NICOL_CACHE=cache)
    return subprocess.run(arguments, env=environment, timeout=TIMEOUT, capture_output=True, text=True)


class ForeignTest(unittest.TestCase):
    def test_a_program_that_exports_embree_and_pugixml_gets_the_same_image(self):
        images = []
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder, "scene.xml")
            scene.write_text(SCENE)
            # HOST runs first and fills the cache, because the libraries are called in its process. Its results serve as
            # the comparison.
            for program in (HOST, SAVE_STOKES):
                path = pathlib.Path(folder, "image.npy")
                done = child(program, str(scene), str(path), cache=str(pathlib.Path(folder, "cache")))
                self.assertEqual(done.returncode, 0, done.stderr)
                images.append(path.read_bytes())
        self.assertEqual(*images)

    def test_without_embree_the_message_says_what_to_install(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("libembree4.so.4", "libembree3.so.3"):
                pathlib.Path(folder, name).write_text("not a library")
            done = child(sys.executable, __file__, "render", libraries=folder)
        self.assertEqual(done.returncode, nicol.ERROR_UNSUPPORTED, done.stderr)
        self.assertIn("install libembree4-4 or libembree3-3", done.stderr)

    def test_beside_another_embree_whose_names_are_everybodys(self):
        libraries = [str(path) for path in embree_4() if "embree" in path.name]
        if not libraries:
            self.skipTest("the package embreex is absent")
        alone, beside = (child(sys.executable, __file__, "render", *others) for others in ([], libraries))
        self.assertEqual(beside.returncode, 0, beside.stderr)
        self.assertEqual(beside.stdout, alone.stdout)

    def test_embree_4_traces_as_embree_3(self):
        libraries = embree_4()
        if not libraries:
            self.skipTest("the package embreex is absent")
        with tempfile.TemporaryDirectory() as folder:
            for path in libraries:
                name = "libembree4.so.4" if "embree" in path.name else path.name
                shutil.copy(path, pathlib.Path(folder, name))
            done = child(TEST_GEOMETRY, "--source-file=*ray_scene*", libraries=folder)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("Embree 4", done.stdout)


if __name__ == "__main__":
    if sys.argv[1] == "render":
        try:
            print(render())
        except nicol.Error as error:
            print(error, file=sys.stderr)
            sys.exit(error.code)
    else:
        TEST_GEOMETRY, SAVE_STOKES, HOST = sys.argv[1:4]
        del sys.argv[1:4]
        unittest.main()
