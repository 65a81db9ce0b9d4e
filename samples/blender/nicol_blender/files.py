# SPDX-License-Identifier: MIT
"""Writes the files of an exported scene: PLY, PNG and OpenEXR, from arrays."""

from __future__ import annotations

import os
import struct
import zlib

import numpy


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
    height, width, channels = pixels.shape
    names = ["Y"] if channels == 1 else ["B", "G", "R"]

    def attribute(name: str, kind: str, value: bytes) -> bytes:
        return f"{name}\0{kind}\0".encode() + struct.pack("<I", len(value)) + value

    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    listed = b"".join(name.encode() + b"\0" + struct.pack("<IB3xII", 2, 0, 1, 1) for name in names) + b"\0"
    header = b"\x76\x2f\x31\x01\x02\0\0\0" + attribute("channels", "chlist", listed) + attribute("compression", "compression", b"\0")
    header += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window)
    header += attribute("lineOrder", "lineOrder", b"\0") + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)) + attribute("screenWindowWidth", "float", struct.pack("<f", 1))
    header += b"\0"
    row_bytes = 4 * width * channels
    lines = numpy.empty(height, [("y", "<i4"), ("size", "<i4"), ("data", "<f4", (channels, width))])
    lines["y"], lines["size"] = numpy.arange(height), row_bytes
    lines["data"] = pixels[..., ::-1].transpose(0, 2, 1)
    offsets = len(header) + 8 * height + numpy.arange(height, dtype="<u8") * lines.itemsize
    with open(path, "wb") as file:
        file.write(header + offsets.tobytes() + lines.tobytes())
