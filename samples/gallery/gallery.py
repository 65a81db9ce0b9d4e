#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Renders the images of the README. usage: gallery.py [FOLDER]

The script needs numpy, and libnicol where the package `nicol` in samples/python finds it. Each pixel is the mean of 2 x 2 Stokes vectors.
"""

import os
import struct
import sys
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))
SAMPLES = os.path.dirname(HERE)
sys.path.insert(0, os.path.join(SAMPLES, "python"))

import nicol  # noqa: E402
import numpy as np  # noqa: E402
import table  # noqa: E402

GAP = 4


def render(context, scene_file, width, height, light_angle=0, view=None):
    """Returns Stokes vectors, [row][column][channel][component]; view: (origin, target, field of view in degrees)."""
    definitions = [f"light_angle={light_angle}"]
    with nicol.Scene.load(context, os.path.join(SAMPLES, "assets", scene_file), definitions) as scene:
        camera = scene.get_camera()
        if view:
            camera.look_at(view[0], view[1], (0, 1, 0))
            camera.fov = view[2]
        with nicol.Framebuffer.create(context, 2 * width, 2 * height, 3) as framebuffer:
            nicol.render(scene, camera, nicol.RenderOptions(), framebuffer)
            stokes = np.stack([framebuffer.plane(nicol.PLANE_STOKES, channel=c) for c in range(3)], axis=2)
    return stokes.reshape(height, 2, width, 2, 3, 4).mean(axis=(1, 3))


def torus(context, rows, columns):
    """Returns a torus with waves, of rows x columns vertices."""
    u, v = np.meshgrid(2 * np.pi * np.arange(rows) / rows, 2 * np.pi * np.arange(columns) / columns, indexing="ij")
    tube = 0.42 + 0.06 * np.sin(5 * u) * np.cos(3 * v)
    ring = 1 + tube * np.cos(v)
    places = np.stack([ring * np.cos(u), tube * np.sin(v), ring * np.sin(u)], -1).reshape(-1, 3)
    r, c = (i.ravel() for i in np.indices((rows, columns)))
    at = lambda row, column: row % rows * columns + column % columns  # noqa: E731
    corners = [at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r, c), at(r + 1, c + 1), at(r + 1, c)]
    return nicol.Mesh.create(context, nicol.mesh_data(places, np.stack(corners, -1).reshape(-1, 3)))


def plastic(context):
    red = nicol.Spectrum(count=3, values=[0.13, 0.035, 0.015] + 13 * [0])
    return nicol.Material.create_pplastic(
        context, nicol.Pplastic(diffuse_reflectance=red, distribution=nicol.DISTRIBUTION_GGX, alpha=0.15)
    )


def brushed_gold(context):
    return nicol.Material.create_conductor(context, nicol.Conductor(metal=b"Au", alpha_u=0.1, alpha_v=0.4))


def render_in_forest(context, make_mesh, make_material, fov, brightness, size, **options):
    """Returns Stokes vectors like render(), of one mesh in the forest."""
    with (
        nicol.Scene.create(context) as scene,
        make_mesh(context) as mesh,
        make_material(context) as material,
        nicol.Environment.load(context, os.path.join(SAMPLES, "assets", "forest_blurred.exr")) as light,
        nicol.Framebuffer.create(context, 2 * size, 2 * size, 3) as framebuffer,
    ):
        scene.add_instance(nicol.Instance(mesh=mesh, material=material))
        scene.set_environment(light, None, brightness)
        camera = nicol.Camera(fov=fov)
        camera.look_at((1.5, 3, 3), (0, 0, 0), (0, 1, 0))
        nicol.render(scene, camera, nicol.RenderOptions(**options), framebuffer)
        stokes = np.stack([framebuffer.plane(nicol.PLANE_STOKES, channel=c) for c in range(3)], axis=2)
    return stokes.reshape(size, 2, size, 2, 3, 4).mean(axis=(1, 3))


def render_table(context, width, height, **options):
    """Returns Stokes vectors like render(), of the table in the forest."""
    light = nicol.Environment.load(context, os.path.join(SAMPLES, "assets", "forest.exr"))
    scene, camera = table.make_scene(context, light)
    with nicol.Framebuffer.create(context, 2 * width, 2 * height, 3) as framebuffer:
        nicol.render(scene, camera, nicol.RenderOptions(max_depth=12, **options), framebuffer)
        stokes = np.stack([framebuffer.plane(nicol.PLANE_STOKES, channel=c) for c in range(3)], axis=2)
    return stokes.reshape(height, 2, width, 2, 3, 4).mean(axis=(1, 3))


def tone_mapped(radiance):
    x = np.clip(radiance, 0, 1)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)


def s0(stokes):
    return tone_mapped(stokes[..., 0])


def polarizer(stokes, degrees):
    """Returns the image behind an ideal polarizer, one stop brighter, so that unpolarized parts look as in s0."""
    angle = np.radians(2 * degrees)
    return tone_mapped(stokes[..., 0] + np.cos(angle) * stokes[..., 1] + np.sin(angle) * stokes[..., 2])


def linear(stokes):
    """Returns the degree of linear polarization, and the angle divided by 180 degrees, of the mean of the channels."""
    mean = stokes.mean(axis=2)
    degree = np.hypot(mean[..., 1], mean[..., 2]) / np.maximum(mean[..., 0], 1e-9)
    return np.clip(degree, 0, 1), np.arctan2(mean[..., 2], mean[..., 1]) / (2 * np.pi) % 1


def dolp(stokes):
    return np.repeat(linear(stokes)[0][..., None], 3, axis=2)


def hue(fraction):
    return np.clip(np.abs((6 * fraction[..., None] + [0, 4, 2]) % 6 - 3) - 1, 0, 1)


def aolp(stokes, wheel=0):
    """Returns an image whose hue is the angle and brightness the square root of the degree. wheel: radius of the colour
    wheel in the corner."""
    degree, angle = linear(stokes)
    image = hue(angle) * np.sqrt(degree)[..., None]
    if wheel:
        size = 2 * wheel + 5
        y, x = (np.indices((size, size)) - size // 2).astype(float)
        radius = np.hypot(x, y)
        cover = np.clip(wheel + 0.5 - radius, 0, 1) * np.clip(radius - 0.45 * wheel + 0.5, 0, 1)
        corner = image[8 : 8 + size, -8 - size : -8]
        corner += cover[..., None] * (hue(np.arctan2(-y, x) / np.pi % 1) - corner)
    return image


def sheet(rows):
    """Joins images of equal size side by side and below each other, with white gaps."""
    across = [np.concatenate(sum(([image, np.ones((image.shape[0], GAP, 3))] for image in row), [])[:-1], 1) for row in rows]
    return np.concatenate(sum(([row, np.ones((GAP, row.shape[1], 3))] for row in across), [])[:-1], 0)


def write_png(path, image):
    pixels = np.round(255 * image).astype(np.int16)
    height, width, _ = pixels.shape
    # Each row is stored as differences to the row above (filter 2), which compress better.
    above = np.concatenate([np.zeros_like(pixels[:1]), pixels[:-1]])
    rows = np.concatenate([np.full((height, 1), 2), (pixels - above).reshape(height, -1) % 256], axis=1)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)))
        file.write(chunk(b"IDAT", zlib.compress(rows.astype(np.uint8).tobytes(), 9)) + chunk(b"IEND", b""))
    print(f"{path}: {width} x {height}, {os.path.getsize(path)} bytes")


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else HERE
    os.makedirs(folder, exist_ok=True)
    with nicol.Context.create() as context:
        view = (-3.0, 1.75, 4.0), (-0.05, 0.88, 0.0), 37
        stokes = render(context, "snail_hdr.xml", 320, 320, 0, view)
        images = [s0(stokes), polarizer(stokes, 0), polarizer(stokes, 90), dolp(stokes), aolp(stokes, 34)]
        write_png(os.path.join(folder, "strip.png"), sheet([images]))

        def coarse_torus(made_in):
            return torus(made_in, 20, 13)

        rays = {"method": nicol.METHOD_REFERENCE, "samples": 256}
        coarse = [
            render_in_forest(context, coarse_torus, plastic, 38, 2, 256, **options)
            for options in ({"shade_at": nicol.SHADE_AT_VERTICES}, {"shade_at": nicol.SHADE_AT_PIXELS}, rays)
        ]
        write_png(os.path.join(folder, "coarse.png"), sheet([list(map(s0, coarse)), list(map(dolp, coarse))]))

        brushed = [
            render_in_forest(context, nicol.Mesh.create_sphere, brushed_gold, 30, 0.5, 256, **options)
            for options in ({"pixel_samples": 8, "bsdf_samples": 0}, {"pixel_samples": 8}, rays)
        ]
        write_png(os.path.join(folder, "brushed.png"), sheet([list(map(s0, brushed)), list(map(dolp, brushed))]))

        few_rays = {"method": nicol.METHOD_REFERENCE, "samples": 64}
        laid = [render_table(context, 240, 200, **options) for options in ({"pixel_samples": 4}, few_rays)]
        rows = [[s0(stokes), polarizer(stokes, 0), polarizer(stokes, 90)] for stokes in laid]
        write_png(os.path.join(folder, "table.png"), sheet(rows))

        rows = []
        for scene_file in ("snail_hdr.xml", "snail_sky.xml"):
            first, second = (render(context, scene_file, 320, 240, angle) for angle in (0, 120))
            rows.append([s0(first), dolp(first), aolp(first), s0(second), aolp(second)])
        write_png(os.path.join(folder, "demo.png"), sheet(rows))


if __name__ == "__main__":
    main()
