# SPDX-License-Identifier: MIT
"""The pair of reflection_pair.py: at Brewster's angle the polarizer at 90 degrees removes the reflection, and at 0 it does not.

usage: reflection_pair_test.py REFLECTION_PAIR_PY ENVIRONMENT
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest

PAIR, ENVIRONMENT = (os.path.abspath(sys.argv.pop(1)) for _ in range(2))


class ReflectionPairTest(unittest.TestCase):
    def test_pair(self):
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, PAIR, ENVIRONMENT, folder, "--size", "48x36"]
            ended = subprocess.run(command, capture_output=True, text=True, timeout=120)
            self.assertEqual(ended.returncode, 0, ended.stderr)
            images = [f"{name}_{angle}.png" for name in ("pane", "open") for angle in (0, 45, 90, 135)]
            self.assertEqual(sorted(os.listdir(folder)), sorted(images + ["pane.npy", "open.npy"]))
        (pane_0, open_0), (pane_90, open_90) = (map(float, line) for line in re.findall(r"(0\.\d+) with.* (0\.\d+) without", ended.stdout))
        # Reflections brighten one, and the other is within what reaches the pane at other angles.
        self.assertGreater(pane_0, 1.15 * open_0, ended.stdout)
        self.assertLess(abs(pane_90 - open_90), 0.05 * open_90, ended.stdout)


if __name__ == "__main__":
    unittest.main()
