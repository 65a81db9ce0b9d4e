# SPDX-License-Identifier: MIT
# nicol-serve as a client meets it. The command line: the program, nicol-render, then what unittest takes.
import hashlib
import hmac
import json
import os
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest

from serve_client import PATIENCE, Server, write_scenes
from serve_pictures import read_exr, read_png

PROGRAM, RENDER = os.path.abspath(sys.argv.pop(1)), os.path.abspath(sys.argv.pop(1))
SQUARE = "/scenes/square/"
IMAGE = SQUARE + "image.png?size=32x24"


def read(path):
    with open(path, "rb") as file:
        return file.read()


def alive(pid):
    """Whether the process is there, and more than what its parent has yet to wait for."""
    try:
        return b" Z " not in read(f"/proc/{pid}/stat")
    except OSError:
        return False


class ServeTest(unittest.TestCase):
    options = ()

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        write_scenes(cls.folder)
        cls.server = Server(PROGRAM, cls.folder, *cls.options)
        cls.addClassCleanup(cls.server.stop)

    def assert_problem(self, answer, status, parameter=None, words=""):
        self.assertEqual(answer.status, status, answer.body)
        self.assertEqual(answer.headers["content-type"], "application/problem+json")
        problem = answer.json()
        self.assertEqual(problem["status"], status)
        self.assertTrue(problem["title"])
        self.assertEqual(problem.get("parameter"), parameter)
        self.assertIn(words, problem["detail"] + problem.get("range", ""))
        return problem


class Resources(ServeTest):
    """What there is, of a service at rest."""

    options = ("--workers", "2")

    def test_states(self):
        health = self.server.get("/health")
        self.assertEqual((health.status, health.json()["alive"]), (200, True))
        self.assertEqual(self.server.get("/ready").status, 200)

    def test_scenes(self):
        scenes = self.server.get("/scenes").json()["scenes"]
        self.assertEqual([scene["id"] for scene in scenes], ["box", "square"])
        self.assertEqual((scenes[1]["size"], scenes[1]["channels"], scenes[1]["up"]), ([24, 16], 3, "y"))
        # The camera of the file looks at the middle of the square.
        for value, wanted in zip(scenes[1]["target"], (0, 0, 0)):
            self.assertAlmostEqual(value, wanted, 2)
        self.assertAlmostEqual(scenes[1]["distance"], (1 + 0.25 + 16) ** 0.5, 2)
        for scene in scenes:
            width, height, _ = read_png(self.server.get(scene["preview"]).body)
            self.assertLessEqual(max(width, height), 256)

    def test_openapi(self):
        description = self.server.get("/openapi.json").json()
        self.assertTrue(description["openapi"].startswith("3."))
        names = {p["name"] for p in description["paths"]["/scenes/{id}/image.png"]["get"]["parameters"]}
        self.assertLessEqual({"id", "size", "azimuth", "light", "observer", "polarizer"}, names)
        for path in description["paths"]:
            self.assertEqual(self.server.get(path.replace("{id}", "square")).status, 200, path)

    def test_what_is_not_there(self):
        self.assert_problem(self.server.get("/none"), 404)
        self.assert_problem(self.server.get("/scenes/none/image.png"), 404)
        self.assert_problem(self.server.get("/scenes/square"), 404)
        self.assert_problem(self.server.get("/scenes/square/image.gif"), 404)
        self.assert_problem(self.server.get("/scenes/../secret/image.png"), 404)
        answer = self.server.get(IMAGE, method="POST")
        self.assert_problem(answer, 405)
        self.assertEqual(answer.headers["allow"], "GET, HEAD")

    def test_parameters_are_named_with_their_range(self):
        for query, parameter, words in (("elevation=95", "elevation", "-89 to 89"), ("size=9000x1", "size", "1 to 2048"),
                                        ("size=2048x2048", "size", "pixels"), ("frame=1", "frame", "azimuth"),
                                        ("observer=x", "observer", "dolp"), ("fov=1&fov=2", "fov", "once")):  # fmt: skip
            self.assert_problem(self.server.get(f"{SQUARE}image.png?{query}"), 400, parameter, words)
        # What only the library knows to be wrong is no failure of the service either.
        self.assert_problem(self.server.get(f"{SQUARE}image.png?matrix={','.join(['0'] * 16)}"[:-1] + "1"), 400)

    def test_bytes_that_are_no_request(self):
        for data, status in ((b"\r\n\r\nnonsense\r\n\r\n", 400), (b"GET / HTTP/9.9\r\n\r\n", 400), (b"GET \x00 HTTP/1.1\r\n\r\n", 400),
                             (b"GET / HTTP/1.1\r\nA: " + b"x" * 20000 + b"\r\n\r\n", 431),
                             (b"GET /" + b"x" * 20000 + b" HTTP/1.1\r\n\r\n", 431),
                             (b"GET / HTTP/1.1\r\nContent-Length: 9999\r\n\r\n", 413)):  # fmt: skip
            with socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as connection:
                connection.sendall(data)
                head = connection.makefile("rb").readline()
            self.assertIn(str(status).encode(), head, data[:40])

    def test_connections_are_kept(self):
        connection = self.server.connect()
        for _ in range(3):
            connection.request("GET", "/health")
            first = connection.getresponse()
            first.read()
            local = connection.sock.getsockname()
        self.assertEqual(connection.sock.getsockname(), local)
        connection.close()
        with socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as raw:
            raw.sendall(f"GET {IMAGE}&azimuth=77 HTTP/1.1\r\nHost: x\r\n\r\n".encode())
            raw.sendall(b"GET /health HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n")
            answers = raw.makefile("rb").read()
        self.assertEqual(answers.count(b"HTTP/1.1 200 OK"), 2)


