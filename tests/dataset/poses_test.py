# SPDX-License-Identifier: MIT
"""The written poses: points that pictures show, projected by each format's own formulas, meet the pixels that show them."""

import json
import unittest

import numpy
from data_set import DataSetTest, load

WIDTH, HEIGHT = 48, 32
RECIPE = {
    "size": [WIDTH, HEIGHT], "views": 4,
    "objects": [{"mesh": "cube", "rotation": "any"}, {"mesh": "sphere", "size": 0.6, "position": [0.9, 0.2, 0]}],
    "camera": {"fov": {"uniform": [25, 60]}, "azimuth": {"sweep": [0, 360]}, "elevation": {"sweep": [-60, 85]},
               "roll": {"uniform": [-40, 40]}, "target": [0.3, 0.1, 0]},
    "write": {"positions": "npy", "ids": "npy", "depth": "npy", "normals": "npy", "normals_camera": "npy",
              "poses": ["transforms", "llff", "colmap"]},
}  # fmt: skip


def rotation(w, x, y, z):
    """COLMAP's rotation of a quaternion."""
    return numpy.array([
        [1 - 2 * y * y - 2 * z * z, 2 * x * y - 2 * w * z, 2 * z * x + 2 * w * y],
        [2 * x * y + 2 * w * z, 1 - 2 * x * x - 2 * z * z, 2 * y * z - 2 * w * x],
        [2 * z * x - 2 * w * y, 2 * y * z + 2 * w * x, 1 - 2 * x * x - 2 * y * y],
    ])  # fmt: skip


def by_colmap(folder):
    """Yields functions from points to pixels and depths, frame by frame."""
    cameras = {}
    with open(f"{folder}/colmap/cameras.txt") as file:
        for line in file:
            number, model, width, height, *intrinsics = line.split()
            assert (model, int(width), int(height)) == ("PINHOLE", WIDTH, HEIGHT)
            cameras[number] = list(map(float, intrinsics))
    with open(f"{folder}/colmap/images.txt") as file:
        lines = file.read().split("\n")
    for line, points in zip(lines[0:-1:2], lines[1::2]):
        assert points == ""
        _, *numbers, camera, _ = line.split()
        numbers = list(map(float, numbers))
        R, t = rotation(*numbers[:4]), numpy.array(numbers[4:])
        fx, fy, cx, cy = cameras[camera]

        def project(points, R=R, t=t, fx=fx, fy=fy, cx=cx, cy=cy):
            x, y, z = numpy.moveaxis(points @ R.T + t, -1, 0)
            return fx * x / z + cx, fy * y / z + cy, z

        yield project


def by_transforms(folder):
    with open(f"{folder}/transforms.json") as file:
        frames = json.load(file)["frames"]
    for frame in frames:
        to_camera = numpy.linalg.inv(numpy.array(frame["transform_matrix"]))

        def project(points, m=to_camera, f=frame):
            x, y, z = numpy.moveaxis(points @ m[:3, :3].T + m[:3, 3], -1, 0)
            return f["fl_x"] * x / -z + f["cx"], f["fl_y"] * -y / -z + f["cy"], -z

        yield project


def by_llff(folder):
    for row in load(folder, "poses_bounds.npy"):
        matrix = row[:15].reshape(3, 5)
        height, width, focal = matrix[:, 4]

        def project(points, m=matrix, focal=focal, width=width, height=height):
            down, right, back = numpy.moveaxis((points - m[:, 3]) @ m[:, :3], -1, 0)
            return focal * right / -back + width / 2, focal * down / -back + height / 2, -back

        yield project


