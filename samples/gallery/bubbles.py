# SPDX-License-Identifier: MIT
"""Soap bubbles in a forest above bowls of anodised metal: thin films, whose colours follow their thickness and the angle."""

import os

import nicol
import numpy as np
import shapes

HERE = os.path.dirname(os.path.abspath(__file__))
FOREST = os.path.join(os.path.dirname(HERE), "assets", "forest.exr")
CUP = [(0, 0), (0.3, 0), (0.36, 0.02), (0.62, 0.3), (0.72, 0.62), (0.7, 0.64), (0.68, 0.62), (0.57, 0.3), (0.3, 0.07), (0, 0.06)]


def soap(context, thickness):
    """Returns a skin of water with air on both sides; thickness in nm."""
    film = nicol.Film(thickness=thickness, eta=1.33)
    return nicol.Material.create_dielectric(context, nicol.Dielectric(int_ior=1, ext_ior=1, film=film))


def anodised(context, thickness):
    """Returns titanium below an oxide; thickness in nm."""
    metal = nicol.Conductor(eta=[2.74, 2.54, 2.2], k=[3.81, 3.43, 3.0], alpha=0.12, film=nicol.Film(thickness=thickness, eta=2.3))
    return nicol.Material.create_conductor(context, metal)


def make_view(context):
    scene = nicol.Scene.create(context)
    scene.set_environment(nicol.Environment.load(context, FOREST), None, 1)
    slate = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.035, 0.04, 0.045], alpha=0.15))
    shapes.add(scene, nicol.Mesh.create_rectangle(context), slate, shapes.placed(scale=9, axes=shapes.FLOOR))
    ball = nicol.Mesh.create_divided_sphere(context, 64)
    for x, y, z, radius, thickness in (
        (-1.1, 1.75, -0.3, 0.78, 420), (0.75, 2.0, -0.8, 0.6, 310), (1.95, 1.45, 0.2, 0.44, 560), (0.1, 1.2, 0.7, 0.3, 240),
        (-2.3, 1.35, 0.3, 0.34, 640),
    ):  # fmt: skip
        shapes.add(scene, ball, soap(context, thickness), shapes.placed((x, y, z), radius))
    cup = shapes.lathe(context, shapes.rounded(CUP))
    for i, thickness in enumerate((38, 55, 85, 120)):
        shapes.add(scene, cup, anodised(context, thickness), shapes.placed((1.55 * (i - 1.5), 0.001, 0.5 - 0.35 * (i % 2))))
    camera = nicol.Camera(fov=42).look_at((0, 1.5, 6.9), (0, 1.15, 0), (0, 1, 0))
    return shapes.View(scene, camera, polarizer=0, max_depth=8)
