# SPDX-License-Identifier: MIT
"""The files of a picture."""

import io
import os

import nicol
import numpy

from . import exr, planes

_EXR_NAMES = {
    "depth": ["Z"], "ids": ["id"], "alpha": ["A"], "normals": ["N.X", "N.Y", "N.Z"],
    "normals_camera": ["X", "Y", "Z"], "positions": ["P.X", "P.Y", "P.Z"],
}  # fmt: skip
_SHOWN = ("s0", "dolp", "aolp")


def names(write):
    """Returns the files that each name of `write` gives."""
    files = []
    for name, how in write.items():
        if name == "angles" and how["format"] == "png":
            files += [f"angle_{angle}.png" for angle in planes.ANGLES]
        else:
            files.append(f"{name}.{how['format']}")
    return files


def write(folder, wanted, arrays, sensor):
    """Writes the files of arrays into a folder, but those that write_shown() makes."""
    for name, how in wanted.items():
        format_ = how["format"]
        if format_ == "npy":
            _save(os.path.join(folder, f"{name}.npy"), _npy(arrays[name]))
        elif format_ == "exr":
            _save(os.path.join(folder, f"{name}.exr"), _exr(name, arrays[name], how))
        elif name == "mosaic":
            sensor.save(arrays[name], os.path.join(folder, "mosaic.png"))
        elif name == "angles":
            for angle, raw in zip(planes.ANGLES, arrays[name]):
                behind = planes.behind(sensor, angle)
                behind.save(raw, os.path.join(folder, f"angle_{angle}.png"))


def write_shown(folder, wanted, framebuffer):
    """Writes the pictures for the eye: s0, dolp and aolp as PNG."""
    for name in _SHOWN:
        if wanted.get(name, {}).get("format") == "png":
            framebuffer.write_png(nicol.Observation(kind=name), os.path.join(folder, f"{name}.png"))


def _save(path, buffers):
    with open(path, "wb") as file:
        file.writelines(buffers)


def _npy(array):
    header = io.BytesIO()
    numpy.lib.format.write_array_header_1_0(header, numpy.lib.format.header_data_from_array_1_0(array))
    return [header.getvalue(), numpy.ascontiguousarray(array)]


def _exr(name, array, how):
    if name == "stokes":
        found = exr.stokes_planes(array)
    elif name in _EXR_NAMES:
        parts = array.reshape(*array.shape[:2], -1)
        found = {channel: parts[..., i] for i, channel in enumerate(_EXR_NAMES[name])}
    else:
        found = {colour: array[..., c] for c, colour in enumerate(exr.colours(array.shape[2]))}
    if how.get("half"):
        found = {channel: p.astype(numpy.float16) if p.dtype == numpy.float32 else p for channel, p in found.items()}
    return exr.encoded(found, how.get("compression", "zip"))
