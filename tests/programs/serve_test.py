# SPDX-License-Identifier: MIT
# Tests of nicol-serve's answers: resources, images, signed URLs.
import functools
import hashlib
import hmac
import os
import re
import shutil
import socket
import struct
import subprocess
import tempfile
import time
import unittest
import zlib

from serve_case import IMAGE, PROGRAM, RENDER, SQUARE, ServeTest, read
from serve_client import PATIENCE
from images import read_exr, read_png


class Resources(ServeTest):
    """Resources of a service at rest."""

    options = ("--workers", "2")

    def test_states(self):
        health = self.server.get("/health")
        self.assertEqual((health.status, health.json()["alive"]), (200, True))
        self.assertEqual(self.server.get("/ready").status, 200)

    def test_scenes(self):
        scenes = self.server.get("/scenes").json()["scenes"]
        self.assertEqual([scene["id"] for scene in scenes], ["box", "square"])
        self.assertEqual((scenes[1]["size"], scenes[1]["channels"], scenes[1]["up"]), ([24, 16], 3, "y"))
        # The file's camera looks at the middle of the square.
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
        (server,) = description["servers"]
        for path, item in description["paths"].items():
            target = path.replace("{id}", "square")
            for prefix in ("", server["url"]):
                answer = self.server.get(prefix + target)
                self.assertEqual(answer.status, 200, prefix + path)
            described = item["get"]["responses"]["200"]
            kind = answer.headers["content-type"].split(";")[0]
            self.assertIn(kind, described["content"], path)
            if kind == "application/json":
                self.assert_described(description, described["content"][kind]["schema"], answer.json(), path)
            for header in described.get("headers", {}):
                if header != "Nicol-Scale":  # of some images
                    self.assertIn(header.lower(), answer.headers, path)
        operations = [item["get"]["operationId"] for item in description["paths"].values()]
        self.assertEqual(len(set(operations)), len(operations))
        wrong = self.server.get("/v1/scenes/none/image.png").json()
        self.assert_described(description, {"$ref": "#/components/schemas/Problem"}, wrong, "problem")

    def assert_described(self, description, schema, value, where):
        """Checks a value by the parts of JSON Schema that the description uses; nothing else may be there."""
        if "$ref" in schema:
            schema = functools.reduce(lambda at, key: at[key], schema["$ref"][2:].split("/"), description)
        kinds = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int, "number": (int, float)}
        self.assertIsInstance(value, kinds[schema["type"]], where)
        self.assertIn(value, schema.get("enum", [value]), where)
        if schema["type"] == "array":
            for one in value:
                self.assert_described(description, schema["items"], one, where + "[]")
        if schema["type"] == "object":
            self.assertLessEqual(set(schema.get("required", [])), set(value), where)
            for name, one in value.items():
                inner = schema.get("properties", {}).get(name) or schema.get("additionalProperties")
                self.assertIsNotNone(inner, f"{where}.{name} is not described")
                self.assert_described(description, inner, one, f"{where}.{name}")

    def test_parts_of_an_answer(self):
        target = f"{SQUARE}stokes.f32"
        whole = self.server.get(target)
        self.assertEqual(whole.headers["accept-ranges"], "bytes")
        part = self.server.get(target, **{"Range": "bytes=100-199", "If-Range": whole.headers["etag"]})
        self.assertEqual((part.status, part.body), (206, whole.body[100:200]))
        self.assertEqual(part.headers["content-range"], f"bytes 100-199/{len(whole.body)}")
        self.assertEqual(part.headers["etag"], whole.headers["etag"])
        former = self.server.get(target, **{"Range": "bytes=100-199", "If-Range": '"former"'})
        self.assertEqual((former.status, former.body), (200, whole.body))
        beyond = self.server.get(target, Range=f"bytes={len(whole.body)}-")
        self.assertEqual((beyond.status, beyond.body), (416, b""))
        self.assertEqual(beyond.headers["content-range"], f"bytes */{len(whole.body)}")

    def test_what_is_not_there(self):
        for target in ("/none", "/scenes/none/image.png", "/scenes/circle", "/scenes/square/image.gif", "/scenes/../secret/image.png",
                       "/scenes%2fsquare/image.png", "/scenes/square%2Fimage.png", "/%2fhealth", "/health/", "//health"):  # fmt: skip
            self.assert_problem(self.server.get(target), 404)
        answer = self.server.get(IMAGE, method="POST")
        self.assert_problem(answer, 405)
        self.assertEqual(answer.headers["allow"], "GET, HEAD, OPTIONS")

    def test_parameters_are_named_with_their_range(self):
        self.assert_problem(self.server.get(f"{SQUARE}image.png?elevation=95"), 400, "elevation", "-89 to 89")
        # A parameter that only the library refuses must not count as a failure of the service.
        self.assert_problem(self.server.get(f"{SQUARE}image.png?matrix={','.join(['0'] * 16)}"[:-1] + "1"), 400)

    def talk(self, data):
        """Returns the statuses of all answers to these bytes."""
        with socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as connection:
            connection.sendall(data)
            connection.shutdown(socket.SHUT_WR)
            return [int(status) for status in re.findall(rb"HTTP/1.1 (\d+)", connection.makefile("rb").read())]

    def test_bytes_that_are_no_request(self):
        for data, status in ((b"\r\n\r\nnonsense\r\n\r\n", 400), (b"GET / HTTP/9.9\r\n\r\n", 400), (b"GET \x00 HTTP/1.1\r\n\r\n", 400),
                             (b"GET / HTTP/1.1\r\nA: " + b"x" * 20000 + b"\r\n\r\n", 431),
                             (b"GET /" + b"x" * 20000 + b" HTTP/1.1\r\n\r\n", 431),
                             (b"GET / HTTP/1.1\r\nContent-Length: 9999\r\n\r\n", 413)):  # fmt: skip
            with socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as connection:
                connection.sendall(data)
                head = connection.makefile("rb").readline()
            self.assertIn(str(status).encode(), head, data[:40])

    def test_framing(self):
        """A second request follows each first one. It is answered if and only if the end of the first one is certain."""
        host, more = "Host: localhost\r\n", "GET /health HTTP/1.1\r\nHost: localhost\r\n\r\n"
        chunks = "Transfer-Encoding: chunked\r\n"
        for first, statuses in (
            ("GET /health HTTP/1.1\r\n" + host, [200, 200]),
            ("GET /health HTTP/1.0\r\n", [200]),
            ("GET /health HTTP/1.1\r\nHost:\r\n", [200, 200]),
            ("GET /health HTTP/1.1\r\nHost: [::1]:80\r\n", [200, 200]),
            ("GET /health HTTP/1.1\r\n", [400]),
            ("GET /health HTTP/1.1\r\n" + host + host, [400]),
            ("GET /health HTTP/1.0\r\n" + host + host, [400]),
            ("GET /health HTTP/1.1\r\nHost: a b\r\n", [400]),
            ("GET /health HTTP/1.1\r\nHost: a/b\r\n", [400]),
            ("GET http://localhost:80/health HTTP/1.1\r\n" + host, [200, 200]),
            ("GET HTTP://localhost?x=1 HTTP/1.1\r\n" + host, [200, 200]),
            ("GET http://other/health HTTP/1.1\r\n" + host, [421, 200]),
            ("GET http:///health HTTP/1.1\r\n" + host, [400, 200]),
            ("OPTIONS * HTTP/1.1\r\n" + host, [204, 200]),
            ("CONNECT a:80 HTTP/1.1\r\n" + host, [405, 200]),
            ("GET /health HTTP/1.1\r\n" + host + "X: a\r\n b\r\n", [400]),
            ("GET /health HTTP/1.1\r\n" + host + "X: a\r\n\tb\r\n", [400]),
            ("GET /health HTTP/1.1\r\n" + host + chunks + "\r\n3\r\nabc\r\n0\r\n", [200, 200]),
            ("GET /health HTTP/1.1\r\n" + host + chunks + "Content-Length: 3\r\n", [400]),
            ("GET /health HTTP/1.1\r\n" + host + "Content-Length: 3\r\n" + chunks, [400]),
            ("GET /health HTTP/1.1\r\n" + host + chunks + chunks, [400]),
            ("GET /health HTTP/1.1\r\n" + host + "Transfer-Encoding: chunked, chunked\r\n", [400]),
            ("GET /health HTTP/1.1\r\n" + host + "Transfer-Encoding: chunked, gzip\r\n", [400]),
            ("GET /health HTTP/1.1\r\n" + host + "Transfer-Encoding: gzip\r\n", [400]),
            ("GET /health HTTP/1.1\r\n" + host + "Transfer-Encoding: gzip, chunked\r\n", [501]),
            ("GET /health HTTP/1.0\r\n" + chunks, [400]),
            ("GET /health HTTP/1.1\r\n" + host + "Expect: tea\r\n", [417]),
            ("GET /health HTTP/1.0\r\nExpect: tea\r\n", [200]),
        ):  # fmt: skip
            with self.subTest(first=first):
                self.assertEqual(self.talk((first + "\r\n" + more).encode()), statuses)

    def test_a_body_is_waited_for_when_the_client_is_told_to_send_it(self):
        for method, length, answers in (("GET", 3, (100, 200)), ("POST", 3, (405,)), ("GET", 9999, (413,))):
            with self.subTest(method=method, length=length), socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as connection:
                connection.sendall(f"{method} /health HTTP/1.1\r\nHost: localhost\r\nContent-Length: {length}\r\nExpect: 100-continue\r\n\r\n".encode())
                replies = connection.makefile("rb")
                self.assertIn(str(answers[0]).encode(), replies.readline())
                if answers[0] == 100:
                    connection.sendall(b"abcGET /health HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
                    self.assertEqual(replies.read().count(b"HTTP/1.1 200"), 2)
                else:
                    self.assertIn(b"Connection: close", replies.read())

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
            raw.sendall(f"GET {IMAGE}&azimuth=77 HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())
            raw.sendall(b"GET /health HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
            answers = raw.makefile("rb").read()
        self.assertEqual(answers.count(b"HTTP/1.1 200 OK"), 2)


    def test_hosts(self):
        """A foreign name that resolves to this machine's address is no host of the service."""
        for host, status in (
            ("localhost", 200), ("LOCALHOST.:1", 200), ("127.0.0.1", 200), ("[::1]:80", 200), ("127.0.0.9:1", 421), ("evil.example", 421),
            ("evil.example:8080", 421), ("localhost.evil.example", 421), ("127.0.0.1.evil.example", 421), ("[::2]", 421), ("user@localhost", 400),
        ):  # fmt: skip
            for target in ("/health", "/metrics", "/scenes", "/", IMAGE):
                with self.subTest(host=host, target=target):
                    answer = self.server.get(target, Host=host)
                    self.assertEqual(answer.status, status)
                    if status == 421:
                        self.assertIn("--allow-host", self.assert_problem(answer, 421, words=host)["detail"])

    def test_answers_are_for_pages_of_the_service(self):
        for target in ("/", "/scenes", IMAGE, "/none"):
            answer = self.server.get(target, Origin="https://other.example")
            self.assertEqual(answer.headers["cross-origin-resource-policy"], "same-origin", target)
            self.assertNotIn("access-control-allow-origin", answer.headers)


class Visitors(ServeTest):
    """A service with configured hosts and origins."""

    PAGE = "https://page.example"
    options = ("--workers", "1", "--allow-host", "Images.Example", "--allow-origin", PAGE)

    def test_allowed_hosts(self):
        for host, status in (("images.example", 200), ("images.example:8080", 200), ("localhost", 200), ("other.example", 421)):
            self.assertEqual(self.server.get("/health", Host=host).status, status, host)

    def test_allowed_origins(self):
        for origin, allowed in ((self.PAGE, self.PAGE), ("https://other.example", None), ("null", None), (self.PAGE + ".example", None)):
            for method in ("GET", "HEAD", "OPTIONS"):
                with self.subTest(origin=origin, method=method):
                    answer = self.server.get(IMAGE, method=method, Origin=origin, Access_Control_Request_Method="GET")
                    self.assertEqual(answer.status, 204 if method == "OPTIONS" else 200)
                    self.assertEqual(answer.headers.get("access-control-allow-origin"), allowed)
                    self.assertIn("Origin", answer.headers["vary"])
                    asked = answer.headers.get("access-control-allow-methods")
                    self.assertEqual(asked, "GET, HEAD, POST" if allowed and method == "OPTIONS" else None)
        self.assertIn("ETag", self.server.get(IMAGE, Origin=self.PAGE).headers["access-control-expose-headers"])


class Images(ServeTest):
    def rendered(self, *arguments):
        """Runs nicol-render on the scene, with the samples that the service takes, and returns a reader of its files: stokes.exr and the images."""
        out = os.path.join(self.folder, "rendered")
        subprocess.run([RENDER, os.path.join(self.folder, "square.xml"), "-o", os.path.join(out, "stokes.exr"), "--images", out, "--filter", "box",
                        "--pixel-samples", "1", *arguments], check=True, capture_output=True)  # fmt: skip
        return lambda name: read(os.path.join(out, name))

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        os.mkdir(os.path.join(cls.folder, "rendered"))

    def assert_alike(self, left, right):
        """Checks that the images have equal size and that no value differs by more than rounding."""
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

    def test_light_rotations(self):
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
        # Intensities behind two crossed polarizers add up to the total.
        s0 = read_exr(self.server.get(f"{SQUARE}image.exr{query}").body)["G"]
        first, second = (read_exr(self.server.get(f"{SQUARE}image.exr{query}&polarizer={a}").body)["G"] for a in (30, 120))
        for whole, a, b in zip(s0, first, second):
            self.assertAlmostEqual(whole, a + b, delta=1e-5 * whole)
        self.assertNotEqual(first, second)
        bright = read_exr(self.server.get(f"{SQUARE}image.exr{query}&exposure=2").body)["G"]
        self.assertEqual([4 * v for v in s0], bright)

    def test_planes(self):
        """The planes hold the numbers of stokes.f16 in every content coding."""
        query, pixels = "?size=20x10&azimuth=20", 200
        halves = struct.unpack(f"<{pixels * 12}H", self.server.get(f"{SQUARE}stokes.f16{query}").body)
        tags = set()
        for accepted, coding in (("deflate", "deflate"), ("identity", None), ("gzip, deflate;q=0", None), ("*", "deflate")):
            with self.subTest(accepted=accepted):
                answer = self.server.get(f"{SQUARE}stokes.planes{query}", Accept_Encoding=accepted)
                self.assertEqual((answer.headers.get("content-encoding"), answer.headers["vary"]), (coding, "Accept-Encoding"))
                tags.add((answer.headers["etag"], coding))
                bytes_ = zlib.decompress(answer.body) if coding else answer.body
                self.assertEqual((answer.headers["nicol-components"], len(bytes_)), ("3", pixels * 3 * 3 * 2))
                for plane in range(9):
                    component, channel = divmod(plane, 3)
                    low, high = (bytes_[(2 * plane + byte) * pixels :][:pixels] for byte in range(2))
                    value = 0
                    for i in range(pixels):
                        value = ((value if i % 20 else 0) + low[i] + 256 * high[i]) % 65536
                        self.assertEqual(value, halves[(channel * pixels + i) * 4 + component])
        self.assertEqual(len(tags), 2)

    @unittest.skipUnless(shutil.which("node"), "no Node.js here")
    def test_the_page_reads_planes(self):
        """The page's decoder, run without a browser, gives the Stokes vectors of stokes.f16."""
        query = "?size=20x10&azimuth=20"
        for name, target in (("stokes.mjs", "/stokes.js"), ("planes", f"{SQUARE}stokes.planes{query}")):
            with open(os.path.join(self.folder, name), "wb") as file:
                file.write(self.server.get(target).body)
        script = """import { readFileSync } from "node:fs";
            import { Stokes } from "./stokes.mjs";
            const bytes = readFileSync("planes");
            const planes = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
            process.stdout.write(Buffer.from(new Stokes(20, 10, 3, planes).halves.buffer));"""
        run = subprocess.run(["node", "--input-type=module", "-e", script], cwd=self.folder, capture_output=True, check=True)
        self.assertEqual(run.stdout, self.server.get(f"{SQUARE}stokes.f16{query}").body)

    def test_cameras(self):
        def image(query):
            answer = self.server.get(f"{SQUARE}image.png?size=40x30&{query}")
            self.assertEqual(answer.status, 200, query)
            return answer.body

        own = image("")
        images = {image(q) for q in ("azimuth=90", "azimuth=30", "elevation=60", "distance=9", "target=0.3,0,0", "fov=20", "light=60",
                                         "light_tilt=60")}  # fmt: skip
        self.assertEqual(len(images | {own}), 9)
        # The matrix describes the scene's own camera.
        forward = [-1 / 17.25**0.5, -0.5 / 17.25**0.5, -4 / 17.25**0.5]
        left = [forward[2], 0, -forward[0]]
        norm = (left[0] ** 2 + left[2] ** 2) ** 0.5
        left = [v / norm for v in left]
        up = [forward[1] * left[2] - forward[2] * left[1], forward[2] * left[0] - forward[0] * left[2],
              forward[0] * left[1] - forward[1] * left[0]]  # fmt: skip
        rows = [[left[i], up[i], forward[i], (1, 0.5, 4)[i]] for i in range(3)] + [[0, 0, 0, 1]]
        self.assert_alike(image("matrix=" + ",".join(str(v) for row in rows for v in row)), own)
        # The orbit also describes the scene's own camera.
        scene = next(s for s in self.server.get("/scenes").json()["scenes"] if s["id"] == "square")
        orbit = image(f"azimuth={scene['azimuth']}")
        self.assertLess(sum(a != b for a, b in zip(read_png(orbit)[2], read_png(own)[2])), 400)

    def test_scale_is_told(self):
        scale = float(self.server.get(f"{SQUARE}image.png?size=20x10&observer=s1").headers["nicol-scale"])
        exr = read_exr(self.server.get(f"{SQUARE}image.exr?size=20x10&observer=s1").body)
        means = [abs(sum(v) / 3) for v in zip(exr["R"], exr["G"], exr["B"])]
        self.assertAlmostEqual(scale, max(means), delta=1e-6)
        self.assertEqual(self.server.get(f"{SQUARE}image.png?size=20x10&observer=s1&scale=0.5").headers["nicol-scale"], "0.5")


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
        self.assert_problem(self.server.get(self.sign(IMAGE, self.KEYS[0]).replace("32x24", "33x24")), 403, "sig")
        # A client without a signature does not learn which scenes exist.
        self.assert_problem(self.server.get("/scenes/none/image.png"), 403, "sig")
        self.assert_problem(self.server.get(self.sign(SQUARE + "image.png?size=0x0", self.KEYS[0])), 400, "size")
        self.assertEqual(self.server.get("/ready").status, 200)

    def test_expiry(self):
        past = int(time.time()) - 10
        self.assert_problem(self.server.get(self.sign(f"{IMAGE}&expires={past}", self.KEYS[1])), 403, "expires")

    def test_command_line_signs(self):
        run = subprocess.run([PROGRAM, "--keys", self.keys, "--sign", IMAGE], capture_output=True, text=True, check=True)
        self.assertEqual(run.stdout.strip(), self.sign(IMAGE, self.KEYS[0]))


if __name__ == "__main__":
    unittest.main()
