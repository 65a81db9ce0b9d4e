# SPDX-License-Identifier: MIT
# A test of two nicol-serve behind haproxy, one of which is killed under load. The command line: the program, haproxy's
# configuration.
import http.client
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from serve_client import PATIENCE, Server, write_scenes

PROGRAM, RECIPE = os.path.abspath(sys.argv.pop(1)), os.path.abspath(sys.argv.pop(1))


@unittest.skipUnless(shutil.which("haproxy"), "no haproxy here")
class Instances(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        write_scenes(folder.name)
        # The instances share a cache, so the second one finds the baked results of the first.
        self.servers = [Server(PROGRAM, folder.name, "--workers", "1") for _ in range(2)]
        for server in self.servers:
            self.addCleanup(server.stop)
        with socket.create_server(("127.0.0.1", 0)) as probe:
            self.port = probe.getsockname()[1]
        names = {name: f"127.0.0.1:{port}" for name, port in
                 (("NICOL_FRONT", self.port), ("NICOL_A", self.servers[0].port), ("NICOL_B", self.servers[1].port))}  # fmt: skip
        haproxy = subprocess.Popen(["haproxy", "-db", "-f", RECIPE], env={**os.environ, **names}, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)  # fmt: skip
        self.addCleanup(haproxy.wait)
        self.addCleanup(haproxy.kill)
        end = time.monotonic() + PATIENCE
        while self.ask("/ready") != 200:
            self.assertLess(time.monotonic(), end)

    def ask(self, target):
        """Returns the status, or 0 if the connection fails."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE)
        try:
            connection.request("GET", target)
            response = connection.getresponse()
            response.read()
            return response.status
        except (OSError, http.client.HTTPException):
            return 0
        finally:
            connection.close()

    def test_one_is_killed_under_load(self):
        statuses, stop = [], threading.Event()

        def load(client):
            number = 0
            while not stop.is_set():
                number += 1
                target = f"/scenes/box/image.png?size=64x48&azimuth={number % 360}&elevation={client}"
                first = self.ask(target)
                # A client retries once after a 503 or a failed connection.
                statuses.append(first if first == 200 else self.ask(target))

        clients = [threading.Thread(target=load, args=(client,)) for client in range(4)]
        for client in clients:
            client.start()
        try:
            for server in self.servers:
                server.wait(lambda server=server: server.metric("renders_total") >= 20)
            self.servers[0].process.send_signal(signal.SIGKILL)
            self.servers[0].process.wait()
            done = len(statuses)
            self.servers[1].wait(lambda: len(statuses) >= done + 100)
        finally:
            stop.set()
            for client in clients:
                client.join()
        self.assertEqual(set(statuses), {200})
        self.assertEqual(self.ask("/metrics"), 404)


if __name__ == "__main__":
    unittest.main()
