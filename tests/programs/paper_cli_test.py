# SPDX-License-Identifier: MIT
# Tests of nicol-paper from the outside: its images and tables if the paper's data is present, and a clear line if it is
# absent.
#
# usage: paper_cli_test.py PROGRAM CommandLine|Results
import os
import struct
import sys
import tempfile
import unittest

from program_test import ProgramTest, run

DATA = os.path.join(os.environ.get("NICOL_TEST_DATA", ""), "polarsh")
FILES = ("buddha.obj", "plane.obj", "SHVec_sponza_1024_L100.npz", "SHMat_6_gold_ds1_L20_ISOBI2.npz")
SKIPPED = 77


class CommandLine(ProgramTest):
    def test_data_absent(self):
        folder = self.folder
        self.assert_fails(["buddha.obj", folder], folder, "--out", self.path("out"))
        self.assert_fails(["buddha.obj", self.path("polarsh")], NICOL_TEST_DATA=folder)
        self.assert_fails(["no folder of data", "NICOL_TEST_DATA"], NICOL_TEST_DATA="")

    def test_data_incomplete_or_broken(self):
        for missing in FILES:
            for name in FILES:
                self.write(name, "nothing\n")
            os.remove(self.path(missing))
            self.assert_fails([missing], self.folder)
        self.write(FILES[-1], "nothing\n")
        self.assert_fails([FILES[2]], self.folder, "--out", self.path("out"))

    def test_arguments(self):
        table = (
            (["--size", "31"], ". --size 31"),
            (["--size", "4097"], ". --size 4097"),
            (["--frames", "-1"], ". --frames -1"),
            (["--reference", "0"], ". --reference 0"),
            (["--directions", "255"], ". --directions 255"),
            (["--size", "value"], ". --size"),
            (["--lights"], ". --lights"),
            (["two folders"], "a b"),
        )
        self.assert_each_fails(table)

    def test_help(self):
        done = self.assert_succeeds("--help")
        self.assertEqual(done.stderr, "")
        self.assertIn("--reference", done.stdout)


def rows(text, first_words):
    """Returns the lines of the table that begins with these words, as lists of cells."""
    lines = text.split("\n")
    begin = next(i for i, line in enumerate(lines) if line.startswith("| " + first_words))
    table = []
    for line in lines[begin + 2 :]:
        if not line.startswith("|"):
            break
        table.append([cell.strip() for cell in line.strip("|").split("|")])
    return table


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.done = run(cls.folder.name, DATA, "--size", "64", "--frames", "1", "--directions", "512",
                       "--reference", "32", "--out", cls.folder.name, timeout=600)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_succeeds(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)

    def test_images(self):
        for name, columns in (("fig8_harmonics.png", 5), ("fig9_decomposition.png", 3), ("fig20_ablation.png", 3), ("fig22_physical_range.png", 4)):
            with open(self.path(name), "rb") as file:
                head = file.read(24)
            self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
            width, height = struct.unpack(">II", head[16:])
            self.assertGreater(width, 64 * columns)
            self.assertGreater(height, 64 * 4)
        contents = set()
        for name in ("low", "shadow", "five", "convolution", "stokes", "physical", "reference"):
            with open(self.path(name + ".exr"), "rb") as file:
                contents.add(file.read())
        self.assertEqual(len(contents), 7)

    def test_costs(self):
        """The table has the paper's numbers of coefficients, and every step takes time."""
        with open(self.path("table4.md")) as file:
            text = file.read()
        table = rows(text, "step")
        self.assertEqual([row[1] for row in table], ["19763"] * 5)
        self.assertEqual([row[2:5] for row in table],
                         [["75", "5625", "-"], ["75", "5625", "-"], ["108", "11664", "-"], ["300", "5625", "45"], ["300", "5625", "-"]])
        for row in table:
            dense, factored = float(row[5]), float(row[6])
            self.assertGreater(dense, 5625 * 3 * 4)
            self.assertLess(factored, dense / 10)
            for time in row[7:]:
                self.assertGreater(float(time), 0)

    def test_errors(self):
        """Shadows bring the image closer to the reference, and so does either form of the high orders."""
        table = rows(self.done.stdout, "relative error")
        low, shadow, five, convolution, split = ([float(x) for x in row[1:]] for row in table)
        self.assertLess(shadow[0], 0.8 * low[0])
        for high in (five, convolution, split):
            self.assertLess(high[0], shadow[0])
            self.assertLess(high[2], shadow[2])

    def test_realizable_range(self):
        """Some truncated light leaves the range, by shares within the expected bounds."""
        for row in rows(self.done.stdout, "share"):
            for share in row[1:]:
                self.assertGreater(float(share.rstrip(" %")), 1)
                self.assertLess(float(share.rstrip(" %")), 35)


if __name__ == "__main__":
    if sys.argv[1:2] == ["Results"] and not all(os.path.isfile(os.path.join(DATA, name)) for name in FILES):
        print("skipped: the folder polarsh in NICOL_TEST_DATA lacks the paper's data")
        sys.exit(SKIPPED)
    unittest.main()
