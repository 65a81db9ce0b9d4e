# SPDX-License-Identifier: MIT
"""OpenEXR files of arrays. Unlike nicol_framebuffer_write_exr they may be uncompressed or of 16-bit floats, and are made
without the framebuffer, which is free for the next picture."""

import struct
import zlib

import numpy

_TYPES = {numpy.dtype("uint32"): 0, numpy.dtype("float16"): 1, numpy.dtype("float32"): 2}
_ZIP_LINES = 16  # lines of a block
_LEVEL = 1  # of zlib: as small as 6 on these files, in two thirds of the time


def _attribute(name, kind, value):
    return f"{name}\0{kind}\0".encode() + struct.pack("<i", len(value)) + value


def _header(channels, width, height, compression):
    listed = b"".join(name.encode() + b"\0" + struct.pack("<iB3xii", _TYPES[plane.dtype], 0, 1, 1) for name, plane in channels)
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    return (
        struct.pack("<ii", 20000630, 2)
        + _attribute("channels", "chlist", listed + b"\0")
        + _attribute("compression", "compression", bytes([{"none": 0, "zip": 3}[compression]]))
        + _attribute("dataWindow", "box2i", window)
        + _attribute("displayWindow", "box2i", window)
        + _attribute("lineOrder", "lineOrder", b"\0")
        + _attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
        + _attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
        + _attribute("screenWindowWidth", "float", struct.pack("<f", 1))
        + b"\0"
    )


def _zipped(block):
    """Returns a block as OpenEXR's ZIP has it: even bytes before odd ones, differences, zlib; or as it is, if not shorter."""
    halves = numpy.concatenate([block[0::2], block[1::2]])
    differences = halves.copy()
    differences[1:] -= halves[:-1]
    differences[1:] += 128
    packed = zlib.compress(differences, _LEVEL)
    return packed if len(packed) < block.nbytes else block.tobytes()


def encoded(planes, compression="zip"):
    """Returns the bytes of a file, as a list of buffers: planes are arrays (height, width) by channel name, of 32-bit or 16-bit
    floats or unsigned 32-bit numbers; compression is "zip" or "none"."""
    channels = sorted(planes.items())
    height, width = channels[0][1].shape
    header = _header(channels, width, height, compression)
    lines = _lines(channels, width, height)
    if compression == "none":
        # A block is one line: its number, its length, and its channels one after the other.
        blocks, sizes = [lines], [lines.shape[1]] * height
    else:
        blocks = []
        for first in range(0, height, _ZIP_LINES):
            data = _zipped(lines[first : first + _ZIP_LINES, 8:].reshape(-1))
            blocks.append(struct.pack("<ii", first, len(data)) + data)
        sizes = [len(block) for block in blocks]
    offsets = numpy.cumsum([len(header) + 8 * len(sizes), *sizes[:-1]], dtype="<u8")
    return [header, offsets, *blocks]


def _lines(channels, width, height):
    """Returns the lines of an uncompressed file as bytes (height, length)."""
    length = sum(plane.dtype.itemsize for _, plane in channels) * width
    line = [("y", "<i4"), ("length", "<i4")] + [(name, plane.dtype, width) for name, plane in channels]
    lines = numpy.empty(height, line)
    lines["y"], lines["length"] = numpy.arange(height), length
    for name, plane in channels:
        lines[name] = plane
    return lines.view(numpy.uint8).reshape(height, 8 + length)


def colours(count):
    """Returns the names of the colour channels in files of Nicol."""
    return {1: ["Y"], 3: ["R", "G", "B"]}.get(count, [str(i) for i in range(count)])


def stokes_planes(stokes):
    """Returns the channels of a Stokes image (height, width, channels, 4), as nicol_framebuffer_write_exr names them."""
    height, width, count, _ = stokes.shape
    # The rows of all channels at once, because each row by itself takes twice as long.
    rows = numpy.ascontiguousarray(stokes.reshape(height, width, 4 * count).transpose(0, 2, 1))
    planes = {}
    for c, colour in enumerate(colours(count)):
        for p in range(4):
            planes[f"S{p}.{colour}"] = rows[:, 4 * c + p]
        if count in (1, 3):
            planes[colour] = rows[:, 4 * c]
    return planes
