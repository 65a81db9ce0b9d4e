# SPDX-License-Identifier: MIT
"""Prints how many pictures of 512 x 512 a minute nicol-dataset makes, and the processor time of each: of a scene whose shadows
are known, with files (mosaic PNG, Stokes EXR) and without, and with a new object and light in each.
usage: rates.py [--frames N]"""

import argparse
import os
import tempfile
import time

from nicol.dataset import Recipe, Renderer
from nicol.dataset.folder import Folder
from nicol.dataset.program import render

HERE = os.path.dirname(os.path.abspath(__file__))


def measured(label, renderer, folder, frames):
    start, used = time.monotonic(), time.process_time()
    render(renderer, folder, frames)
    seconds, used = time.monotonic() - start, time.process_time() - used
    print(f"{label:42} {60 * len(frames) / seconds:7,.0f} a minute {1000 * used / len(frames):7,.0f} ms of processor time each")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--frames", type=int, default=200)
    count = parser.parse_args().frames
    recipe = Recipe(os.path.join(HERE, "orbit.json"))
    renderer = Renderer(recipe)
    render(renderer, None, range(0, recipe.views, 5))  # bakes what the views show
    with tempfile.TemporaryDirectory() as place:
        with Folder(place, recipe) as folder:
            measured("one scene, mosaic PNG and Stokes EXR", renderer, folder, range(count))
    measured("one scene, without files", renderer, None, range(count))
    recipe = Recipe(os.path.join(HERE, "random.json"))
    with tempfile.TemporaryDirectory() as place:
        with Folder(place, recipe) as folder:
            measured("a new object and light in each", Renderer(recipe), folder, range(max(1, count // 10)))


if __name__ == "__main__":
    main()
