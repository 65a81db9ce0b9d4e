# SPDX-License-Identifier: MIT
"""Recipes and folders that cannot be used: one clear line, exit code 2, and nothing complete is lost."""

import importlib.util
import json
import os
import shutil
import subprocess
import unittest

from data_set import DataSetTest

PLASTIC = {"type": "pplastic"}
# Part of a recipe, and what the line must say.
RECIPES = [
    ({"sede": 1}, "recipe.json: sede: unknown key; did you mean seed?"),
    ({"objects": [{"mesh": "cube", "colour": 1}]}, "objects[0].colour: unknown key; known are count, material"),
    ({"camera": {"zoom": 2}}, "camera.zoom: unknown key; known are azimuth, baseline, distance, elevation"),
    ({"light": {"sun": {"hight": 3}}}, "light.sun.hight: unknown key"),
    ({"objects": [{"mesh": "cube", "material": {"type": "pplastic", "alhpa": 1}}]}, "material.alhpa: unknown key; did you mean alpha?"),
    ({"render": {"time_budget_ms": 5}}, "render.time_budget_ms: unknown key"),
    ({"objects": None}, "objects is missing; a recipe has objects, or a scene to start from"),
    ({"objects": [{}]}, "objects[0]: mesh is missing"),
    ({"objects": {"mesh": "cube"}}, "objects: {'mesh': 'cube'}; it must be a list of objects"),
    ({"objects": [{"mesh": "ball.ply"}]}, "ball.ply does not exist"),
    ({"objects": [{"mesh": "ball"}]}, "objects[0].mesh: 'ball'; it must be a file of .obj .ply"),
    ({"objects": [{"mesh": {"folder": "no"}}]}, "no is no folder"),
    ({"objects": [{"mesh": {"folder": "."}}]}, "holds no file of .obj"),
    ({"objects": [{"mesh": {"choice": []}}]}, "objects[0].mesh.choice: []; it must be a list of one value or more"),
    ({"objects": [{"mesh": "cube", "size": {"uniform": [2, 1]}}]}, "size.uniform: [2, 1]; the first end must not be above the second"),
    ({"objects": [{"mesh": "cube", "size": {"uniform": [0, 1]}}]}, "size.uniform: [0, 1]; it must be two ends, each a number of at least 1e-06"),
    ({"objects": [{"mesh": "cube", "size": {"log_uniform": [1]}}]}, "size.log_uniform: [1]; it must be two ends"),
    ({"objects": [{"mesh": "cube", "count": {"uniform": [1, 2.5]}}]}, "count.uniform: [1, 2.5]; it must be two ends, each a whole number"),
    ({"objects": [{"mesh": "cube", "position": [0, 1]}]}, "position: [0, 1]; it must be a list of 3"),
    ({"objects": [{"mesh": "cube", "rotation": "some"}]}, "rotation: 'some'; it must be a number"),
    ({"camera": {"fov": 200}}, "camera.fov: 200; it must be a number from 0.1 to 170, or an object of one of uniform"),
    ({"camera": {"elevation": {"uniform_sine": [0, 100]}}}, "camera.elevation.uniform_sine: [0, 100]; it must be two ends"),
    ({"camera": {"azimuth": {"log_uniform": [-1, 1]}}}, "both ends must be above 0"),
    ({"camera": {"azimuth": {"uniform": [0, float("inf")]}}}, "camera.azimuth.uniform: [0, inf]; it must be two ends"),
    ({"camera": {"position": [0, 0, 1], "azimuth": 3}}, "camera.azimuth: position already says where the camera is"),
    ({"camera": {"lens": {"type": "wide"}}}, "camera.lens.type: 'wide'; it must be one of opencv, fisheye, equirectangular"),
    ({"camera": {"lens": {"type": {"choice": ["opencv", "fisheye"]}}}}, "camera.lens: drawn; it must be the same in all frames"),
    ({"camera": {"lens": {"type": "fisheye"}}, "write": ["s0"]}, "write.s0: png is not written of pictures through a lens"),
    ({"camera": {"lens": {"type": "fisheye"}}, "write": {"poses": ["llff"]}}, "write.poses: llff knows no fisheye lens"),
    ({"camera": {"lens": {"type": "opencv", "distortion": [-9, 0, 0, 0]}}}, "frame 0: distortion: no direction is shown at column"),
    ({"camera": {"baseline": 0.1}}, "camera.baseline: a rig of two cameras needs an even number of views, not 1"),
    ({"camera": {"position": {"path": [[0, 0, 1]]}}}, "camera.position.path: [[0, 0, 1]]; it must be a list of two points or more"),
    ({"camera": {"position": [1, 1, 1], "target": [1, 1, 1]}}, "camera: position and target are the same point"),
    ({"objects": [{"mesh": "cube", "material": {"alpha": 1}}]}, "material: type is missing; it must be one of conductor"),
    ({"objects": [{"mesh": "cube", "material": {"type": "wood"}}]}, "material.type: 'wood'; it must be one of conductor"),
    ({"objects": [{"mesh": "cube", "material": {**PLASTIC, "alpha": {"uniform": [0.1, 3]}}}]}, "objects[0].material: alpha"),
    ({"objects": [{"mesh": "cube", "material": {"choice": [PLASTIC, {**PLASTIC, "int_ior": -1}]}}]}, "objects[0].material: int_ior"),
    ({"objects": [{"mesh": "cube", "material": {"type": "conductor", "metal": "gould"}}]}, "objects[0].material: metal"),
    ({"objects": [{"mesh": "cube", "material": {**PLASTIC, "distribution": "phong"}}]}, "distribution: 'phong'; it must be one of beckmann, ggx"),
    ({"floor": {"material": {"type": "diffuse", "reflectance": 2}}}, "floor.material: reflectance"),
    ({"light": {"environment": {"sky": {"turbidity": 1}}}}, "light.environment.sky: rayleigh_sky: turbidity"),
    ({"light": {"environment": "sun.exr"}}, "sun.exr does not exist"),
    ({"light": {"per": "hour"}}, "light.per: 'hour'; it must be one of scene, frame"),
    ({"size": [0, 10]}, "size[0]: 0; it must be a whole number from 1 to 16384"),
    ({"size": [33, 20]}, "the image has 33 x 20 pixels; both sides must be multiples of 2"),
    ({"views": 0}, "views: 0; it must be a whole number"),
    ({"seed": -1}, "seed: -1; it must be a whole number"),
    ({"sensor": {"bitts": 8}}, 'sensor: "bitts" must be one of: preset'),
    ({"sensor": {"bits": 7}}, "sensor: bits"),
    ({"exposure": 0}, "exposure: 0; it must be a number of at least 1e-09"),
    ({"render": {"pixel_samples": 5000}}, "frame 0: pixel_samples"),
    ({"render": {"method": "fast"}}, "render.method: 'fast'; it must be one of dense, factored, reference"),
    ({"render": {"tolerance": {"uniform": [0.01, 0.1]}}}, "render.tolerance: drawn; it must be the same in all frames"),
    ({"objects": [{"mesh": "cube", "size": {"sweep": [1, 2]}}]}, "objects[0].size: is the same in all views of a scene"),
    ({"light": {"environment": 1, "rotation": {"choice": [0, {"sweep": [0, 9]}]}}}, "light.rotation.choice[1]: is the same in all views"),
    ({"objects": [{"mesh": "cube", "position": {"path": [[0, 0, 0], [1, 0, 0]]}}]}, "objects[0].position: is the same in all views"),
    ({"write": ["pictures"]}, "write[0]: 'pictures'; it must be one of mosaic"),
    ({"write": {"stokes": "png"}}, "write.stokes.format: 'png'; it must be one of exr, npy"),
    ({"write": {"depth": {"format": "npy", "half": True}}}, "write.depth.half: unknown key"),
    ({"write": {"poses": ["blender"]}}, "write.poses[0]: 'blender'; it must be one of transforms, llff, colmap"),
]  # fmt: skip


