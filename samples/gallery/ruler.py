# SPDX-License-Identifier: MIT
"""A stressed plastic ruler before a polarized panel. Stress makes plastic birefringent, which only a second polarizer shows.

The ruler lies on two supports at its ends, and is pressed from above in its middle: stress is proportional to the bending
moment and to the height above the middle line, and superposed by the shear that carries the load. The ruler is a retarder
with textures of its axis and of its retardance, which is a length, so that each colour has an angle of its own.
"""

import nicol
import numpy as np
import shapes

LENGTH, HEIGHT = 7.6, 1.15
TEXELS = 2280, 360
DISTANCE, CENTRE = 14, 0.1  # of the camera, and the height that it looks at
WAVELENGTHS = 611, 549, 464  # nm, of red, green and blue


def stress(x, y):
    """Returns sigma_xx, sigma_yy and sigma_xy of the bent ruler, in orders of interference at 549 nm."""
    half, deep = LENGTH / 2, HEIGHT / 2
    moment = np.logaddexp(0, 14 * (1 - np.hypot(x, 0.15) / (0.92 * half))) / 14
    bending = -4.2 * moment * y / deep
    between = np.tanh((0.92 * half - np.abs(x)) / 0.15) / 2 + 0.5
    shear = 0.75 * np.tanh(x / 0.35) * between * (1 - (y / deep) ** 2)
    # The load in the middle and the supports press on small places (Flamant): -P cos(angle) / distance, along the distance.
    total = np.array([bending, 0 * x, shear])
    for at, edge, load in ((0.0, deep, 0.62), (-0.92 * half, -deep, 0.36), (0.92 * half, -deep, 0.36)):
        dx, dy = x - at, edge - y
        distance = np.hypot(dx, dy) + 0.11
        radial = -load * np.abs(dy) / distance**2
        total += radial * np.array([(dx / distance) ** 2, (dy / distance) ** 2, -dx * dy / distance**2])
    # The mould left some stress along the edges.
    total[0] += 0.55 * ((y / deep) ** 4 - 0.2)
    return total


def ruler(context):
    """Returns the ruler as a retarder."""
    columns, rows = TEXELS
    x, y = np.meshgrid((np.arange(columns) + 0.5) / columns - 0.5, (np.arange(rows) + 0.5) / rows - 0.5)
    xx, yy, xy = stress(LENGTH * x, HEIGHT * y)
    degrees = np.degrees(np.arctan2(2 * xy, xx - yy) / 2)
    order = np.hypot(xx - yy, 2 * xy)[..., None] * WAVELENGTHS[1] / np.array(WAVELENGTHS)
    # Angles of 90 and -90 degrees are neighbours, so that none is interpolated.
    options = nicol.TextureOptions(filter=nicol.TEXTURE_FILTER_NEAREST)
    texture = lambda numbers: nicol.Texture.create_image(context, nicol.texture_image(numbers.astype("f4")), options)  # noqa: E731
    return nicol.PolarizationElement(
        kind=nicol.POLARIZATION_ELEMENT_RETARDER, angle=1, retardance=360, transmittance=0.86,
        angle_texture=texture(degrees), retardance_texture=texture(order),
        to_world=list(shapes.placed(scale=(LENGTH / 2, HEIGHT / 2, 1)).ravel()),
    )  # fmt: skip


def make_scene(context):
    scene = nicol.Scene.create(context)
    black = nicol.Material.create_diffuse(context, 0.0)
    square, cube, ball = nicol.Mesh.create_rectangle(context), nicol.Mesh.create_cube(context), nicol.Mesh.create_divided_sphere(context, 8)
    panel = nicol.Emission(radiance=[0.98, 0.95, 0.86], polarization=nicol.Polarization(dolp=1, axis=[1, 1, 0]))
    shapes.add(scene, square, black, shapes.placed((0, 0, -1.5), (6, 6, 1)), panel)
    # Marks every tenth of a unit, the load and the supports.
    for i, x in enumerate(np.arange(-3.6, 3.61, 0.1)):
        long = 0.3 if i % 10 == 0 else 0.22 if i % 5 == 0 else 0.14
        shapes.add(scene, square, black, shapes.placed((x, HEIGHT / 2 - long / 2, 0.02), (0.011, long / 2, 1)))
    for x, side in ((0, 1), (-0.46 * LENGTH, -1), (0.46 * LENGTH, -1)):
        shapes.add(scene, ball, black, shapes.placed((x, side * (HEIGHT / 2 + 0.16), 0), 0.16))
        shapes.add(scene, cube, black, shapes.placed((x, side * (HEIGHT / 2 + 1.36), 0), (0.07, 1.1, 0.07)))
    scene.add_polarization_element(ruler(context))
    return scene


def make_view(context):
    camera = nicol.Camera(fov=32.5).look_at((0, CENTRE, DISTANCE), (0, CENTRE, 0), (0, 1, 0))
    return shapes.View(make_scene(context), camera, polarizer=-45, shadows=0)
