# SPDX-License-Identifier: MIT
"""A nicol-serve process for tests, and its client."""

import http.client
import json
import os
import signal
import subprocess
import time

# Every step is short, but a machine under load may take longer.
PATIENCE = 60

SCENE = """<scene version="3.0.0">
  <default name="light_angle" value="0"/>
  <sensor type="perspective">
    <float name="fov" value="40"/>
    <transform name="to_world"><lookat origin="1,0.5,4" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="24"/><integer name="height" value="16"/></film>
  </sensor>
  <emitter type="sky">
    <vector name="sun_direction" x="0.6" y="0.5" z="0.6"/><rgb name="radiance" value="0.4,0.5,{blue}"/>
    <transform name="to_world"><rotate y="1" angle="$light_angle"/></transform>
  </emitter>
  <shape type="{shape}"><bsdf type="pplastic"><float name="alpha" value="0.3"/></bsdf></shape>
</scene>
"""


def write_scenes(folder):
    for name, shape in (("square", "rectangle"), ("box", "cube")):
        with open(os.path.join(folder, name + ".xml"), "w", encoding="utf-8") as file:
            file.write(SCENE.format(shape=shape, blue=0.9))


class Answer:
    def __init__(self, response):
        self.status, self.body = response.status, response.read()
        self.headers = {name.lower(): value for name, value in response.getheaders()}

    def json(self):
        return json.loads(self.body)


class Server:
    """A server that runs until stop(). It may still be warming up after construction if `ready` is false."""

    status_port = None  # port of --status-listen

    def __init__(self, program, folder, *options, ready=True):
        self.log = open(os.path.join(folder, "log"), "a+", encoding="utf-8")
        cache = os.path.join(folder, "cache")
        self.process = subprocess.Popen(
            [program, "--scenes", folder, "--listen", "127.0.0.1:0", "--cache", cache,
             "--slow-scene", str(PATIENCE), *options],
            stdout=subprocess.PIPE, stderr=self.log, stdin=subprocess.DEVNULL, text=True)  # fmt: skip
        line = self.process.stdout.readline()
        if "http://" not in line:
            raise AssertionError(f"{line!r}: {self.errors()}")
        self.port = int(line.rsplit(":", 1)[1])
        if "--status-listen" in options:
            self.status_port = int(self.process.stdout.readline().rsplit(":", 1)[1])
        if ready:
            self.wait(lambda: self.get("/ready").status == 200)
            workers = self.workers()
            self.wait(lambda: all(state == "idle" for _, state in self.workers()) or not workers)

    def errors(self):
        self.log.seek(0)
        return self.log.read()

    def wait(self, condition):
        """Waits until the condition holds. Fails if it does not hold in time."""
        end = time.monotonic() + PATIENCE
        while not condition():
            if time.monotonic() > end or self.process.poll() is not None:
                raise AssertionError(f"never came: {self.errors()}")
            time.sleep(0.01)  # leaves the processors to the server

    def connect(self, port=None, source=None):
        """Returns a connection. `source` is its local address, any of 127.0.0.0/8."""
        return http.client.HTTPConnection("127.0.0.1", port or self.port, timeout=PATIENCE, source_address=source and (source, 0))

    def ask(self, target, method="GET", port=None, source=None, **headers):
        """Sends a request. answer() fetches its answer."""
        connection = self.connect(port, source)
        connection.request(method, target, headers={name.replace("_", "-"): value for name, value in headers.items()})
        return connection

    @staticmethod
    def answer(connection):
        answer = Answer(connection.getresponse())
        connection.close()
        return answer

    def get(self, target, method="GET", port=None, source=None, **headers):
        return self.answer(self.ask(target, method, port, source, **headers))

    def metrics(self):
        """Returns the metrics as name with labels -> value."""
        lines = self.get("/metrics", port=self.status_port).body.decode().splitlines()
        return {line.rsplit(" ", 1)[0][len("nicol_serve_") :]: float(line.rsplit(" ", 1)[1]) for line in lines if line[0] != "#"}

    def metric(self, name):
        return self.metrics()[name]

    def workers(self):
        """Returns the process id and state of each worker."""
        found = [name for name in self.metrics() if name.startswith("worker{")]
        label = lambda name, key: name.split(key + '="')[1].split('"')[0]  # noqa: E731
        return [(int(label(name, "pid")), label(name, "state")) for name in sorted(found)]

    def signal_workers(self, number):
        for pid, _ in self.workers():
            os.kill(pid, number)

    def stop(self):
        try:
            self.signal_workers(signal.SIGCONT)
        except OSError:
            pass  # the server is already ending
        if self.process.poll() is None:
            self.process.terminate()
        code = self.process.wait(PATIENCE)
        self.process.stdout.close()
        self.log.close()
        return code