class PosesTest(DataSetTest):
    def setUp(self):
        super().setUp()
        self.render(self.recipe(**RECIPE), "0:4", "out")

    def frame(self, number, name):
        return load(self.path("out", "frames", f"{number:06d}", f"{name}.npy"))

    def test_points_meet_their_pixels(self):
        for projections in (by_colmap, by_transforms, by_llff):
            with self.subTest(projections.__name__):
                found = list(projections(self.path("out", "poses", "000000")))
                self.assertEqual(len(found), 4)
                for number, project in enumerate(found):
                    hit = self.frame(number, "ids") != 0xFFFFFFFF
                    self.assertGreater(hit.sum(), 100)
                    u, v, z = project(self.frame(number, "positions")[hit].astype(float))
                    rows, columns = numpy.nonzero(hit)
                    self.assertLess(abs(u - columns - 0.5).max(), 1e-3)
                    self.assertLess(abs(v - rows - 0.5).max(), 1e-3)
                    self.assertLess(abs(z - self.frame(number, "depth")[hit]).max(), 1e-4)

    def test_bounds_enclose_depths(self):
        for number, row in enumerate(load(self.path("out", "poses", "000000", "poses_bounds.npy"))):
            depth = self.frame(number, "depth")
            depth = depth[numpy.isfinite(depth)]
            self.assertLessEqual(row[15], depth.min() + 1e-4)
            self.assertGreaterEqual(row[16], depth.max() - 1e-4)

    def through(self, lens, **write):
        """Renders a frame through a lens; returns its camera, and pixels and points (in its axes) of surfaces."""
        camera = {**RECIPE["camera"], "fov": 60, "lens": lens}
        self.render(self.recipe(**{**RECIPE, "camera": camera, "write": {"positions": "npy", "ids": "npy", **write}}), "1:2", "lens")
        folder = self.path("lens", "frames", "000001")
        with open(f"{folder}/frame.json") as file:
            camera = json.load(file)["camera"]
        rows, columns = numpy.nonzero(load(folder, "ids.npy") != 0xFFFFFFFF)
        self.assertGreater(len(rows), 100)
        points = load(folder, "positions.npy")[rows, columns].astype(float) @ numpy.transpose(camera["R"]) + camera["t"]
        return camera, columns + 0.5, rows + 0.5, points

    def assert_shown(self, camera, x, y, columns, rows):
        K = camera["K"]
        # Surfaces are those of the nearest pixel of the view that is resampled.
        self.assertLess(abs(K[0][0] * x + K[0][2] - columns).max(), 1)
        self.assertLess(abs(K[1][1] * y + K[1][2] - rows).max(), 1)

    def test_distortion(self):
        k1, k2, p1, p2 = distortion = [-0.25, 0.08, 0.004, -0.006]
        write = {"mosaic": "npy", "aolp": "npy", "stokes": "npy", "dolp": "npy", "depth": "npy", "normals_camera": "npy", "alpha": "npy",
                 "poses": ["colmap", "transforms"]}  # fmt: skip
        camera, columns, rows, points = self.through({"type": "opencv", "distortion": distortion}, **write)
        x, y = points[:, 0] / points[:, 2], points[:, 1] / points[:, 2]
        r = x * x + y * y
        radial = 1 + k1 * r + k2 * r * r
        u, v = x * radial + 2 * p1 * x * y + p2 * (r + 2 * x * x), y * radial + p1 * (r + 2 * y * y) + 2 * p2 * x * y
        self.assert_shown(camera, u, v, columns, rows)
        with open(self.path("lens", "poses", "000000", "colmap", "cameras.txt")) as file:
            _, model, _, _, *numbers = file.read().split()
        self.assertEqual((model, list(map(float, numbers[4:]))), ("FULL_OPENCV", [*distortion, 0, 0, 0, 0]))
        with open(self.path("lens", "poses", "000000", "transforms.json")) as file:
            facts = json.load(file)
        self.assertEqual([facts[name] for name in ("camera_model", "k1", "k2", "p1", "p2")], ["OPENCV", *distortion])
        stokes, aolp = (load(self.path("lens", "frames", "000001", f"{name}.npy")) for name in ("stokes", "aolp"))
        numpy.testing.assert_array_equal(aolp, numpy.arctan2(stokes[..., 2], stokes[..., 1]) / 2)

    def test_fisheye(self):
        distortion = [0.05, -0.02, 0.003, -0.001]
        camera, columns, rows, points = self.through({"type": "fisheye", "distortion": distortion})
        r = numpy.hypot(points[:, 0], points[:, 1])
        angle = numpy.arctan2(r, points[:, 2])
        bent = angle * (1 + sum(k * angle ** (2 * i + 2) for i, k in enumerate(distortion)))
        self.assert_shown(camera, bent * points[:, 0] / r, bent * points[:, 1] / r, columns, rows)

    def test_two_cameras(self):
        camera = {**RECIPE["camera"], "baseline": 0.2}
        self.render(self.recipe(**{**RECIPE, "camera": camera}), "0:4", "rig")
        for left in (0, 2):
            poses = []
            for frame in (left, left + 1):
                with open(self.path("rig", "frames", f"{frame:06d}", "frame.json")) as file:
                    poses.append(json.load(file)["camera"])
            self.assertEqual([poses[0]["K"], poses[0]["R"]], [poses[1]["K"], poses[1]["R"]])
            # Points are further to the left in the picture of the right camera.
            numpy.testing.assert_allclose(numpy.subtract(poses[1]["t"], poses[0]["t"]), [-0.2, 0, 0], atol=1e-9)

    def test_normals_of_the_camera(self):
        for number in range(4):
            with open(self.path("out", "frames", f"{number:06d}", "frame.json")) as file:
                R = numpy.array(json.load(file)["camera"]["R"])
            world, camera = self.frame(number, "normals"), self.frame(number, "normals_camera")
            self.assertLess(abs(world @ R.T * [1, -1, -1] - camera).max(), 1e-5)
            # Surfaces that face the camera have a normal towards it.
            hit = self.frame(number, "ids") != 0xFFFFFFFF
            self.assertGreater((camera[hit][:, 2] > 0).mean(), 0.95)


if __name__ == "__main__":
    unittest.main()
