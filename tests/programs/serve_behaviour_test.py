# SPDX-License-Identifier: MIT
# Tests of nicol-serve's behaviour: caching, load, limits, failing workers, start and end.
import base64
import ctypes
import json
import os
import re
import resource
import signal
import socket
import stat
import struct
import tempfile
import time
import unittest
import unittest.mock

from images import read_exr
from program_test import ProgramTest
from serve_case import IMAGE, PROGRAM, SQUARE, ServeTest, alive, read
from serve_client import PATIENCE, Server, write_scenes


def has_landlock():
    create_ruleset, ask_version = 444, 1
    return ctypes.CDLL(None).syscall(create_ruleset, None, 0, ask_version) > 0


# AddressSanitizer ends a process whose allocation the system refuses.
@unittest.skipIf("ASAN_OPTIONS" in os.environ, "AddressSanitizer ends workers without memory")
class LackOfMemory(ServeTest):
    """A worker whose address space is full reports it or is replaced, and the next request is answered."""

    options = ("--workers", "1")

    def test_each_room(self):
        refused = 0
        for number, room in enumerate((0, 1, 2, 4, 8, 16, 32, 64)):
            with self.subTest(room=room):
                worker = self.server.workers()[0][0]
                used = int(read(f"/proc/{worker}/statm").split()[0]) * resource.getpagesize()
                _, most = resource.prlimit(worker, resource.RLIMIT_AS)
                resource.prlimit(worker, resource.RLIMIT_AS, (used + (room << 20), most))
                short = self.server.get(f"{SQUARE}image.png?size=640x480&azimuth={number}")
                if short.status != 200:
                    refused += 1
                    self.assert_problem(short, 503)
                if alive(worker):
                    resource.prlimit(worker, resource.RLIMIT_AS, (most, most))
                self.server.wait(lambda: self.server.workers()[0][1] == "idle")
                self.assertEqual(self.server.get(f"{IMAGE}&azimuth={number}").status, 200)
        self.assertGreater(refused, 0)


class Caching(ServeTest):
    options = ("--workers", "1")

    def test_unchanged_is_answered_before_rendering(self):
        first = self.server.get(IMAGE + "&azimuth=1")
        tag = first.headers["etag"]
        self.assertRegex(tag, '^"[0-9a-f]{32}"$')
        renders = self.server.metric("renders_total")
        self.server.signal_workers(signal.SIGSTOP)
        again = self.server.get(IMAGE + "&azimuth=1", If_None_Match=tag)
        self.assertEqual((again.status, again.body, again.headers["etag"]), (304, b"", tag))
        # HEAD requests need no rendering, even for a new image.
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
                # A restarted worker finds the new scene, and then the other worker reloads it.
                killed = other.workers()[0][0]
                old = other.get(IMAGE + "&azimuth=5").body
                os.kill(killed, signal.SIGKILL)
                other.wait(lambda: other.get(IMAGE, method="HEAD").headers.get("etag") != tag)
                other.wait(lambda: all(state == "idle" for _, state in other.workers()))
                self.assertNotEqual(other.get(IMAGE + "&azimuth=5").body, old)
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
        """Returns two requests: one held by a stopped worker, and one in the queue."""
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
        # Invalid requests and known answers need no place in the queue.
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


    def test_who_leaves_behind_further_bytes_is_not_worked_for(self):
        before = self.server.metric("clients_gone_total")
        self.server.signal_workers(signal.SIGSTOP)
        for number, data in enumerate((b"G", b"GET /health HTTP/1.1\r\nHost: localhost\r\n\r\n" * 400)):
            with socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as connection:
                connection.sendall(f"GET {IMAGE}&azimuth={24 + number} HTTP/1.1\r\nHost: localhost\r\n\r\n".encode() + data)
                self.server.wait(lambda: self.server.metric("renders_running") + self.server.metric("queue_length") == 1 + number)  # noqa: B023
        self.server.wait(lambda: self.server.metric("clients_gone_total") == before + 2)
        self.assertEqual(self.server.metric("queue_length"), 0)


