# SPDX-License-Identifier: MIT
"""The bytes of a frame belong to its recipe and number: whoever renders it, in whichever order, with how many threads, and
after whatever ended a run before."""

import os
import unittest

from data_set import ASSETS, DataSetTest

FOREST = os.path.join(ASSETS, "forest.exr")
# A new object, material and light in each frame.
SINGLES = {
    "objects": [{
        "mesh": {"folder": "meshes"}, "rotation": "any", "size": {"uniform": [0.5, 1]},
        "material": {"choice": [
            {"type": "pplastic", "alpha": {"log_uniform": [0.05, 0.4]}, "diffuse_reflectance": {"uniform": [0.1, 0.9]}},
            {"type": "conductor", "metal": {"choice": ["gold", "copper"]}, "alpha": {"uniform": [0.1, 0.3]}},
        ]},
    }],
    "light": {
        "environment": {"choice": [FOREST, {"sky": {"elevation": {"uniform": [10, 80]}}}]}, "rotation": {"uniform": [0, 360]},
        "sun": {"azimuth": {"uniform": [0, 360]}, "elevation": {"uniform": [20, 70]}, "irradiance": 2, "angular_radius": 1},
    },
    "camera": {"azimuth": {"uniform": [0, 360]}, "elevation": {"uniform_sine": [-20, 80]}, "roll": {"uniform": [-10, 10]}},
    "exposure": {"percentile": 99, "level": 0.9},
    "write": ["mosaic", "angles", "stokes", "s0", "dolp", "aolp", "depth", "normals", "normals_camera", "positions", "ids", "alpha"],
}  # fmt: skip
# Scenes of several views, in which light is reflected from surface to surface, and turns. Few directions are enough, because bytes are compared, not light.
ORBITS = {
    "views": 3,
    "objects": [
        {"mesh": "meshes/fine.ply", "material": {"type": "pplastic"}},
        {"mesh": "cube", "size": 0.5, "position": [0.9, 0, 0], "material": {"type": "conductor", "metal": "gold", "alpha": 0.2}},
    ],
    "floor": {"size": 4},
    "light": {"environment": FOREST, "rotation": {"sweep": [0, 90]}, "per": "frame"},
    "camera": {"azimuth": {"sweep": [0, 360]}, "distance": {"uniform": [0.6, 2]}},
    "render": {"max_depth": 3, "pixel_samples": 4, "bake_directions": 256},
    "write": {"stokes": {"format": "exr", "compression": "none"}, "mosaic": "png", "poses": ["transforms", "llff", "colmap"]},
}  # fmt: skip
KILL = """
import os, signal
def killed(*arguments):
    if killed.left == 0:
        os.kill(os.getpid(), signal.SIGKILL)
    killed.left -= 1
    return real(*arguments)
"""


class BytesTest(DataSetTest):
    def test_single_frames_in_any_order(self):
        self.add_meshes()
        recipe = self.recipe(**SINGLES)
        self.render(recipe, "0:6", "once", "--threads", "2")
        for frames in ("4:6", "0:1", "2:4", "1:3"):
            self.render(recipe, frames, "parts", "--threads", "1")
        self.assert_same_tree("once", "parts")
        frames = {name: data for name, data in self.tree("once").items() if name.endswith("stokes.exr")}
        self.assertEqual(len(set(frames.values())), 6)

    def test_views_of_scenes_in_any_order(self):
        self.add_meshes()
        recipe = self.recipe(**ORBITS)
        self.render(recipe, "0:6", "once")
        for frames in ("5:6", "4:5", "1:4", "0:1"):
            self.render(recipe, frames, "parts", "--threads", "1")
        self.assert_same_tree("once", "parts")

    def test_cache_of_tables_and_shadows(self):
        self.add_meshes()
        recipe = self.recipe(**ORBITS)
        self.render(recipe, "0:2", "without")
        os.environ["NICOL_CACHE"] = self.path("cache")
        try:
            self.render(recipe, "1:2", "with")
            self.render(recipe, "0:1", "with")
        finally:
            os.environ["NICOL_CACHE"] = ""
        self.assertTrue(os.listdir(self.path("cache")))
        self.assert_same_tree("without", "with")

    def test_killed_in_a_file_before_a_rename_and_in_an_index(self):
        recipe = self.recipe(write=["mosaic", "stokes", "depth"])
        self.render(recipe, "0:4", "once")
        for function, calls in (("outputs._save", 5), ("folder.os.rename", 2), ("folder.os.replace", 1)):
            with self.subTest(function):
                output = self.path(function)
                before = f"{KILL}\nkilled.left = {calls}\nreal = {function}\n{function} = killed"
                ended = self.start(before, recipe, "--frames", "0:4", "--output", output)
                self.assertEqual(ended.returncode, -9, ended.stderr)
                self.assertTrue([name for name in os.listdir(output) if name.startswith(".work-")])
                self.render(recipe, "0:4", function)
                self.assert_same_tree("once", function)

    def test_two_runs_at_once(self):
        recipe = self.recipe(write=["mosaic", "stokes"])
        self.render(recipe, "0:4", "once")
        # The second run starts and ends while the first one has a frame that is written and not renamed.
        before = """
import os, subprocess
real = folder.os.rename
def second(*arguments):
    folder.os.rename = real
    subprocess.run([sys.executable, "-m", "nicol.dataset", *sys.argv[1:]], check=True)
    return real(*arguments)
folder.os.rename = second"""
        ended = self.start(before, recipe, "--frames", "0:4", "--output", self.path("twice"))
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assert_same_tree("once", "twice")

    def test_complete_frames_are_not_rendered_again(self):
        recipe = self.recipe()
        self.render(recipe, "0:3", "out")
        self.assertIn("2 frames rendered", self.render(recipe, "1:5", "out"))
        self.assertIn("2 were complete", self.render(recipe, "1:3", "out"))


if __name__ == "__main__":
    unittest.main()
