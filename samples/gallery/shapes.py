# SPDX-License-Identifier: MIT
"""Shapes and light that the gallery's scenes have in common."""

import nicol
import numpy as np


def rounded(profile, rounds=3):
    """Returns a profile whose corners are cut several times (Chaikin's subdivision)."""
    points = np.array(profile, float)
    for _ in range(rounds):
        cut = np.stack([0.8 * points[:-1] + 0.2 * points[1:], 0.2 * points[:-1] + 0.8 * points[1:]], 1).reshape(-1, 2)
        points = np.concatenate([points[:1], cut, points[-1:]])
    return points


def lathe(context, profile, columns=96):
    """Returns the mesh of a profile [point][radius, height] that is rotated about the vertical axis."""
    points = np.array(profile, float)
    points = points[np.concatenate([[True], np.hypot(*np.diff(points, axis=0).T) > 1e-9])]
    points[:, 0] = np.maximum(points[:, 0], 1e-4)
    angles = 2 * np.pi * np.arange(columns) / columns
    radius, height = points.T
    places = np.stack([np.outer(radius, np.cos(angles)), np.outer(height, np.ones(columns)), np.outer(radius, np.sin(angles))], -1)
    return sheet(context, places, wraps=True)


def sheet(context, places, wraps=False, repeats=(1, 1)):
    """Returns the mesh of a grid of places [row][column][3], whose texture repeats along rows and columns. wraps: whether the
    last column meets the first. The front is where columns and rows grow counter-clockwise."""
    rows, columns = places.shape[:2]
    row, column = (i.ravel() for i in np.indices((rows - 1, columns if wraps else columns - 1)))
    at = lambda r, c: r * columns + c % columns  # noqa: E731
    here, above, across, beside = at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1)
    corners = np.stack([here, above, across, here, across, beside], -1).reshape(-1, 3)
    v, u = np.indices((rows, columns)) / np.array([rows - 1, columns - 1]).reshape(2, 1, 1)
    uv = np.stack([repeats[1] * u, repeats[0] * v], -1).reshape(-1, 2)
    return nicol.Mesh.create(context, nicol.mesh_data(places.reshape(-1, 3), corners, texcoords=None if wraps else uv))


def placed(at=(0, 0, 0), scale=(1, 1, 1), axes=np.eye(3)):
    """Returns a transform: scale, then rotation into the columns of axes, then movement."""
    to_world = np.eye(4)
    to_world[:3, :3] = np.asarray(axes) @ np.diag(np.broadcast_to(scale, 3))
    to_world[:3, 3] = at
    return to_world


def rotated(axis, degrees):
    """Returns a rotation about a coordinate axis, 0 to 2, counter-clockwise from its tip."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    out = np.eye(3)
    out[i, i], out[i, j], out[j, i], out[j, j] = c, -s, s, c
    return out


FLOOR = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])  # axes of a rectangle that faces up


def add(scene, mesh, material, to_world=np.eye(4), emission=None):
    """Adds an instance, which may emit light."""
    instance = scene.add_instance(nicol.Instance(mesh=mesh, material=material, to_world=list(np.ravel(to_world))))
    if emission is not None:
        scene.set_emission(instance, emission)
    return instance


def studio(context, panels, ambient=0.05, width=512):
    """Returns light from all around: soft panels (direction, width and height in degrees, radiance) before even light."""
    height = width // 2 + 1
    u, v = np.meshgrid(2 * np.pi * (np.arange(width) + 0.5) / width, np.pi * np.arange(height) / (height - 1))
    view = np.stack([np.sin(v) * np.sin(u), np.cos(v), -np.sin(v) * np.cos(u)], -1)
    pixels = np.full((height, width, 3), 1.0) * ambient
    for direction, wide, high, radiance in panels:
        z = np.array(direction, float) / np.linalg.norm(direction)
        x = np.cross((0, 1, 0) if abs(z[1]) < 0.95 else (1, 0, 0), z)
        x /= np.linalg.norm(x)
        y = np.cross(z, x)
        ahead = view @ z
        with np.errstate(divide="ignore", invalid="ignore"):
            across = np.maximum(np.abs(view @ x) / ahead / np.tan(np.radians(wide / 2)), np.abs(view @ y) / ahead / np.tan(np.radians(high / 2)))
        edge = np.clip((1.06 - across) / 0.12, 0, 1) * (ahead > 0)
        pixels += np.nan_to_num(edge)[..., None] * np.asarray(radiance, float)
    return nicol.Environment.create_image(context, nicol.image(pixels.astype(np.float32)))


class View:
    """A scene, how it is seen, and which polarizer shows what is special about it."""

    def __init__(self, scene, camera, polarizer, exposure=0.0, circular=0, **options):
        self.scene, self.camera, self.polarizer, self.exposure, self.options = scene, camera, polarizer, exposure, options
        self.circular = circular  # 1 or -1: a right or left circular polarizer in place of the linear one

    def render(self, size, samples):
        """Returns Stokes vectors (height, width, channels, 4)."""
        return nicol.render(self.scene, self.camera, nicol.RenderOptions(pixel_samples=samples, **self.options), size=size).stokes
