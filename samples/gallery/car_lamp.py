# SPDX-License-Identifier: MIT
"""A car's lamp behind its clear cover, in red paint. The cover's reflections hide what is inside; a polarizer removes them."""

import nicol
import numpy as np
import shapes

# Profiles as (radius, depth) of the reflector, the ring around it, the lens, and the cover.
REFLECTOR = [(r, 0.62 * r**2 - 0.5) for r in np.linspace(0.08, 0.92, 24)]
RING = [(0.9, 0.0), (0.92, 0.1), (1.0, 0.14), (1.08, 0.1), (1.1, -0.05), (1.06, -0.3)]
PROJECTOR = [(0, 0.22), (0.2, 0.2), (0.34, 0.1), (0.42, -0.04), (0.42, -0.12), (0, -0.12)]


def turned(context, profile, columns=96, rounds=1):
    return shapes.lathe(context, shapes.rounded(profile, rounds), columns)


def body(context, holes, rows=100, columns=160):
    """Returns a curved panel of the car with round holes, whose rims are drawn in."""
    x, y = np.meshgrid(np.linspace(-4.2, 4.2, columns), np.linspace(-2.6, 2.6, rows))
    z = -0.045 * (x - 0.4) ** 2 - 0.06 * (y + 0.2) ** 2
    z += 0.13 / (1 + np.exp(-9 * (y - 1.55))) - 0.2 / (1 + np.exp(8 * (y + 1.5)))
    for cx, cy, radius in holes:
        distance = np.hypot(x - cx, y - cy)
        z -= 0.9 / (1 + np.exp((distance - radius * 0.97) / 0.035))
        z += 0.1 * np.exp(-(((distance - radius * 1.12) / 0.1) ** 2))
    return shapes.sheet(context, np.stack([x, y, z], -1))


def make_view(context):
    scene = nicol.Scene.create(context)
    sky = [
        ((0.1, 1.0, 0.55), 95, 40, (4.2, 4.4, 4.8)), ((-1.0, 0.35, 0.7), 26, 70, (6, 6, 6.2)),
        ((1.0, 0.12, 0.5), 60, 12, (2.4, 2.1, 1.7)), ((0, -1, 0.3), 140, 120, (0.09, 0.085, 0.08)),
    ]  # fmt: skip
    scene.set_environment(shapes.studio(context, sky, ambient=0.16), None, 1)
    chrome = nicol.Material.create_twosided(context, nicol.Material.create_conductor(context, nicol.Conductor(metal=b"Al")))
    steel = nicol.Material.create_twosided(context, nicol.Material.create_conductor(context, nicol.Conductor(metal=b"Al", alpha=0.1)))
    dark = nicol.Material.create_twosided(context, nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=0.012, alpha=0.2)))
    paint = nicol.Material.create_twosided(
        context, nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.42, 0.012, 0.012], alpha=0.1))
    )
    lens = nicol.Material.create_dielectric(context, nicol.Dielectric(int_ior=1.5, ext_ior=1))
    cover = nicol.Material.create_dielectric(context, nicol.Dielectric(thin=1, int_ior=1.59, ext_ior=1))
    amber = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.6, 0.2, 0.01], alpha=0.1))
    black = nicol.Material.create_diffuse(context, 0.0)
    ball, cube = nicol.Mesh.create_divided_sphere(context, 8), nicol.Mesh.create_cube(context)
    facing = np.stack([[1, 0, 0], [0, 0, 1], [0, -1, 0]], 1) @ np.diag([1, 1, 1.0])  # the lathe's axis towards +z
    lamps = ((-1.05, 0.1, 1.1), (1.35, 0.02, 0.9))
    shapes.add(scene, body(context, lamps), paint)
    for x, y, size in lamps:
        at = lambda z: (x, y, z - 0.12)  # noqa: E731
        place = lambda z=0.0, s=size: shapes.placed(at(z), s, facing)  # noqa: E731
        shapes.add(scene, turned(context, RING), chrome, place())
        shapes.add(scene, turned(context, REFLECTOR), steel, place())
        shapes.add(scene, turned(context, PROJECTOR), lens, place(0.0, 0.85 * size))
        shapes.add(scene, turned(context, [(0.44, 0.02), (0.5, 0.04), (0.5, -0.3)]), steel, place(0.0, 0.9 * size))
        glow = nicol.Emission(radiance=[26, 25, 22])
        shapes.add(scene, ball, black, shapes.placed(at(-0.34 * size), 0.07 * size), glow)
        clear = [(r, 0.2 - 0.13 * r**2) for r in np.linspace(0, 1.02, 20)]
        shapes.add(scene, turned(context, clear), cover, place())
    shapes.add(scene, cube, amber, shapes.placed((2.75, 0.0, -0.22), (0.3, 0.34, 0.1), shapes.rotated(1, 18)))
    for y in (-1.55, -1.85, -2.15):
        shapes.add(scene, cube, dark, shapes.placed((0, y, 0.02), (3.4, 0.07, 0.1)))
    camera = nicol.Camera(fov=34).look_at((6.4, 1.7, 6.0), (0.2, -0.1, 0), (0, 1, 0))
    return shapes.View(scene, camera, polarizer=0, exposure=0.1, max_depth=3, bake_directions=512, refine_tolerance=0)