class Pictures(ServeTest):
    def rendered(self, *arguments):
        """What nicol-render makes of the scene: a folder with stokes.exr and the pictures."""
        out = os.path.join(self.folder, "rendered")
        subprocess.run([RENDER, os.path.join(self.folder, "square.xml"), "-o", os.path.join(out, "stokes.exr"), "--pictures", out,
                        *arguments], check=True, capture_output=True)  # fmt: skip
        return lambda name: read(os.path.join(out, name))

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        os.mkdir(os.path.join(cls.folder, "rendered"))

    def assert_alike(self, left, right):
        """The same size, and no code differs by more than rounding."""
        left, right = read_png(left), read_png(right)
        self.assertEqual(left[:2], right[:2])
        self.assertLessEqual(max(abs(a - b) for a, b in zip(left[2], right[2])), 1)

    def test_as_the_library_draws_them(self):
        file = self.rendered("--size", "40x30")
        for name in ("s0", "s1", "s2", "s3", "dolp", "aolp"):
            answer = self.server.get(f"{SQUARE}image.png?size=40x30&observer={name}")
            self.assertEqual(answer.headers["content-type"], "image/png")
            self.assert_alike(answer.body, file(name + ".png"))
        self.assertEqual(self.server.get(SQUARE + "stokes.exr?size=40x30").body, file("stokes.exr"))

    def test_light_turns(self):
        file = self.rendered("--size", "40x30", "-D", "light_angle=120")
        self.assert_alike(self.server.get(f"{SQUARE}image.png?size=40x30&light=120").body, file("s0.png"))

    def test_numbers(self):
        query = "?size=20x10&azimuth=20"
        stokes = self.server.get(f"{SQUARE}stokes.f32{query}").body
        self.assertEqual(len(stokes), 20 * 10 * 3 * 4 * 4)
        values = struct.unpack(f"<{len(stokes) // 4}f", stokes)
        halves = struct.unpack(f"<{len(stokes) // 4}e", self.server.get(f"{SQUARE}stokes.f16{query}").body)
        for value, half in zip(values, halves):
            self.assertAlmostEqual(value, half, delta=1e-3 * abs(value) + 1e-6)
        for component in range(4):
            exr = read_exr(self.server.get(f"{SQUARE}image.exr{query}&observer=s{component}").body)
            for channel, name in enumerate("RGB"):
                plane = values[channel * 800 : (channel + 1) * 800]
                self.assertEqual(tuple(exr[name]), plane[component::4])
        # A polarizer passes half of what it is turned to and the sum of two across is everything.
        s0 = read_exr(self.server.get(f"{SQUARE}image.exr{query}").body)["G"]
        first, second = (read_exr(self.server.get(f"{SQUARE}image.exr{query}&polarizer={a}").body)["G"] for a in (30, 120))
        for whole, a, b in zip(s0, first, second):
            self.assertAlmostEqual(whole, a + b, delta=1e-5 * whole)
        self.assertNotEqual(first, second)
        bright = read_exr(self.server.get(f"{SQUARE}image.exr{query}&exposure=2").body)["G"]
        self.assertEqual([4 * v for v in s0], bright)

    def test_cameras(self):
        def picture(query):
            answer = self.server.get(f"{SQUARE}image.png?size=40x30&{query}")
            self.assertEqual(answer.status, 200, query)
            return answer.body

        own = picture("")
        pictures = {picture(q) for q in ("azimuth=90", "azimuth=30", "elevation=60", "distance=9", "target=0.3,0,0", "fov=20", "light=60",
                                         "light_tilt=60")}  # fmt: skip
        self.assertEqual(len(pictures | {own}), 9)
        # The scene's own camera, written as a matrix.
        forward = [-1 / 17.25**0.5, -0.5 / 17.25**0.5, -4 / 17.25**0.5]
        left = [forward[2], 0, -forward[0]]
        norm = (left[0] ** 2 + left[2] ** 2) ** 0.5
        left = [v / norm for v in left]
        up = [forward[1] * left[2] - forward[2] * left[1], forward[2] * left[0] - forward[0] * left[2],
              forward[0] * left[1] - forward[1] * left[0]]  # fmt: skip
        rows = [[left[i], up[i], forward[i], (1, 0.5, 4)[i]] for i in range(3)] + [[0, 0, 0, 1]]
        self.assert_alike(picture("matrix=" + ",".join(str(v) for row in rows for v in row)), own)
        # And as an orbit.
        scene = next(s for s in self.server.get("/scenes").json()["scenes"] if s["id"] == "square")
        orbit = picture(f"azimuth={scene['azimuth']}")
        self.assertLess(sum(a != b for a, b in zip(read_png(orbit)[2], read_png(own)[2])), 400)

    def test_scale_is_told(self):
        scale = float(self.server.get(f"{SQUARE}image.png?size=20x10&observer=s1").headers["nicol-scale"])
        exr = read_exr(self.server.get(f"{SQUARE}image.exr?size=20x10&observer=s1").body)
        means = [abs(sum(v) / 3) for v in zip(exr["R"], exr["G"], exr["B"])]
        self.assertAlmostEqual(scale, max(means), delta=1e-6)
        self.assertEqual(self.server.get(f"{SQUARE}image.png?size=20x10&observer=s1&scale=0.5").headers["nicol-scale"], "0.5")


