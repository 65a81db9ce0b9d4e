#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the images of the textured scenes, and textured.gltf with its buffer. usage: make_textures.py [FOLDER]

Floor tiles, 4 x 4 in a repeating image: colours, roughness and normals. Bands of gold leaf on lacquer: colours, and
roughness and metallic in the channels of glTF (green and blue). The script needs only numpy, and writes the same files
each time.
"""

import json
import os
import struct
import sys
import zlib

import numpy as np

SIZE = 256  # pixels per side


def write_png(path, values):
    """Writes values of 0 to 1, [y][x] or [y][x][3], with 8 bits."""
    samples = np.rint(np.clip(values, 0, 1) * 255).astype(np.uint8)
    height, width = samples.shape[:2]
    rows = samples.reshape(height, -1).astype(int)
    # Each row is stored as differences from the row above, which deflate well.
    filtered = np.diff(rows, axis=0, prepend=np.zeros((1, rows.shape[1]), int)) % 256
    data = np.hstack([np.full((height, 1), 2), filtered]).astype(np.uint8).tobytes()

    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    kind = 0 if samples.ndim == 2 else 2
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)))
        file.write(chunk(b"IDAT", zlib.compress(data, 9)) + chunk(b"IEND", b""))
    print(f"{path}: {width} x {height}, {os.path.getsize(path)} bytes")


def srgb(linear):
    linear = np.asarray(linear, float)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055)


def step(low, high, x):
    """Returns 0 below low, 1 above high, and a smooth transition between."""
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def pixels():
    """Returns u and v of pixel centres, v downwards."""
    middles = (np.arange(SIZE) + 0.5) / SIZE
    return np.meshgrid(middles, middles)


def tiles():
    """Returns the distance to the joint in tiles, and three random numbers per tile."""
    u, v = pixels()
    x, y = 4 * u, 4 * v
    joint = np.minimum(np.minimum(x % 1, 1 - x % 1), np.minimum(y % 1, 1 - y % 1))
    random = np.random.default_rng(7).random((4, 4, 3))
    return joint, random[y.astype(int), x.astype(int)]


def tile_height(joint, random):
    """Returns the height in tiles: a round edge, a joint below it, and slightly tilted and uneven tops."""
    u, v = pixels()
    x, y = (4 * u) % 1 - 0.5, (4 * v) % 1 - 0.5
    top = 0.05 * (random[..., 0] - 0.5) * x + 0.05 * (random[..., 1] - 0.5) * y
    top += 0.0015 * np.cos(2 * np.pi * (3 * x + random[..., 2])) * np.cos(2 * np.pi * 2 * y)
    return step(0.02, 0.07, joint) * (0.03 + top)


def normals(height, scale):
    """Returns normals in OpenGL's convention (x to the right, y up) of a height in units of 1 / scale of the image."""
    dx = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) * SIZE / (2 * scale)
    dy = (np.roll(height, 1, 0) - np.roll(height, -1, 0)) * SIZE / (2 * scale)
    n = np.stack([-dx, -dy, np.ones_like(height)], axis=-1)
    return 0.5 + 0.5 * n / np.linalg.norm(n, axis=-1, keepdims=True)


def make_tiles(folder):
    joint, random = tiles()
    glaze = np.array([0.055, 0.11, 0.14]) + random[..., :1] * np.array([0.05, 0.06, 0.03])
    mortar = np.array([0.11, 0.10, 0.085])
    top = step(0.02, 0.04, joint)[..., None]
    write_png(os.path.join(folder, "tiles_color.png"), srgb(top * glaze + (1 - top) * mortar))
    write_png(os.path.join(folder, "tiles_roughness.png"), top[..., 0] * (0.12 + 0.16 * random[..., 1]) + (1 - top[..., 0]) * 0.7)
    write_png(os.path.join(folder, "tiles_normals.png"), normals(tile_height(joint, random), 4))


def make_bands(folder):
    u, v = pixels()
    wave = 0.06 * np.sin(2 * np.pi * 3 * u)
    gold = step(0.62, 0.66, np.abs(((v + wave) * 5) % 1 - 0.5) * 2)
    lacquer = np.array([0.16, 0.012, 0.01])
    color = gold[..., None] * np.array([1.0, 0.766, 0.336]) + (1 - gold[..., None]) * lacquer
    write_png(os.path.join(folder, "bands_color.png"), srgb(color))
    worn = 0.5 + 0.5 * np.sin(2 * np.pi * (5 * u + 2 * v)) * np.sin(2 * np.pi * 4 * v)
    surface = np.stack([np.zeros_like(u), gold * (0.35 + 0.25 * worn) + (1 - gold) * 0.3, gold], axis=-1)
    write_png(os.path.join(folder, "bands_surface.png"), surface)


