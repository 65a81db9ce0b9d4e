# SPDX-License-Identifier: MIT
"""A table of scene files that Mitsuba 3 and Nicol render: errors in R, G, B over their root mean square, and time.

usage: mitsuba_scenes.py SCENE.xml... [--samples N]. The integrator must be a `path` of max_depth 2 or another of direct light;
Mitsuba's mode is the fastest with colours, which has no polarization."""

import argparse
import os
import pathlib
import time

import nicol
import numpy
import peer_mitsuba as peer

os.environ["NICOL_CACHE"] = ""  # times are without what earlier runs kept


def timed(work):
    """Returns (result, seconds) of the second run, when everything is prepared."""
    work()
    begin = time.perf_counter()
    return work(), time.perf_counter() - begin


def mitsuba_images(scene_file, samples):
    scene = peer.mitsuba.load_file(str(scene_file))
    image = lambda seed: numpy.array(peer.mitsuba.render(scene, spp=samples, seed=seed), dtype=float)[:, :, :3]  # noqa: E731
    b, seconds = timed(lambda: image(2))
    return image(1), b, seconds


def nicol_image(context, scene_file, **options):
    """Returns (image, seconds). The camera moves slightly before each frame, so that there is something to draw."""
    with nicol.Scene.load(context, str(scene_file)) as scene:
        camera = scene.get_camera()
        with nicol.Framebuffer.create(context, *scene.get_film_size(), scene.get_channels()) as framebuffer:

            def render():
                camera.to_world[3] += 1e-6
                nicol.render(scene, camera, nicol.RenderOptions(**options), framebuffer)

            _, seconds = timed(render)
            return framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS)[..., 0].astype(float), seconds


def row(context, scene_file, samples):
    by_rays, _ = nicol_image(context, scene_file, method=nicol.METHOD_REFERENCE, samples=samples)
    default, frame = nicol_image(context, scene_file)
    a, b, seconds = mitsuba_images(scene_file, samples)
    error = lambda image: max(0, ((image - a) * (image - b)).mean() / (a * b).mean()) ** 0.5  # noqa: E731
    noise = (((a - b) ** 2).mean() / 2 / (a * b).mean()) ** 0.5
    return f"{error(by_rays):.4f} | {error(default):.4f} | {1e3 * frame:.1f} ms | {noise:.4f} | {1e3 * seconds:.1f} ms"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    parser.add_argument("--samples", type=int, default=1024, help="a pixel, of Mitsuba and of the reference method")
    arguments = parser.parse_args()
    peer.choose_variant(colors=True)
    n = arguments.samples
    print(f"| scene | reference method, {n} samples | default | a frame | Mitsuba, {n} samples: its noise | its time |\n|---|---|---|---|---|---|")
    with nicol.Context.create() as context:
        for scene_file in arguments.scenes:
            try:
                print(f"| {scene_file.stem} | {row(context, scene_file, n)} |", flush=True)
            except nicol.Error as refused:
                print(f"| {scene_file.stem} | not read: {str(refused).split(': ', 1)[-1].split(';')[0]} | | | | |", flush=True)


if __name__ == "__main__":
    main()
