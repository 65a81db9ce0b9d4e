# SPDX-License-Identifier: MIT
# Tests of nicol-convert from the outside: its files and messages, and exit code 2 with one clear line for every bad
# input.
import json
import math
import os
import struct
import subprocess
import unittest
import zipfile
import zlib

from images import exr_channels, exr_size
from program_test import PROGRAM, ProgramTest


def npy(kind, shape, data):
    header = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape!r}, }}".encode()
    header += b" " * (63 - (10 + len(header)) % 64) + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + data


def npz(path, shape, values):
    def text(word):
        return npy(f"<U{len(word)}", (), word.encode("utf-32-le"))

    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("coeff.npy", npy("<f8", shape, struct.pack(f"<{len(values)}d", *values)))
        archive.writestr("cod_type.npy", text("POLAR4"))
        archive.writestr("sh_type.npy", text("REAL"))


def read_npz(path):
    with zipfile.ZipFile(path) as archive:
        data = archive.read("coeff.npy")
    start = 10 + struct.unpack_from("<H", data, 8)[0]
    return list(struct.unpack(f"<{(len(data) - start) // 8}d", data[start:]))


def grey_png(width, height, value):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = (b"\0" + bytes([value]) * width) * height
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def light(order, last=0.0):
    """Returns radiance 1 from every direction, with `last` as the last s0 coefficient."""
    values = [0.0] * (4 * (order + 1) ** 2)
    values[0] = math.sqrt(4 * math.pi)
    values[-4] = last
    return values


class ConvertTest(ProgramTest):
    def setUp(self):
        super().setUp()
        os.mkdir(self.path("out"))
        npz(self.path("light.npz"), (1, 9, 4), light(2, 0.5))
        # Two levels have 8 entries. The first entry is s0 to s0 of order 0.
        npz(self.path("material.npz"), (1, 8, 4, 4), [0.5] + [0.0] * (8 * 16 - 1))

    def run_program(self, *arguments, **environment):
        # Conversions need no OpenGL, so the program must not look for it.
        return super().run_program(*arguments, **{"NICOL_BACKEND": "none", **environment})

    def info(self, *arguments):
        return json.loads(self.assert_succeeds("--info", "--json", *arguments).stdout)


