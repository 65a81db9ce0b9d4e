# SPDX-License-Identifier: MIT
"""Errors of pictures by default, as nicol-render makes them, against the references of Mitsuba's own render tests.

usage: mitsuba_tests.py FOLDER, the folder with test_*_path.xml and refs/test_*_ref_rgb.exr (resources/data/tests/scenes/bsdf_spheres)

Errors are those of R, G, B over the root mean square of the reference, whose noise, about 1 %, is in them."""

import os
import pathlib
import sys
import time

import nicol
import numpy
import peer_mitsuba as peer

os.environ["NICOL_CACHE"] = ""  # times are without what earlier runs kept


def read(file):
    return numpy.array(peer.mitsuba.Bitmap(str(file)), dtype=float)[..., :3]


def default_picture(context, file):
    """Returns (image, samples of a pixel, seconds)."""
    begin = time.perf_counter()
    with nicol.Scene.load(context, str(file)) as scene:
        samples = min(64, scene.get_sample_count() or 8)
        with nicol.Framebuffer.create(context, *scene.get_film_size(), scene.get_channels()) as framebuffer:
            options = nicol.RenderOptions(pixel_samples=samples, filter=scene.get_filter())
            nicol.render(scene, scene.get_camera(), options, framebuffer)
            return framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS)[..., 0].astype(float), samples, time.perf_counter() - begin


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    peer.choose_variant(colors=True)
    folder = pathlib.Path(sys.argv[1])
    print("| scene | samples of a pixel | error | first picture |\n|---|---|---|---|")
    errors = []
    for file in sorted(folder.glob("test_*_path.xml")):
        name = file.stem.removesuffix("_path")
        try:
            with nicol.Context.create() as context:  # a new one, so that nothing is kept
                image, samples, seconds = default_picture(context, file)
        except nicol.Error as refused:
            print(f"| {name} | | not read: {str(refused).split(': ', 1)[-1]} | |")
            continue
        truth = read(folder / "refs" / f"{name}_ref_rgb.exr")
        errors.append((((image - truth) ** 2).mean() / (truth**2).mean()) ** 0.5)
        print(f"| {name} | {samples} | {100 * errors[-1]:.1f} % | {seconds:.2f} s |", flush=True)
    print(f"\n{sum(error < 0.05 for error in errors)} of {len(errors)} within 5 %.")


if __name__ == "__main__":
    main()
