# SPDX-License-Identifier: MIT
"""The recipes of samples/dataset, the sheet of a data set, and the rates."""

import json
import os
import re
import struct
import subprocess
import sys
import unittest
import zlib

import numpy
from data_set import DataSetTest, load
from nicol.dataset import exr

SAMPLES = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", "samples", "dataset"))


class DemoTest(DataSetTest):
    def script(self, name, *arguments):
        command = [sys.executable, os.path.join(SAMPLES, name), *arguments]
        ended = subprocess.run(command, capture_output=True, text=True, timeout=500)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return ended.stdout

    def test_recipes_have_no_fault(self):
        for name in os.listdir(SAMPLES):
            if name.endswith(".json"):
                with self.subTest(name):
                    self.assertEqual(self.run_program(os.path.join(SAMPLES, name), "--check")[0], 0)

    def test_sheet(self):
        with open(os.path.join(SAMPLES, "demo.json")) as file:
            recipe = json.load(file)
        recipe["size"], recipe["objects"][0]["mesh"] = [96, 64], "cube"
        recipe["light"]["environment"] = {"sky": {}}
        self.render(self.recipe(**recipe), "0:21", "out")
        self.script("sheet.py", self.path("out"), self.path("sheet.png"))
        with open(self.path("sheet.png"), "rb") as file:
            width, height = struct.unpack(">II", file.read()[16:24])
        # 21 frames are two rows of 20, above as s0 and below as AoLP.
        self.assertEqual((width, height), (20 * 36, 4 * 36))

    def test_layout_of_neisf(self):
        recipe = self.recipe(
            views=2, write={"stokes": "npy", "ids": "npy", "poses": ["llff"]}, light={"environment": [1, 2, 3]}
        )
        self.render(recipe, "0:4", "out")
        self.script("neisf.py", self.path("out"), self.path("neisf"), "--scene", "1")
        names = ["images_s0", "images_s1", "images_s2", "masks", "poses_bounds.npy"]
        self.assertEqual(sorted(os.listdir(self.path("neisf"))), names)
        for name, suffix in zip(names, ("exr", "exr", "exr", "png")):
            self.assertEqual(sorted(os.listdir(self.path("neisf", name))), [f"img_001.{suffix}", f"img_002.{suffix}"])
        with open(self.path("neisf", "masks", "img_002.png"), "rb") as file:
            header, data = file.read()[16:26], zlib.decompress(self.tree("neisf")["masks/img_002.png"][41:-16])
        self.assertEqual(struct.unpack(">IIBB", header), (48, 32, 16, 2))
        mask = numpy.frombuffer(data, numpy.uint8).reshape(32, 1 + 6 * 48)[:, 1:].copy().view(">u2").reshape(32, 48, 3)
        ids = load(self.path("out", "frames", "000003", "ids.npy"))
        self.assertGreater((ids == 0).sum(), 100)
        numpy.testing.assert_array_equal(mask[..., 0] == 65535, ids == 0)
        stokes = load(self.path("out", "frames", "000003", "stokes.npy"))
        expected = b"".join(exr.encoded({c: stokes[:, :, i, 1] for i, c in enumerate("RGB")}))
        self.assertEqual(self.tree("neisf")["images_s1/img_002.exr"], expected)

    def test_rates(self):
        out = self.script("rates.py", "--frames", "2")
        self.assertEqual(len(re.findall(r" [\d,]+ a minute +[\d,]+ ms of processor time each", out)), 3, out)


if __name__ == "__main__":
    unittest.main()
