# SPDX-License-Identifier: MIT
"""Draws error over time: Nicol's methods by order and Mitsuba 3 by samples a pixel, for a snail in a forest, direct light of one channel.

usage: error_over_time.py NICOL-BENCH OUT.svg [--size N] [--samples N] [--orders A-B]"""

import argparse
import pathlib
import subprocess
import tempfile

import mitsuba_contest as contest
import nicol
import peer_mitsuba as peer

SCENE = "snail in a forest"


def mitsuba_curve(scene_file, inner):
    """Returns (samples, milliseconds, errors of s0, s1, s2): the noise of an image inside surfaces, over the RMS of s0."""
    scene = peer.mitsuba_scene(scene_file)
    curve = []
    for samples in (4, 16, 64, 256):
        peer.mitsuba_image(scene, samples, 0)  # compiles the kernel
        (a, _), (b, seconds) = (contest.timed(lambda seed=seed: peer.mitsuba_image(scene, samples, seed)[inner]) for seed in (1, 2))  # noqa: B023
        noise = (((a - b) ** 2 / 2).mean(0)[:3] / (a[:, 0] * b[:, 0]).mean()) ** 0.5
        curve.append((samples, 1e3 * seconds[0], *noise))
    return curve


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bench")
    parser.add_argument("output")
    parser.add_argument("--size", type=int, default=512, help="images of N x N")
    parser.add_argument("--samples", type=int, default=256, help="a pixel, of each of the reference's two images")
    parser.add_argument("--orders", default="1-9")
    arguments = parser.parse_args()
    peer.choose_variant()
    version = f"Mitsuba {peer.mitsuba.__version__} by samples a pixel"
    with tempfile.TemporaryDirectory() as folder:
        scene_file = contest.write_scene(folder, SCENE, arguments.size)
        with nicol.Context.create() as context:
            inner = contest.Show(context, scene_file, {}).inner()
        curve = mitsuba_curve(scene_file, inner)
        lines = [",".join(f"{value:g}" for value in point) for point in curve]
        print(version, *lines, sep="\n", flush=True)
        peer_file = pathlib.Path(folder, "mitsuba.csv")
        peer_file.write_text("\n".join([version, *lines]) + "\n")
        subprocess.run(
            [arguments.bench, "pareto", scene_file, "--size", str(arguments.size), "--samples", str(arguments.samples),
             "--orders", arguments.orders, "--peer", peer_file, "--plot", arguments.output], check=True)  # fmt: skip


if __name__ == "__main__":
    main()
