# SPDX-License-Identifier: MIT
"""Cameras of a recipe's frames, and their poses in the conventions of others."""

import math

import nicol
import numpy

from ..lens import Lens
from .scenes import direction


def camera(recipe, stage, frame):
    """Returns the camera of a frame. Without a position it is at an azimuth and elevation around its target, at `distance`
    times the distance from which the sphere around the objects fills the image. With a baseline, even frames are those of the
    left camera of a rig, and odd ones those of the right camera, which is that far from it."""
    if "camera" not in recipe.parts and "scene" in recipe.parts:
        return stage.scene.get_camera()
    drawn = recipe.parts["camera"].at(recipe.camera_draw(frame)) if "camera" in recipe.parts else {}
    fov = drawn.get("fov", 40)
    target = numpy.array(drawn.get("target", (stage.lower + stage.upper) / 2), float)
    radius = max(numpy.linalg.norm(stage.upper - stage.lower) / 2, 1e-9)
    if "position" in drawn:
        place = numpy.array(drawn["position"], float)
    else:
        narrow = math.atan(math.tan(math.radians(fov) / 2) * min(1, recipe.height / recipe.width))
        away = drawn.get("distance", 1.1) * radius / math.sin(narrow)
        place = target + away * numpy.array(direction(drawn.get("azimuth", 0), drawn.get("elevation", 20)))
    view = target - place
    length = numpy.linalg.norm(view)
    if length < 1e-9 * radius:
        recipe.source.fail("camera", "position and target are the same point")
    up = numpy.array([0, 0, 1] if abs(view[1]) > 0.9999 * length else [0, 1, 0], float)
    if "roll" in drawn:
        up = _rolled(view / length, up, math.radians(drawn["roll"]))
    made = nicol.Camera(fov=fov, near_clip=max(1e-3 * radius, 1e-6), far_clip=math.inf)
    made.look_at(list(place), list(target), list(up))
    half = drawn.get("baseline", 0) / 2 * (-1 if frame % 2 else 1)
    for row in range(3):
        made.to_world[4 * row + 3] += half * made.to_world[4 * row]  # x points to the image's left
    return made


def _rolled(view, up, angle):
    """Returns the up direction of a camera that is turned clockwise about its view, so that its image turns the other way."""
    right = numpy.cross(view, up)
    right /= numpy.linalg.norm(right)
    return math.cos(angle) * numpy.cross(right, view) + math.sin(angle) * right


def lens(recipe, fov):
    """Returns the recipe's lens for a camera of this field of view: K of OpenCV and a Lens. A fisheye has the field of view at
    the left and right border before its distortion, as others have it."""
    size, given = (recipe.width, recipe.height), recipe.lens
    if given["type"] == "equirectangular":
        return nicol.Camera(fov=fov).to_opencv(size)[0], Lens.equirectangular(size)
    distortion = given.get("distortion", [0, 0, 0, 0])
    if given["type"] == "fisheye":
        focal = recipe.width / math.radians(fov)
        K = numpy.array([[focal, 0, (recipe.width - 1) / 2], [0, focal, (recipe.height - 1) / 2], [0, 0, 1]])
        return K, Lens.fisheye(K, size, distortion)
    K = nicol.Camera(fov=fov).to_opencv(size)[0]
    return K, Lens.opencv(K, size, distortion)


def pose(recipe, stage, made):
    """Returns what frame.json says about a camera: COLMAP's K, R and t, the lens if there is one, and the depths between which
    the objects' box lies."""
    K, R, t = made.to_colmap((recipe.width, recipe.height))
    corners = numpy.array([[(stage.lower, stage.upper)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)])
    depths = corners @ R[2] + t[2]
    near = max(float(depths.min()), 1e-3 * float(depths.max()))
    lens = {"lens": recipe.lens} if recipe.lens else {}
    return {"K": K.tolist(), "R": R.tolist(), "t": t.tolist(), "near": near, "far": float(depths.max()), **lens}
