# SPDX-License-Identifier: MIT
"""fork(): before the library is used it is as good as a new process, afterwards every call in the child fails at once."""

import ctypes
import multiprocessing
import os
import signal
import unittest

import nicol

TIMEOUT = 60


def sphere(context):
    """Returns a scene of a grey sphere and a camera that sees it."""
    scene = nicol.Scene.create(context)
    material = nicol.Material.create_diffuse(context, 0.5)
    scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_sphere(context), material=material))
    scene.set_environment(nicol.Environment.create_constant(context, 1.0), None, 1)
    return scene, nicol.Camera(fov=20).look_at((0, 0, 4), (0, 0, 0), (0, 1, 0))


def brightness(_=None):
    """Renders a grey sphere and returns s0 at its centre."""
    with nicol.Context.create() as context:
        framebuffer = nicol.Framebuffer.create(context, 9, 9, 1)
        nicol.render(*sphere(context), None, framebuffer)
        return round(float(framebuffer.plane(nicol.PLANE_S0)[4, 4]), 3)


def of_child(method):
    with multiprocessing.get_context(method).Pool(1) as pool:
        return pool.map_async(brightness, [0]).get(TIMEOUT)[0]


def exit_code(call, leave):
    """Returns the exit code of a forked child that calls: 0 if the library refuses as it should."""
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


def submitted(context, samples):
    """Returns a job that renders the sphere."""
    options = nicol.RenderOptions(method=nicol.METHOD_REFERENCE, samples=samples)
    return nicol.render_async(*sphere(context), options, nicol.Framebuffer.create(context, 64, 64, 1))


def running():
    context = nicol.Context.create()
    job = submitted(context, 65536)
    while job.poll().state == nicol.JOB_WAITING or job.poll().fraction == 0:
        pass
    return context, job


def finished():
    context = nicol.Context.create()
    job = submitted(context, 1)
    job.wait(nicol.WAIT_FOREVER)
    return context, job


def released():
    with nicol.Context.create() as context, submitted(context, 1) as job:
        job.wait(nicol.WAIT_FOREVER)


def released_while_running():
    context, job = running()
    job.cancel()
    job.release()
    context.release()


def leave():
    """Ends the process through the handlers of C's exit() and not those of Python."""
    ctypes.CDLL(None).exit(0)


class ForkTest(unittest.TestCase):
    def test_before_and_after_use(self):
        # The checks share one test, because their order matters.
        self.assertEqual(of_child("fork"), 0.5)
        self.assertEqual(brightness(), 0.5)
        context = nicol.Context.create()
        scene, mesh = nicol.Scene.create(context), nicol.Mesh.create_cube(context)
        for call in (brightness, nicol.Context.create, mesh.get_size, scene.get_channels):
            self.assertEqual(exit_code(call, os._exit), 0, call)
        # A child may also end through the handlers of exit().
        self.assertEqual(exit_code(mesh.get_size, ctypes.CDLL(None).exit), 0)
        self.assertEqual(of_child("spawn"), 0.5)
        self.assertEqual(brightness(), 0.5)

    def test_children_end_while_jobs_run(self):
        for stage in 5 * (running, finished, released, released_while_running):
            kept = stage()
            child = os.fork()
            if child == 0:
                signal.alarm(TIMEOUT)
                leave()
            code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
            if kept:
                kept[1].cancel()
            self.assertEqual(code, 0, stage.__name__)


if __name__ == "__main__":
    unittest.main()
