# SPDX-License-Identifier: MIT
"""The example of another language gives the image that C gets, and says clearly what is wrong with a bad scene.

usage: save_stokes_test.py C_PROGRAM SCENES command of the example...
"""

import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SCENES = os.path.abspath(sys.argv.pop(1)), os.path.abspath(sys.argv.pop(1))
EXAMPLE = sys.argv[1:]
del sys.argv[1:]
SIZE = ["width=96", "height=72"]


def run(command, folder, *arguments):
    """Runs the command in `folder`, with one cache for all runs."""
    environment = {**os.environ, "NICOL_CACHE": os.path.join(folder, "cache")}
    return subprocess.run([*command, *arguments], cwd=folder, env=environment, capture_output=True, text=True, timeout=120)


def read_npy(path):
    """Reads an array of 32-bit floats and returns (shape, numbers)."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:8] != b"\x93NUMPY\x01\x00":
        raise ValueError(f"{path} is no array of numpy")
    (length,) = struct.unpack_from("<H", data, 8)
    head = eval(data[10 : 10 + length], {"__builtins__": {}}, {"True": True, "False": False})
    if head["descr"] != "<f4" or head["fortran_order"] or (10 + length) % 16:
        raise ValueError(f"{path} has the head {head}")
    numbers = data[10 + length :]
    return head["shape"], struct.unpack(f"<{len(numbers) // 4}f", numbers)


class SaveStokesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def image(self, command, name, scene="snail_sky.xml"):
        path = os.path.join(self.folder, name)
        ended = run(command, self.folder, os.path.join(SCENES, scene), path, *SIZE)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return read_npy(path), ended.stdout

    def test_same_image_as_c(self):
        (shape, expected), _ = self.image([PROGRAM], "c.npy")
        (shape_here, found), output = self.image(EXAMPLE, "example.npy")
        self.assertEqual(shape, (72, 96, 4))
        self.assertEqual(shape_here, shape)
        self.assertGreater(max(abs(s1) for s1 in expected[1::4]), 0.01)
        self.assertLessEqual(max(abs(a - b) for a, b in zip(expected, found)), 1e-6)
        # The printed mean shows that the example reads its pixels.
        mean = sum(expected[0::4]) / (72 * 96)
        self.assertAlmostEqual(float(re.search(r"mean s0 (\d\.\d+)", output).group(1)), mean, delta=1e-4)
        self.assertIn("96 x 72", output)

    def test_bad_scene(self):
        ended = run(EXAMPLE, self.folder, "nowhere.xml", "out.npy")
        self.assertNotEqual(ended.returncode, 0)
        self.assertIn("nowhere.xml", ended.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "out.npy")))


if __name__ == "__main__":
    unittest.main()
