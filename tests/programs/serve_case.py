# SPDX-License-Identifier: MIT
"""Shared base of the nicol-serve tests. The command line: the program, nicol-render, then the arguments of unittest."""

import os
import sys
import tempfile
import unittest

from program_test import PROGRAM
from serve_client import Server, write_scenes

RENDER = os.path.abspath(sys.argv.pop(1))
SQUARE = "/scenes/square/"
IMAGE = SQUARE + "image.png?size=32x24"


def read(path):
    with open(path, "rb") as file:
        return file.read()


def alive(pid):
    """Returns whether the process runs. A zombie does not count."""
    try:
        return b" Z " not in read(f"/proc/{pid}/stat")
    except OSError:
        return False


class ServeTest(unittest.TestCase):
    options = ()

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        write_scenes(cls.folder)
        cls.server = Server(PROGRAM, cls.folder, *cls.options)
        cls.addClassCleanup(cls.server.stop)

    def assert_problem(self, answer, status, parameter=None, words=""):
        self.assertEqual(answer.status, status, answer.body)
        self.assertEqual(answer.headers["content-type"], "application/problem+json")
        problem = answer.json()
        self.assertEqual(problem["status"], status)
        self.assertTrue(problem["title"])
        self.assertEqual(problem.get("parameter"), parameter)
        self.assertIn(words, problem["detail"] + problem.get("range", ""))
        return problem
