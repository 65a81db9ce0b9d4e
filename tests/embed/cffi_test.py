# SPDX-License-Identifier: MIT
"""A binding that cffi makes from the installed headers renders an image, with defaults from the initialisers.

usage: cffi_test.py CMAKE BUILD_FOLDER C_COMPILER
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest

import cffi

CMAKE, BUILD, COMPILER = sys.argv[1:]
HEADERS = ("nicol.h", "nicol_psh.h", "nicol_files.h")
INTEGER = re.compile(r"#define (NICOL_\w+) (0x[0-9a-f]+|\d+)[uUL]*")


def preprocessed(include, *options):
    """Returns the headers after the C preprocessor, without the system's types, which cffi knows."""
    with tempfile.TemporaryDirectory() as empty:
        open(os.path.join(empty, "stdint.h"), "w").close()
        source = "".join(f'#include "{name}"\n' for name in HEADERS)
        command = [COMPILER, "-E", "-P", "-undef", "-nostdinc", "-I", empty, "-I", include, *options, "-"]
        return subprocess.run(command, input=source, capture_output=True, text=True, check=True).stdout


def bind(prefix):
    """Returns cffi's types and the loaded library of an installation."""
    ffi = cffi.FFI()
    include = os.path.join(prefix, "include")
    macros = INTEGER.findall(preprocessed(include, "-dM"))
    ffi.cdef("".join(f"#define {name} {value}\n" for name, value in macros) + preprocessed(include))
    found = [os.path.join(folder, "libnicol.so") for folder, _, files in os.walk(prefix) if "libnicol.so" in files]
    return ffi, ffi.dlopen(found[0])


class CffiTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        command = [CMAKE, "--install", BUILD, "--prefix", cls.folder.name]
        for component in ("runtime", "development"):
            subprocess.run([*command, "--component", component], check=True, capture_output=True)
        cls.ffi, cls.nicol = bind(cls.folder.name)

    def check(self, result):
        self.assertEqual(result, self.nicol.NICOL_OK, self.ffi.string(self.nicol.nicol_last_error()))

    def made(self, name):
        """Returns a struct with its defaults."""
        struct = self.ffi.new(f"nicol_{name}*")
        self.check(getattr(self.nicol, f"nicol_{name}_init")(struct, self.ffi.sizeof(struct[0])))
        return struct

    def create(self, function, handle, *arguments):
        out = self.ffi.new(f"nicol_{handle}*")
        self.check(getattr(self.nicol, f"nicol_{function}")(*arguments, out))
        return self.ffi.gc(out[0], getattr(self.nicol, f"nicol_{handle}_release"))

    def test_constants(self):
        self.assertEqual(self.nicol.NICOL_NO_LIMIT, 2**64 - 1)
        self.assertEqual(self.nicol.NICOL_PLANE_ALPHA, 12)
        self.assertGreater(len([name for name in dir(self.nicol) if name.startswith("NICOL_")]), 100)

    def test_every_struct_has_its_size(self):
        structs = [name for name in self.ffi.list_types()[0] if name.startswith("nicol_")]
        structs = [name for name in structs if self.ffi.typeof(name).kind == "struct"]
        self.assertGreater(len(structs), 30)
        for name in structs:
            struct = self.made(name.removeprefix("nicol_"))
            if hasattr(struct, "struct_size"):
                self.assertEqual(struct.struct_size, self.ffi.sizeof(name), name)

    def test_render(self):
        options = self.made("context_options")
        context = self.create("context_create", "context", options)
        scene = self.create("scene_create", "scene", context)
        light = self.create("environment_create_constant", "environment", context, self.ffi.NULL)
        self.check(self.nicol.nicol_scene_set_environment(scene, light, self.ffi.NULL, 1))
        instance = self.made("instance")
        instance.mesh = mesh = self.create("mesh_create_rectangle", "mesh", context)
        instance.material = material = self.create("material_create_diffuse", "material", context, self.ffi.NULL)
        self.check(self.nicol.nicol_scene_add_instance(scene, instance, self.ffi.NULL))
        del mesh, material  # the scene keeps them
        camera = self.made("camera")
        self.check(self.nicol.nicol_camera_look_at(camera, [0, 0, 4], [0, 0, 0], [0, 1, 0]))
        framebuffer = self.create("framebuffer_create", "framebuffer", context, 9, 9, 1)
        self.check(self.nicol.nicol_render(scene, camera, self.made("render_options"), framebuffer))
        pixels = self.ffi.new("float[81]")
        self.check(self.nicol.nicol_framebuffer_read(framebuffer, self.nicol.NICOL_PLANE_S0, 0, pixels, 0, 324))
        self.assertAlmostEqual(pixels[40], 0.5, delta=0.01)  # the diffuse reflectance
        self.assertAlmostEqual(pixels[0], 1, delta=0.01)  # the environment
        self.assertEqual(self.nicol.nicol_mesh_load(context, b"none.obj", self.ffi.new("nicol_mesh*")), 4)
        self.assertIn(b"none.obj", self.ffi.string(self.nicol.nicol_last_error()))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
