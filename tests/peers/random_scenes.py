# SPDX-License-Identifier: MIT
"""Random scenes by default against rays, and rays against Mitsuba 3: errors of s0 and of s1, s2 relative to the root mean square
of s0, without noise.

usage: random_scenes.py ASSETS [--count N] [--first SEED] [--without KIND ...] [--mitsuba] [--keep FOLDER]
ASSETS: the folder samples/assets. --mitsuba compares rays with Mitsuba instead. --keep writes the ten worst scenes."""

import argparse
import pathlib
import sys
import tempfile

try:
    import numpy
    import peer_mitsuba as peer
except ModuleNotFoundError as absent:
    print(f"skipped: {sys.executable} has no module {absent.name}; NICOL_PEER_PYTHON names an interpreter that has mitsuba and numpy")
    sys.exit(77)

import nicol
import random_scene

RAYS = {"method": nicol.METHOD_REFERENCE, "samples": 256}
DEFAULT = {"pixel_samples": 8}
# Largest errors of s0: the 90th percentile and the worst scene.
BY_DEFAULT = (0.015, 0.05)
MITSUBA = (0.01, 0.03)


def nicol_image(context, scene_file, seed, options):
    """Renders in one context, which keeps the tables of materials from image to image."""
    with nicol.Scene.load(context, str(scene_file)) as scene:
        with nicol.Framebuffer.create(context, *scene.get_film_size(), scene.get_channels()) as framebuffer:
            nicol.render(scene, scene.get_camera(), nicol.RenderOptions(seed=seed, **options), framebuffer)
            return peer.nicol_stokes(framebuffer)


def errors(ours, truth):
    """Returns the root mean squared errors of s0, and of s1 and s2, without noise."""
    with numpy.errstate(invalid="ignore", divide="ignore"):
        squares, _ = peer.squared_error(ours, truth)
    # Of pictures without light, the quotient is undefined.
    roots = numpy.sqrt(numpy.maximum(numpy.nan_to_num(squares), 0))
    return roots[0], max(roots[1], roots[2])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("assets", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--without", nargs="*", default=(), choices=("brushed", "narrow"))
    parser.add_argument("--mitsuba", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path)
    asked = parser.parse_args()
    if asked.mitsuba:
        print(f"Mitsuba {peer.mitsuba.__version__}, {peer.choose_variant()}")
    found = []
    with tempfile.TemporaryDirectory() as folder, nicol.Context.create() as context:
        file = pathlib.Path(folder) / "scene.xml"
        for seed in range(asked.first, asked.first + asked.count):
            scene = random_scene.RandomScene(seed, asked.assets.resolve(), asked.without)
            file.write_text(scene.text)
            try:
                truth = [nicol_image(context, file, n, RAYS) for n in (1, 2)]
                if asked.mitsuba:
                    loaded = peer.mitsuba_scene(file)
                    error = errors(truth, [peer.mitsuba_image(loaded, RAYS["samples"], n) for n in (1, 2)])
                else:
                    error = errors([nicol_image(context, file, n, DEFAULT) for n in (3, 4)], truth)
            except nicol.Error as refused:
                print(f"{seed}: refused: {refused}", flush=True)
                error = (numpy.inf, numpy.inf)
            found.append((*error, seed, scene))
            print(f"{seed}: {error[0]:.4f} {error[1]:.4f}", flush=True)
    found.sort(key=lambda of: -of[0])
    print("the worst:")
    for s0, polarized, seed, scene in found[:10]:
        print(f"  {s0:.4f} {polarized:.4f} seed {seed}, {scene.words}")
        if asked.keep:
            asked.keep.mkdir(parents=True, exist_ok=True)
            (asked.keep / f"{seed}.xml").write_text(scene.text)
    s0 = numpy.array([of[0] for of in found])
    p90, worst = numpy.quantile(s0, 0.9, method="lower"), s0.max()
    print(f"{len(s0)} scenes: median {numpy.median(s0):.4f}, 90th percentile {p90:.4f}, worst {worst:.4f}")
    limits = MITSUBA if asked.mitsuba else BY_DEFAULT
    sys.exit(0 if p90 <= limits[0] and worst <= limits[1] else 1)


if __name__ == "__main__":
    main()
