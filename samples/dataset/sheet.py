# SPDX-License-Identifier: MIT
"""Draws all frames of a data set as small pictures, 20 in a row: above s0, below the AoLP as hue with twice the DoLP as brightness.
usage: sheet.py DATASET OUT.png. The data set has s0, dolp and aolp as npy."""

import os
import struct
import sys
import zlib

import numpy

COLUMNS, TILE = 20, 36


def small(image):
    """Returns an image as TILE x TILE means of equal parts; the rest at the right and at the bottom is left out."""
    step = min(image.shape[:2]) // TILE
    part = image[: step * TILE, : step * TILE]
    return part.reshape(TILE, step, TILE, step, -1).mean(axis=(1, 3))


def tone_mapped(light):
    """Returns light through the sRGB curve, its 99th percentile white."""
    light = numpy.clip(light / max(numpy.percentile(light, 99), 1e-9), 0, 1)
    return numpy.where(light < 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def wheel(dolp, aolp):
    """Returns the colours of angles: hue = angle / 180 degrees, brightness = 2 DoLP. Angles are averaged as vectors."""
    s1, s2 = small(dolp * numpy.cos(2 * aolp)), small(dolp * numpy.sin(2 * aolp))
    hue, value = (numpy.arctan2(s2, s1) / (2 * numpy.pi)) % 1, numpy.clip(2 * numpy.hypot(s1, s2), 0, 1)
    return value * numpy.clip(numpy.abs((6 * hue + numpy.array([0, 4, 2])) % 6 - 3) - 1, 0, 1)


def save_png(path, image):
    """Writes R G B, or R G B A, (height, width, 3 or 4) as PNG: numbers of 8 or 16 bits, or colours from 0 to 1 as 8 bits."""
    numbers = numpy.rint(255 * image).astype(numpy.uint8) if image.dtype.kind == "f" else image
    height, width, channels = numbers.shape
    rows = numbers.astype(numbers.dtype.newbyteorder(">")).reshape(height, -1).view(numpy.uint8)
    lines = numpy.concatenate([numpy.zeros((height, 1), numpy.uint8), rows], axis=1)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        header = struct.pack(">IIBBBBB", width, height, 8 * numbers.itemsize, {3: 2, 4: 6}[channels], 0, 0, 0)
        for name, data in ((b"IHDR", header), (b"IDAT", zlib.compress(lines.tobytes())), (b"IEND", b"")):
            file.write(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)))


def main(folder, path):
    frames = sorted(os.listdir(os.path.join(folder, "frames")))
    rows = -(-len(frames) // COLUMNS)
    sheet = numpy.zeros((2 * rows * TILE, COLUMNS * TILE, 3))
    for i, frame in enumerate(frames):
        s0, dolp, aolp = (numpy.load(os.path.join(folder, "frames", frame, f"{name}.npy")) for name in ("s0", "dolp", "aolp"))
        row, column = divmod(i, COLUMNS)
        pictures = tone_mapped(small(s0)), wheel(dolp.mean(axis=2, keepdims=True), aolp[..., :1])
        for half, picture in enumerate(pictures):
            top = (half * rows + row) * TILE
            sheet[top : top + TILE, column * TILE : (column + 1) * TILE] = picture
    save_png(path, sheet)


if __name__ == "__main__":
    main(*sys.argv[1:])
