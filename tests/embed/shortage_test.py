# SPDX-License-Identifier: MIT
"""A process whose address space is nearly full gets NICOL_ERROR_OUT_OF_MEMORY, and goes on when there is room."""

import json
import os
import pathlib
import resource
import signal
import sys
import tempfile
import unittest

import nicol

ASSETS = pathlib.Path(sys.argv.pop(1))
TIMEOUT = 120
MEBIBYTE = 1 << 20


def many_nodes(folder):
    """Writes a glTF scene whose text alone is large."""
    document = json.loads((ASSETS / "solids.gltf").read_text(encoding="utf-8"))
    document["nodes"] += [{"translation": [i % 7, 0, 1]} for i in range(40000)]
    path = pathlib.Path(folder) / "many.gltf"
    path.write_text(json.dumps(document), encoding="utf-8")
    return str(path)


def loading(context, folder):
    path = many_nodes(folder)
    return lambda: nicol.Scene.load(context, path)


def framebuffer(context, _):
    return lambda: nicol.Framebuffer.create(context, 2048, 2048, 1)


def rendering(method):
    def prepared(context, _):
        scene = nicol.Scene.load(context, str(ASSETS / "solids.gltf"))
        scene.set_environment(nicol.Environment.create_constant(context, 1.0), None, 1)
        target = nicol.Framebuffer.create(context, 64, 64, 3)
        options = nicol.RenderOptions(method=method, samples=4, bake_directions=256)
        camera = scene.get_camera()
        return lambda: nicol.render(scene, camera, options, target)

    return prepared


CASES = {
    "glTF": (loading, (2, 12)),
    "framebuffer": (framebuffer, (32, 72)),
    "reference": (rendering(nicol.METHOD_REFERENCE), (1, 133)),
    "factored": (rendering(nicol.METHOD_FACTORED), (1, 133)),
    "dense": (rendering(nicol.METHOD_DENSE), (1,)),
}


def attempt(prepare, room):
    """Returns the error code of a call with `room` MiB to spare. The call must succeed after the limit is lifted."""
    with tempfile.TemporaryDirectory() as folder:
        call = prepare(nicol.Context.create(), folder)
        pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        used = pages * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (used + room * MEBIBYTE, resource.RLIM_INFINITY))
        code = nicol.OK
        try:
            call()
        except nicol.Error as error:
            code = error.code
        resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        call()
        return code


class ShortageTest(unittest.TestCase):
    def test_address_space(self):
        for name, (prepare, rooms) in CASES.items():
            codes = []
            for room in rooms:
                child = os.fork()  # forked before the first use, so that each child has its own library state
                if child == 0:
                    signal.alarm(TIMEOUT)
                    code = 99
                    try:
                        code = attempt(prepare, room)
                    finally:
                        os._exit(code)
                codes.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
            print(name, codes)
            self.assertLessEqual(set(codes), {nicol.OK, nicol.ERROR_OUT_OF_MEMORY}, name)
            self.assertIn(nicol.ERROR_OUT_OF_MEMORY, codes, name)


if __name__ == "__main__":
    unittest.main()
