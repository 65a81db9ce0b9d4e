# SPDX-License-Identifier: MIT
"""Scenes that clients send to nicol-serve, and the events of a render.

usage: serve_upload_test.py NICOL_SERVE NICOL_RENDER [unittest options]"""

import json
import os
import shutil
import socket
import struct
import subprocess
import tempfile
import unittest
import zlib

from images import read_png
from program_test import PROGRAM
from serve_case import IMAGE, RENDER, ServeTest, read
from serve_client import PATIENCE, SCENE, Server, write_scenes

XML = SCENE.format(shape="cube", blue=0.7).encode()
OBJ = b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n"
WITH_MESH = XML.replace(b'<shape type="cube">', b'<shape type="obj"><string name="filename" value="models/a.obj"/>')
LOOP = XML.replace(b"<sensor", b'<include filename="scene.xml"/><sensor')


def glb():
    """Returns a GLB file of one triangle."""
    points = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0)
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36}],
    }).encode()  # fmt: skip
    text += b" " * (-len(text) % 4)
    size = 12 + 8 + len(text) + 8 + len(points)
    return (b"glTF" + struct.pack("<II", 2, size) + struct.pack("<I", len(text)) + b"JSON" + text
            + struct.pack("<I", len(points)) + b"BIN\0" + points)  # fmt: skip


def multipart(files, boundary="b0undary"):
    parts = [
        f'--{boundary}\r\nContent-Disposition: form-data; name="file"; filename="{name}"\r\n\r\n'.encode() + content + b"\r\n"
        for name, content in files
    ]
    return f"multipart/form-data; boundary={boundary}", b"".join(parts) + f"--{boundary}--\r\n".encode()