class Caching(ServeTest):
    options = ("--workers", "1")

    def test_unchanged_is_answered_before_rendering(self):
        first = self.server.get(IMAGE + "&azimuth=1")
        tag = first.headers["etag"]
        self.assertRegex(tag, '^"[0-9a-f]{32}"$')
        renders = self.server.metric("renders_total")
        self.server.signal_workers(signal.SIGSTOP)
        for value in (tag, f'"x", {tag}', "*", "W/" + tag):
            again = self.server.get(IMAGE + "&azimuth=361"[:-3] + "1", If_None_Match=value)
            self.assertEqual((again.status, again.body, again.headers["etag"]), (304, b"", tag))
        # Nor does a picture that was never asked for have to be made.
        head = self.server.get(IMAGE + "&azimuth=99", method="HEAD")
        self.assertEqual((head.status, head.body), (200, b""))
        self.assertEqual(self.server.get(IMAGE + "&azimuth=99", If_None_Match=head.headers["etag"]).status, 304)
        self.assertEqual(self.server.metric("renders_total"), renders)
        self.server.signal_workers(signal.SIGCONT)
        self.assertNotEqual(self.server.get(IMAGE + "&azimuth=2", If_None_Match=tag).status, 304)

    def test_equal_answers_are_kept(self):
        first = self.server.get(IMAGE + "&azimuth=3")
        before = self.server.metrics()
        second = self.server.get(IMAGE + "&azimuth=3.0")
        after = self.server.metrics()
        self.assertEqual(first.body, second.body)
        self.assertEqual(before["renders_total"], after["renders_total"])
        self.assertEqual(before['cache_hits_total{kind="result"}'] + 1, after['cache_hits_total{kind="result"}'])

    def test_views_are_kept_by_workers(self):
        self.server.get(IMAGE + "&azimuth=4")
        before = self.server.metric('cache_hits_total{kind="view"}')
        self.server.get(IMAGE + "&azimuth=4&observer=dolp")
        self.assertEqual(self.server.metric('cache_hits_total{kind="view"}'), before + 1)

    def test_equal_requests_in_flight_are_rendered_once(self):
        before = self.server.metrics()
        self.server.signal_workers(signal.SIGSTOP)
        asked = [self.server.ask(IMAGE + "&azimuth=5") for _ in range(3)]
        flight = 'cache_hits_total{kind="flight"}'
        self.server.wait(lambda: self.server.metric(flight) == before[flight] + 2)
        self.server.signal_workers(signal.SIGCONT)
        bodies = {self.server.answer(connection).body for connection in asked}
        self.assertEqual(len(bodies), 1)
        self.assertEqual(self.server.metric("renders_total"), before["renders_total"] + 1)

    def test_tags_outlive_the_process_and_not_the_scene(self):
        tag = self.server.get(IMAGE).headers["etag"]
        other = Server(PROGRAM, self.folder, "--workers", "2")
        try:
            self.assertEqual(other.get(IMAGE).headers["etag"], tag)
            box = other.get("/scenes/box/image.png").headers["etag"]
            path = os.path.join(self.folder, "square.xml")
            scene = read(path)
            try:
                with open(path, "wb") as file:
                    file.write(scene.replace(b"0.9", b"0.1"))
                # A worker that starts anew finds the new scene, and the other one is replaced.
                killed, left = [pid for pid, _ in other.workers()]
                os.kill(killed, signal.SIGKILL)
                other.wait(lambda: other.get(IMAGE, method="HEAD").headers.get("etag") != tag)
                other.wait(lambda: left not in [pid for pid, _ in other.workers()])
                self.assertEqual(other.get(IMAGE).status, 200)
                self.assertEqual(other.get("/scenes/box/image.png").headers["etag"], box)
            finally:
                with open(path, "wb") as file:
                    file.write(scene)
        finally:
            other.stop()


