# SPDX-License-Identifier: MIT
"""Files of camera poses as others read them: nerfstudio's transforms.json, LLFF's poses_bounds.npy, COLMAP's text."""

import io
import json
import math

import numpy

_PICTURES = ("s0.png", "mosaic.png", "angle_0.png", "stokes.exr", "stokes.npy")


def files(kinds, frames):
    """Returns the bytes or text of each file, by its path below the scene's folder, for what frame.json says about frames."""
    made = {}
    if "transforms" in kinds:
        made["transforms.json"] = _transforms(frames)
    if "llff" in kinds:
        made["poses_bounds.npy"] = _llff(frames)
    if "colmap" in kinds:
        made |= {f"colmap/{name}": text for name, text in _colmap(frames).items()}
    return made


def _picture(facts):
    """Returns the file of a frame that other programs can show, else the first one, relative to frames/."""
    names = [name for name in _PICTURES if name in facts["files"]] or sorted(facts["files"]) or ["frame.json"]
    return f"{facts['frame']:06d}/{names[0]}"


def _to_world(facts):
    """Returns the camera's right, down and forward as columns (3 x 3), and its place."""
    R = numpy.array(facts["camera"]["R"])
    return R.T, -R.T @ numpy.array(facts["camera"]["t"])


def _transforms(frames):
    """nerfstudio's and instant-ngp's: camera to world with right, up and backward; intrinsics for each frame, whose first
    pixel has its middle at 0.5."""
    listed = []
    for facts in frames:
        axes, place = _to_world(facts)
        K, (width, height) = facts["camera"]["K"], facts["size"]
        matrix = numpy.eye(4)
        matrix[:3] = numpy.column_stack([axes * [1, -1, -1], place])
        listed.append({
            "file_path": f"../../frames/{_picture(facts)}", "transform_matrix": matrix.tolist(), "w": width, "h": height,
            "fl_x": K[0][0], "fl_y": K[1][1], "cx": K[0][2], "cy": K[1][2],
        })  # fmt: skip
    kind, numbers = _lens(frames[0])
    model = {"opencv": "OPENCV", "fisheye": "OPENCV_FISHEYE", "equirectangular": "EQUIRECTANGULAR"}[kind]
    names = ("k1", "k2", "k3", "k4") if kind == "fisheye" else ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")
    return json.dumps({"camera_model": model, **dict(zip(names, numbers)), "frames": listed}, indent=1) + "\n"


def _lens(facts):
    """Returns the lens's type and its distortion."""
    lens = facts["camera"].get("lens", {"type": "opencv", "distortion": [0, 0, 0, 0]})
    return lens["type"], lens.get("distortion", [0, 0, 0, 0])


def _llff(frames):
    """LLFF's: 17 numbers a frame, the 3 x 5 matrix of down, right, backward, place and (height, width, focal length), and
    the nearest and farthest depth. The principal point is the middle of the image."""
    rows = []
    for facts in frames:
        axes, place = _to_world(facts)
        width, height = facts["size"]
        columns = [axes[:, 1], axes[:, 0], -axes[:, 2], place, [height, width, facts["camera"]["K"][0][0]]]
        rows.append([*numpy.column_stack(columns).ravel(), facts["camera"]["near"], facts["camera"]["far"]])
    data = io.BytesIO()
    numpy.lib.format.write_array(data, numpy.array(rows, float), (1, 0), allow_pickle=False)
    return data.getvalue()


def _quaternion(R):
    """Returns w, x, y, z of a rotation, w not negative: from its largest component, which no cancellation spoils."""
    d = [R[0][0], R[1][1], R[2][2]]
    squares = [1 + sum(d), 1 + d[0] - d[1] - d[2], 1 - d[0] + d[1] - d[2], 1 - d[0] - d[1] + d[2]]
    most = squares.index(max(squares))
    a, b, c = R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]
    p, q, r = R[0][1] + R[1][0], R[0][2] + R[2][0], R[1][2] + R[2][1]
    row = [[squares[0], a, b, c], [a, squares[1], p, q], [b, p, squares[2], r], [c, q, r, squares[3]]][most]
    length = math.copysign(math.sqrt(sum(x * x for x in row)), row[0])
    return [x / length for x in row]


def _colmap(frames):
    """COLMAP's text: a camera for each set of intrinsics, and no points."""
    cameras, images = {}, []
    for facts in frames:
        K, (width, height) = facts["camera"]["K"], facts["size"]
        intrinsics = f"{width} {height} {K[0][0]!r} {K[1][1]!r} {K[0][2]!r} {K[1][2]!r}"
        if "lens" in facts["camera"]:
            kind, numbers = _lens(facts)
            numbers = numbers + [0] * (4 if len(numbers) == 4 else 8 - len(numbers))
            model = "OPENCV_FISHEYE" if kind == "fisheye" else "FULL_OPENCV"
            intrinsics = " ".join([model, intrinsics, *map(repr, numbers[:4] if kind == "fisheye" else numbers)])
        else:
            intrinsics = f"PINHOLE {intrinsics}"
        camera = cameras.setdefault(intrinsics, len(cameras) + 1)
        numbers = [*_quaternion(facts["camera"]["R"]), *facts["camera"]["t"]]
        place = " ".join(map(repr, numbers))
        # A line of 2D points follows each image; it is empty.
        images.append(f"{facts['frame'] + 1} {place} {camera} {_picture(facts)}\n\n")
    return {
        "cameras.txt": "".join(f"{number} {intrinsics}\n" for intrinsics, number in cameras.items()),
        "images.txt": "".join(images),
        "points3D.txt": "",
    }
