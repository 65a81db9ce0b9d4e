# SPDX-License-Identifier: MIT
"""Load that nicol-serve takes on this machine: images a second at its capacity and beyond, latency, memory.

Fails where an answer is neither an image nor a 503 that says when to come again. With --library the service is compared with the
bare renderer in one process, the two taking turns."""

import argparse
import json
import math
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

from serve_client import Server, write_scenes

HERE = os.path.dirname(os.path.abspath(__file__))


def wrk(server, target, connections, seconds, pause=0):
    run = subprocess.run(
        ["wrk", "-t1", f"-c{connections}", f"-d{seconds}s", "--timeout", "60s", "-s", os.path.join(HERE, "serve_load.lua"),
         f"http://127.0.0.1:{server.port}"],
        env={**os.environ, "SERVE_TARGET": target, "SERVE_PAUSE": str(pause)}, capture_output=True, text=True, check=True)  # fmt: skip
    result = json.loads(next(line[5:] for line in run.stdout.splitlines() if line.startswith("JSON ")))
    if result["wrong"] or result["untold"] or result["broken"]:
        raise AssertionError(f"{connections} connections: {result}; {server.errors()}")
    result["rate"] = (result["requests"] - result["refused"]) / result["seconds"]
    return result


class Bare:
    """The renderer in this process: it sets the camera, renders and reads s0, frame by frame."""

    def __init__(self, library, scene, size, cache):
        os.environ["NICOL_LIBRARY"] = library
        sys.path.insert(0, os.path.join(HERE, "..", "..", "samples", "python"))
        import nicol

        self.nicol = nicol
        self.context = nicol.Context.create(nicol.ContextOptions(cache_folder=cache))
        self.scene = nicol.Scene.load(self.context, scene)
        self.framebuffer = nicol.Framebuffer.create(self.context, size, size, self.scene.get_channels())
        self.camera = self.scene.get_camera()
        self.number = 0
        self.rate(0.1)

    def rate(self, seconds):
        """Returns frames per second."""
        frames, start, own = 0, time.monotonic(), list(self.camera.to_world)
        while time.monotonic() - start < seconds:
            self.number += 1
            angle = self.number * 2.4
            c, s = math.cos(angle), math.sin(angle)
            matrix = list(own)
            for column in range(4):
                matrix[column] = c * own[column] + s * own[8 + column]
                matrix[8 + column] = c * own[8 + column] - s * own[column]
            camera = self.nicol.Camera(projection=self.camera.projection, fov=self.camera.fov)
            camera.to_world = matrix
            self.nicol.render(self.scene, camera, None, self.framebuffer)
            # Reading the plane completes drawing that may be outstanding.
            self.framebuffer.plane(self.nicol.PLANE_S0, 0)
            frames += 1
        return frames / (time.monotonic() - start)


def resident(pid):
    with open(f"/proc/{pid}/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 2**20


def memory(server):
    """Returns the memory of the front process and of all workers together, in MiB."""
    return resident(server.process.pid), sum(resident(pid) for pid, _ in server.workers())


def compare(server, target, bare, rounds, seconds, workers):
    ratios, bare_rates, rates = [], [], []
    for _ in range(rounds):
        bare_rates.append(bare.rate(seconds))
        rates.append(wrk(server, target, 2 * workers, seconds)["rate"])
        ratios.append(rates[-1] / bare_rates[-1])
    print(f"bare renderer {statistics.median(bare_rates):.1f} frames/s, service {statistics.median(rates):.1f} images/s, "
          f"ratio {statistics.median(ratios):.2f} (median of {rounds})")  # fmt: skip


def load(server, target, seconds, workers, queue):
    full = wrk(server, target, workers + queue, seconds)
    # Each connection rests as long as its image takes, or twice as long if all connections were to work.
    half = wrk(server, target, workers, seconds, pause=round(1000 * workers / full["rate"]))
    beyond = wrk(server, target, 4 * (workers + queue), seconds)
    for name, result in (("half load", half), ("1x", full), ("4x", beyond)):
        print(f"{name}: {result['rate']:.1f} images/s, 503: {100 * result['refused'] / max(1, result['requests']):.1f} %, "
              f"p50 {result['p50']:.0f} ms, p99 {result['p99']:.0f} ms")  # fmt: skip


def growth(server, scene, requests):
    """Requests images of all formats and observers, after a first batch that fills the caches, and prints the memory
    growth."""
    def ask(first, count):
        for number in range(first, first + count):
            name = ("image.png", "image.exr", "stokes.f16", "stokes.exr")[number % 4 if number % 40 < 4 else 0]
            observer = f"&observer={('s0', 's1', 'dolp', 'aolp')[number % 4]}" if name.startswith("image") else ""
            light = f"&light={number % 360}" if number % 10 == 0 else ""
            answer = server.get(f"/scenes/{scene}/{name}?size={64 + number % 3}x48&azimuth={number * 0.036 % 360:.3f}{observer}{light}")
            if answer.status != 200:
                raise AssertionError(f"{answer.status}: {answer.body}")
    ask(0, min(500, requests))
    before = memory(server)
    ask(500, requests)
    after = memory(server)
    print(f"{requests} requests: front {before[0]:.1f} -> {after[0]:.1f} MiB, workers {before[1]:.1f} -> {after[1]:.1f} MiB")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("--scenes", help="a folder; without it small scenes of its own")
    parser.add_argument("--scene", default="box", help="which of them, default box")
    parser.add_argument("--size", type=int, default=512, help="of the images, default 512")
    parser.add_argument("--seconds", type=int, default=1, help="of each measurement, default 1")
    parser.add_argument("--rounds", type=int, default=5, help="of the comparison with the bare renderer, default 5")
    parser.add_argument("--library", type=os.path.abspath, help="libnicol.so, of the bare renderer")
    parser.add_argument("--requests", type=int, default=0, help="to look for growth of memory")
    arguments = parser.parse_args()
    if not shutil.which("wrk"):
        print("skipped: no wrk here")
        sys.exit(77)
    workers, queue = os.cpu_count(), 2 * os.cpu_count()
    target = f"/scenes/{arguments.scene}/image.png?size={arguments.size}x{arguments.size}"
    with tempfile.TemporaryDirectory() as folder:
        if arguments.scenes:
            for name in os.listdir(arguments.scenes):
                os.symlink(os.path.abspath(os.path.join(arguments.scenes, name)), os.path.join(folder, name))
        else:
            write_scenes(folder)
        # --results 0 prevents answers from memory to repeated requests.
        server = Server(arguments.program, folder, "--workers", str(workers), "--queue", str(queue), "--results", "0")
        try:
            front, all_workers = memory(server)
            print(f"warm: front {front:.1f} MiB, {workers} workers {all_workers:.1f} MiB, "
                  f"{len(server.get('/scenes').json()['scenes'])} scenes")  # fmt: skip
            load(server, target, arguments.seconds, workers, queue)
            if arguments.library:
                scene = os.path.join(folder, arguments.scene + ".xml")
                bare = Bare(arguments.library, scene, arguments.size, os.path.join(folder, "cache"))
                compare(server, target, bare, arguments.rounds, arguments.seconds, workers)
            if arguments.requests:
                growth(server, arguments.scene, arguments.requests)
        finally:
            server.stop()


if __name__ == "__main__":
    main()
