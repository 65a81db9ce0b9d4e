# SPDX-License-Identifier: MIT
"""A still life of glass: a wine glass, a decanter, a ball and a lemon on a wooden table, before a window."""

import nicol
import numpy as np
import shapes

# Profiles as (radius, height), from the middle of the bottom outwards, up and back inside.
WINE_GLASS = [
    (0, 0), (0.5, 0), (0.52, 0.02), (0.3, 0.07), (0.06, 0.14), (0.045, 0.5), (0.05, 0.85), (0.16, 0.98), (0.45, 1.25), (0.53, 1.6),
    (0.46, 2.05), (0.445, 2.07), (0.43, 2.05), (0.5, 1.6), (0.42, 1.27), (0.15, 1.04), (0, 1.0),
]  # fmt: skip
DECANTER = [
    (0, 0), (0.6, 0), (0.66, 0.05), (0.68, 0.3), (0.6, 0.75), (0.3, 1.1), (0.17, 1.35), (0.16, 1.85), (0.27, 2.1), (0.26, 2.12),
    (0.24, 2.1), (0.12, 1.85), (0.13, 1.35), (0.26, 1.08), (0.55, 0.72), (0.62, 0.3), (0.58, 0.1), (0, 0.08),
]  # fmt: skip


def wood(size=512):
    """Returns the colours of boards."""
    random = np.random.default_rng(5)
    v, u = np.mgrid[0:size, 0:size] / size
    board = np.floor(6 * v)
    shift = random.uniform(0, 9, 6)[board.astype(int)]
    rings = sum(np.sin(2 * np.pi * (f * (6 * v % 1) + a * np.sin(2 * np.pi * (u + shift)) + shift)) / f for f, a in ((2, 0.3), (5, 0.5), (11, 0.7)))
    fibre = random.normal(0, 1, (size, size)) @ np.eye(size)
    for _ in range(24):
        fibre = (fibre + np.roll(fibre, 1, 1)) / 2
    joint = np.clip(np.minimum(6 * v % 1, 1 - 6 * v % 1) / 0.02, 0, 1)
    tone = (0.62 + 0.1 * rings + 0.5 * fibre) * (0.85 + 0.3 * random.random(6)[board.astype(int)]) * (0.35 + 0.65 * joint)
    return (np.clip(tone, 0.05, 1)[..., None] * [0.3, 0.155, 0.07]).astype(np.float32)


def lemon(context):
    t = np.linspace(0, np.pi, 60)
    radius = 0.34 * np.sin(t) ** 0.9
    height = 0.44 * -np.cos(t) - 0.06 * np.sign(np.cos(t)) * np.abs(np.cos(t)) ** 14
    return shapes.lathe(context, np.stack([radius, height], -1))


def filling(profile, level):
    """Returns the profile of a liquid inside a vessel, which fills it up to a height. It leaves a gap to the vessel, because
    bodies of glass must not overlap."""
    inside = profile[np.argmax(profile[:, 1]) :]
    inside = inside[inside[:, 1] < level][::-1]
    return np.concatenate([inside * [0.985, 1] + [0, 0.006], [[0.985 * inside[-1, 0], level], [0, level]]])


def make_view(context):
    scene = nicol.Scene.create(context)
    window = [
        ((-1.0, 0.55, 0.25), 34, 44, (9, 9.5, 10.5)), ((-1.0, 0.55, -0.75), 30, 44, (9, 9.5, 10.5)),
        ((1.0, 0.5, 0.4), 50, 60, (0.5, 0.42, 0.35)), ((0.3, 0.25, -1.0), 90, 30, (0.12, 0.1, 0.09)),
    ]  # fmt: skip
    scene.set_environment(shapes.studio(context, window, ambient=0.035), None, 1)
    glass = nicol.Material.create_dielectric(context, nicol.Dielectric(int_ior=1.5, ext_ior=1))
    green = nicol.Material.create_dielectric(context, nicol.Dielectric(int_ior=1.52, ext_ior=1, absorption=[1.6, 0.35, 1.1]))
    wine = nicol.Material.create_dielectric(context, nicol.Dielectric(int_ior=1.34, ext_ior=1, absorption=[0.35, 4, 3.6]))
    boards = nicol.Texture.create_image(context, nicol.texture_image(wood()))
    table = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance_texture=boards, alpha=0.12))
    peel = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.75, 0.5, 0.03], alpha=0.22))
    vessel = shapes.rounded(WINE_GLASS)
    shapes.add(scene, nicol.Mesh.create_rectangle(context), table, shapes.placed(scale=5, axes=shapes.FLOOR @ shapes.rotated(2, 8)))
    shapes.add(scene, shapes.lathe(context, vessel), glass, shapes.placed((0.75, 0.001, 0.55)))
    shapes.add(scene, shapes.lathe(context, filling(vessel, 1.5)), wine, shapes.placed((0.75, 0.001, 0.55)))
    shapes.add(scene, shapes.lathe(context, shapes.rounded(DECANTER)), green, shapes.placed((-0.75, 0.001, -0.1)))
    shapes.add(scene, nicol.Mesh.create_sphere(context), glass, shapes.placed((-0.2, 0.302, 1.25), 0.3))
    shapes.add(scene, lemon(context), peel, shapes.placed((1.75, 0.335, 1.0), axes=shapes.rotated(1, 35) @ shapes.rotated(2, 90)))
    camera = nicol.Camera(fov=42).look_at((0.6, 2.0, 6.9), (0.4, 0.95, 0), (0, 1, 0))
    return shapes.View(scene, camera, polarizer=90, exposure=0.6, max_depth=12)
