# SPDX-License-Identifier: MIT
"""The orbit's plot: as many points as views, a full turn, and what the printed line says.

usage: orbit_test.py ORBIT_PY SCENES
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

ORBIT, SCENES = (os.path.abspath(sys.argv.pop(1)) for _ in range(2))


class OrbitTest(unittest.TestCase):
    def test_plot(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "orbit.svg")
            command = [sys.executable, ORBIT, os.path.join(SCENES, "snail_sky.xml"), path, "--views", "6", "--size", "48x36"]
            ended = subprocess.run(command, capture_output=True, text=True, timeout=120)
            self.assertEqual(ended.returncode, 0, ended.stderr)
            line = xml.etree.ElementTree.parse(path).find(".//{*}polyline").get("points")
        points = [tuple(map(float, point.split(","))) for point in line.split()]
        self.assertEqual(len(points), 7)
        self.assertEqual(points[0][1], points[-1][1])
        self.assertTrue(all(40 <= y <= 260 for _, y in points), points)
        least, most = (float(x) for x in re.findall(r"(0\.\d+) at", ended.stdout))
        self.assertTrue(0 < least < most < 1, ended.stdout)
        # Towards and away from the sun the ground is polarized little, and at right angles to it strongly.
        self.assertGreater(max(y for _, y in points) - min(y for _, y in points), 50)


if __name__ == "__main__":
    unittest.main()
