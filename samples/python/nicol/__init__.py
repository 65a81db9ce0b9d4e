# SPDX-License-Identifier: MIT
"""Nicol: polarized light in real time.

    picture = nicol.render("scene.xml", size=(640, 480))
    picture.save("scene.exr"), picture.dolp, picture.polarizer(45)

Every function of the C headers is here without its prefix. A function that begins with the name of a handle or struct is a
method: nicol_scene_load is Scene.load, nicol_render is render. Results through pointers are returned, failures raise Error.
"""

import math
import os

from . import _abi
from ._abi import *  # noqa: F403
from ._runtime import Error, Handle, Struct

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

if _abi.version() // 100 != _abi.VERSION // 100:
    raise ImportError(f"libnicol is {_abi.version_string()}; this package needs a {_abi.VERSION_MAJOR}.{_abi.VERSION_MINOR}")


class Context(_abi.Context):
    __doc__ = _abi.Context.__doc__

    @classmethod
    def create(cls, options=None):
        """Creates a context, see nicol_context_create. Unless the options or NICOL_CACHE name another folder, tables of
        materials and baked shadows are kept in the user's cache folder."""
        options = _abi.ContextOptions() if options is None else options
        given = options.cache_folder
        if not given:
            options.cache_folder = _user_cache_folder()
        try:
            return super().create(options)
        finally:
            options.cache_folder = given


def _user_cache_folder():
    """Returns $XDG_CACHE_HOME/nicol, else ~/.cache/nicol, and makes the folder. Returns None if NICOL_CACHE is set, which then
    decides, and if the folder cannot be made or written."""
    if "NICOL_CACHE" in os.environ:
        return None
    root = os.environ.get("XDG_CACHE_HOME", "")
    if not os.path.isabs(root):
        root = os.path.join(os.path.expanduser("~"), ".cache")
    folder = os.path.join(root, "nicol")
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError:
        return None
    return folder if os.access(folder, os.W_OK | os.X_OK) else None


