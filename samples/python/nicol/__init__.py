# SPDX-License-Identifier: MIT
"""Nicol: polarized light in real time.

Every function of nicol.h is here without its prefix, as a method where it begins with the name of a handle or struct:
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


__all__ = [*_abi.__all__, "Error", "Handle", "Struct"]
__version__ = _abi.version_string()
