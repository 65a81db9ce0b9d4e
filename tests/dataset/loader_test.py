# SPDX-License-Identifier: MIT
"""Dataset: the arrays of a recipe's frames, in worker processes, and in flat memory."""

import concurrent.futures
import multiprocessing
import os
import pickle
import subprocess
import sys
import unittest

import numpy
from data_set import DataSetTest, load
from nicol.dataset import Dataset

NAMES = ("stokes", "mosaic", "angles", "normals_camera", "ids", "depth")
RECIPE = {"views": 4, "camera": {"azimuth": {"sweep": [0, 360]}}, "write": {name: "npy" for name in NAMES}}
FORKED = """
import concurrent.futures, multiprocessing, sys
import numpy
from nicol.dataset import Dataset
dataset = Dataset(sys.argv[1], range(8), ["stokes"], threads=1)
with concurrent.futures.ProcessPoolExecutor(2, multiprocessing.get_context("fork")) as pool:
    found = list(pool.map(dataset.__getitem__, range(8), chunksize=4))
numpy.save(sys.argv[2], [item["stokes"] for item in found])
"""


def workers(how):
    """Returns a pool of two processes, which unlike multiprocessing.Pool fails if one dies."""
    return concurrent.futures.ProcessPoolExecutor(2, multiprocessing.get_context(how))


def resident():
    """Returns the bytes that this process has in memory."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class LoaderTest(DataSetTest):
    def test_items_are_the_written_arrays(self):
        recipe = self.recipe(**RECIPE)
        self.render(recipe, "0:4", "out")
        dataset = Dataset(recipe, range(1, 3), NAMES)
        self.assertEqual(len(dataset), 2)
        for item, frame in zip(dataset, (1, 2)):
            self.assertEqual(item["frame"], frame)
            for name in NAMES:
                written = load(self.path("out", "frames", f"{frame:06d}", f"{name}.npy"))
                self.assertEqual(item[name].dtype, written.dtype)
                numpy.testing.assert_array_equal(item[name], written, name)

    def test_shapes(self):
        item = Dataset(self.recipe(), range(1), NAMES)[0]
        shapes = {name: item[name].shape for name in NAMES}
        expected = {"stokes": (32, 48, 1, 4), "mosaic": (32, 48), "angles": (4, 32, 48), "normals_camera": (32, 48, 3),
                    "ids": (32, 48), "depth": (32, 48)}  # fmt: skip
        self.assertEqual(shapes, expected)

    def test_spawned_workers(self):
        dataset = Dataset(self.recipe(**RECIPE), range(8), ["stokes"], threads=1)
        here = [item["stokes"] for item in dataset]
        with workers("spawn") as pool:
            there = list(pool.map(dataset.__getitem__, range(8), chunksize=4))
        numpy.testing.assert_array_equal(here, [item["stokes"] for item in there])

    def test_forked_workers(self):
        recipe = self.recipe(**RECIPE)
        ended = subprocess.run(
            [sys.executable, "-c", FORKED, recipe, self.path("forked.npy")], capture_output=True, text=True, timeout=240
        )
        self.assertEqual(ended.returncode, 0, ended.stderr)
        here = [item["stokes"] for item in Dataset(recipe, range(8), ["stokes"])]
        numpy.testing.assert_array_equal(here, load(self.path("forked.npy")))

    def test_pickled_after_use(self):
        dataset = Dataset(self.recipe(), range(1), ["stokes"])
        numpy.testing.assert_array_equal(dataset[0]["stokes"], pickle.loads(pickle.dumps(dataset))[0]["stokes"])

    def test_index_and_names_out_of_range(self):
        dataset = Dataset(self.recipe(), range(2), ["stokes"])
        with self.assertRaises(IndexError):
            dataset[2]
        with self.assertRaisesRegex(ValueError, "'colour' is no array; known are mosaic"):
            Dataset(self.recipe(), range(2), ["colour"])

    def test_flat_memory(self):
        # A new scene every tenth picture, each with another light and material.
        recipe = self.recipe(
            size=[96, 96], views=10, camera={"azimuth": {"uniform": [0, 360]}},
            objects=[{"mesh": "cube", "material": {"type": "pplastic", "alpha": {"uniform": [0.1, 0.5]}}}],
            light={"environment": {"sky": {"elevation": {"uniform": [5, 80]}}}},
        )  # fmt: skip
        dataset = Dataset(recipe, range(300), ["stokes"])
        sizes = []
        for index, _ in enumerate(dataset):
            if index % 50 == 49:
                sizes.append(resident())
        # Pools make the size vary by several MB; 150 pictures of 147 KB that were kept would add 22 MB.
        self.assertLess(sizes[-1], sizes[2] + 12e6, sizes)


if __name__ == "__main__":
    unittest.main()