class Load(ServeTest):
    options = ("--workers", "1", "--queue", "1", "--deadline", "30", "--render-limit", "30")

    def tearDown(self):
        self.server.signal_workers(signal.SIGCONT)
        self.server.wait(lambda: self.server.metric("renders_running") == 0)

    def hold(self, azimuth):
        """One request that a stopped worker has, one in the queue."""
        self.server.signal_workers(signal.SIGSTOP)
        running = self.server.ask(f"{IMAGE}&azimuth={azimuth}")
        self.server.wait(lambda: self.server.metric("renders_running") == 1)
        queued = self.server.ask(f"{IMAGE}&azimuth={azimuth + 1}")
        self.server.wait(lambda: self.server.metric("queue_length") == 1)
        return running, queued

    def test_a_full_queue_says_when_to_come_again(self):
        held = self.hold(10)
        refused = self.server.get(IMAGE + "&azimuth=12")
        self.assert_problem(refused, 503)
        self.assertGreaterEqual(int(refused.headers["retry-after"]), 1)
        # What is wrong or known needs no place in the queue.
        self.assert_problem(self.server.get(IMAGE + "&azimuth=999"), 400, "azimuth")
        self.assert_problem(self.server.get(SQUARE + "image.png?size=2048x2048"), 400, "size")
        self.assertEqual(self.server.get("/health").status, 200)
        self.server.signal_workers(signal.SIGCONT)
        self.assertEqual([self.server.answer(c).status for c in held], [200, 200])

    def test_who_leaves_is_not_worked_for(self):
        before = self.server.metrics()
        running, queued = self.hold(20)
        queued.close()
        self.server.wait(lambda: self.server.metric("queue_length") == 0)
        running.close()
        self.server.wait(lambda: self.server.metric("renders_cancelled_total") == before["renders_cancelled_total"] + 1)
        self.assertEqual(self.server.metric("clients_gone_total"), before["clients_gone_total"] + 2)
        self.server.signal_workers(signal.SIGCONT)
        self.assertEqual(self.server.get(IMAGE + "&azimuth=23").status, 200)


class Limits(ServeTest):
    options = ("--workers", "1", "--deadline", "0.5", "--read-limit", "0.3", "--idle-limit", "0.3", "--connections", "3", "--max-order", "6")

    def setUp(self):
        # What the test before closed may still count.
        self.server.wait(lambda: b"nicol_serve_connections 1\n" in self.server.get("/metrics").body)

    def test_deadline(self):
        self.server.signal_workers(signal.SIGSTOP)
        self.assert_problem(self.server.get(IMAGE + "&azimuth=30"), 504)
        self.server.signal_workers(signal.SIGCONT)
        self.server.wait(lambda: self.server.get(IMAGE + "&azimuth=31").status == 200)

    def test_slow_and_silent_clients(self):
        with socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as slow:
            slow.sendall(b"GET / HT")
            self.assertIn(b"408", slow.makefile("rb").readline())
        with socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as silent:
            self.assertEqual(silent.recv(1), b"")

    def test_connections(self):
        held = [socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) for _ in range(3)]
        try:
            with socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as extra:
                self.assertIn(b"503", extra.makefile("rb").readline())
        finally:
            for connection in held:
                connection.close()

    def test_order(self):
        self.assertEqual(self.server.get(IMAGE + "&order_low=2&order_high=3").status, 200)
        self.assert_problem(self.server.get(IMAGE + "&order_low=7"), 400, "order_low", "0 to 6")


