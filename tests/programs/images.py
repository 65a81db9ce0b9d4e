# SPDX-License-Identifier: MIT
"""Readers of the image formats that the tests compare."""

import struct
import zlib


def read_png(data):
    """Returns width, height and the bytes of an 8-bit colour image, with alpha if the file has it."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("no PNG")
    at, packed, width, height, step = 8, b"", 0, 0, 3
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack_from(">IIBB", data, at + 8)
            if depth != 8 or colour not in (2, 6):
                raise ValueError("not 8 bits of R G B")
            step = 3 if colour == 2 else 4
        if kind == b"IDAT":
            packed += data[at + 8 : at + 8 + length]
        at += length + 12
    raw, stride, rows, before = zlib.decompress(packed), step * width, [], bytes(step * width)
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for x in range(stride):
            left = row[x - step] if x >= step else 0
            above, corner = before[x], before[x - step] if x >= step else 0
            estimate = left + above - corner
            paeth = min((left, above, corner), key=lambda v: abs(estimate - v))
            row[x] = (row[x] + (0, left, above, (left + above) // 2, paeth)[kind]) % 256
        rows.append(bytes(row))
        before = rows[-1]
    return width, height, b"".join(rows)


def exr_attributes(data):
    """Returns the attributes of an OpenEXR file as name -> bytes, and the position of its offset table."""
    if data[:4] != struct.pack("<i", 20000630):
        raise ValueError("no OpenEXR file")
    attributes, at = {}, 8
    while data[at] != 0:
        end = data.index(b"\0", at)
        name, at = data[at:end].decode(), data.index(b"\0", end + 1) + 1
        size = struct.unpack_from("<i", data, at)[0]
        attributes[name], at = data[at + 4 : at + 4 + size], at + 4 + size
    return attributes, at + 1


def exr_size(data):
    left, top, right, bottom = struct.unpack("<4i", exr_attributes(data)[0]["dataWindow"])
    return right - left + 1, bottom - top + 1


def exr_channels(data):
    """Returns the channel names in the order of the file."""
    rest, names = exr_attributes(data)[0]["channels"], []
    while len(rest) > 1:
        name, rest = rest.split(b"\0", 1)
        names.append(name.decode())
        rest = rest[16:]
    return names


def read_exr(data):
    """Returns channel -> floats, row by row, of an uncompressed file of 32-bit floats."""
    table, (width, height), names = exr_attributes(data)[1], exr_size(data), exr_channels(data)
    channels = {name: [] for name in names}
    for y in range(height):
        row = struct.unpack_from("<Q", data, table + 8 * y)[0] + 8
        for index, name in enumerate(names):
            channels[name] += struct.unpack_from(f"<{width}f", data, row + 4 * width * index)
    return channels