class Success(ConvertTest):
    def test_every_format_of_light(self):
        run = self.assert_succeeds("light.npz", "out/a.exr", "--size", "40x21")
        self.assertEqual((run.stdout, run.stderr), ("", ""))
        self.assertEqual([self.info("out/a.exr")[k] for k in ("width", "height")], [40, 21])
        self.assert_succeeds("out/a.exr", "out/b.npz", "--order", "2", "--band-limited")
        for a, b in zip(read_npz(self.path("out/b.npz")), light(2, 0.5)):
            self.assertAlmostEqual(a, b, delta=1e-6)
        self.assert_succeeds("light.npz", "out/a.exr")
        self.assert_succeeds("out/a.exr", "out/c_s0.exr", "--edge", "64")
        self.assert_succeeds("out/c_s3.exr", "out/d.npz", "--order=2")
        for a, b in zip(read_npz(self.path("out/d.npz")), light(2, 0.5)):
            self.assertAlmostEqual(a, b, delta=1e-3)
        wanted = ["a.exr", "b.npz", "c_s0.exr", "c_s1.exr", "c_s2.exr", "c_s3.exr", "d.npz"]
        self.assertEqual(sorted(os.listdir(self.path("out"))), wanted)
        for name, kind in (("a.exr", "light image"), ("c_s2.exr", "light cross"), ("d.npz", "light psh")):
            self.assertEqual(self.info("out/" + name)["kind"], kind)

    def test_rotations(self):
        # The l = 1 coefficients are -y, z, -x. A rotation by 90 degrees about x maps y to z and z to -y, then one about
        # z maps x to y and y to -x.
        values = [10.0, 0, 0, 0, 1.0, 0, 0, 0, 2.0, 0, 0, 0, 3.0, 0, 0, 0]
        npz(self.path("turn.npz"), (1, 4, 4), values)
        self.assert_succeeds("turn.npz", "out/x.npz", "--rotate", "1,0,0,90")
        for a, b in zip(read_npz(self.path("out/x.npz"))[4::4], (2, -1, 3)):
            self.assertAlmostEqual(a, b)
        self.assert_succeeds("turn.npz", "out/xz.npz", "--rotate", "2,0,0,90", "--rotate=0,0,1,90", "--scale", "2")
        for a, b in zip(read_npz(self.path("out/xz.npz"))[4::4], (6, -2, -4)):
            self.assertAlmostEqual(a, b)

    def test_materials(self):
        self.assert_succeeds("material.npz", "out/m.npz")
        self.assertEqual(read_npz(self.path("out/m.npz")), read_npz(self.path("material.npz")))
        self.assert_succeeds("material.npz", "out/cache/")
        (table,) = os.listdir(self.path("out/cache"))
        self.assertEqual(self.info("out/cache/" + table)["kind"], "material table")
        self.assert_succeeds("out/cache/" + table, "out/back.npz", "--order", "0")
        # Half of the light of order 0 leaves downwards.
        self.assertAlmostEqual(read_npz(self.path("out/back.npz"))[0], 0.25, delta=1e-6)

    def test_information(self):
        report = self.info("light.npz")
        self.assertEqual((report["channels"], report["order"], report["wavelengths"]), (1, 2, None))
        self.assertAlmostEqual(report["mean"][0], 1, delta=1e-3)
        self.assertAlmostEqual(report["energy"][0][0][0], 4 * math.pi, delta=1e-6)
        self.assertAlmostEqual(report["energy"][0][2][0], 0.25)
        self.assertEqual(len(report["energy"][0]), 3)
        self.assertIs(report["polarized"], False)
        report = self.info("light.npz", "--order", "0", "--scale=3")
        self.assertEqual(len(report["energy"][0]), 1)
        self.assertAlmostEqual(report["mean"][0], 3, delta=1e-5)
        report = self.info("material.npz")
        self.assertEqual((report["kind"], report["order"], report["file_order"]), ("material psh", 1, 1))
        self.assertEqual(report["norms"], [[[0.5, 0, 0], [0, 0, 0], [0, 0, 0]]])
        self.assertEqual(report["energy"], [[0.25, 0]])
        self.assertEqual(report["asymmetry"], [0])

    def test_information_for_people(self):
        text = self.assert_succeeds("--info", "light.npz").stdout
        for words in ("light.npz\n", "coefficients", "channels", "0 to 2", "mean s0", "Eq. 70", "100.0000 %"):
            self.assertIn(words, text)
        self.assertIn("albedo", self.assert_succeeds("material.npz", "--info").stdout)
        self.assertLess(max(map(len, text.splitlines())), 100)

    def test_unphysical_light_is_noticed(self):
        npz(self.path("ringing.npz"), (1, 9, 4), light(2, 6.0))
        run = self.assert_succeeds("ringing.npz", "out/a.exr")
        self.assertEqual(len(run.stderr.splitlines()), 1)
        for words in ("notice: out/a.exr", "--physical"):
            self.assertIn(words, run.stderr)
        self.assertGreater(self.info("out/a.exr")["unphysical"][0], 0.01)
        self.assertEqual(self.assert_succeeds("ringing.npz", "out/a.exr", "--physical").stderr, "")
        self.assertEqual(self.info("out/a.exr")["unphysical"], [0])

    def test_mosaics(self):
        # An even grey of 51 is 0.2 of the largest number, behind each polarizer: s0 is 0.4, unpolarized.
        self.write("raw.png", grey_png(4, 2, 51))
        self.write("sensor.json", '{"bits": 8, "gain": 0.255, "full_well": 1000, "exposure": 1000, "quantum_efficiency": 1}')
        for method, size in (("bilinear", (4, 2)), ("gradient", (4, 2)), ("blocks", (2, 1))):
            self.assert_succeeds("--demosaic", method, "raw.png", "out/a.exr", "--sensor", "sensor.json")
            with open(self.path("out/a.exr"), "rb") as file:
                data = file.read()
            self.assertEqual(exr_size(data), size)
            self.assertEqual(exr_channels(data), ["S0.Y", "S1.Y", "S2.Y", "S3.Y", "Y"])
        self.assert_succeeds("--angles", *["raw.png"] * 4, "out/b.exr")
        with open(self.path("out/b.exr"), "rb") as file:
            self.assertEqual(exr_size(file.read()), (4, 2))

    def test_bad_mosaics(self):
        self.write("raw.png", grey_png(4, 2, 51))
        self.write("odd.png", grey_png(3, 2, 51))
        self.write("sensor.json", '{"bits": 8}')
        self.write("wrong.json", '{"bit": 8}')
        table = (
            (["raw.png", "Nicol:Sensor", "JSON"], "raw.png out/a.exr"),
            (["wrong.json", '"bit"', "bits"], "raw.png out/a.exr --sensor wrong.json"),
            (["3 x 2", "multiples of 2"], "odd.png out/a.exr --sensor sensor.json"),
            (["out/a.png", ".exr"], "raw.png out/a.png --sensor sensor.json"),
            (["nowhere.json"], "raw.png out/a.exr --sensor nowhere.json"),
        )
        self.assert_each_fails(table, "--demosaic", "bilinear")
        self.assert_fails(["--demosaic", "best"], "--demosaic", "best", "raw.png", "out/a.exr")
        self.assert_fails(["--sensor", "--demosaic"], "raw.png", "out/a.exr", "--sensor", "sensor.json")
        self.assert_fails(["--angles", "4 files"], "--angles", *["raw.png"] * 3, "out/a.exr")
        self.assert_fails(["odd.png", "3 x 2"], "--angles", *["raw.png"] * 3, "odd.png", "out/a.exr")

    def test_help_and_version(self):
        self.assertIn("--wavelengths", self.assert_succeeds("--help").stdout)
        self.assertRegex(self.assert_succeeds("--version").stdout, r"^nicol-convert \d+\.\d+\.\d+\n")