class Failures(ServeTest):
    options = ("--workers", "2", "--render-limit", "1", "--deadline", "60")

    def test_a_crash_is_survived(self):
        self.server.wait(lambda: all(state == "idle" for _, state in self.server.workers()))
        self.server.signal_workers(signal.SIGSTOP)
        before = self.server.metrics()
        asked = self.server.ask(IMAGE + "&azimuth=40")
        self.server.wait(lambda: any(state == "busy" for _, state in self.server.workers()))
        busy, idle = sorted(self.server.workers(), key=lambda w: w[1])
        os.kill(idle[0], signal.SIGCONT)
        os.kill(busy[0], signal.SIGKILL)
        self.assertEqual(self.server.answer(asked).status, 200)
        self.assertNotIn(busy[0], [pid for pid, _ in self.server.workers()])
        self.assertEqual(self.server.metric('workers_lost_total{reason="crash"}'), before['workers_lost_total{reason="crash"}'] + 1)

    def test_two_crashes_are_an_answer(self):
        self.server.wait(lambda: all(state == "idle" for _, state in self.server.workers()))
        self.server.signal_workers(signal.SIGSTOP)
        asked = self.server.ask(IMAGE + "&azimuth=41")
        stopped = {pid for pid, _ in self.server.workers()}
        for _ in range(2):
            self.server.wait(lambda: any(state == "busy" and pid in stopped for pid, state in self.server.workers()))
            busy = next(pid for pid, state in self.server.workers() if state == "busy")
            os.kill(busy, signal.SIGKILL)
            stopped.discard(busy)
        answer = self.server.answer(asked)
        self.assert_problem(answer, 503)
        self.assertGreaterEqual(int(answer.headers["retry-after"]), 1)
        self.server.wait(lambda: self.server.get(IMAGE + "&azimuth=42").status == 200)

    def test_a_hang_is_survived(self):
        self.server.wait(lambda: all(state == "idle" for _, state in self.server.workers()))
        before = self.server.metrics()
        self.server.signal_workers(signal.SIGSTOP)
        asked = self.server.ask(IMAGE + "&azimuth=43")
        self.server.wait(lambda: any(state == "busy" for _, state in self.server.workers()))
        idle = next(pid for pid, state in self.server.workers() if state == "idle")
        os.kill(idle, signal.SIGCONT)
        self.assertEqual(self.server.answer(asked).status, 200)
        self.assertEqual(self.server.metric('workers_lost_total{reason="hang"}'), before['workers_lost_total{reason="hang"}'] + 1)


class Signed(ServeTest):
    KEYS = ("00112233445566778899aabbccddeeff", "a" * 64)

    @classmethod
    def setUpClass(cls):
        keys = tempfile.NamedTemporaryFile("w", suffix=".keys")
        cls.addClassCleanup(keys.close)
        keys.write("# of today\n" + "\n".join(cls.KEYS) + "\n")
        keys.flush()
        cls.keys = keys.name
        cls.options = ("--workers", "1", "--keys", keys.name)
        super().setUpClass()

    @staticmethod
    def sign(target, key):
        digest = hmac.new(bytes.fromhex(key), target.encode(), hashlib.sha256).hexdigest()
        return f"{target}{'&' if '?' in target else '?'}sig={digest}"

    def test_signatures(self):
        for key in self.KEYS:
            self.assertEqual(self.server.get(self.sign(IMAGE, key)).status, 200)
        self.assertEqual(self.server.get(self.sign(SQUARE + "image.png", self.KEYS[0])).status, 200)
        self.assert_problem(self.server.get(IMAGE), 403, "sig")
        self.assert_problem(self.server.get(self.sign(IMAGE, "b" * 64)), 403, "sig")
        self.assert_problem(self.server.get(self.sign(IMAGE, self.KEYS[0]).replace("32x24", "33x24")), 403, "sig")
        # Who may not ask does not learn what there is.
        self.assert_problem(self.server.get("/scenes/none/image.png"), 403, "sig")
        self.assert_problem(self.server.get(self.sign(SQUARE + "image.png?size=0x0", self.KEYS[0])), 400, "size")
        self.assertEqual(self.server.get("/ready").status, 200)

    def test_expiry(self):
        soon, past = int(time.time()) + 3600, int(time.time()) - 10
        self.assertEqual(self.server.get(self.sign(f"{IMAGE}&expires={soon}", self.KEYS[1])).status, 200)
        self.assert_problem(self.server.get(self.sign(f"{IMAGE}&expires={past}", self.KEYS[1])), 403, "expires")

    def test_command_line_signs(self):
        run = subprocess.run([PROGRAM, "--keys", self.keys, "--sign", IMAGE], capture_output=True, text=True, check=True)
        self.assertEqual(run.stdout.strip(), self.sign(IMAGE, self.KEYS[0]))


