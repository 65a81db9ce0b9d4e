# SPDX-License-Identifier: MIT
"""nicol-serve under more load than it can take, while workers are killed and scenes change.

Every body must be of the right scene and of a version that was there, a strong ETag must stand for one version alone, and at the
end no memory and no descriptors may be lost. 20 minutes: serve_soak.py build/bin/nicol-serve --seconds 1200"""

import argparse
import http.client
import os
import random
import signal
import statistics
import struct
import tempfile
import threading
import time

from serve_client import PATIENCE, Server

# A plate under uniform light. Green is half the version, and red identifies the scene.
SCENE = """<scene version="3.0.0">
  <sensor type="perspective"><float name="fov" value="30"/>
    <transform name="to_world"><lookat origin="0,0,3" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="8"/></film></sensor>
  <emitter type="constant"><rgb name="radiance" value="{version},{version},{version}"/></emitter>
  <shape type="rectangle"><transform name="to_world"><scale value="9"/></transform>
    <bsdf type="diffuse"><rgb name="reflectance" value="{red},0.5,0.1"/></bsdf></shape>
</scene>
"""
REDS = {"one": 0.2, "two": 0.4, "three": 0.8}
SIDE = 128


class Scenes:
    """The versions that may be served: the newest, and earlier ones that have not been replaced yet."""

    def __init__(self, folder):
        self.folder = folder
        self.lock = threading.Lock()
        self.valid = {name: {1} for name in REDS}
        for name in REDS:
            self.write(name, 1)

    def write(self, name, version):
        path = os.path.join(self.folder, name + ".xml")
        with open(path + ".new", "w", encoding="utf-8") as file:
            file.write(SCENE.format(version=version, red=REDS[name]))
        os.replace(path + ".new", path)

    def change(self, name):
        with self.lock:
            version = max(self.valid[name]) + 1
            self.valid[name].add(version)
        self.write(name, version)
        return version

    def settle(self, name, version):
        with self.lock:
            self.valid[name] = {version}


class Clients:
    def __init__(self, port, scenes, count):
        self.port, self.scenes = port, scenes
        self.lock = threading.Lock()
        self.statuses, self.tags, self.wrong = {}, {}, []
        self.over = threading.Event()
        self.threads = [threading.Thread(target=self.run, args=(number,)) for number in range(count)]
        for thread in self.threads:
            thread.start()

    def stop(self):
        self.over.set()
        for thread in self.threads:
            thread.join()

    def run(self, number):
        chance = random.Random(number)
        connection = None
        while not self.over.is_set():
            name = chance.choice(list(REDS))
            target = f"/scenes/{name}/stokes.f32?size={SIDE}x{SIDE}&light={chance.randrange(50)}"
            with self.scenes.lock:
                before = set(self.scenes.valid[name])
            try:
                connection = connection or http.client.HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE)
                connection.request("GET", target)
                response = connection.getresponse()
                body, tag, status = response.read(), response.getheader("ETag"), response.status
                if response.will_close:
                    connection.close()
                    connection = None
            except (http.client.HTTPException, OSError) as error:
                body, tag, status, connection = b"", None, type(error).__name__, None
            with self.scenes.lock:
                allowed = before | self.scenes.valid[name]
            with self.lock:
                self.statuses[status] = self.statuses.get(status, 0) + 1
                if status == 200:
                    self.judge(name, target, tag, body, allowed)
                elif status != 503:
                    self.wrong.append(f"{target}: {status} {body[:200]}")

    def judge(self, name, target, tag, body, allowed):
        middle = 16 * (SIDE // 2 * SIDE + SIDE // 2)
        red, green = (struct.unpack_from("<f", body, channel * 16 * SIDE * SIDE + middle)[0] for channel in (0, 1))
        version = round(2 * green)
        if abs(red / (2 * green) - REDS[name]) > 0.01:
            self.wrong.append(f"{target}: red {red}, green {green} are of another scene")
        elif version not in allowed:
            self.wrong.append(f"{target}: version {version}, where {sorted(allowed)} are there")
        elif self.tags.setdefault((target, tag), version) != version:
            self.wrong.append(f"{target}: {tag} was that of version {self.tags[target, tag]} and is that of {version}")


def of_process(pid):
    """Returns resident memory in MiB and the number of open descriptors."""
    with open(f"/proc/{pid}/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 2**20, len(os.listdir(f"/proc/{pid}/fd"))


def usage(server):
    """Returns the usage of the front process, then of all workers together, or None while a worker is being replaced."""
    try:
        workers = [of_process(pid) for pid, _ in server.workers()]
        return (*of_process(server.process.pid), *(sum(values) for values in zip(*workers)))
    except OSError:
        return None


def newest_is_served(server, name, version):
    answer = server.get(f"/scenes/{name}/stokes.f32?size=8x8")
    return answer.status == 200 and round(2 * struct.unpack_from("<f", answer.body, 16 * 8 * 8 + 16 * 36)[0]) == version


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("--seconds", type=int, default=8)
    arguments = parser.parse_args()
    chance = random.Random(1)
    with tempfile.TemporaryDirectory() as folder:
        scenes = Scenes(folder)
        workers, queue = os.cpu_count(), 2 * os.cpu_count()
        server = Server(arguments.program, folder, "--workers", str(workers), "--queue", str(queue), "--results", "0")
        samples, changes, kills = [usage(server)], 0, 0
        clients = Clients(server.port, scenes, 4 * (workers + queue))
        try:
            end = time.monotonic() + arguments.seconds
            while time.monotonic() < end or changes < 2:
                name = chance.choice(list(REDS))
                version = scenes.change(name)
                changes += 1
                # A restarted worker reads the scenes again, and then all workers do.
                os.kill(chance.choice(server.workers())[0], signal.SIGKILL)
                kills += 1
                server.wait(lambda: newest_is_served(server, name, version))  # noqa: B023
                server.wait(lambda: len(server.workers()) == workers and usage(server) is not None)
                scenes.settle(name, version)
                samples.append(usage(server) or samples[-1])
        finally:
            clients.stop()
        server.wait(lambda: all(state == "idle" for _, state in server.workers()))
        last = usage(server)
        server.stop()
    print(f"{sum(clients.statuses.values())} requests {clients.statuses}, {changes} changes, {kills} workers killed")
    half = len(samples) // 2
    for text, at in (("front MiB", 0), ("front descriptors", 1), ("workers MiB", 2), ("workers descriptors", 3)):
        early, late = (statistics.median(sample[at] for sample in part) for part in (samples[:half], samples[half:]))
        print(f"{text}: first half {early:.1f}, second half {late:.1f}, at rest {last[at]:.1f}")
        # Memory kept by allocators does not grow, while lost memory keeps growing.
        if half > 20 and late > 1.1 * early + 8:
            clients.wrong.append(f"{text} grew")
    if last[1] > samples[0][1] + 4 or last[3] > samples[0][3] + 4:
        clients.wrong.append("descriptors were lost")
    if not clients.statuses.get(200) or clients.wrong:
        raise SystemExit("\n".join(clients.wrong[:20]) or "no image at all")


if __name__ == "__main__":
    main()