class CommandLine(ConvertTest):
    def test_arguments(self):
        # The output is an image unless the arguments name another file.
        table = (
            (["3"], "light.npz out/a.exr more"),
            (["output", "1"], "light.npz"),
            (["--info", "2"], "light.npz out/a.exr --info"),
            (["--info", "0"], "--info"),
            (["--json"], "--info light.npz --json=1"),
            (["width"], "light.npz out/a.npz --size 24x16"),
            (["width"], "light.npz out/a_s0.exr --size 24x16"),
            (["edge"], "light.npz out/a_s0.exr --edge 0"),
            (["PHYSICAL"], "light.npz out/a.npz --physical"),
            (["rotation"], "material.npz out/m.npz --rotate 1,0,0,90"),
            (["65"], "material.npz out/m.npz --order 65"),
            (["input", "0"], ""),
        )
        self.assert_each_fails(table)
        table = (
            (["--json"], "--json"),
            (["--frobnicate"], "--frobnicate"),
            (["--order"], "--order"),
            (["--order", "four"], "--order four"),
            (["--order", "-1"], "--order -1"),
            (["--order", "4097"], "--order 4097"),
            (["--order", "99999999999"], "--order 99999999999"),
            (["--size", "24"], "--size 24"),
            (["--size"], "--size 24x16x3"),
            (["--size", "0x16"], "--size 0x16"),
            (["100000"], "--size 100000x16"),
            (["edge"], "--edge 16"),
            (["--wavelengths", "''"], "--wavelengths="),
            (["--wavelengths", "red"], "--wavelengths 550,red"),
            (["--wavelengths", "17"], "--wavelengths " + ",".join(["550"] * 17)),
            (["wavelength"], "--wavelengths 5"),
            (["wavelengths"], "--wavelengths 550"),
            (["--scale", "0"], "--scale 0"),
            (["--scale", "nan"], "--scale nan"),
            (["--scale", "1,2"], "--scale 1,2"),
            (["scale"], "--scale 1e30"),
            (["--rotate", "1,0,0"], "--rotate 1,0,0"),
            (["--rotate", "axis"], "--rotate 0,0,0,90"),
            (["--band-limited"], "--band-limited=1"),
            (["BAND_LIMITED"], "--band-limited"),
        )
        self.assert_each_fails(table, "light.npz", "out/a.exr")


class BadFiles(ConvertTest):
    def test_inputs(self):
        """Each kind of bad file appears once, because the tests of the readers cover the details."""
        for name in ("text.txt", "empty.npz", "zero.exr", "zero.pbsdf", "zero.response"):
            self.write(name, bytes(0 if name == "empty.npz" else 4096))
        npz(self.path("odd.npz"), (1, 13, 4, 4), [0.0] * (13 * 16))
        os.mkdir(self.path("folder.exr"))
        for name in (
            "nowhere.exr nowhere nowhere_s0.exr text.txt empty.npz zero.exr zero.pbsdf zero.response odd.npz folder.exr"
        ).split():
            words = [name.split("_")[0]]
            self.assert_each_fails([(words, "--info " + name), (words, name + " out/a.exr"), (words, name + " out/a.npz")])

    def test_cube_with_a_part_missing(self):
        self.assert_succeeds("light.npz", "out/c_s0.exr", "--edge", "8")
        os.remove(self.path("out/c_s2.exr"))
        self.assert_fails(["out/c_s2.exr"], "--info", "out/c_s0.exr")

    def test_light_and_materials_do_not_mix(self):
        self.assert_each_fails(((["light", "folder/"], "light.npz folder/"), (["out/a.exr"], "material.npz out/a.exr")))

    def test_outputs(self):
        self.write("file", "x")
        outputs = ("nowhere/a.exr", "file/a.exr", "nowhere/a.npz", "nowhere/a_s0.exr", "out/a.png")
        self.assert_each_fails([([output.removesuffix("_s0.exr")], output) for output in outputs], "light.npz")
        self.assert_fails(["file"], "material.npz", "file/")
        os.mkdir(self.path("out/a.exr"))
        self.assert_fails(["out/a.exr"], "light.npz", "out/a.exr")

    def test_report_that_cannot_be_written(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        with open("/dev/full", "w") as full:
            run = subprocess.run(
                [PROGRAM, "--info", self.path("light.npz")], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60
            )
        self.assertEqual(run.returncode, 2)
        self.assertEqual(len(run.stderr.splitlines()), 1)


if __name__ == "__main__":
    unittest.main()
