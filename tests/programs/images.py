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
    """Returns channel -> floats, row by row, of a file of 32-bit floats, uncompressed or by ZIP."""
    attributes, table = exr_attributes(data)
    (width, height), names = exr_size(data), exr_channels(data)
    lines = {0: 1, 3: 16}[attributes["compression"][0]]
    channels = {name: [] for name in names}
    for y in range(0, height, lines):
        at = struct.unpack_from("<Q", data, table + 8 * (y // lines))[0]
        size = struct.unpack_from("<i", data, at + 4)[0]
        block = data[at + 8 : at + 8 + size]
        count = min(lines, height - y)
        # A block that ZIP does not shorten is stored as it is.
        block = block if size == 4 * width * len(names) * count else _unzipped(block)
        for row in range(count * len(names)):
            channels[names[row % len(names)]] += struct.unpack_from(f"<{width}f", block, 4 * width * row)
    return channels


def _unzipped(block):
    """Returns the bytes of a block of OpenEXR's ZIP: differences of bytes, the even ones before the odd ones."""
    packed = bytearray(zlib.decompress(block))
    for i in range(1, len(packed)):
        packed[i] = (packed[i - 1] + packed[i] - 128) % 256
    half = (len(packed) + 1) // 2
    block = bytearray(len(packed))
    block[::2], block[1::2] = packed[:half], packed[half:]
    return bytes(block)
