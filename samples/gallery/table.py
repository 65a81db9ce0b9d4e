# SPDX-License-Identifier: MIT
"""A table with a glass, a bottle, a window pane and a metal tray, made with the Python package."""

import nicol
import numpy as np
from shapes import lathe, rounded

# Profiles as (radius, height), from the middle of the bottom outwards, up and back inside.
TUMBLER = [(0, 0), (0.32, 0), (0.34, 0.03), (0.4, 0.95), (0.385, 0.97), (0.37, 0.95), (0.31, 0.12), (0.28, 0.09), (0, 0.08)]
BOTTLE = [(0, 0), (0.36, 0), (0.4, 0.05), (0.4, 1.1), (0.32, 1.3), (0.15, 1.5), (0.13, 1.9), (0.16, 1.93), (0.16, 2), (0, 2)]
TRAY = [(0, 0), (1.15, 0), (1.25, 0.1), (1.22, 0.1), (1.13, 0.03), (0, 0.03)]


def make_scene(context, environment):
    """Returns the scene and its camera."""
    glass = nicol.Material.create_dielectric(context, nicol.Dielectric(int_ior=1.5, ext_ior=1))
    green = nicol.Material.create_dielectric(context, nicol.Dielectric(int_ior=1.5, ext_ior=1, absorption=[3, 0.4, 2]))
    pane = nicol.Material.create_dielectric(context, nicol.Dielectric(thin=1, int_ior=1.5, ext_ior=1))
    steel = nicol.Material.create_conductor(context, nicol.Conductor(metal=b"Al", alpha=0.08))
    wood = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.35, 0.2, 0.1], alpha=0.2))
    scene = nicol.Scene.create(context)
    scene.set_environment(environment, None, 0.6)

    def add(mesh, material, x, y, z, to_axes=np.eye(3)):
        to_world = np.eye(4)
        to_world[:3, :3] = to_axes
        to_world[:3, 3] = x, y, z
        scene.add_instance(nicol.Instance(mesh=mesh, material=material, to_world=list(to_world.ravel())))

    square = nicol.Mesh.create_rectangle(context)
    flat = np.array([[4, 0, 0], [0, 0, 4], [0, -4, 0]])
    # Leans back, so that it mirrors the sky near Brewster's angle.
    leaning = np.array([[0.9, 0, 0], [0, 0.5, 0.87], [0, -0.87, 0.5]])
    add(square, wood, 0, 0, 0, flat)
    add(lathe(context, rounded(TRAY)), steel, 0.1, 0.01, 0.2)
    add(lathe(context, rounded(TUMBLER)), glass, 0.45, 0.05, 0.6)
    add(lathe(context, rounded(BOTTLE)), green, -0.35, 0.05, 0)
    add(square, pane, 1.2, 1.0, -0.4, leaning)
    return scene, nicol.Camera(fov=36).look_at((-0.6, 1.9, 5), (0.25, 0.85, 0), (0, 1, 0))
