# SPDX-License-Identifier: MIT
"""publish_mosaics, as a process that maps its memory sees it. usage: shared_memory_test.py PROGRAM SCENE"""

import mmap
import os
import struct
import subprocess
import sys
import unittest

PROGRAM, SCENE = (os.path.abspath(argument) for argument in sys.argv[1:3])
del sys.argv[1:3]
NAME = f"/nicol_test_{os.getpid()}"


class PublishTest(unittest.TestCase):
    def test_frames_follow_each_other(self):
        program = subprocess.Popen([PROGRAM, SCENE, NAME, "2"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        images = []
        try:
            for frame in range(2):
                self.assertEqual(program.stdout.readline(), f"{frame}\n")
            with open("/dev/shm" + NAME, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as memory:
                magic, layout, width, height, mosaic, bits, _, sequence, frame, time, _ = struct.unpack_from("<8s6I4Q", memory)
                self.assertEqual((magic, layout, mosaic, bits, sequence, frame), (b"NICOLRAW", 1, 1, 12, 4, 1))
                self.assertGreater(time, 0)
                pixels = memoryview(memory)[64:].cast("H")
                try:
                    self.assertEqual(len(pixels), width * height)
                    images = pixels.tolist()
                finally:
                    pixels.release()
        finally:
            program.stdin.close()
            self.assertEqual(program.wait(), 0)
            program.stdout.close()
        self.assertLess(max(images), 4096)
        self.assertGreater(len(set(images)), 100)
        self.assertFalse(os.path.exists("/dev/shm" + NAME))

    def test_what_is_refused(self):
        for arguments, text in (
            ([SCENE, NAME], "usage: publish_mosaics"),
            ([SCENE, NAME, "many"], "usage: publish_mosaics"),
            (["/none.xml", NAME, "1"], "publish_mosaics: /none.xml: "),
            ([SCENE, "/nowhere/camera", "1"], "/nowhere/camera: "),
        ):
            ended = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL)
            self.assertEqual(ended.returncode, 2)
            self.assertIn(text, ended.stderr)
            self.assertEqual(len(ended.stderr.splitlines()), 1)


if __name__ == "__main__":
    unittest.main()
