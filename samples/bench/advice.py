# SPDX-License-Identifier: MIT
"""Costs and gains of samples, filters, vertices or pixels and qualities, for scene files of nicol-render.

usage: advice.py SCENE... [--size N] [--truth N]

For each scene a table: seconds to the first picture without a cache, milliseconds of a frame after the camera has moved, and the
relative RMSE of s0 and s1 against the quality `final` with --truth samples of a pixel (default 256), over the RMS of s0."""

import argparse
import os
import statistics
import time

import nicol
import numpy

os.environ["NICOL_CACHE"] = ""  # times are without what earlier runs kept

ROWS = {
    "1 sample, vertices": {"shade_at": nicol.SHADE_AT_VERTICES},
    "1 sample, pixels": {"shade_at": nicol.SHADE_AT_PIXELS},
    "4 samples": {"pixel_samples": 4},
    "8 samples": {"pixel_samples": 8},
    "16 samples": {"pixel_samples": 16},
    "64 samples": {"pixel_samples": 64},
    "quality realtime": {"quality": nicol.QUALITY_REALTIME},
    "quality preview": {"quality": nicol.QUALITY_PREVIEW},
    "quality final": {"quality": nicol.QUALITY_FINAL},
}


def options_of(quality=None, **wanted):
    options = nicol.RenderOptions()
    if quality is not None:
        options.set_quality(quality)
    for name, value in wanted.items():
        setattr(options, name, value)
    return options


def measured(file, options, size, frames=3):
    """Returns (image, seconds of the first picture, milliseconds of a frame whose camera has moved)."""
    with nicol.Context.create() as context:  # a new one, so that nothing is kept
        begin = time.perf_counter()
        with nicol.Scene.load(context, file) as scene:
            camera = scene.get_camera()
            with nicol.Framebuffer.create(context, size, size, scene.get_channels()) as framebuffer:
                nicol.render(scene, camera, options, framebuffer)
                first = time.perf_counter() - begin
                image = framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS).astype(float)
                times = []
                for _ in range(frames):
                    camera.to_world[3] += 1e-6
                    begin = time.perf_counter()
                    nicol.render(scene, camera, options, framebuffer)
                    times.append(1000 * (time.perf_counter() - begin))
                return image, first, statistics.median(times)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("scenes", nargs="+")
    arguments.add_argument("--size", type=int, default=256)
    arguments.add_argument("--truth", type=int, default=256)
    given = arguments.parse_args()
    for file in given.scenes:
        truth, _, _ = measured(file, options_of(nicol.QUALITY_FINAL, pixel_samples=given.truth), given.size, frames=1)
        power = (truth[..., 0] ** 2).mean() ** 0.5
        print(f"\n{os.path.basename(file)}, {given.size} x {given.size}\n\n| | first picture, s | frame, ms | s0 | s1 |\n|---|---|---|---|---|")
        for name, wanted in ROWS.items():
            try:
                image, first, frame = measured(file, options_of(**wanted), given.size)
            except nicol.Error as refused:
                print(f"| {name} | refused: {refused} | | | |")
                continue
            errors = [(((image - truth)[..., p] ** 2).mean()) ** 0.5 / power for p in (0, 1)]
            print(f"| {name} | {first:.2f} | {frame:.0f} | {errors[0]:.4f} | {errors[1]:.4f} |", flush=True)


if __name__ == "__main__":
    main()
