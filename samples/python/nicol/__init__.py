# SPDX-License-Identifier: MIT
"""Nicol: polarized light in real time.

Every function of the C headers is here without its prefix, as a method where it begins with the name of a handle or struct:
nicol_scene_load is Scene.load, nicol_render is render. What C returns through pointers is returned, failures raise Error.
"""

from . import _abi
from ._abi import *  # noqa: F403
from ._runtime import Error, Handle, Struct

try:
    import numpy
except ImportError:
    numpy = None

if _abi.version() // 100 != _abi.VERSION // 100:
    raise ImportError(f"libnicol is {_abi.version_string()}; this package needs a {_abi.VERSION_MAJOR}.{_abi.VERSION_MINOR}")


class Framebuffer(_abi.Framebuffer):
    __doc__ = _abi.Framebuffer.__doc__

    def plane(self, plane=_abi.PLANE_STOKES, channel=0, out=None):
        """One plane of one colour channel as 32-bit floats, of shape (height, width), or (height, width, 4) for Stokes
        vectors: a numpy array, without numpy a memoryview. The library writes straight into `out` where it is given,
        which may be a part of a larger array as long as its rows are in one piece."""
        width, height, _ = self.get_size()
        shape = (height, width, 4) if plane == _abi.PLANE_STOKES else (height, width)
        if out is None:
            if numpy is not None:
                out = numpy.empty(shape, numpy.float32)
            else:
                out = memoryview(bytearray(4 * width * height * (4 if len(shape) == 3 else 1))).cast("f", shape)
        elif tuple(out.shape) != shape:
            raise ValueError(f"out has the shape {tuple(out.shape)}; the plane has {shape}")
        self.read(plane, channel, out)
        return out


def mesh_data(positions, indices, normals=None):
    """For Mesh.create, from buffers of 32-bit floats and unsigned integers: three numbers a vertex and a triangle."""
    counts = []
    for name, value in (("positions", positions), ("indices", indices), ("normals", normals)):
        count, rest = divmod(0 if value is None else memoryview(value).nbytes, 12)
        if rest:
            raise ValueError(f"{name} takes three 32-bit numbers each; {12 * count + rest} bytes are no multiple of 12")
        counts.append(count)
    if normals is not None and counts[2] != counts[0]:
        raise ValueError(f"{counts[2]} normals of {counts[0]} vertices")
    return _abi.MeshData(
        positions=positions, indices=indices, normals=normals, vertex_count=counts[0], triangle_count=counts[1]
    )


def image(pixels):
    """For Environment.create_image, from 32-bit floats of shape (height, width, channels), or (height, width, channels, 4)
    for Stokes vectors."""
    view = memoryview(pixels)
    if view.ndim not in (3, 4):
        raise ValueError(f"pixels have the shape {view.shape}; it must be (height, width, channels) or (..., channels, 4)")
    height, width, channels, components = (*view.shape, 1)[:4]
    return _abi.Image(
        width=width, height=height, channels=channels, components=components, pixels=pixels, byte_size=view.nbytes
    )


__all__ = [*_abi.__all__, "Error", "Handle", "Struct", "image", "mesh_data"]
__version__ = _abi.version_string()
