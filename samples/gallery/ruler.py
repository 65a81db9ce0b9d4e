# SPDX-License-Identifier: MIT
"""A stressed plastic ruler before a polarized panel. Stress makes plastic birefringent, which only a second polarizer shows.

The ruler lies on two supports at its ends, and is pressed from above in its middle: stress is proportional to the bending
moment and to the height above the middle line, and superposed by the shear that carries the load. Cells of the ruler are
retarders. Their retardance is one of lengths, so that each colour has an angle of its own, and is rendered by itself.
"""

import nicol
import numpy as np
import shapes

LENGTH, HEIGHT = 7.6, 1.15
CELLS = 570, 90
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


def retarders(channel):
    """Returns the ruler's cells as elements for one colour channel."""
    columns, rows = CELLS
    x, y = np.meshgrid((np.arange(columns) + 0.5) / columns - 0.5, (np.arange(rows) + 0.5) / rows - 0.5)
    x, y = (LENGTH * x).ravel(), (HEIGHT * y).ravel()
    xx, yy, xy = stress(x, y)
    angle = np.degrees(np.arctan2(2 * xy, xx - yy) / 2)
    order = np.hypot(xx - yy, 2 * xy)
    size = 0.5 * LENGTH / columns, 0.5 * HEIGHT / rows, 1
    for place, axis, retardance in zip(zip(x, y), angle, 360 * order * WAVELENGTHS[1] / WAVELENGTHS[channel]):
        yield nicol.PolarizationElement(
            kind=nicol.POLARIZATION_ELEMENT_RETARDER, angle=axis, retardance=retardance, transmittance=0.86,
            to_world=list(shapes.placed((*place, 0), size).ravel()),
        )  # fmt: skip


def make_scene(context, channel):
    """Returns the scene of one colour, without the ruler's cells."""
    scene = nicol.Scene.create(context)
    black = nicol.Material.create_diffuse(context, 0.0)
    square, cube, ball = nicol.Mesh.create_rectangle(context), nicol.Mesh.create_cube(context), nicol.Mesh.create_divided_sphere(context, 8)
    glow = (0.98, 0.95, 0.86)[channel]
    panel = nicol.Emission(radiance=[glow], polarization=nicol.Polarization(dolp=1, axis=[1, 1, 0]))
    shapes.add(scene, square, black, shapes.placed((0, 0, -1.5), (6, 6, 1)), panel)
    # Marks every tenth of a unit, the load and the supports.
    for i, x in enumerate(np.arange(-3.6, 3.61, 0.1)):
        long = 0.3 if i % 10 == 0 else 0.22 if i % 5 == 0 else 0.14
        shapes.add(scene, square, black, shapes.placed((x, HEIGHT / 2 - long / 2, 0.02), (0.011, long / 2, 1)))
    for x, side in ((0, 1), (-0.46 * LENGTH, -1), (0.46 * LENGTH, -1)):
        shapes.add(scene, ball, black, shapes.placed((x, side * (HEIGHT / 2 + 0.16), 0), 0.16))
        shapes.add(scene, cube, black, shapes.placed((x, side * (HEIGHT / 2 + 1.36), 0), (0.07, 1.1, 0.07)))
    return scene


class Ruler(shapes.View):
    """Renders tiles, each with its own cells, because every pixel asks every element whether it covers the pixel."""

    TILES = 57, 12  # columns and rows; less in pictures where tiles would have fewer than 8 pixels on a side

    def render(self, size, samples):
        columns, rows = (np.linspace(0, side, max(1, min(n, side // 8)) + 1).astype(int) for side, n in zip(size, self.TILES))
        colours = []
        for channel, scene in enumerate(self.scene):
            cells = list(retarders(channel))
            places = np.array([(cell.to_world[3], cell.to_world[7]) for cell in cells])
            tile = lambda x, y: self.tile(scene, cells, places, size, x, y, samples)  # noqa: B023, E731
            lines = [np.concatenate([tile(x, y) for x in zip(columns, columns[1:])], 1) for y in zip(rows, rows[1:])]
            colours.append(np.concatenate(lines))
        return np.concatenate(colours, 2)

    def tile(self, scene, cells, places, size, x, y, samples):
        """Returns the Stokes vectors of the columns x[0] to x[1] and of the rows y[0] to y[1]."""
        middle = np.array(size) / 2
        first, last = np.array([x[0], y[0]]), np.array([x[1], y[1]])
        half = np.tan(np.radians(self.camera.fov / 2))
        camera = nicol.Camera(fov=2 * np.degrees(np.arctan(half * (x[1] - x[0]) / size[0])), to_world=list(self.camera.to_world))
        camera.shift = list(((first + last) / 2 - middle) / (last - first))
        unit = 2 * DISTANCE * half / size[0]  # of a pixel, at the ruler
        low, high = np.sort([unit * (end - middle) * [1, -1] + [0, CENTRE] for end in (first, last)], 0)
        seen = ((places > low - 0.05) & (places < high + 0.05)).all(1)
        added = [scene.add_polarization_element(cells[i]) for i in np.flatnonzero(seen)]
        options = nicol.RenderOptions(pixel_samples=samples, **self.options)
        stokes = nicol.render(scene, camera, options, size=tuple(map(int, last - first))).stokes
        for element in added:
            scene.remove_polarization_element(element)
        return stokes


def make_view(context):
    camera = nicol.Camera(fov=32.5).look_at((0, CENTRE, DISTANCE), (0, CENTRE, 0), (0, 1, 0))
    return Ruler([make_scene(context, channel) for channel in range(3)], camera, polarizer=-45, shadows=0)
