# SPDX-License-Identifier: MIT
"""fork(): before the library is used it is as good as a new process, afterwards every call in the child fails at once."""

import ctypes
import multiprocessing
import os
import signal
import unittest

import nicol

TIMEOUT = 60


def brightness(_=None):
    """Of a grey sphere, rendered."""
    with nicol.Context.create() as context:
        scene = nicol.Scene.create(context)
        material = nicol.Material.create_diffuse(context, 0.5)
        scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_sphere(context), material=material))
        scene.set_environment(nicol.Environment.create_constant(context, 1.0), None, 1)
        framebuffer = nicol.Framebuffer.create(context, 9, 9, 1)
        camera = nicol.Camera(fov=20).look_at((0, 0, 4), (0, 0, 0), (0, 1, 0))
        nicol.render(scene, camera, None, framebuffer)
        return round(float(framebuffer.plane(nicol.PLANE_S0)[4, 4]), 3)


def of_child(method):
    with multiprocessing.get_context(method).Pool(1) as pool:
        return pool.map_async(brightness, [0]).get(TIMEOUT)[0]


def exit_code(call, leave):
    """Of a forked child that calls; 0 where the library refuses as it should."""
    child = os.fork()
    if child == 0:
        signal.alarm(TIMEOUT)
        code = 1
        try:
            call()
        except nicol.Error as error:
            code = 0 if error.code == nicol.ERROR_UNSUPPORTED and "forked" in str(error) else 2
        leave(code)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


class ForkTest(unittest.TestCase):
    def test_before_and_after_use(self):
        # In one test, because the order counts.
        self.assertEqual(of_child("fork"), 0.5)
        self.assertEqual(brightness(), 0.5)
        context = nicol.Context.create()
        scene, mesh = nicol.Scene.create(context), nicol.Mesh.create_cube(context)
        for call in (brightness, nicol.Context.create, mesh.get_size, scene.get_channels):
            self.assertEqual(exit_code(call, os._exit), 0, call)
        # Also a child that leaves by the handlers of exit().
        self.assertEqual(exit_code(mesh.get_size, ctypes.CDLL(None).exit), 0)
        self.assertEqual(of_child("spawn"), 0.5)
        self.assertEqual(brightness(), 0.5)


if __name__ == "__main__":
    unittest.main()
