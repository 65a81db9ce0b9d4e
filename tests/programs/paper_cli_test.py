# SPDX-License-Identifier: MIT
# nicol-paper from the outside: its pictures and tables where the data is, and a clear line where it is not.
#
# usage: paper_cli_test.py PROGRAM CommandLine|Results
import os
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
DATA = os.path.join(os.environ.get("NICOL_TEST_DATA", ""), "polarsh")
FILES = ("buddha.obj", "plane.obj", "SHVec_sponza_1024_L100.npz", "SHMat_6_gold_ds1_L20_ISOBI2.npz")
SKIPPED = 77


def run(*arguments, **environment):
    return subprocess.run([PROGRAM, *arguments], env={**os.environ, **environment}, capture_output=True, text=True)


class CommandLine(unittest.TestCase):
    def refuse(self, words, *arguments, **environment):
        done = run(*arguments, **environment)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_data_absent(self):
        with tempfile.TemporaryDirectory() as folder:
            self.refuse(["buddha.obj", folder], folder, "--out", os.path.join(folder, "out"))
            self.assertFalse(os.path.exists(os.path.join(folder, "out")))
            self.refuse(["buddha.obj", os.path.join(folder, "polarsh")], NICOL_TEST_DATA=folder)
        self.refuse(["no folder of data", "NICOL_TEST_DATA"], NICOL_TEST_DATA="")

    def test_data_incomplete_or_broken(self):
        with tempfile.TemporaryDirectory() as folder:
            for missing in FILES:
                for name in FILES:
                    with open(os.path.join(folder, name), "w") as file:
                        file.write("nothing\n")
                os.remove(os.path.join(folder, missing))
                self.refuse([missing], folder)
            with open(os.path.join(folder, FILES[-1]), "w") as file:
                file.write("nothing\n")
            self.refuse([FILES[2]], folder, "--out", os.path.join(folder, "out"))

    def test_arguments(self):
        self.refuse(["--size", "31"], ".", "--size", "31")
        self.refuse(["--size", "4097"], ".", "--size", "4097")
        self.refuse(["--frames", "-1"], ".", "--frames", "-1")
        self.refuse(["--reference", "0"], ".", "--reference", "0")
        self.refuse(["--directions", "255"], ".", "--directions", "255")
        self.refuse(["--size", "value"], ".", "--size")
        self.refuse(["--lights"], ".", "--lights")
        self.refuse(["two folders"], "a", "b")

    def test_help(self):
        done = run("--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("--reference", done.stdout)


def rows(text, first_words):
    """The lines of the table that begins with these words, as lists of cells."""
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
        cls.done = run(DATA, "--size", "64", "--frames", "1", "--directions", "512", "--reference", "32",
                       "--out", cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_succeeds(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)

    def test_pictures(self):
        for name, columns in (("fig20_ablation.png", 3), ("fig22_physical_range.png", 4)):
            with open(self.path(name), "rb") as file:
                head = file.read(24)
            self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
            width, height = struct.unpack(">II", head[16:])
            self.assertGreater(width, 64 * columns)
            self.assertGreater(height, 64 * 4)
        contents = set()
        for name in ("low", "shadow", "convolution", "stokes", "physical", "reference"):
            with open(self.path(name + ".exr"), "rb") as file:
                contents.add(file.read())
        self.assertEqual(len(contents), 6)

    def test_costs(self):
        """The article's numbers of coefficients, and that nothing is free."""
        with open(self.path("table4.md")) as file:
            text = file.read()
        table = rows(text, "step")
        self.assertEqual([row[1] for row in table], ["19765"] * 4)
        self.assertEqual([row[2:5] for row in table],
                         [["75", "5625", "-"], ["75", "5625", "-"], ["300", "5625", "45"], ["300", "5625", "-"]])
        for row in table:
            dense, factored = float(row[5]), float(row[6])
            self.assertGreater(dense, 5625 * 3 * 4)
            self.assertLess(factored, dense / 10)
            for time in row[7:]:
                self.assertGreater(float(time), 0)

    def test_errors(self):
        """Shadows bring the picture nearer to the reference, and either form of the high orders too."""
        table = rows(self.done.stdout, "relative error")
        low, shadow, convolution, split = ([float(x) for x in row[1:]] for row in table)
        self.assertLess(shadow[0], 0.8 * low[0])
        for high in (convolution, split):
            self.assertLess(high[0], shadow[0])
            self.assertLess(high[2], shadow[2])

    def test_physical_range(self):
        """Truncated light leaves it, within the sizes that were seen."""
        for row in rows(self.done.stdout, "share"):
            for share in row[1:]:
                self.assertGreater(float(share.rstrip(" %")), 1)
                self.assertLess(float(share.rstrip(" %")), 35)


if __name__ == "__main__":
    if sys.argv[2:3] == ["Results"] and not all(os.path.isfile(os.path.join(DATA, name)) for name in FILES):
        print("skipped: the folder polarsh in NICOL_TEST_DATA lacks the article's data")
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
