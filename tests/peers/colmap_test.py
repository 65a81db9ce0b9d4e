# SPDX-License-Identifier: MIT
"""COLMAP triangulates points of rendered pictures from the written poses, with a median reprojection error below half a pixel;
from poses that are wrong by a degree it does not."""

import json
import math
import os
import shutil
import struct
import subprocess
import sys
import unittest
import zlib

try:
    import numpy
except ImportError:
    numpy = None
if numpy is None or shutil.which("colmap") is None:
    print("skipped: colmap or numpy is absent")
    sys.exit(77)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "dataset"))
from data_set import DataSetTest  # noqa: E402

VIEWS = 10
RECIPE = {
    "size": [480, 360], "views": VIEWS,
    "objects": [
        {"mesh": "cube", "rotation": 20, "material": {"type": "diffuse", "reflectance_texture": "noise.png"}},
        {"mesh": "sphere", "size": 0.8, "position": [1, 0, 0.2], "material": {"type": "pplastic", "diffuse_reflectance_texture": "noise.png"}},
    ],
    "floor": {"size": 5, "material": {"type": "diffuse", "reflectance_texture": "noise.png"}},
    "light": {"environment": 1}, "render": {"pixel_samples": 4},
    "camera": {"azimuth": {"sweep": [-40, 40]}, "elevation": {"uniform": [20, 45]}, "roll": {"uniform": [-10, 10]}},
    "write": {"s0": "png", "poses": ["colmap"]},
}  # fmt: skip


def save_noise(path, size=256):
    """Writes blobs of many sizes as a grey PNG."""
    random = numpy.random.default_rng(1)
    image = sum(numpy.kron(random.random((size // step, size // step)), numpy.ones((step, step))) for step in (4, 8, 16, 32))
    rows = numpy.rint(255 * image / image.max()).astype(numpy.uint8)
    lines = numpy.concatenate([numpy.zeros((size, 1), numpy.uint8), rows], axis=1)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        header = struct.pack(">IIBBBBB", size, size, 8, 0, 0, 0, 0)
        for name, data in ((b"IHDR", header), (b"IDAT", zlib.compress(lines.tobytes())), (b"IEND", b"")):
            file.write(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)))


class ColmapTest(DataSetTest):
    def colmap(self, *arguments):
        environment = os.environ | {"QT_QPA_PLATFORM": "offscreen"}
        ended = subprocess.run(
            ["colmap", *arguments], capture_output=True, text=True, timeout=600, env=environment, check=False
        )
        self.assertEqual(ended.returncode, 0, ended.stdout[-2000:] + ended.stderr[-2000:])

    def triangulate(self, poses):
        """Returns the reprojection errors of the points that COLMAP finds with these poses, pixels."""
        os.makedirs(self.path("model"), exist_ok=True)
        self.colmap(
            "point_triangulator", "--database_path", self.path("db"), "--image_path", self.path("out", "frames"),
            "--input_path", poses, "--output_path", self.path("model"),
        )  # fmt: skip
        self.colmap(
            "model_converter", "--input_path", self.path("model"), "--output_path", self.path("model"), "--output_type", "TXT"
        )
        with open(self.path("model", "points3D.txt")) as file:
            return [float(line.split()[7]) for line in file if not line.startswith("#")]

    def test_triangulates_from_written_poses(self):
        save_noise(self.path("noise.png"))
        self.render(self.recipe(**RECIPE), f"0:{VIEWS}", "out")
        with open(self.path("out", "frames", "000000", "frame.json")) as file:
            K = json.load(file)["camera"]["K"]
        # Images get their numbers in the database in the order of their names only from one thread.
        self.colmap(
            "feature_extractor", "--SiftExtraction.num_threads", "1", "--database_path", self.path("db"), "--image_path", self.path("out", "frames"),
            "--ImageReader.camera_model", "PINHOLE", "--ImageReader.single_camera", "1", "--SiftExtraction.use_gpu", "0",
            "--ImageReader.camera_params", f"{K[0][0]},{K[1][1]},{K[0][2]},{K[1][2]}",
        )  # fmt: skip
        self.colmap("exhaustive_matcher", "--database_path", self.path("db"), "--SiftMatching.use_gpu", "0")
        poses = self.path("out", "poses", "000000", "colmap")
        errors = self.triangulate(poses)
        print(f"{len(errors)} points, median reprojection error {numpy.median(errors):.3f} px")
        self.assertGreater(len(errors), 500)
        self.assertLess(numpy.median(errors), 0.5)

        shutil.copytree(poses, self.path("wrong"))
        with open(self.path("wrong", "images.txt")) as file:
            lines = file.read().split("\n")
        for i in range(0, 2 * VIEWS, 4):
            fields = lines[i].split()
            # Every other camera is turned by a degree about its view: q becomes (cos, 0, 0, sin) q.
            w, x, y, z = map(float, fields[1:5])
            c, s = math.cos(math.radians(0.5)), math.sin(math.radians(0.5))
            fields[1:5] = map(repr, (c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w))
            lines[i] = " ".join(fields)
        with open(self.path("wrong", "images.txt"), "w") as file:
            file.write("\n".join(lines))
        wrong = self.triangulate(self.path("wrong"))
        print(f"wrong by a degree: {len(wrong)} points, median reprojection error {numpy.median(wrong or [99]):.3f} px")
        self.assertTrue(len(wrong) < len(errors) / 2 or numpy.median(wrong) > 0.5)


if __name__ == "__main__":
    unittest.main()
