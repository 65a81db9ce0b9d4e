# SPDX-License-Identifier: MIT
"""Lenses that bend straight lines, and equirectangular views. Needs numpy.

    lens = nicol.lens.Lens.opencv(K, (640, 480), [k1, k2, p1, p2, k3])
    picture = nicol.lens.render(scene, nicol.Camera.from_opencv(K, R, t, (640, 480)), lens)

Directions are in the camera's axes as OpenCV has them: right, down, forward."""

import nicol
import numpy

from . import conventions
from ._runtime import constant

# Pinhole views of a cube around the camera: rows right, down, forward of each.
_FACES = numpy.array([
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    [[0, 0, -1], [0, 1, 0], [1, 0, 0]],
    [[-1, 0, 0], [0, 1, 0], [0, 0, -1]],
    [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
    [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
    [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
])  # fmt: skip


class Lens:
    """Directions (height, width, 3), of length 1, that the pixels of an image show. NaN: a pixel that shows nothing."""

    def __init__(self, directions):
        self.directions = numpy.asarray(directions, float)

    @property
    def size(self):
        return self.directions.shape[1], self.directions.shape[0]

    @classmethod
    def opencv(cls, K, size, distortion):
        """Returns a lens with OpenCV's distortion of pinholes (Brown-Conrady): k1, k2, p1, p2, and none, k3, or k3 to k6.
        K is of images whose first pixel has its middle at (0, 0)."""
        if len(distortion) not in (4, 5, 8):
            raise ValueError(f"distortion has {len(distortion)} numbers; it must have 4, 5 or 8")
        wanted = _on_plane(K, size)
        found = _inverted(lambda plane: _bent(plane, *distortion), wanted, wanted)
        found = numpy.concatenate([found, numpy.ones((*found.shape[:2], 1))], axis=2)
        return cls(found / numpy.linalg.norm(found, axis=2, keepdims=True))

    @classmethod
    def fisheye(cls, K, size, distortion=(0, 0, 0, 0)):
        """Returns a lens of OpenCV's fisheye model: k1 to k4. Pixels more than 180 degrees from the view show nothing, nor do
        those beyond the angle from which on the distortion would lead back towards the middle."""
        if len(distortion) != 4:
            raise ValueError(f"distortion has {len(distortion)} numbers; it must have 4")
        plane = _on_plane(K, size)
        radius = numpy.linalg.norm(plane, axis=2, keepdims=True)

        def bent(angle):
            square = angle * angle
            return angle * (1 + sum(k * square ** (i + 1) for i, k in enumerate(distortion)))

        angles = numpy.linspace(0, numpy.pi, 1801)
        table = bent(angles)
        falls = numpy.diff(table) <= 0
        most = numpy.argmax(falls) if falls.any() else len(angles) - 1
        start = numpy.interp(radius, table[: most + 1], angles[: most + 1])
        angle = _inverted(bent, radius, start, outside=table[most])
        across = plane * numpy.divide(numpy.sin(angle), radius, out=numpy.ones_like(radius), where=radius > 0)
        return cls(numpy.concatenate([across, numpy.cos(angle)], axis=2))

    @classmethod
    def equirectangular(cls, size):
        """Returns the view of all directions: columns are even in the angle about the camera's up, with the view in the
        middle, rows in the angle from up to down."""
        longitude = ((numpy.arange(size[0]) + 0.5) / size[0] * 2 - 1) * numpy.pi
        latitude = (0.5 - (numpy.arange(size[1]) + 0.5) / size[1])[:, None] * numpy.pi
        x, z = numpy.cos(latitude) * numpy.sin(longitude), numpy.cos(latitude) * numpy.cos(longitude)
        return cls(numpy.stack([x, numpy.broadcast_to(-numpy.sin(latitude), x.shape), z], axis=2))


def _on_plane(K, size):
    """Returns the points of pixels on the plane at distance 1 (height, width, 2), as if there were no distortion."""
    K = numpy.asarray(K, float)
    columns, rows = numpy.meshgrid(numpy.arange(size[0]), numpy.arange(size[1]))
    return numpy.stack([(columns - K[0, 2]) / K[0, 0], (rows - K[1, 2]) / K[1, 1]], axis=2)


def _bent(plane, k1, k2, p1, p2, k3=0, k4=0, k5=0, k6=0):
    x, y = plane[..., :1], plane[..., 1:]
    r = x * x + y * y
    radial = (1 + r * (k1 + r * (k2 + r * k3))) / (1 + r * (k4 + r * (k5 + r * k6)))
    bent_x = x * radial + 2 * p1 * x * y + p2 * (r + 2 * x * x)
    return numpy.concatenate([bent_x, y * radial + p1 * (r + 2 * y * y) + 2 * p2 * x * y], axis=-1)


def _inverted(bend, wanted, start, outside=numpy.inf):
    """Returns where bend() gives the wanted values (..., 1 or 2), by Newton's method; NaN for values above `outside`. Raises
    ValueError where it finds none."""
    point, step, parts = numpy.array(start), 1e-6, wanted.shape[-1]
    for _ in range(30):
        rest = bend(point) - wanted
        slopes = [(bend(point + step * e) - bend(point - step * e)) / (2 * step) for e in numpy.eye(parts)]
        with numpy.errstate(divide="ignore", invalid="ignore"):
            if parts == 1:
                point = point - rest / slopes[0]
            else:
                (a, c), (b, d) = (numpy.moveaxis(slope, -1, 0) for slope in slopes)
                x, y = numpy.moveaxis(rest, -1, 0)
                point = point - numpy.stack([d * x - b * y, a * y - c * x], axis=-1) / (a * d - b * c)[..., None]
    point[wanted > outside] = numpy.nan
    wrong = ~(abs(bend(point) - wanted) < 1e-9).all(axis=-1) & ~(wanted > outside).all(axis=-1)
    if wrong.any():
        row, column = numpy.argwhere(wrong)[0]
        raise ValueError(f"distortion: no direction is shown at column {column}, row {row}; images must be smaller")
    return point


def render(scene, camera, lens, options=None, aovs=(), sharpness=1.0):
    """Renders a scene through a lens, with the place, the axes and the clipping of a camera, and returns a dictionary: stokes
    (height, width, channels, 4), in the frames of the pixels' own directions as always, see capi/reference/conventions.md;
    distance, normal, position, instance and alpha where `aovs` name them ("distance" is that from the camera). The
    picture is resampled from up to six pinhole views, with as many pixels along a line as the lens has in the middle, times
    `sharpness`; Stokes vectors linearly, surfaces by the nearest. Pixels that show nothing are 0."""
    options = nicol.RenderOptions() if options is None else options
    given = options.aovs
    options.aovs = sum({constant("aov", "depth" if name == "distance" else name) for name in aovs})
    try:
        return _resampled(scene, camera, lens, options, aovs, sharpness)
    finally:
        options.aovs = given


def _resampled(scene, camera, lens, options, aovs, sharpness):
    _, R, t = camera.to_opencv(lens.size)
    seen = numpy.nan_to_num(lens.directions)
    nearest = numpy.where(numpy.isnan(lens.directions[..., 0]), -1, numpy.argmax(seen @ _FACES[:, 2].T, axis=2))
    masks = {face: nearest == face for face in range(len(_FACES)) if (nearest == face).any()}
    parts = {face: _Part(camera, lens, seen[mask] @ _FACES[face].T, sharpness) for face, mask in masks.items()}
    views = [part.view(_FACES[face] @ R, _FACES[face] @ t) for face, part in parts.items()]
    framebuffers = [nicol.Framebuffer.create(scene.context, *part.size, scene.get_channels()) for part in parts.values()]
    nicol.render_views(scene, views, framebuffers, options)
    picture = {}
    for (face, mask), framebuffer in zip(masks.items(), framebuffers):
        planes = parts[face].planes(nicol.Picture(framebuffer), aovs)
        if face >= 4:
            angle = _between(seen[mask], -_FACES[face][1])
            planes["stokes"] = conventions.rotated(planes["stokes"], angle[:, None])
        for name, values in planes.items():
            empty = nicol.NO_INSTANCE if name == "instance" else numpy.inf if name == "distance" else 0
            picture.setdefault(name, numpy.full((*mask.shape, *values.shape[1:]), empty, values.dtype))[mask] = values
    return picture


def _between(directions, up):
    """Returns the angles from the frames of views whose up is `up` to those of the camera, whose up is (0, -1, 0)."""
    x = numpy.cross(directions, up)
    right = numpy.cross(directions, [0, -1, 0])
    # y = z x x, where z is against the direction.
    return numpy.arctan2((right * -numpy.cross(directions, x)).sum(axis=1), (right * x).sum(axis=1))


class _Part:
    """The pinhole view that holds some directions (count, 3) of a lens, in the view's own axes."""

    def __init__(self, camera, lens, directions, sharpness):
        self.camera = camera
        plane = directions[:, :2] / directions[:, 2:]
        lower, upper = plane.min(axis=0), plane.max(axis=0)
        middle = lens.directions[lens.size[1] // 2]
        steps = numpy.linalg.norm(numpy.diff(middle, axis=0), axis=1)
        focal = sharpness / numpy.nanmedian(steps)
        # A pixel on each side is for the interpolation.
        self.size = [int(side) for side in numpy.ceil(focal * (upper - lower)) + 3]
        self.K = [[focal, 0, 1 - focal * lower[0]], [0, focal, 1 - focal * lower[1]], [0, 0, 1]]
        self.pixels = focal * (plane - lower) + 1

    def view(self, R, t):
        view = nicol.Camera.from_opencv(self.K, R, t, self.size)
        view.near_clip, view.far_clip = self.camera.near_clip, self.camera.far_clip
        return view

    def planes(self, shown, aovs):
        """Returns the planes of a picture of the view, at the part's directions."""
        planes = {"stokes": self._linear(shown.stokes)}
        column, row = numpy.rint(self.pixels).astype(int).T
        for name in aovs:
            planes[name] = getattr(shown, "depth" if name == "distance" else name)[row, column]
        if "distance" in planes:
            x, y = (column - self.K[0][2]) / self.K[0][0], (row - self.K[1][2]) / self.K[1][1]
            planes["distance"] = planes["distance"] * numpy.sqrt(1 + x * x + y * y).astype(numpy.float32)
        return planes

    def _linear(self, image):
        corner = numpy.floor(self.pixels).astype(int)
        (column, row), (x, y) = corner.T, (self.pixels - corner).T.astype(numpy.float32)[..., None, None]
        above = image[row, column] * (1 - x) + image[row, column + 1] * x
        below = image[row + 1, column] * (1 - x) + image[row + 1, column + 1] * x
        return above * (1 - y) + below * y
