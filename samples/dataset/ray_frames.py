# SPDX-License-Identifier: MIT
"""Renders frames of a recipe as tasks of Ray; a task whose worker dies is given to another one.
usage: ray_frames.py RECIPE OUTPUT FRAMES [--each N] [--address ADDRESS]

RECIPE and OUTPUT are on a file system that all machines share."""

import argparse

import ray


@ray.remote(num_cpus=1, max_retries=-1)
def render(recipe, output, first, end):
    """Renders frames first to end - 1."""
    from nicol.dataset import program

    code = program.main([recipe, "--frames", f"{first}:{end}", "--output", output, "--threads", "1"])
    if code:
        raise RuntimeError(f"frames {first} to {end - 1} failed; the worker's errors say why")
    return end - first


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("recipe")
    parser.add_argument("output")
    parser.add_argument("frames", type=int)
    parser.add_argument("--each", type=int, default=50, help="frames of a task")
    parser.add_argument("--address", help="of a cluster; default: this machine alone")
    given = parser.parse_args()
    ray.init(address=given.address)
    starts = range(0, given.frames, given.each)
    tasks = [render.remote(given.recipe, given.output, first, min(first + given.each, given.frames)) for first in starts]
    print(f"{sum(ray.get(tasks))} frames are in {given.output}")


if __name__ == "__main__":
    main()
