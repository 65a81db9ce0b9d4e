# SPDX-License-Identifier: MIT
"""The recipes of samples/dataset, the sheet of a data set, and the rates."""

import json
import os
import re
import struct
import subprocess
import sys
import unittest

from data_set import DataSetTest

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

    def test_rates(self):
        out = self.script("rates.py", "--frames", "2")
        self.assertEqual(len(re.findall(r" [\d,]+ a minute +[\d,]+ ms of processor time each", out)), 3, out)


if __name__ == "__main__":
    unittest.main()
