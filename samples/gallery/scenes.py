#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Renders a scene of the gallery: s0, the DoLP, and the light behind a polarizer, side by side and each by itself.

usage: scenes.py NAME... [-o FOLDER] [--size WIDTHxHEIGHT] [--samples N]
"""

import argparse
import importlib
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), "python"))

import gallery  # noqa: E402
import nicol  # noqa: E402
import numpy as np  # noqa: E402

NAMES = "car_lamp", "beetle", "still_life", "wet_street", "ruler", "gold_bowl", "bubbles"


def toned(light):
    """Returns light with soft highlights, encoded for a screen."""
    white = 6.0
    return gallery.tone_mapped(light * (1 + light / white**2) / (1 + light) * 1.35)


def panels(stokes, view):
    """Returns the images s0, DoLP, and behind the polarizer, one stop brighter than an ideal one leaves it."""
    s0, s1, s2, s3 = np.moveaxis(stokes * 2**view.exposure, -1, 0)
    angle = np.radians(2 * view.polarizer)
    through = s0 + view.circular * s3 if view.circular else s0 + np.cos(angle) * s1 + np.sin(angle) * s2
    degree = gallery.dolp(stokes)
    return toned(s0), gallery.tone_mapped(degree), toned(np.maximum(through, 0))


def smaller(image, times):
    height, width = (side // times for side in image.shape[:2])
    return image[: height * times, : width * times].reshape(height, times, width, times, -1).mean((1, 3))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="+", choices=NAMES, metavar="NAME", help=", ".join(NAMES))
    parser.add_argument("-o", "--output", default=".", metavar="FOLDER")
    parser.add_argument("--size", default="1920x1080", metavar="WIDTHxHEIGHT")
    parser.add_argument("--samples", type=int, default=16, help="of each pixel, default 16")
    given = parser.parse_args()
    size = tuple(map(int, given.size.split("x")))
    os.makedirs(given.output, exist_ok=True)
    with nicol.Context.create() as context:
        for name in given.names:
            view = importlib.import_module(name).make_view(context)
            images = panels(view.render(size, given.samples), view)
            path = os.path.join(given.output, name)
            for kind, image in zip(("s0", "dolp", "polarizer"), images):
                gallery.write_png(f"{path}_{kind}.png", image)
            gallery.write_png(path + ".png", gallery.sheet([[smaller(image, max(1, size[0] // 640)) for image in images]]))


if __name__ == "__main__":
    main()
