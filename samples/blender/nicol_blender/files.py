# SPDX-License-Identifier: MIT
"""Writes the files of an exported scene: PLY, PNG and OpenEXR, from arrays."""

from __future__ import annotations

import os
import struct
import zlib

import numpy
from nicol.dataset import exr


def write_ply(path: str | os.PathLike, mesh) -> None:
    names = ["x", "y", "z", "nx", "ny", "nz"]
    columns = [mesh.positions, mesh.normals]
    if mesh.texcoords is not None:
        names += ["u", "v"]
        columns.append(mesh.texcoords)
    vertices = numpy.concatenate(columns, 1).astype("<f4")
    faces = numpy.empty(len(mesh.faces), [("count", "u1"), ("indices", "<u4", 3)])
    faces["count"], faces["indices"] = 3, mesh.faces
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
    header += [f"property float {name}" for name in names]
    header += [f"element face {len(faces)}", "property list uchar uint vertex_indices", "end_header", ""]
    with open(path, "wb") as file:
        file.write("\n".join(header).encode() + vertices.tobytes() + faces.tobytes())


def write_png(path: str | os.PathLike, pixels: numpy.ndarray) -> None:
    """pixels: (height, width, 1, 3 or 4) of 8-bit integers."""
    height, width, channels = pixels.shape

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = numpy.zeros((height, 1 + width * channels), numpy.uint8)  # each begins with the filter 0
    rows[:, 1:] = pixels.reshape(height, -1)
    head = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows.tobytes())) + chunk(b"IEND", b""))


def write_exr(path: str | os.PathLike, pixels: numpy.ndarray) -> None:
    """pixels: (height, width, 1 or 3) of 32-bit floats, stored uncompressed."""
    planes = dict(zip(exr.colours(pixels.shape[2]), numpy.moveaxis(pixels, 2, 0)))
    with open(path, "wb") as file:
        file.writelines(exr.encoded(planes, "none"))