class Unread(ServeTest):
    """Unread answers take no more memory than the limit for them."""

    options = ("--workers", "1", "--answers", "8", "--results", "0", "--write-limit", "1")
    LARGE = SQUARE + "stokes.f32?size=512x512"  # 12 MiB

    def tearDown(self):
        self.server.signal_workers(signal.SIGCONT)
        self.server.wait(lambda: self.server.metric("answer_bytes") == 0)

    def test_answers_under_way_count(self):
        self.server.signal_workers(signal.SIGSTOP)
        first = self.server.ask(self.LARGE)
        self.server.wait(lambda: self.server.metric("renders_running") == 1)
        self.assertGreaterEqual(self.server.metric("answer_bytes"), 512 * 512 * 48)
        refused = self.server.get(self.LARGE + "&azimuth=1")
        self.assert_problem(refused, 503, words="unread")
        self.assertGreaterEqual(int(refused.headers["retry-after"]), 1)
        equal = self.server.ask(self.LARGE + "&light=0")  # the answer is in memory only once
        self.server.wait(lambda: self.server.metric('cache_hits_total{kind="flight"}') >= 1)
        self.server.signal_workers(signal.SIGCONT)
        self.assertEqual([len(self.server.answer(asked).body) for asked in (first, equal)], [512 * 512 * 48] * 2)

    def test_who_does_not_read_is_dropped(self):
        with socket.socket() as silent:
            silent.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            silent.connect(("127.0.0.1", self.server.port))
            silent.sendall(f"GET {self.LARGE}&azimuth=2 HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())
            self.server.wait(lambda: self.server.metric("answer_bytes") == 512 * 512 * 48)
            self.server.wait(lambda: self.server.metric("answer_bytes") == 0)
        self.assertEqual(self.server.get(self.LARGE + "&azimuth=3").status, 200)


class Limits(ServeTest):
    options = ("--workers", "1", "--deadline", "0.5", "--read-limit", "0.3", "--idle-limit", "0.3", "--max-order", "6")

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

    def test_order(self):
        # The first image of these orders may take longer than this server's deadline.
        self.server.wait(lambda: self.server.get(IMAGE + "&order_low=2&order_high=3").status == 200)
        self.assert_problem(self.server.get(IMAGE + "&order_low=7"), 400, "order_low", "0 to 6")


class Places(ServeTest):
    """The server handles more connections than it has places for."""

    options = ("--workers", "1", "--connections", "4", "--connections-per-address", "2", "--status-listen", "127.0.0.1:0")
    ONE, OTHER, THIRD = "127.0.0.2", "127.0.0.3", "127.0.0.4"

    def setUp(self):
        self.held = []
        self.server.wait(lambda: self.server.metric("connections") == 0)

    def tearDown(self):
        for connection in self.held:
            connection.close()
        self.server.signal_workers(signal.SIGCONT)
        self.server.wait(lambda: self.server.metric("renders_running") == 0)

    def hold(self, source, data=b""):
        """Returns a connection that sends nothing or an incomplete request."""
        connection = socket.create_connection(("127.0.0.1", self.server.port), PATIENCE, source_address=(source, 0))
        self.held.append(connection)
        connection.sendall(data)
        self.server.wait(lambda: self.server.metric("connections") == len(self.held))
        return connection

    def hold_busy(self, source, azimuth):
        """Adds a connection whose image a stopped worker does not make."""
        self.held.append(self.server.ask(f"{IMAGE}&azimuth={azimuth}", source=source))
        self.server.wait(lambda: self.server.metric("renders_running") + self.server.metric("queue_length") == len(self.held))

    def assert_open(self, connections):
        for connection in connections:
            connection.sendall(b"GET /health HTTP/1.1\r\nHost: localhost\r\n\r\n")
            self.assertIn(b" 200 ", connection.recv(1000))

    def test_who_waits_longest_makes_room(self):
        for data in (b"", b"GET /health HT"):
            with self.subTest(data=data):
                self.held = [self.hold(source, data) for source in (self.ONE, self.ONE, self.OTHER, self.OTHER)]
                self.assertEqual(self.server.get("/health", source=self.THIRD).status, 200)
                self.assertEqual(self.held[0].recv(1), b"")
                if not data:
                    self.assert_open(self.held[1:])
                for connection in self.held:
                    connection.close()
                self.held = []
                self.server.wait(lambda: self.server.metric("connections") == 0)

    def test_an_address_makes_room_for_itself(self):
        first = self.hold(self.OTHER)
        own = [self.hold(self.ONE), self.hold(self.ONE)]
        self.assertEqual(self.server.get("/health", source=self.ONE).status, 200)
        self.assertEqual(own[0].recv(1), b"")
        self.assert_open([first, own[1]])

    def test_who_works_stays(self):
        self.server.signal_workers(signal.SIGSTOP)
        for azimuth, source in enumerate((self.ONE, self.ONE, self.OTHER, self.OTHER)):
            self.hold_busy(source, 40 + azimuth)
        self.assert_problem(self.server.get("/health", source=self.ONE), 429)
        refused = self.server.get("/health", source=self.THIRD)
        self.assert_problem(refused, 503)
        self.assertGreaterEqual(int(refused.headers["retry-after"]), 1)
        # Monitoring has separate places.
        for target, status in (("/health", 200), ("/ready", 200), ("/metrics", 200), ("/scenes", 404), (IMAGE, 404)):
            self.assertEqual(self.server.get(target, port=self.server.status_port).status, status, target)
        self.server.signal_workers(signal.SIGCONT)
        self.assertEqual([self.server.answer(asked).status for asked in self.held], [200] * 4)


class Failures(ServeTest):
    options = ("--workers", "2", "--render-limit", "3", "--deadline", "60")

    def lose(self, reason, azimuth):
        """Stops the worker of one request, and kills it if the reason is a crash. The other worker must answer."""
        self.server.wait(lambda: all(state == "idle" for _, state in self.server.workers()))
        lost = f'workers_lost_total{{reason="{reason}"}}'
        before = self.server.metric(lost)
        self.server.signal_workers(signal.SIGSTOP)
        asked = self.server.ask(f"{IMAGE}&azimuth={azimuth}")
        self.server.wait(lambda: any(state == "busy" for _, state in self.server.workers()))
        busy, idle = sorted(self.server.workers(), key=lambda w: w[1])
        os.kill(idle[0], signal.SIGCONT)
        if reason == "crash":
            os.kill(busy[0], signal.SIGKILL)
        self.assertEqual(self.server.answer(asked).status, 200)
        self.assertNotIn(busy[0], [pid for pid, _ in self.server.workers()])
        self.assertEqual(self.server.metric(lost), before + 1)

    def test_a_crash_is_survived(self):
        self.lose("crash", 40)

    def test_a_hang_is_survived(self):
        self.lose("hang", 43)


class Ends(ProgramTest):
    """Starts and ends of the service."""

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
        # The end of the idle connection shows that the signal has arrived.
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

    def test_bad_command_lines(self):
        self.assert_fails(["--scenes DIR"])
        table = (
            (["--wrong"], "--wrong 1"),
            (["--port"], "--port"),
            (["--listen", "127.0.0.1:8080"], "--listen 8080"),
            (["--listen", "numeric"], "--listen nowhere.invalid:0"),
            (["--status-listen", "127.0.0.1:8080"], "--status-listen 8080"),
            (["--status-listen", "numeric"], "--listen 127.0.0.1:0 --status-listen nowhere.invalid:0"),
            (["--connections-per-address"], "--connections-per-address -1"),
            (["--read", "/none"], "--read /none"),
            (["--allow-host", "images.example.org"], "--allow-host http://a"),
            (["--allow-host", "images.example.org"], "--allow-host a:80"),
            (["--allow-origin", "https://example.org"], "--allow-origin example.org"),
            (["--allow-origin", "https://example.org"], "--allow-origin https://example.org/page"),
            (["--workers", "1 to 1024"], "--workers 0"),
            (["--deadline"], "--deadline nan"),
            (["--keys", "/none"], "--keys /none"),
        )
        self.assert_each_fails(table, "--scenes", self.folder)

    def test_bad_scenes(self):
        for word, folder in (("*.xml", self.folder), ("/none", "/none"), ("bad.xml", self.folder)):
            if word == "bad.xml":
                self.write(word, "<scene>")
            ended = self.run_program("--listen", "127.0.0.1:0", "--scenes", folder)
            self.assertEqual(ended.returncode, 2, ended.stderr)
            self.assertEqual(len(ended.stderr.splitlines()), 1, ended.stderr)
            self.assertIn(word, ended.stderr)

    def test_a_gltf_scene_without_lights_is_lit(self):
        corners = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0)
        triangle = {
            "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + base64.b64encode(corners).decode()}],
        }  # fmt: skip
        self.write("triangle.gltf", json.dumps(triangle))
        server = Server(PROGRAM, self.folder, "--workers", "1")
        try:
            self.assertEqual([scene["id"] for scene in server.get("/scenes").json()["scenes"]], ["triangle"])
            image = server.get("/scenes/triangle/image.exr?size=20x20&observer=s0")
            brightness = read_exr(image.body)["G"]
            self.assertGreater(brightness[10 * 20 + 10], 0.3)
            self.assertAlmostEqual(brightness[0], 1, 3)
        finally:
            server.stop()

    def test_a_broken_scene_is_its_own(self):
        write_scenes(self.folder)
        box = os.path.join(self.folder, "box.xml")
        whole = read(box)
        server = Server(PROGRAM, self.folder, "--workers", "1")
        try:
            for content, status in ((b"<scene>", 503), (whole, 200)):
                with open(box, "wb") as file:
                    file.write(content)
                os.kill(server.workers()[0][0], signal.SIGKILL)
                server.wait(lambda: server.get("/scenes/box/image.png").status == status)
                self.assertEqual(server.get(IMAGE).status, 200)
                listed = server.get("/scenes").json()
                self.assertEqual(listed["broken"], [] if status == 200 else ["box"])
        finally:
            server.stop()
        self.write("box.xml", "<scene>")
        server = Server(PROGRAM, self.folder, "--workers", "1")
        self.assertEqual([server.get(path).status for path in (IMAGE, "/scenes/box/image.png")], [200, 503])
        self.assertEqual(server.stop(), 0)

    def test_a_slow_scene_is_its_own(self):
        """The only worker serves the other scene while a further process, stopped in this test, loads the slow one."""
        write_scenes(self.folder)
        side = 31
        lines = [f"v {x / 15 - 1} {y / 15 - 1} {(x * y) % 7 / 70}\n" for y in range(side) for x in range(side)]
        lines += [f"f {i} {i + 1} {i + side + 1} {i + side}\n" for y in range(1, side) for i in range(side * (y - 1) + 1, side * y)]
        self.write("slow.obj", "".join(lines))
        shape = '<shape type="obj"><string name="filename" value="slow.obj"/><bsdf type="pplastic"/></shape>'
        box = read(os.path.join(self.folder, "box.xml")).decode()
        self.write("box.xml", re.sub("<shape.*</shape>", shape, box))
        server = Server(PROGRAM, self.folder, "--workers", "1", "--slow-scene", "0.3", "--deadline", "60", ready=False)
        spare = lambda: [pid for pid, state in server.workers() if state == "spare"]  # noqa: E731
        try:
            server.wait(spare)
            held = spare()[0]
            os.kill(held, signal.SIGSTOP)
            server.wait(lambda: server.get("/ready").status == 200)
            self.assertEqual(server.get("/ready").json()["scenes"], {"box": "preparing", "square": "ready"})
            self.assertEqual(server.get("/scenes").json()["preparing"], ["box"])
            self.assertEqual(server.get(IMAGE).status, 200)
            slow = server.get("/scenes/box/image.png")
            self.assertEqual((slow.status, "prepared" in slow.json()["detail"]), (503, True))
            self.assertGreaterEqual(int(slow.headers["retry-after"]), 1)
            os.kill(held, signal.SIGCONT)
            server.wait(lambda: server.get("/ready").json()["scenes"] == {"box": "ready", "square": "ready"})
            self.assertEqual([server.get(path).status for path in (IMAGE + "&azimuth=1", "/scenes/box/image.png")], [200, 200])
        finally:
            server.stop()

    def test_a_worker_reads_no_other_files(self):
        if not has_landlock():
            self.skipTest("the kernel has no Landlock")
        write_scenes(self.folder)
        outside = tempfile.TemporaryDirectory()
        self.addCleanup(outside.cleanup)
        mesh = os.path.join(outside.name, "triangle.obj")
        with open(mesh, "w", encoding="utf-8") as file:
            file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        shape = f'<shape type="obj"><string name="filename" value="{mesh}"/><bsdf type="pplastic"/></shape>'
        self.write("box.xml", re.sub("<shape.*</shape>", shape, read(os.path.join(self.folder, "box.xml")).decode()))
        for options, status in (((), 503), (("--read", outside.name), 200), (("--no-sandbox",), 200)):
            with self.subTest(options=options):
                server = Server(PROGRAM, self.folder, "--workers", "1", *options)
                try:
                    self.assertEqual(server.get("/scenes/box/image.png").status, status)
                    self.assertEqual(server.get(IMAGE).status, 200)
                    self.assertEqual(server.get(SQUARE + "stokes.exr").status, 200)
                    left_out = re.search("a scene is left out: .*" + re.escape(mesh), server.errors())
                    self.assertEqual(bool(left_out), status == 503, server.errors())
                finally:
                    server.stop()
                os.remove(os.path.join(self.folder, "log"))

    def test_no_file_has_a_name_that_others_can_take(self):
        """A pipe of that name would block the service, and it would follow a link."""
        write_scenes(self.folder)
        server = Server(PROGRAM, self.folder, "--workers", "1")
        try:
            pipes = [os.path.join(folder, f"nicol-serve-{server.workers()[0][0]}.exr") for folder in ("/dev/shm", "/tmp", self.folder)]
            for pipe in pipes:
                os.mkfifo(pipe)
                self.addCleanup(os.remove, pipe)
            self.assertEqual(server.get(SQUARE + "stokes.exr").body[:4], b"\x76\x2f\x31\x01")
            self.assertTrue(all(stat.S_ISFIFO(os.stat(pipe).st_mode) for pipe in pipes))
        finally:
            server.stop()

    def test_systemd_is_told(self):
        write_scenes(self.folder)
        for name in (self.path("notify"), f"\0nicol-serve-{os.getpid()}"):
            with self.subTest(name=name), socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as told:
                told.bind(name)
                told.settimeout(PATIENCE)
                with unittest.mock.patch.dict(os.environ, NOTIFY_SOCKET=name.replace("\0", "@")):
                    server = Server(PROGRAM, self.folder, "--workers", "1", ready=False)
                self.assertEqual(told.recv(100), b"READY=1")
                self.assertEqual(server.get("/ready").status, 200)
                self.assertEqual(server.stop(), 0)
                self.assertEqual(told.recv(100), b"STOPPING=1")

    def test_a_drain_that_takes_too_long(self):
        write_scenes(self.folder)
        server = Server(PROGRAM, self.folder, "--workers", "1", "--drain-limit", "0.1")
        server.signal_workers(signal.SIGSTOP)
        asked = server.ask(IMAGE)
        server.wait(lambda: server.metric("renders_running") == 1)
        server.process.terminate()
        self.assertEqual(server.process.wait(PATIENCE), 0)
        self.assertEqual(server.stop(), 0)
        asked.close()

    def test_taken_port(self):
        write_scenes(self.folder)
        with socket.create_server(("127.0.0.1", 0)) as taken:
            port = taken.getsockname()[1]
            self.assert_fails([str(port), "in use"], "--scenes", self.folder, "--listen", f"127.0.0.1:{port}")

    def test_help(self):
        self.assertIn("--drain-limit", self.assert_succeeds("--help").stdout)
        self.assertRegex(self.assert_succeeds("--version").stdout, r"^nicol-serve \d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    unittest.main()
