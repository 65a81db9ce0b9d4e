# SPDX-License-Identifier: MIT
"""Shared base of the tests of data sets: a folder with meshes for each test, recipes, and runs of the program."""

import contextlib
import io
import json
import math
import os
import subprocess
import sys

import numpy
from nicol.dataset import program

TESTS = os.path.abspath(os.path.join(os.path.dirname(__file__), ".."))
sys.path.insert(0, os.path.join(TESTS, "programs"))
from folder_test import FolderTest  # noqa: E402

ASSETS = os.path.join(os.path.dirname(TESTS), "samples", "assets")


def save_bumpy_sphere(path, rows, columns):
    """Writes a sphere with bumps that shadow each other as PLY."""
    vertices, faces = [], []
    for i in range(rows + 1):
        for j in range(columns):
            theta, phi = math.pi * i / rows, 2 * math.pi * j / columns
            r = 1 + 0.25 * math.sin(5 * theta) * math.sin(5 * phi)
            vertices.append(
                f"{r * math.sin(theta) * math.cos(phi)} {r * math.cos(theta)} {-r * math.sin(theta) * math.sin(phi)}"
            )
            if i < rows:
                a, b = i * columns + j, i * columns + (j + 1) % columns
                faces += [f"3 {a} {a + columns} {b}", f"3 {b} {a + columns} {b + columns}"]
    head = ["ply", "format ascii 1.0", f"element vertex {len(vertices)}", "property float x", "property float y",
            "property float z", f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]  # fmt: skip
    with open(path, "w") as file:
        file.write("\n".join([*head, *vertices, *faces]) + "\n")


class DataSetTest(FolderTest):
    def add_meshes(self):
        """Makes the folder meshes/, in which one mesh is fine enough that its bake infers rays (4,096 vertices)."""
        os.mkdir(self.path("meshes"))
        save_bumpy_sphere(self.path("meshes", "coarse.ply"), 12, 24)
        save_bumpy_sphere(self.path("meshes", "fine.ply"), 44, 92)

    def recipe(self, **parts):
        """Writes a recipe and returns its path; parts replace or add keys, None removes one."""
        recipe = {"seed": 3, "size": [48, 32], "objects": [{"mesh": "cube"}], "light": {"environment": 1}, "write": ["stokes"]}
        recipe = {key: value for key, value in {**recipe, **parts}.items() if value is not None}
        with open(self.path("recipe.json"), "w") as file:
            json.dump(recipe, file)
        return self.path("recipe.json")

    def run_program(self, *arguments):
        """Runs the program in this process; returns its exit code, output and errors."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                code = program.main(list(arguments))
            except SystemExit as ended:
                code = ended.code
        return code, out.getvalue(), err.getvalue()

    def render(self, recipe, frames, output, *more):
        code, out, err = self.run_program(recipe, "--frames", frames, "--output", self.path(output), *more)
        self.assertEqual(code, 0, err)
        return out

    def start(self, before, *arguments):
        """Runs the program in a process of its own, after the statements `before`; returns the ended process."""
        script = (
            f"import sys\nfrom nicol.dataset import folder, outputs, program\n{before}\nsys.exit(program.main(sys.argv[1:]))"
        )
        return subprocess.run([sys.executable, "-c", script, *arguments], capture_output=True, text=True, timeout=240)

    def tree(self, output):
        """Returns the bytes of all files below a folder, by path."""
        found = {}
        for place, _, files in os.walk(self.path(output)):
            for name in files:
                path = os.path.join(place, name)
                with open(path, "rb") as file:
                    found[os.path.relpath(path, self.path(output))] = file.read()
        return found

    def assert_same_tree(self, first, second):
        a, b = self.tree(first), self.tree(second)
        self.assertEqual(sorted(a), sorted(b))
        different = [name for name in a if a[name] != b[name]]
        self.assertEqual(different, [])


def load(*names):
    return numpy.load(os.path.join(*names))