class RefusedTest(DataSetTest):
    def refused(self, *arguments):
        code, _, err = self.run_program(*arguments)
        self.assertEqual(code, 2, err)
        self.assertEqual(err.count("\n"), 1, err)
        return err

    def test_recipes(self):
        for number, (parts, text) in enumerate(RECIPES):
            with self.subTest(parts):
                recipe = self.recipe(**{"write": ["mosaic", "stokes"], **parts})
                self.assertIn(text, self.refused(recipe, "--frames", "0:1", "--output", self.path(str(number))))

    def test_files_that_are_no_recipe(self):
        for text, said in (("{", "not JSON"), ("[]", "[]; it must be an object"), ("{}", "objects is missing")):
            with open(self.path("recipe.json"), "w") as file:
                file.write(text)
            self.assertIn(said, self.refused(self.path("recipe.json"), "--check"))
        self.assertIn("No such file", self.refused(self.path("none.json"), "--check"))

    def test_yaml(self):
        yaml = self.path("recipe.yaml")
        for text, said in (("seed: [", "not YAML"), ("sede: 1", "sede: unknown key; did you mean seed?"), ("", "it must be an object")):
            with open(yaml, "w") as file:
                file.write(text)
            if importlib.util.find_spec("yaml"):
                self.assertIn(said, self.refused(yaml, "--check"))
        ended = self.start("sys.modules['yaml'] = None", yaml, "--check")
        self.assertEqual((ended.returncode, ended.stderr.count("\n")), (2, 1), ended.stderr)
        self.assertIn("recipe.yaml: YAML needs the Python package PyYAML; install it, or write the recipe as JSON", ended.stderr)

    def test_frames(self):
        recipe = self.recipe()
        for frames in ("3", "2:1", "a:b", "-1:2"):
            code, _, err = self.run_program(recipe, f"--frames={frames}", "--output", self.path("out"))
            self.assertEqual(code, 2)
            self.assertIn("it must be A:B", err)

    def test_folders(self):
        recipe = self.recipe()
        for output in ("/proc/nicol", os.path.join(recipe, "below")):
            self.assertIn(output, self.refused(recipe, "--frames", "0:1", "--output", output))

    def test_folder_of_another_recipe(self):
        self.render(self.recipe(), "0:1", "out")
        before = self.tree("out")
        self.assertIn(
            "holds frames of another recipe; choose another folder",
            self.refused(self.recipe(seed=4), "--frames", "0:1", "--output", self.path("out")),
        )
        self.assertEqual(self.tree("out"), before)

    def test_folder_of_other_meshes(self):
        self.add_meshes()
        recipe = self.recipe(objects=[{"mesh": {"folder": "meshes"}}])
        self.render(recipe, "0:1", "out")
        os.remove(self.path("meshes", "fine.ply"))
        err = self.refused(recipe, "--frames", "0:1", "--output", self.path("out"))
        self.assertIn("holds frames of another content of the recipe's folders", err)

    def test_full_disk(self):
        recipe = self.recipe(write=["mosaic", "stokes", "depth"])
        self.render(recipe, "0:4", "once")
        # The process may write no more than a few bytes to a file from its third picture on.
        before = """
import resource
real = outputs.write
def full(place, *arguments):
    full.left -= 1
    if full.left < 0:
        resource.setrlimit(resource.RLIMIT_FSIZE, (200, 200))
    return real(place, *arguments)
full.left = 2
outputs.write = full"""
        ended = self.start(before, recipe, "--frames", "0:4", "--output", self.path("full"))
        self.assertEqual(ended.returncode, 2, ended.stderr)
        self.assertEqual(ended.stderr.count("\n"), 1, ended.stderr)
        self.assertRegex(ended.stderr, "full.*(File too large|cannot be written)")
        self.assertEqual(sorted(os.listdir(self.path("full", "frames"))), ["000000", "000001"])
        self.assertEqual([name for name in os.listdir(self.path("full")) if name.startswith(".work-")], [])
        self.render(recipe, "0:4", "full")
        self.assert_same_tree("once", "full")

    @unittest.skipIf(os.geteuid() or not shutil.which("mount"), "only root mounts a file system of its own")
    def test_small_file_system(self):
        recipe = self.recipe(write={"stokes": "npy"})
        self.render(recipe, "0:6", "once")
        os.mkdir(self.path("small"))
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=144k", "nicol", self.path("small")], capture_output=True, text=True)
        if mounted.returncode:
            self.skipTest(mounted.stderr)
        self.addCleanup(subprocess.run, ["umount", self.path("small")], check=True)
        err = self.refused(recipe, "--frames", "0:6", "--output", self.path("small"))
        self.assertIn("No space left on device", err)
        whole = sorted(os.listdir(self.path("small", "frames")))
        self.assertGreater(len(whole), 0)
        self.assertEqual([name for name in os.listdir(self.path("small")) if name.startswith(".work-")], [])
        once, small = self.tree("once"), self.tree("small")
        for name in (f"frames/{frame}/{file}" for frame in whole for file in ("stokes.npy", "frame.json")):
            self.assertEqual(small[name], once[name])

    def test_copies(self):
        recipe = self.recipe()
        before = "sys.modules['fsspec'] = None"
        ended = self.start(before, recipe, "--frames", "0:1", "--output", self.path("out"), "--copy-to", "s3://bucket")
        self.assertEqual((ended.returncode, ended.stderr.count("\n")), (2, 1), ended.stderr)
        self.assertIn("s3://bucket: copies need the Python package fsspec", ended.stderr)
        if importlib.util.find_spec("fsspec"):
            err = self.refused(recipe, "--frames", "0:1", "--output", self.path("out"), "--copy-to", "s4://bucket")
            self.assertIn("s4://bucket: cannot be written", err)
            there = self.path("there")
            self.render(recipe, "0:2", "out", "--copy-to", f"file://{there}")
            os.remove(self.path("there", "frames", "000001", "frame.json"))
            self.render(recipe, "0:3", "out", "--copy-to", f"file://{there}")
            os.remove(self.path("out", ".lock"))
            self.assert_same_tree("out", "there")

    def test_verify(self):
        recipe = self.recipe()
        self.render(recipe, "0:2", "out")
        self.assertEqual(self.run_program(recipe, "--verify", "--output", self.path("out"))[0], 0)
        damaged = self.path("out", "frames", "000001", "stokes.exr")
        with open(damaged, "r+b") as file:
            file.seek(900)
            file.write(b"x")
        self.assertIn(damaged, self.refused(recipe, "--verify", "--output", self.path("out")))

    def test_dataset_json_names_recipe_and_library(self):
        recipe = self.recipe()
        self.render(recipe, "0:1", "out")
        with open(self.path("out", "dataset.json")) as file:
            facts = json.load(file)
        with open(recipe) as file:
            self.assertEqual(facts["recipe"], json.load(file))
        self.assertIn("version", facts["library"])


if __name__ == "__main__":
    unittest.main()
