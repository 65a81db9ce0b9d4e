# SPDX-License-Identifier: MIT
"""Prints how many pictures of 512 x 512 a minute nicol-dataset makes, and the processor time of each: of a scene whose shadows
are known, with files (mosaic PNG, Stokes EXR) and without, and with a new object and light in each. --nodes: instead, new
objects by one program and by two, each on a core of its own, as a cluster's nodes of one core are. --memory: instead, N pictures
of 32 x 32 as arrays, with a new object, material and light every 100, and the memory of the process after each tenth of them.
usage: rates.py [--frames N] [--nodes | --memory]"""

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time

from nicol.dataset import Dataset, Recipe, Renderer
from nicol.dataset.folder import Folder
from nicol.dataset.program import render

HERE = os.path.dirname(os.path.abspath(__file__))


def measured(label, renderer, folder, frames):
    start, used = time.monotonic(), time.process_time()
    render(renderer, folder, frames)
    seconds, used = time.monotonic() - start, time.process_time() - used
    print(f"{label:42} {60 * len(frames) / seconds:7,.0f} a minute {1000 * used / len(frames):7,.0f} ms of processor time each")


def children_used():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def nodes(parts, count):
    """Renders count frames for each of the parts, pairs of a core and the number of its frames' part, and returns pictures a
    minute, by the clock and by processor time alone."""
    command = [sys.executable, "-m", "nicol.dataset", os.path.join(HERE, "random.json"), "--threads", "1"]
    with tempfile.TemporaryDirectory() as place:
        start, used = time.monotonic(), children_used()
        programs = [
            subprocess.Popen(
                [*command, "--output", place, "--frames", f"{part * count}:{(part + 1) * count}"],
                preexec_fn=lambda core=core: os.sched_setaffinity(0, {core}), stdout=subprocess.DEVNULL,
            )
            for core, part in parts
        ]  # fmt: skip
        if any([program.wait() for program in programs]):
            sys.exit("a program failed")
        seconds, used = time.monotonic() - start, children_used() - used
    return 60 * count * len(parts) / seconds, 60 * count * len(parts) / (used / len(parts))


def compare_nodes(count):
    cores = sorted(os.sched_getaffinity(0))[:2]
    if len(cores) < 2:
        sys.exit("two nodes need two cores")
    # In turn, because other programs of the machine then disturb both in the same way. A core has the same frames, alone or
    # not, because some take longer than others. One picture each is a trial, for which one round is enough.
    parts = list(zip(cores, range(2)))
    rounds = [(nodes([part], count), nodes(parts, count)) for part in parts * min(count, 2)]
    one, two = (tuple(statistics.median(part) for part in zip(*half)) for half in zip(*rounds))
    print(f"one node of one core  {one[0]:7,.0f} a minute {one[1]:7,.0f} a minute of processor time")
    print(f"two nodes             {two[0]:7,.0f} a minute {two[1]:7,.0f} a minute of processor time on both")
    print(f"two nodes over twice one node: {two[0] / one[0] / 2:.2f}, by processor time {two[1] / one[1] / 2:.2f}; medians of {len(rounds)}")


def resident():
    """Returns the memory of this process in MB."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / 1e6


def watch_memory(count):
    dataset = Dataset(os.path.join(HERE, "small.json"), range(count), ["mosaic", "stokes", "normals"])
    step = max(1, count // 10)
    for number, _ in enumerate(dataset, 1):
        if number % step == 0:
            print(f"{number:8,} pictures {resident():7.1f} MB", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--frames", type=int, default=200)
    instead = parser.add_mutually_exclusive_group()
    instead.add_argument("--nodes", action="store_true")
    instead.add_argument("--memory", action="store_true")
    given = parser.parse_args()
    count = given.frames
    if given.nodes:
        compare_nodes(max(1, count // 10))
        return
    if given.memory:
        watch_memory(count)
        return
    recipe = Recipe(os.path.join(HERE, "orbit.json"))
    renderer = Renderer(recipe)
    last = min(count, recipe.views) - 1
    render(renderer, None, [*range(0, last, 5), last])  # bakes what the views show
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