class Camera(_abi.Camera):
    __doc__ = _abi.Camera.__doc__

    @classmethod
    def from_opencv(cls, K, R, t, size):
        """Returns the camera of OpenCV's intrinsics K (3 x 3) and pose (x = R X + t) for images of size (width, height). Pixels
        have their middles at whole numbers. Images must be undistorted."""
        return cls().set_opencv(_flat(K), _flat(R), _flat(t), *size)

    @classmethod
    def from_colmap(cls, K, R, t, size):
        """Returns the camera of COLMAP's intrinsics and pose, which are OpenCV's but for the first pixel's middle: (0.5, 0.5)."""
        return cls.from_opencv(_moved(K, -0.5), R, t, size)

    @classmethod
    def from_opengl(cls, to_world, K, size):
        """Returns the camera of a pose as OpenGL, Blender and transforms.json of nerfstudio have it: to_world (4 x 4) takes
        points of a camera that looks along -z, with +y up. The first pixel's middle is (0.5, 0.5), as in COLMAP."""
        m = _flat(to_world)
        R = [m[0], m[4], m[8], -m[1], -m[5], -m[9], -m[2], -m[6], -m[10]]
        t = [-sum(R[3 * i + j] * m[4 * j + 3] for j in range(3)) for i in range(3)]
        return cls.from_colmap(K, R, t, size)

    @classmethod
    def from_projection(cls, P, size):
        """Returns the camera of a projection matrix without skew: 3 x 4, from points of the world to pixels of OpenCV, or 4 x 4,
        OpenGL's projection times its view, whose depth is ignored: near_clip and far_clip have their defaults."""
        p = _flat(P)
        if len(p) not in (12, 16):
            raise ValueError(f"P has {len(p)} numbers; it must be 3 x 4 or 4 x 4")
        rows = [p[4 * i : 4 * i + 4] for i in range(len(p) // 4)]
        if len(rows) == 4:
            x, y, _, w = rows
            width, height = size
            rows = [_sum(0.5 * width, x, 0.5 * width - 0.5, w), _sum(-0.5 * height, y, 0.5 * height - 0.5, w), w]
        # P = K (R | t). The rows of R are those of P made orthogonal from the last one on; all signs may be the other way.
        a, b, c = (row[:3] for row in rows)
        scale = math.copysign(_dot(c, c) ** 0.5, _dot(_cross(a, b), c))
        a, b, forward = ([x / scale for x in row] for row in (a, b, c))
        cx, cy = _dot(a, forward), _dot(b, forward)
        a, b = _sum(1, a, -cx, forward), _sum(1, b, -cy, forward)
        fy = _dot(b, b) ** 0.5
        down = [x / fy for x in b]
        right, skew = _cross(down, forward), _dot(a, down)
        fx = _dot(a, right)
        t = [row[3] / scale for row in rows]
        place = [(t[0] - cx * t[2]) / fx, (t[1] - cy * t[2]) / fy, t[2]]
        # Rounding leaves a little skew.
        return cls.from_opencv([fx, skew if abs(skew) > 1e-9 * fx else 0, cx, 0, fy, cy, 0, 0, 1], right + down + forward, place, size)

    def to_opencv(self, size):
        """Returns K (3 x 3), R (3 x 3) and t of from_opencv(), as numpy arrays, or as nested lists without numpy."""
        K, R, t = self.get_opencv(*size)
        return _rows(K, 3), _rows(R, 3), _rows(t, None)

    def to_colmap(self, size):
        """Returns K, R and t of from_colmap()."""
        K, R, t = self.get_opencv(*size)
        return _rows(_moved(K, 0.5), 3), _rows(R, 3), _rows(t, None)

    def to_opengl(self, size):
        """Returns to_world (4 x 4) and K (3 x 3) of from_opengl()."""
        K, R, t = self.get_opencv(*size)
        place = [-sum(R[3 * j + i] * t[j] for j in range(3)) for i in range(3)]
        m = [x for i in range(3) for x in (R[i], -R[3 + i], -R[6 + i], place[i])] + [0, 0, 0, 1]
        return _rows(m, 4), _rows(_moved(K, 0.5), 3)


_abi.Camera = Camera  # type: ignore[misc]  # what Scene.get_camera() returns


def _flat(numbers):
    """Returns the numbers of nested sequences, or of an array of any shape, as a flat list."""
    if hasattr(numbers, "__len__"):
        return [x for part in numbers for x in _flat(part)]
    return [float(numbers)]


def _sum(a, x, b, y):
    return [a * p + b * q for p, q in zip(x, y)]


def _dot(x, y):
    return sum(p * q for p, q in zip(x, y))


def _cross(x, y):
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def _moved(K, by):
    """Returns intrinsics with the principal point moved."""
    K = _flat(K)
    K[2] += by
    K[5] += by
    return K


def _rows(numbers, length):
    """Returns numbers as rows of this length, or as one row for None."""
    rows = list(numbers) if length is None else [list(numbers[i : i + length]) for i in range(0, len(numbers), length)]
    return rows if numpy is None else numpy.array(rows, float)


class Sensor(_abi.Sensor):
    __doc__ = _abi.Sensor.__doc__

    def capture(self, light, frame=0):
        """Returns what the sensor gives for light, as 16-bit numbers (height, width): a numpy array, or a memoryview without
        numpy. light is a Framebuffer, or 32-bit floats of shape (height, width, channels, 4). See nicol_sensor_expose."""
        if isinstance(light, Framebuffer):
            width, height, _ = light.get_size()
        else:
            light = _stokes_image(light)
            width, height = light.width, light.height
        raw = _room((height, width), "H")
        if isinstance(light, Framebuffer):
            light.expose(self, frame, _raw_image(raw))
        else:
            self.expose(light, frame, _raw_image(raw))
        return raw

    def stokes(self, raw, method=_abi.DEMOSAIC_BILINEAR):
        """Returns the light on the sensor as 32-bit floats (height, width, channels, 4), from 16-bit numbers (height, width). See
        nicol_sensor_demosaic."""
        raw = _raw_image(raw)
        cell = {_abi.MOSAIC_PLAIN: 1, _abi.MOSAIC_POLARIZED: 2}.get(self.mosaic, 4) if method == _abi.DEMOSAIC_BLOCKS else 1
        channels = 3 if self.mosaic == _abi.MOSAIC_POLARIZED_BAYER else 1
        light = _room((raw.height // cell, raw.width // cell, channels, 4), "f")
        self.demosaic(raw, method, _stokes_image(light))
        return light

    def save(self, raw, path):
        """Writes 16-bit numbers (height, width) as PNG. See nicol_sensor_write_png."""
        self.write_png(_raw_image(raw), path)


def _room(shape, kind):
    """Returns an array for numbers of this kind: of numpy, or else a memoryview."""
    if numpy is not None:
        return numpy.empty(shape, kind)
    return memoryview(bytearray(math.prod(shape) * {"f": 4, "I": 4, "H": 2}[kind])).cast(kind, shape)


def _checked(pixels, kind, shape, text):
    view = memoryview(pixels)
    if view.ndim != len(shape) or (shape[-1] == 4 and view.shape[-1] != 4):
        raise ValueError(f"{text} has the shape {view.shape}; it must be ({', '.join(map(str, shape))})")
    if view.format.lstrip("<=") != kind:
        raise TypeError(f"{text} has numbers of kind '{view.format}'; it must be '{kind}'")
    if not view.c_contiguous:
        raise ValueError(f"{text} must be contiguous")
    return view


def _stokes_image(pixels):
    view = _checked(pixels, "f", ("height", "width", "channels", 4), "the Stokes image")
    height, width, channels, _ = view.shape
    return _abi.StokesImage(width=width, height=height, channels=channels, pixels=pixels, byte_size=view.nbytes)


def _raw_image(pixels):
    view = _checked(pixels, "H", ("height", "width"), "the raw image")
    return _abi.RawImage(width=view.shape[1], height=view.shape[0], pixels=pixels, byte_size=view.nbytes)


class Framebuffer(_abi.Framebuffer):
    __doc__ = _abi.Framebuffer.__doc__

    def plane(self, plane=_abi.PLANE_STOKES, channel=0, out=None, polarizer_angle=0):
        """Returns one plane as an array (height, width), with three numbers per pixel for normals and positions, and four for
        Stokes vectors and their variance. It is a numpy array, or a memoryview without numpy. channel ALL_CHANNELS: (height, width,
        channels) and so on. polarizer_angle: of PLANE_POLARIZER, degrees. Numbers are 32-bit floats, for PLANE_INSTANCE unsigned integers. If `out` is given, the library writes
        into it: it may hold 16-bit floats, and may be part of a larger array if its rows are contiguous."""
        width, height, channels = self.get_size()
        shape = (height, width)
        if channel == _abi.ALL_CHANNELS:
            shape += (channels,)
        shape += _COMPONENTS.get(plane, ())
        kind = "I" if plane == _abi.PLANE_INSTANCE else "f"
        if out is None:
            out = _room(shape, kind)
        view = memoryview(out)
        if view.shape != shape:
            raise ValueError(f"out has the shape {view.shape}; the plane has {shape}")
        kind = view.format.lstrip("<=")
        if kind not in _FORMATS:
            raise TypeError(f"out has numbers of kind '{kind}'; a plane has those of {', '.join(_FORMATS)}")
        row_stride = view.strides[0]
        self.read_plane(
            _abi.PlaneBuffer(
                plane=plane, format=_FORMATS[kind], channel=channel, pixels=out, row_stride=row_stride,
                byte_size=row_stride * (height - 1) + view[:1].nbytes, polarizer_angle=polarizer_angle,
            )
        )  # fmt: skip
        return out


_COMPONENTS = {_abi.PLANE_STOKES: (4,), _abi.PLANE_NORMAL: (3,), _abi.PLANE_POSITION: (3,), _abi.PLANE_VARIANCE: (4,)}
_FORMATS = {"f": _abi.FORMAT_FLOAT32, "e": _abi.FORMAT_FLOAT16, "I": _abi.FORMAT_UINT32}


def _shared(values, kind):
    """Returns what has memory that the library can read: the values themselves, or a numpy array of lists, of another library's
    array (by DLPack), or of anything that numpy takes. kind: of the numbers of lists."""
    try:
        memoryview(values)
        return values
    except TypeError:
        if numpy is None:
            raise
    return numpy.from_dlpack(values) if hasattr(values, "__dlpack__") else numpy.asarray(values, kind)


def mesh_data(
    positions, indices=None, normals=None, texcoords=None, texcoord_indices=None, colors=None, face_colors=None, tangents=None
):
    """Returns MeshData for Mesh.create, from arrays of three numbers per vertex or triangle, and of two (tangents: four)
    per texture coordinate; or from an object with `vertices` and `faces`, such as a trimesh.Trimesh, whose texture
    coordinates are taken as well."""
    if indices is None:
        mesh, positions, indices = positions, positions.vertices, positions.faces
        if texcoords is None:
            texcoords = getattr(getattr(mesh, "visual", None), "uv", None)
    fields = {"positions": positions, "indices": indices, "normals": normals, "texcoords": texcoords,
              "texcoord_indices": texcoord_indices, "colors": colors, "face_colors": face_colors, "tangents": tangents}  # fmt: skip
    kinds = {"indices": "I", "texcoord_indices": "I"}
    fields = {name: value if value is None else _shared(value, kinds.get(name, "f")) for name, value in fields.items()}
    counts = {}
    for name, value in fields.items():
        view = memoryview(b"" if value is None else value)
        each = {"texcoords": 2, "tangents": 4}.get(name, 3)
        counts[name], rest = divmod(view.nbytes // view.itemsize, each)
        if rest:
            raise ValueError(f"{name} takes {each} numbers each; {each * counts[name] + rest} are no multiple of {each}")
    of = {"normals": "positions", "colors": "positions", "texcoord_indices": "indices", "face_colors": "indices",
          "tangents": "texcoords"}  # fmt: skip
    if texcoord_indices is None:
        of["texcoords"] = "positions"
    for name, wanted in of.items():
        if fields[name] is not None and counts[name] != counts[wanted]:
            raise ValueError(f"{counts[name]} {name} for {counts[wanted]} {wanted}")
    return _abi.MeshData(
        vertex_count=counts["positions"], triangle_count=counts["indices"], texcoord_count=counts["texcoords"],
        **{name: value for name, value in fields.items() if value is not None},
    )  # fmt: skip


def texture_image(pixels):
    """Returns TextureImage for Texture.create_image, from numbers of shape (height, width) or (height, width, channels):
    unsigned with 8 or 16 bits, or 32-bit floats."""
    pixels = _shared(pixels, "f")
    view = memoryview(pixels)
    if view.ndim not in (2, 3):
        raise ValueError(f"pixels have the shape {view.shape}; it must be (height, width) or (height, width, channels)")
    kind = view.format.lstrip("<=")
    if kind not in _TEXELS:
        raise TypeError(f"pixels are numbers of kind '{kind}'; a texture has those of {', '.join(_TEXELS)}")
    height, width, channels = (*view.shape, 1)[:3]
    return _abi.TextureImage(
        type=_TEXELS[kind], width=width, height=height, channels=channels, pixels=pixels,
        row_stride=view.strides[0], byte_size=view.strides[0] * (height - 1) + view[:1].nbytes,
    )  # fmt: skip


_TEXELS = {"B": _abi.TEXEL_UINT8, "H": _abi.TEXEL_UINT16, "f": _abi.TEXEL_FLOAT32}


def image(pixels):
    """Returns Image for Environment.create_image, from numbers of shape (height, width, channels), or (height, width,
    channels, 4) for Stokes vectors."""
    pixels = _shared(pixels, "f")
    view = memoryview(pixels)
    if view.ndim not in (3, 4):
        raise ValueError(f"pixels have the shape {view.shape}; it must be (height, width, channels) or (..., channels, 4)")
    height, width, channels, components = (*view.shape, 1)[:4]
    return _abi.Image(
        width=width, height=height, channels=channels, components=components, pixels=pixels,
        byte_size=4 * math.prod(view.shape),
    )  # fmt: skip


from . import capi  # noqa: E402, F401
from ._memory import memory_file  # noqa: E402
from ._picture import Picture, Scene, default_context, load, render  # noqa: E402
from ._gradients import Gradients, gradients  # noqa: E402

__all__ = [*_abi.__all__, "Camera", "Context", "Framebuffer", "Scene", "Sensor", "Error", "Handle", "Struct", "image",
           "mesh_data", "texture_image", "memory_file", "Gradients", "gradients", "Picture", "default_context", "load", "render"]  # fmt: skip
__version__ = _abi.version_string()
