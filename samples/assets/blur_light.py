#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes forest_blurred.exr: forest.exr as an out-of-focus lens shows it, at higher resolution, so that no pixel is visible
behind an object.

usage: blur_light.py FOREST.exr FOREST_BLURRED.exr. It needs numpy and OpenEXR for Python (pip install OpenEXR).
"""

import sys

import Imath
import numpy as np
import OpenEXR

RADIUS = np.radians(1.5)  # radius of the disc that a point of light becomes; light of order 32 loses 8 %
WIDTH, HEIGHT = 1280, 640


def read(path):
    file = OpenEXR.InputFile(path)
    window = file.header()["dataWindow"]
    shape = window.max.y - window.min.y + 1, window.max.x - window.min.x + 1
    channels = [file.channel(name, Imath.PixelType(Imath.PixelType.FLOAT)) for name in "RGB"]
    return np.stack([np.frombuffer(channel, np.float32).reshape(shape) for channel in channels], axis=-1)


def resample(image, width, height):
    """Resamples bilinearly in the layout of environment maps: columns are pixel-centred, the first and last rows are the
    poles."""
    rows = np.linspace(0, image.shape[0] - 1, height)
    above = np.minimum(rows.astype(int), image.shape[0] - 2)
    weight = (rows - above)[:, None, None]
    image = image[above] * (1 - weight) + image[above + 1] * weight
    columns = (np.arange(width) + 0.5) / width * image.shape[1] - 0.5
    left = np.floor(columns).astype(int)
    weight = (columns - left)[:, None]
    return image[:, left % image.shape[1]] * (1 - weight) + image[:, (left + 1) % image.shape[1]] * weight


def main():
    image = np.fft.rfft(resample(read(sys.argv[1]), WIDTH, HEIGHT), axis=1)
    theta = np.pi * np.arange(HEIGHT) / (HEIGHT - 1)
    wave = np.arange(image.shape[1])[:, None]
    blurred = np.empty((HEIGHT, WIDTH, 3))
    for row in range(HEIGHT):
        # In each row the disc is an arc: a box, which is a product with sin(wave * half) / wave in Fourier space.
        total, weights = 0, 0
        for other in np.flatnonzero(np.abs(theta - theta[row]) < RADIUS):
            area = max(np.sin(theta[other]), 0.25 * np.pi / HEIGHT)
            across = max(np.sin(theta[row]) * np.sin(theta[other]), 1e-12)
            half = np.arccos(np.clip((np.cos(RADIUS) - np.cos(theta[row]) * np.cos(theta[other])) / across, -1, 1))
            total = total + area * half * np.sinc(wave * half / np.pi) * image[other]
            weights += area * half
        blurred[row] = np.fft.irfft(total / weights, WIDTH, axis=0)
    blurred = np.maximum(blurred, 0)
    header = OpenEXR.Header(WIDTH, HEIGHT)
    header["compression"] = Imath.Compression(Imath.Compression.DWAB_COMPRESSION)
    header["channels"] = {name: Imath.Channel(Imath.PixelType(Imath.PixelType.HALF)) for name in "RGB"}
    file = OpenEXR.OutputFile(sys.argv[2], header)
    file.writePixels({name: blurred[..., i].astype(np.float16).tobytes() for i, name in enumerate("RGB")})
    file.close()


if __name__ == "__main__":
    main()