class UploadTest(ServeTest):
    options = ("--allow-upload", "--workers", "1", "--max-upload", "1", "--uploads", "3", "--load-bytes-limit", "3000000",
               "--deadline", "60", "--render-limit", "60")  # fmt: skip

    def send(self, content, kind="application/xml", target="/v1/scenes", **headers):
        connection = self.server.connect()
        connection.request("POST", target, content, {"Content-Type": kind, **{k.replace("_", "-"): v for k, v in headers.items()}})
        return self.server.answer(connection)

    def loaded(self, answer):
        """Returns the state of an accepted scene once it is loaded, or not."""
        self.assertEqual(answer.status, 202, answer.body)
        target, state = answer.headers["location"], {}

        def settled():
            state.update(self.server.get(target).json())
            return state["state"] != "preparing"

        self.server.wait(settled)
        return state

    def test_a_scene_becomes_an_image_as_by_nicol_render(self):
        state = self.loaded(self.send(XML))
        self.assertEqual((state["state"], state["scene"]["size"]), ("ready", [24, 16]))
        path = os.path.join(self.folder, "sent.xml.txt")
        with open(path, "wb") as file:
            file.write(XML)
        out = os.path.join(self.folder, "sent.exr")
        subprocess.run([RENDER, path, "-o", out, "--filter", "box", "--pixel-samples", "1"], check=True, capture_output=True)
        self.assertEqual(self.server.get(state["scene"]["stokes.exr"]).body, read(out))
        # The id is that of the content, and only its sender knows it.
        self.assertEqual(self.send(XML).json()["id"], state["id"])
        self.assertNotIn(state["id"], self.server.get("/scenes").body.decode() + self.server.get("/ready").body.decode())

    def test_formats(self):
        bundle = [("rooms/scene.xml", WITH_MESH.replace(b"models/a.obj", b"../models/a.obj")), ("models/a.obj", OBJ)]
        for content, kind in (
            (glb(), "model/gltf-binary"),
            (glb(), "application/octet-stream"),
            (XML, "text/xml; charset=utf-8"),
            multipart(bundle)[::-1],
            multipart([("only.glb", glb())], boundary="x")[::-1],
        ):
            state = self.loaded(self.send(content, kind))
            self.assertEqual(state["state"], "ready", state)
            self.assertEqual(read_png(self.server.get(f"/v1/scenes/{state['id']}/image.png?size=16x12").body)[:2], (16, 12))

    def test_what_cannot_be_loaded_says_why(self):
        secret = os.path.join(self.folder, "secret.obj")
        with open(secret, "wb") as file:
            file.write(OBJ)
        for content, reason in (
            (b"<scene", "scene.xml:1"),
            (b"\x89PNG\r\n\x1a\n", "PNG"),
            (WITH_MESH, "models/a.obj: no such file"),
            (WITH_MESH.replace(b"models/a.obj", secret.encode()), "secret.obj: no such file"),
            (WITH_MESH.replace(b"models/a.obj", b"../../../../etc/passwd"), "passwd"),
            (LOOP, "circle"),
            (XML.replace(b'type="cube"', b'type="marble"'), "marble"),
        ):
            state = self.loaded(self.send(content))
            self.assertEqual(state["state"], "broken")
            self.assertIn(reason, state["reason"])
            self.assert_problem(self.server.get(f"/v1/scenes/{state['id']}/image.png"), 503)
        self.assertEqual(self.server.get(IMAGE).status, 200)

    def test_limits_of_loading(self):
        # A small file that becomes more than the limit of bytes.
        row = b"\0" * (3 * 4096 + 1)
        chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))  # noqa: E731
        bomb = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 4096, 4096, 8, 2, 0, 0, 0))
        bomb += chunk(b"IDAT", zlib.compress(row * 4096, 9)) + chunk(b"IEND", b"")
        scene = XML.replace(
            b'<float name="alpha"',
            b'<texture type="bitmap" name="diffuse_reflectance"><string name="filename" value="b.png"/></texture><float name="alpha"')
        state = self.loaded(self.send(*multipart([("a.xml", scene), ("b.png", bomb)])[::-1]))
        self.assertEqual(state["state"], "broken")
        self.assertIn("load_bytes_limit", state["reason"])

    def test_refused_bodies(self):
        kind, body = multipart([("a.xml", XML), ("b.obj", OBJ)])
        for content, type_, status in (
            (XML, "text/plain", 415),
            (XML, "", 415),
            (b"", "application/xml", 400),
            (body, "multipart/form-data", 400),
            (body, "multipart/form-data; boundary=other", 400),
            (body[:-20], kind, 400),
            (body[:40], kind, 400),
            (multipart([("/etc/passwd", XML)])[1], kind, 400),
            (multipart([("../a.xml", XML)])[1], kind, 400),
            (multipart([("a\\\\b.xml", XML)])[1], kind, 400),
            (multipart([("", XML)])[1], kind, 400),
            (multipart([("a.xml", XML), ("a.xml", OBJ)])[1], kind, 400),
            (multipart([(f"{i}", b"x") for i in range(1001)])[1], kind, 400),
            (body.replace(b"Content-Disposition", b"Content-Position"), kind, 400),
            (multipart([])[1], kind, 400),
            (XML + b" " * (1 << 20), "application/xml", 413),
        ):
            self.assert_problem(self.send(content, type_), status)
        self.assert_problem(self.send(XML, target="/v1/scenes/square"), 405)
        self.assert_problem(self.send(XML, origin="http://elsewhere.example"), 403)
        self.assertEqual(self.send(XML, origin=f"http://127.0.0.1:{self.server.port}").status, 202)
        self.assertIn("POST", self.server.get("/v1/scenes", "PUT").headers["allow"])
        self.assertNotIn("POST", self.server.get("/v1/ready", "PUT").headers["allow"])
        self.assertEqual(self.server.get(IMAGE).status, 200)

    @unittest.skipUnless(shutil.which("curl"), "no program curl")
    def test_curl_waits_for_permission(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "big.xml")
            with open(path, "wb") as file:
                file.write(XML + b" " * 500000)
            for size, status in ((0, "202"), (1 << 20, "413")):
                with open(path, "ab") as file:
                    file.write(b" " * size)
                done = subprocess.run(
                    ["curl", "-s", "-o", os.devnull, "-w", "%{http_code}", "-H", "Expect: 100-continue", "-F", f"scene=@{path}",
                     f"http://127.0.0.1:{self.server.port}/v1/scenes"],
                    capture_output=True, text=True, timeout=PATIENCE)  # fmt: skip
                self.assertEqual(done.stdout, status)

    def test_too_many_at_once(self):
        """Bodies that never come take the few rooms, and give them back."""
        head = b"POST /v1/scenes HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/xml\r\nContent-Length: 9000\r\n\r\nx"
        sockets = []
        try:
            for _ in range(4):
                sockets.append(socket.create_connection(("127.0.0.1", self.server.port), PATIENCE))
                sockets[-1].sendall(head)
            self.server.wait(lambda: self.send(XML).status == 429)
            self.assertIn("retry-after", self.send(XML).headers)
            self.assertEqual(self.server.get(IMAGE).status, 200)
        finally:
            for each in sockets:
                each.close()
        self.server.wait(lambda: self.send(XML).status == 202)

    def test_the_oldest_makes_room(self):
        scenes = [SCENE.format(shape="cube", blue=0.1 + i / 100).encode() for i in range(4)]
        ids = [self.loaded(self.send(scene))["id"] for scene in scenes[:3]]
        self.assertEqual(self.server.get(f"/scenes/{ids[0]}/image.png").status, 200)
        ids.append(self.loaded(self.send(scenes[3]))["id"])
        states = [self.server.get(f"/scenes/{each}").status for each in ids]
        self.assertEqual(states, [200, 404, 200, 200])
        pictures = {self.server.get(f"/scenes/{each}/stokes.f32").body for each in (ids[0], ids[2], ids[3])}
        self.assertEqual(len(pictures), 3)

    def test_a_killed_worker_gets_the_scene_again(self):
        state = self.loaded(self.send(XML))
        target = f"/scenes/{state['id']}/image.png?azimuth=77"
        before = self.server.get(target).body
        self.server.signal_workers(9)
        self.server.wait(lambda: self.server.get(target + "&samples=2").status == 200)
        self.assertEqual(self.server.get(target).body, before)

    def events(self, target):
        """Returns the head and the events of a render, as (name, data)."""
        with socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as client:
            client.sendall(f"GET {target} HTTP/1.1\r\nHost: localhost\r\nAccept: text/event-stream\r\n\r\n".encode())
            text = b"".join(iter(lambda: client.recv(65536), b"")).decode()
        head, _, body = text.partition("\r\n\r\n")
        found = [dict(line.split(": ", 1) for line in event.split("\n")) for event in body.strip().split("\n\n")]
        return head, [(event["event"], json.loads(event["data"])) for event in found]

    def test_events(self):
        target = "/v1/scenes/box/image.png?size=512x512&samples=64"
        head, events = self.events(target)
        self.assertIn("text/event-stream", head)
        self.assertEqual(events[-1], ("done", {"url": target}))
        progress = [data for name, data in events if name == "progress"]
        self.assertEqual(len(progress), len(events) - 1)
        self.assertGreater(len(progress), 0)
        for data in progress:
            self.assertIn(data["verb"], ("project", "bake", "relight", "shade", "draw"))
            self.assertTrue(0 <= data["percent"] <= 100)
            self.assertGreaterEqual(data.get("seconds_left", 0), 0)
        self.assertEqual(read_png(self.server.get(target).body)[:2], (512, 512))
        # A kept answer is announced at once.
        self.assertEqual(self.events(target)[1], [("done", {"url": target})])
        self.assertEqual(self.server.get(IMAGE, Accept="text/event-streams").headers["content-type"], "image/png")

    def test_events_of_what_is_wrong(self):
        self.assert_problem(self.server.get("/scenes/box/image.png?size=0x0", Accept="text/event-stream"), 400, "size")

    def test_who_leaves_the_events_is_not_worked_for(self):
        gone = self.server.metric("clients_gone_total")
        with socket.create_connection(("127.0.0.1", self.server.port), PATIENCE) as client:
            client.sendall(b"GET /scenes/box/image.png?size=2000x1000&samples=64&azimuth=3 HTTP/1.1\r\nHost: localhost\r\n"
                           b"Accept: text/event-stream\r\n\r\n")  # fmt: skip
            self.assertIn(b"event: progress", client.recv(65536) + client.recv(65536))
        self.server.wait(lambda: self.server.metric("clients_gone_total") > gone)
        self.assertEqual(self.server.get(IMAGE).status, 200)


