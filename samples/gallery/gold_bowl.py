# SPDX-License-Identifier: MIT
"""A hammered bowl of gold, by the refractive index that was measured of gold, on dark lacquer in a forest."""

import os

import nicol
import numpy as np
import shapes

# Profile of the bowl as (radius, height): foot, outside, rim, inside.
PROFILE = [
    (0, 0), (0.5, 0), (0.56, 0.02), (0.5, 0.1), (0.62, 0.17), (1.05, 0.42), (1.4, 0.85), (1.55, 1.25), (1.585, 1.3),
    (1.53, 1.31), (1.47, 1.24), (1.3, 0.88), (0.96, 0.5), (0.55, 0.27), (0, 0.2),
]  # fmt: skip


def hammered(context, rows=150, columns=260):
    """Returns the bowl with dents of a hammer."""
    points = np.array(PROFILE, float)
    along = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    t = np.linspace(0, along[-1], rows)
    radius, height = (np.interp(t, along, points[:, i]) for i in (0, 1))
    smooth = np.array([0.25, 0.5, 0.25])
    for _ in range(6):  # rounds the corners, but not the ends
        radius[1:-1], height[1:-1] = np.convolve(radius, smooth, "valid"), np.convolve(height, smooth, "valid")
    radius = np.maximum(radius, 1e-4)
    angle = 2 * np.pi * np.arange(columns) / columns
    places = np.stack([np.outer(radius, np.cos(angle)), np.outer(height, np.ones(columns)), np.outer(radius, np.sin(angle))], -1)
    outward = np.cross(np.gradient(places, axis=1), np.gradient(places, axis=0))
    outward /= np.maximum(np.linalg.norm(outward, axis=-1, keepdims=True), 1e-12)
    random = np.random.default_rng(3)
    depth = np.zeros((rows, columns))
    for _ in range(900):
        place = places[random.integers(12, rows - 12), random.integers(columns)]
        size = random.uniform(0.1, 0.16)
        depth = np.maximum(depth, random.uniform(0.5, 1) * np.clip(1 - ((places - place) ** 2).sum(-1) / size**2, 0, 1) ** 2)
    calm = np.clip(np.minimum(np.arange(rows), np.arange(rows)[::-1]) / 14, 0, 1)[:, None]
    return shapes.sheet(context, places - 0.013 * (depth * calm)[..., None] * outward, wraps=True)


def floor(context, size=9, count=121):
    """Returns a square whose grid is denser near the bowl, because light from other surfaces is kept at vertices."""
    along = np.linspace(-1, 1, count)
    along = size * (0.3 * along + 0.7 * along**3)
    x, z = np.meshgrid(along, along)
    return shapes.sheet(context, np.stack([x, 0 * x, z], -1))


def make_view(context):
    scene = nicol.Scene.create(context)
    forest = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "assets", "forest_blurred.exr")
    light = nicol.Environment.load(context, forest)
    scene.set_environment(light, list(shapes.placed(axes=shapes.rotated(1, 200)).ravel()), 1.2)
    gold = nicol.Material.create_conductor(context, nicol.Conductor(metal=b"Au"))
    lacquer = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.05, 0.007, 0.006], alpha=0.3))
    shapes.add(scene, floor(context), lacquer)
    shapes.add(scene, hammered(context), gold)
    for place, size in (((2.3, 0.42, 0.55), 0.42), ((1.55, 0.24, 1.55), 0.24), ((-2.0, 0.3, 0.75), 0.3)):
        shapes.add(scene, nicol.Mesh.create_sphere(context), gold, shapes.placed(place, size))
    camera = nicol.Camera(fov=42).look_at((0.7, 3.3, 7.2), (0.15, 0.4, 0.1), (0, 1, 0))
    return shapes.View(scene, camera, polarizer=90, exposure=0.5, max_depth=5)
