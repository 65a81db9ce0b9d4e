# SPDX-License-Identifier: MIT
"""A data set by tasks of Ray, of whose workers one is killed while it renders: every frame is there once, and the bytes are
those of a single run. ray.log in the folder NICOL_TEST_LOGS has what Ray says."""

import os
import subprocess
import sys
import unittest

try:
    import numpy  # noqa: F401: the data sets need it
    import ray  # noqa: F401
except ImportError as absent:
    print(f"skipped: {absent.name} is absent")
    sys.exit(77)

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "dataset"))
from data_set import DataSetTest  # noqa: E402

SCRIPT = os.path.join(HERE, "..", "..", "samples", "dataset", "ray_frames.py")
# Every Python of the test runs this at its start: the first that comes to rename a frame dies.
KILLED = """
import os, signal
try:
    from nicol.dataset import folder
except ImportError:
    pass
else:
    real = folder.os.rename
    def rename(first, second):
        if "/frames/" in str(second):
            try:
                os.close(os.open("{killed}", os.O_CREAT | os.O_EXCL))
                os.kill(os.getpid(), signal.SIGKILL)
            except FileExistsError:
                pass
        return real(first, second)
    folder.os.rename = rename
"""


class RayTest(DataSetTest):
    def test_a_worker_is_killed(self):
        recipe = self.recipe(size=[64, 48], write=["mosaic", "stokes", "normals"])
        self.render(recipe, "0:12", "once")
        with open(self.path("sitecustomize.py"), "w") as file:
            file.write(KILLED.format(killed=self.path("killed")))
        environment = os.environ | {"PYTHONPATH": f"{self.folder}:{os.environ['PYTHONPATH']}", "RAY_USAGE_STATS_ENABLED": "0"}
        command = [sys.executable, SCRIPT, recipe, self.path("tasks"), "12", "--each", "3"]
        ended = subprocess.run(command, capture_output=True, text=True, timeout=400, env=environment, check=False)
        with open(os.path.join(os.environ.get("NICOL_TEST_LOGS", self.folder), "ray.log"), "w") as file:
            file.write(ended.stdout + ended.stderr)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        self.assertIn("12 frames are in", ended.stdout)
        self.assertTrue(os.path.exists(self.path("killed")))
        self.render(recipe, "0:0", "tasks")  # removes what the killed worker left
        self.assert_same_tree("once", "tasks")


if __name__ == "__main__":
    unittest.main()
