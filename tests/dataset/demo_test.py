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
        self.script("layouts.py", "neisf", self.path("out"), self.path("neisf"), "--scene", "1")
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

    def two_views(self):
        """Renders scene 1 of two views, with light that is polarized and coloured."""
        recipe = self.recipe(
            views=2, write={"stokes": "npy", "ids": "npy", "positions": "npy"}, light={"environment": {"sky": {"radiance": [1, 2, 3]}}},
            camera={"azimuth": {"sweep": [0, 90]}},
        )  # fmt: skip
        self.render(recipe, "2:4", "out")
        return [
            [load(self.path("out", "frames", f"{frame:06d}", f"{name}.npy")) for name in ("stokes", "ids", "positions")]
            for frame in (2, 3)
        ]

    def assert_cameras(self, path, names, views):
        """The matrices of cameras.npz take points of surfaces to their pixels, and the unit sphere around the objects."""
        cameras = numpy.load(path)
        for name, (_, ids, positions) in zip(names, views):
            rows, columns = numpy.nonzero(ids == 0)
            points = positions[rows, columns].astype(float)
            inside = numpy.linalg.inv(cameras[f"scale_mat_{name}"]) @ numpy.column_stack([points, numpy.ones(len(points))]).T
            self.assertLessEqual(numpy.linalg.norm(inside[:3], axis=0).max(), 1 + 1e-5)
            x, y, z, _ = cameras[f"world_mat_{name}"] @ cameras[f"scale_mat_{name}"] @ inside
            self.assertLess(abs(x / z - columns).max(), 1e-3)
            self.assertLess(abs(y / z - rows).max(), 1e-3)

    def test_layout_of_pandora(self):
        views = self.two_views()
        self.script("layouts.py", "pandora", self.path("out"), self.path("pandora"), "--scene", "1")
        tree = self.tree("pandora")
        hdr = [f"images_stokes/0{view}_{suffix}.hdr" for view in (1, 2) for suffix in ("s0", "s0p1", "s0p2")]
        png = [f"{folder}/0{view}.png" for folder in ("images", "mask") for view in (1, 2)]
        self.assertEqual(sorted(tree), sorted([*hdr, *png, "cameras.npz", "pts3d.npz"]))
        self.assert_cameras(self.path("pandora", "cameras.npz"), ("01", "02"), views)
        stokes = views[1][0]
        for suffix, light in (("s0", stokes[..., 0]), ("s0p2", stokes[..., 0] + stokes[..., 2])):
            numbers = numpy.frombuffer(tree[f"images_stokes/02_{suffix}.hdr"][-4 * 48 * 32 :], numpy.uint8).reshape(32, 48, 4)
            there = numpy.ldexp(numbers[..., :3] + 0.5, numbers[..., 3:].astype(int) - 136)
            self.assertLess(abs(there - light).max(), light.max() / 128)

    def test_layout_of_nersp(self):
        views = self.two_views()
        self.script("layouts.py", "nersp", self.path("out"), self.path("nersp"), "--scene", "1")
        tree = self.tree("nersp")
        npy = [f"s{p}/000{view}.npy" for p in range(3) for view in range(2)]
        png = [f"{folder}/000{view}.png" for folder in ("image", "input_azimuth_maps") for view in range(2)]
        self.assertEqual(sorted(tree), sorted([*npy, *png, "cameras.npz"]))
        self.assert_cameras(self.path("nersp", "cameras.npz"), (0, 1), views)
        stokes, ids, _ = views[1]
        numpy.testing.assert_array_equal(load(self.path("nersp", "s2", "0001.npy")), stokes[..., 2])
        data = zlib.decompress(tree["input_azimuth_maps/0001.png"][41:-16])
        image = numpy.frombuffer(data, numpy.uint8).reshape(32, 1 + 8 * 48)[:, 1:].copy().view(">u2").reshape(32, 48, 4)
        numpy.testing.assert_array_equal(image[..., 3] == 65535, ids == 0)
        # Twice the angle, clockwise, has the direction of (s1, -s2).
        angle = 2 * numpy.pi * image[..., 0] / 65535
        s1, s2 = stokes[..., 1].sum(axis=2), stokes[..., 2].sum(axis=2)
        linear = numpy.hypot(s1, s2)
        self.assertLess(abs(linear * numpy.cos(angle) - s1).max(), 1e-3 * linear.max())
        self.assertLess(abs(linear * numpy.sin(angle) + s2).max(), 1e-3 * linear.max())

    def test_rates(self):
        out = self.script("rates.py", "--frames", "2")
        self.assertEqual(len(re.findall(r" [\d,]+ a minute +[\d,]+ ms of processor time each", out)), 3, out)
        out = self.script("rates.py", "--frames", "20", "--memory")
        self.assertEqual(re.findall(r"(\d+) pictures +[\d.]+ MB", out), [str(i) for i in range(2, 21, 2)])
        if len(os.sched_getaffinity(0)) > 1:
            out = self.script("rates.py", "--frames", "2", "--nodes")
            self.assertRegex(out, r"two nodes over twice one node: [\d.]+, by processor time [\d.]+")


if __name__ == "__main__":
    unittest.main()