class OthersTest(unittest.TestCase):
    def test_without_permission_or_signature(self):
        with tempfile.TemporaryDirectory() as folder:
            write_scenes(folder)
            server = Server(PROGRAM, folder, "--workers", "1")
            try:
                connection = server.connect()
                connection.request("POST", "/v1/scenes", XML[:500], {"Content-Type": "application/xml"})
                answer = server.answer(connection)
                self.assertEqual((answer.status, answer.headers["allow"]), (405, "GET, HEAD, OPTIONS"))
                self.assertNotIn("post", server.get("/openapi.json").json()["paths"]["/scenes"])
            finally:
                server.stop()
            keys = os.path.join(folder, "keys")
            with open(keys, "w", encoding="utf-8") as file:
                file.write("00112233445566778899aabbccddeeff\n")
            signed = subprocess.run([PROGRAM, "--keys", keys, "--sign", "/v1/scenes"], check=True, capture_output=True, text=True)
            server = Server(PROGRAM, folder, "--workers", "1", "--allow-upload", "--keys", keys)
            try:
                for target, status in (("/v1/scenes", 403), (signed.stdout.strip(), 202)):
                    connection = server.connect()
                    connection.request("POST", target, XML, {"Content-Type": "application/xml"})
                    self.assertEqual(server.answer(connection).status, status, target)
                self.assertIn("post", server.get("/openapi.json").json()["paths"]["/scenes"])
            finally:
                server.stop()


if __name__ == "__main__":
    unittest.main()
