# SPDX-License-Identifier: MIT
"""Mutated requests against nicol-serve. usage: serve_fuzz.py PROGRAM [--count N] [--seed N]

Fails where an answer is 5xx other than the deliberate 503 and 504, where one is no HTTP, where a worker or the service dies, or
where it renders no more afterwards."""

import argparse
import os
import random
import socket
import tempfile

from serve_client import PATIENCE, Server, write_scenes

PATHS = ["/", "/scenes", "/health", "/ready", "/metrics", "/openapi.json", "/page.js", "/scenes/box/image.png",
         "/scenes/box/image.exr", "/scenes/square/stokes.exr", "/scenes/square/stokes.f16", "/scenes/square/stokes.f32",
         "/scenes/box/stokes.planes"]  # fmt: skip
NAMES = ["size", "azimuth", "elevation", "distance", "target", "matrix", "fov", "light", "light_tilt", "order_low", "order_high",
         "tolerance", "observer", "polarizer", "exposure", "scale", "sig", "expires", "x"]  # fmt: skip
VALUES = ["0", "1", "-1", "45", "89", "90", "1e308", "-1e308", "1e-308", "nan", "inf", "-0", "0x10", "1,2,3", "0,0,0", "16x16", "1x1",
          "2048x1024", "99999x99999", "-1x5", "s0", "s3", "dolp", "aolp", "polarizer", "", "%00", "%ff%fe", "%", "'\"<>", "1" * 400,
          ",".join(["1e6"] * 16), ",".join(["0"] * 16), "-0.7,0,0.7,3,0,1,0,0,-0.7,0,-0.7,3,0,0,0,1", "0.001", "1e6", "../..", "é"]  # fmt: skip
# Valid values, so that many requests reach the renderer.
GOOD = {"size": ["8x8", "1x1", "64x3"], "azimuth": ["30", "-360"], "elevation": ["89", "-12.5"], "distance": ["0.001", "3", "1e6"],
        "target": ["0,0,0", "1e6,1,1"], "fov": ["1", "170"], "light": ["77"], "light_tilt": ["-180"], "order_low": ["0", "3"],
        "order_high": ["9"], "tolerance": ["1", "0.05"], "observer": ["s0", "s3", "dolp", "aolp"], "polarizer": ["12"],
        "exposure": ["-20", "20"], "scale": ["1e-6"],
        "matrix": [",".join(["0"] * 16), "-0.7,0,0.7,3,0,1,0,0,-0.7,0,-0.7,3,0,0,0,1", "-1,0,0,0,0,1,0,0,0,0,-1,3,0,0,0,1"]}  # fmt: skip
METHODS = ["GET"] * 20 + ["HEAD", "POST", "PUT", "OPTIONS", "TRACE", "CONNECT", "get", "G\x00T", ""]
HEADERS = ["Host: x", "If-None-Match: *", 'If-None-Match: "', "Connection: close", "Connection: upgrade", "Content-Length: 3",
           "Content-Length: -1", "Content-Length: 99999999999999999999", "Transfer-Encoding: chunked", "Expect: 100-continue", "Accept-Encoding: deflate",
           "Range: bytes=0-1", "A" * 300 + ": b", ": empty", "no colon", "X: \x01\x02", " folded"]  # fmt: skip


def request(random):
    names = random.sample(NAMES, random.choice([0, 1, 1, 2, 3])) if random.random() < 0.97 else random.choices(NAMES, k=40)
    likely = random.random() < 0.7
    query = "&".join(f"{name}={random.choice(GOOD.get(name, VALUES) if likely else VALUES)}" for name in names)
    # Few images are large, because rendering would take most of the time.
    if "size=" not in query:
        query += "&size=8x8" if query else "size=8x8"
    target = random.choice(PATHS) + "?" + query
    headers = ["Host: localhost"] * (random.random() < 0.9) + [random.choice(HEADERS) for _ in range(random.choice([0, 0, 1, 2, 5]))]
    text = f"{random.choice(METHODS)} {target} {random.choice(['HTTP/1.1'] * 9 + ['HTTP/1.0', 'HTTP/3', ''])}\r\n"
    data = bytearray((text + "".join(h + "\r\n" for h in headers) + "\r\n").encode("utf-8", "surrogateescape"))
    if random.random() < 0.2:
        data += random.choice([b"abc", b"3\r\nabc\r\n0\r\n\r\n", b"x" * 5000, bytes(data)])
    for _ in range(random.choice([0, 0, 0, 0, 1, 2, 8])):
        kind, at = random.randrange(4), random.randrange(len(data))
        if kind == 0:
            data[at] = random.randrange(256)
        elif kind == 1:
            del data[at : at + random.randrange(1, 10)]
        elif kind == 2:
            data[at:at] = bytes(random.randrange(256) for _ in range(random.randrange(1, 10)))
        else:
            data[at:at] = data[at : at + random.randrange(1, 200)]
        if not data:
            data = bytearray(b"\r\n")
    return bytes(data)


def send(server, data, leaves):
    """Returns the status of the first answer, or None if the service closed without one, which is allowed if the request
    had no end."""
    with socket.create_connection(("127.0.0.1", server.port), PATIENCE) as connection:
        try:
            connection.sendall(data)
            if leaves:
                return None
            # Neither side waits for an incomplete header. With a complete header an early close means that the client
            # wants no image.
            if b"\r\n\r\n" not in data:
                connection.shutdown(socket.SHUT_WR)
            line = connection.makefile("rb").readline(200)
        except TimeoutError:
            raise AssertionError(f"no answer to {data!r}") from None
        except OSError:
            return None
    if not line:
        return None
    words = line.split(b" ")
    if not words[0].startswith(b"HTTP/1.") or len(words) < 3 or not words[1].isdigit():
        raise AssertionError(f"no HTTP: {line!r} after {data!r}")
    return int(words[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    source, counts = random.Random(arguments.seed), {}
    with tempfile.TemporaryDirectory() as folder:
        write_scenes(folder)
        server = Server(arguments.program, folder, "--read-limit", "0.2", "--idle-limit", "0.5", "--max-pixels", "65536")
        try:
            for number in range(arguments.count):
                data = request(source)
                status = send(server, data, source.random() < 0.1)
                counts[status] = counts.get(status, 0) + 1
                if status is not None and status >= 500 and status not in (503, 504):
                    raise AssertionError(f"request {number}: {status} after {data!r}")
                if server.process.poll() is not None:
                    raise AssertionError(f"request {number}: the service ended after {data!r}: {server.errors()}")
            lost = {name: value for name, value in server.metrics().items() if name.startswith("workers_lost")}
            if any(lost.values()):
                raise AssertionError(f"{lost}: {server.errors()}")
            if server.get("/scenes/box/image.png?size=9x9").status != 200:
                raise AssertionError("it renders no more")
        finally:
            code = server.stop()
        if code != 0:
            raise AssertionError(f"exit code {code}")
    told = ", ".join(f"{status or 'closed'}: {counts[status]}" for status in sorted(counts, key=lambda s: s or 0))
    print(f"{arguments.count} requests, seed {arguments.seed}: {told}")


if __name__ == "__main__":
    main()