def cube():
    """Returns corner positions, normals, texture coordinates (v downwards) and triangles; each side is the whole image."""
    positions, normal, texcoords, triangles = [], [], [], []
    for axis in range(3):
        for sign in (-1, 1):
            n = np.zeros(3)
            n[axis] = sign
            up = np.array([0, 0, -sign]) if axis == 1 else np.array([0, 1, 0])
            right = np.cross(up, n)
            first = len(positions)
            for u, v in ((0, 0), (0, 1), (1, 1), (1, 0)):
                positions.append(n + (2 * u - 1) * right + (1 - 2 * v) * up)
                normal.append(n)
                texcoords.append((u, v))
            triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return positions, normal, texcoords, triangles


def sphere(rows=32, columns=64):
    """Returns the arrays of cube() for a unit sphere; the image goes around it once, with its top at +y."""
    angles = [(np.pi * r / rows, 2 * np.pi * c / columns) for r in range(rows + 1) for c in range(columns + 1)]
    positions = [(np.sin(t) * np.sin(p), np.cos(t), np.sin(t) * np.cos(p)) for t, p in angles]
    texcoords = [(p / (2 * np.pi), t / np.pi) for t, p in angles]
    triangles = []
    for r in range(rows):
        for c in range(columns):
            a = r * (columns + 1) + c
            b = a + columns + 1
            if r > 0:
                triangles.append((a, b, a + 1))
            if r < rows - 1:
                triangles.append((a + 1, b, b + 1))
    return positions, positions, texcoords, triangles


def make_gltf(folder):
    data, views, accessors, meshes = b"", [], [], []

    def accessor(values, kind, form, component, target, bounds=False):
        nonlocal data
        values = np.asarray(values).astype(form)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": values.nbytes, "target": target})
        data += values.tobytes() + b"\0" * (-values.nbytes % 4)
        entry = {"bufferView": len(views) - 1, "componentType": component, "type": kind, "count": len(values)}
        if kind == "SCALAR":
            entry["count"] = values.size
        if bounds:
            entry["min"], entry["max"] = values.min(0).tolist(), values.max(0).tolist()
        accessors.append(entry)
        return len(accessors) - 1

    for material, (positions, normal, texcoords, triangles) in enumerate((cube(), sphere())):
        attributes = {
            "POSITION": accessor(positions, "VEC3", "<f4", 5126, 34962, True),
            "NORMAL": accessor(normal, "VEC3", "<f4", 5126, 34962),
            "TEXCOORD_0": accessor(texcoords, "VEC2", "<f4", 5126, 34962),
        }
        indices = accessor(np.ravel(triangles), "SCALAR", "<u2", 5123, 34963)
        meshes.append({"primitives": [{"attributes": attributes, "indices": indices, "material": material}]})
    names = ["tiles_color", "tiles_roughness", "tiles_normals", "bands_color", "bands_surface"]
    file = {
        "asset": {"version": "2.0", "generator": "make_textures.py", "copyright": "MIT, as Nicol"},
        "scene": 0,
        "scenes": [{"nodes": [0, 1, 2]}],
        "nodes": [
            {"name": "tiled cube", "mesh": 0, "translation": [-1.3, 0, 0], "rotation": [0, 0.342020, 0, 0.939693]},
            {"name": "gilt ball", "mesh": 1, "translation": [1.4, 0, 0.2], "scale": [1.15, 1.15, 1.15]},
            {"name": "camera", "camera": 0, "translation": [0, 1.9, 6.2], "rotation": [-0.147809, 0, 0, 0.989016]},
        ],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.66, "aspectRatio": 1.5, "znear": 0.1, "zfar": 100}}],
        "materials": [
            {
                "name": "tiles",
                "pbrMetallicRoughness": {
                    "baseColorTexture": {"index": 0},
                    "metallicRoughnessTexture": {"index": 1},
                    "metallicFactor": 0,
                },
                "normalTexture": {"index": 2, "scale": 0.8},
            },
            {
                "name": "gold leaf on lacquer",
                "pbrMetallicRoughness": {"baseColorTexture": {"index": 3}, "metallicRoughnessTexture": {"index": 4}},
            },
        ],
        "textures": [{"source": i, "sampler": 0} for i in range(len(names))],
        "samplers": [{"magFilter": 9729, "minFilter": 9987}],
        "images": [{"uri": name + ".png"} for name in names],
        "meshes": meshes,
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"uri": "textured.bin", "byteLength": len(data)}],
    }
    with open(os.path.join(folder, "textured.bin"), "wb") as out:
        out.write(data)
    with open(os.path.join(folder, "textured.gltf"), "w", encoding="utf-8") as out:
        out.write(json.dumps(file, indent=1) + "\n")
    print(f"textured.gltf, textured.bin: {len(data)} bytes")


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    make_tiles(folder)
    make_bands(folder)
    make_gltf(folder)


if __name__ == "__main__":
    main()