class Ends(unittest.TestCase):
    """Starts and ends."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_drain(self):
        write_scenes(self.folder)
        server = Server(PROGRAM, self.folder, "--workers", "1")
        workers = [pid for pid, _ in server.workers()]
        idle = server.connect()
        idle.connect()
        server.signal_workers(signal.SIGSTOP)
        asked = server.ask(IMAGE)
        server.wait(lambda: server.metric("renders_running") == 1)
        server.process.terminate()
        # The idle connection ends, and with it that the signal came is known.
        self.assertEqual(idle.sock.recv(1), b"")
        with self.assertRaises(ConnectionRefusedError):
            server.get("/ready")
        os.kill(workers[0], signal.SIGCONT)
        answer = server.answer(asked)
        self.assertEqual((answer.status, answer.headers["connection"]), (200, "close"))
        self.assertEqual(server.process.wait(PATIENCE), 0)
        server.stop()
        idle.close()
        for pid in workers:
            self.assertFalse(alive(pid))

    def test_workers_end_with_their_parent(self):
        write_scenes(self.folder)
        server = Server(PROGRAM, self.folder, "--workers", "2")
        workers = [pid for pid, _ in server.workers()]
        server.process.kill()
        server.process.wait()
        end = time.monotonic() + PATIENCE
        while any(alive(pid) for pid in workers):
            self.assertLess(time.monotonic(), end)
        server.stop()

    def test_not_ready_at_first(self):
        write_scenes(self.folder)
        server = Server(PROGRAM, self.folder, ready=False)
        self.assertEqual(server.get("/health").status, 200)
        early = server.get("/ready")
        if early.status == 503:
            self.assertGreaterEqual(int(early.headers["retry-after"]), 1)
        server.wait(lambda: server.get("/ready").status == 200)
        self.assertEqual(server.stop(), 0)

    def assert_fails(self, words, *arguments):
        run = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(run.returncode, 2, run.stderr)
        lines = run.stderr.splitlines()
        self.assertEqual(len(lines), 1, run.stderr)
        for word in words:
            self.assertIn(word, lines[0])

    def test_bad_command_lines(self):
        self.assert_fails(["--scenes DIR"])
        self.assert_fails(["--wrong"], "--wrong", "1")
        self.assert_fails(["--port"], "--scenes", self.folder, "--port")
        self.assert_fails(["--listen", "127.0.0.1:8080"], "--scenes", self.folder, "--listen", "8080")
        self.assert_fails(["--listen", "numeric"], "--scenes", self.folder, "--listen", "nowhere.invalid:0")
        self.assert_fails(["--workers", "1 to 1024"], "--scenes", self.folder, "--workers", "0")
        self.assert_fails(["--deadline"], "--scenes", self.folder, "--deadline", "nan")
        self.assert_fails(["--keys", "/none"], "--scenes", self.folder, "--keys", "/none")

    def test_bad_scenes(self):
        start = ("--listen", "127.0.0.1:0", "--scenes")
        self.assert_fails([self.folder, "*.xml"], *start, self.folder)
        self.assert_fails(["/none"], *start, "/none")
        with open(os.path.join(self.folder, "bad.xml"), "w", encoding="utf-8") as file:
            file.write("<scene>")
        self.assert_fails(["bad.xml"], *start, self.folder)

    def test_taken_port(self):
        write_scenes(self.folder)
        with socket.create_server(("127.0.0.1", 0)) as taken:
            port = taken.getsockname()[1]
            self.assert_fails([str(port), "in use"], "--scenes", self.folder, "--listen", f"127.0.0.1:{port}")

    def test_help(self):
        run = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True)
        self.assertIn("--drain-limit", run.stdout)
        run = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True)
        self.assertRegex(run.stdout, r"^nicol-serve \d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    unittest.main()
