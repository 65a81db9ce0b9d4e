# SPDX-License-Identifier: MIT
"""A wet street at night. The lamps on the left are polarized across the road's plane, those on the right along it: a polarizer
puts out one row and its reflections, or the other."""

import nicol
import numpy as np
import shapes


def noise(size, cells, random):
    """Returns smooth noise of 0 to 1 that repeats."""
    out, weight = np.zeros((size, size)), 0.0
    for octave in range(5):
        n = cells * 2**octave
        grid = random.random((n, n))
        at = np.arange(size) * n / size
        i, f = at.astype(int), at % 1
        f = f * f * (3 - 2 * f)
        rows = grid[i] * (1 - f)[:, None] + grid[(i + 1) % n] * f[:, None]
        out += (rows[:, i] * (1 - f) + rows[:, (i + 1) % n] * f) / 2**octave
        weight += 1 / 2**octave
    return out / weight


def asphalt(context, size=1024):
    """Returns wet asphalt: rough where it is damp, a mirror of water where puddles stand."""
    random = np.random.default_rng(11)
    puddle = np.clip((noise(size, 4, random) - 0.52) / 0.05, 0, 1)
    grain = noise(size, 64, random)
    tone = ((0.018 + 0.03 * grain) * (1 - 0.6 * puddle))[..., None] * [1.0, 1.0, 1.08]
    image = lambda values: nicol.Texture.create_image(context, nicol.texture_image(np.ascontiguousarray(values, np.float32)))  # noqa: E731
    damp = nicol.Pplastic(diffuse_reflectance_texture=image(tone), alpha=0.24, int_ior=1.4)
    water = nicol.Pplastic(diffuse_reflectance=[0.006, 0.006, 0.008], alpha=0.015, int_ior=1.33)
    materials = [nicol.Material.create_pplastic(context, given) for given in (damp, water)]
    return nicol.Material.create_blend(context, *materials, image(puddle))


def windows(lit, random, rows, columns, size=24):
    """Returns the radiance of a front with windows, some of which are lit."""
    out = np.zeros((rows * size, columns * size, 3), np.float32)
    for r in range(rows):
        for c in range(columns):
            if random.random() < lit:
                warm = random.uniform(0.6, 1.4) * np.array([1.0, 0.62, 0.26]) if random.random() < 0.8 else np.array([0.5, 0.65, 0.9])
                out[r * size + 5 : r * size + 20, c * size + 6 : c * size + 18] = warm
                out[r * size + 12, c * size + 6 : c * size + 18] *= 0.2
    return out


def make_view(context):
    random = np.random.default_rng(2)
    scene = nicol.Scene.create(context)
    scene.set_environment(nicol.Environment.create_constant(context, [0.006, 0.008, 0.014]), None, 1)
    square, cube, ball = nicol.Mesh.create_rectangle(context), nicol.Mesh.create_cube(context), nicol.Mesh.create_divided_sphere(context, 8)
    black = nicol.Material.create_diffuse(context, 0.02)
    stone = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.1, 0.085, 0.075], alpha=0.4))
    x, z = np.meshgrid(np.linspace(4.6, -4.6, 24), np.linspace(9, -46, 120))
    road = shapes.sheet(context, np.stack([x, 0 * x, z], -1), repeats=(5, 1))
    shapes.add(scene, road, asphalt(context))
    for side in (-1, 1):
        shapes.add(scene, cube, stone, shapes.placed((side * 5.6, 0.0, -18), (1.0, 0.16, 30)))
        for k in range(7):
            wide, tall = 3.3, random.uniform(4.2, 7.5)
            place = side * 6.8, tall, 2 - 7.0 * k
            shapes.add(scene, cube, stone, shapes.placed((side * 8.8, tall, place[2]), (2.2, tall, wide)))
            rows = int(tall)
            image = nicol.Texture.create_image(context, nicol.texture_image(windows(0.33, random, rows, 5)), nicol.TextureOptions(raw=1))
            axes = np.stack([[0, 0, side], [0, 1, 0], [-side, 0, 0]], 1).astype(float)
            front = nicol.Emission(radiance=[0.55], texture=image)
            shapes.add(scene, square, black, shapes.placed((side * 6.58, tall, place[2]), (wide, tall, 1), axes), front)
        for k in range(5):
            at = np.array([side * 4.3, 3.6, -1.0 - 8 * k])
            shapes.add(scene, cube, black, shapes.placed(at - [0, 1.8, 0], (0.05, 1.8, 0.05)))
            axis = [1, 0, 0] if side > 0 else [0, 1, 0]
            colour = [95, 60, 26] if side > 0 else [48, 66, 100]
            lamp = nicol.Emission(radiance=colour, polarization=nicol.Polarization(dolp=1, axis=axis))
            shapes.add(scene, ball, black, shapes.placed(at, 0.17), lamp)
    camera = nicol.Camera(fov=58).look_at((0.5, 1.7, 8.5), (0, 1.35, -8), (0, 1, 0))
    return shapes.View(scene, camera, polarizer=90, exposure=1.0, max_depth=3)
