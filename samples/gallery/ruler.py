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
CELLS = 190, 30
DISTANCE = 14
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
    """Renders strips, each with its own cells, because every pixel asks every element whether it covers the pixel."""

    STRIPS = 38

    def render(self, size, samples):
        edges = np.linspace(0, size[0], self.STRIPS + 1).astype(int)
        colours = []
        for channel, scene in enumerate(self.scene):
            cells = list(retarders(channel))
            colours.append(np.concatenate([self.strip(scene, cells, size, ends, samples) for ends in zip(edges, edges[1:])], 1))
        return np.concatenate(colours, 2)

    def strip(self, scene, cells, size, ends, samples):
        """Returns the Stokes vectors of the columns from ends[0] to ends[1]."""
        (width, height), (first, last) = size, ends
        half = np.tan(np.radians(self.camera.fov / 2))
        part = (last - first) / width
        camera = nicol.Camera(fov=2 * np.degrees(np.arctan(half * part)), to_world=list(self.camera.to_world))
        camera.shift = [((first + last) / 2 - width / 2) / (last - first), 0]
        left, right = (DISTANCE * half * (2 * end / width - 1) for end in ends)
        seen = [e for e in cells if left - 0.05 < e.to_world[3] < right + 0.05]
        added = [scene.add_polarization_element(element) for element in seen]
        options = nicol.RenderOptions(pixel_samples=samples, **self.options)
        stokes = nicol.render(scene, camera, options, size=(int(last - first), height)).stokes
        for element in added:
            scene.remove_polarization_element(element)
        return stokes


def make_view(context):
    camera = nicol.Camera(fov=32.5).look_at((0, 0.1, DISTANCE), (0, 0.1, 0), (0, 1, 0))
    return Ruler([make_scene(context, channel) for channel in range(3)], camera, polarizer=-45, shadows=0)
