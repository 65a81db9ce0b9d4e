# SPDX-License-Identifier: MIT
"""A client that openapi-python-client makes of nicol-serve's description gets scenes, Stokes vectors and problems, and
sends a scene.

usage: serve_client_test.py NICOL_SERVE"""

import importlib.util
import os
import struct
import subprocess
import sys
import tempfile
import unittest

from serve_client import Server, write_scenes


def missing():
    return [name for name in ("openapi_python_client", "httpx", "attrs") if importlib.util.find_spec(name) is None]


class GeneratedClient(unittest.TestCase):
    def test_scenes_stokes_vectors_and_problems(self):
        with tempfile.TemporaryDirectory() as folder:
            write_scenes(folder)
            server = Server(sys.argv[1], folder, "--workers", "1", "--allow-upload")
            try:
                description = os.path.join(folder, "openapi.json")
                with open(description, "wb") as file:
                    file.write(server.get("/openapi.json").body)
                subprocess.run(
                    [sys.executable, "-m", "openapi_python_client", "generate", "--path", description,
                     "--output-path", os.path.join(folder, "generated"), "--meta", "none"],
                    check=True, stdout=subprocess.DEVNULL)  # fmt: skip
                sys.path.insert(0, folder)
                from generated import Client
                from generated.api.default import get_ready, get_scene, get_scenes, get_stokes_f32, post_scene
                from generated.types import File

                client = Client(base_url=f"http://127.0.0.1:{server.port}/v1")
                self.assertTrue(get_ready.sync(client=client).ready)
                scenes = {scene.id: scene for scene in get_scenes.sync(client=client).scenes}
                self.assertEqual(scenes["square"].size, [24, 16])
                answer = get_stokes_f32.sync_detailed("square", client=client, size="24x16", azimuth=20.0)
                stokes = struct.unpack(f"<{3 * 16 * 24 * 4}f", answer.content)
                self.assertGreater(max(stokes[::4]), 0)
                self.assertEqual(answer.headers["nicol-size"], "24x16")
                self.assertEqual(get_stokes_f32.sync("none", client=client).status, 404)
                with open(os.path.join(folder, "box.xml"), "rb") as scene:
                    sent = post_scene.sync(client=client, body=File(payload=scene))
                server.wait(lambda: get_scene.sync(sent.id, client=client).state == "ready")
                box = get_stokes_f32.sync_detailed("box", client=client, size="24x16").content
                self.assertEqual(get_stokes_f32.sync_detailed(sent.id, client=client, size="24x16").content, box)
            finally:
                server.stop()


if __name__ == "__main__":
    if missing():
        print(f"skipped: this Python has no {', '.join(missing())}")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
