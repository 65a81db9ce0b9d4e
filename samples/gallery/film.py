#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Renders a film of objects that move and deform, a contact sheet of it, and its error against rays.

usage: film.py OUT.png [--frames FOLDER] [--budget MS] [--samples N] [--size WxH]

The sheet has the film's 60 frames, s0, in rows of ten. Every tenth frame is also traced by the reference method with N samples
per pixel (256), and the difference is printed. MS is the time that a frame after the first may spend on the shadows of what moved (0: all that it
needs). FOLDER gets each frame as PNG. Needs numpy and the package `nicol` of samples/python."""

import argparse
import os
import time

import gallery
import nicol
import numpy as np

FRAMES, IN_A_ROW = 60, 10


class Film:
    """A ball of gold on a circle, a ring that tumbles and a blob that breathes, on a floor in the forest."""

    def __init__(self, context, size):
        self.context, self.size = context, size
        self.scene = nicol.Scene.create(context)
        light = nicol.Environment.load(context, os.path.join(gallery.SAMPLES, "assets", "forest.exr"))
        self.scene.set_environment(light, None, 1.5)
        grey = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.4, 0.4, 0.38], alpha=0.2))
        gold = nicol.Material.create_conductor(context, nicol.Conductor(metal=b"Au", alpha=0.2))
        blue = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.05, 0.12, 0.3], alpha=0.15))
        self.places, triangles = sphere(24, 48)
        self.blob_mesh = nicol.Mesh.create(context, nicol.mesh_data(self.places, triangles))
        self._add(nicol.Mesh.create_rectangle(context), grey, placed(0, 0, 0, 5, rotation(0, -90)))
        self.ball = self._add(self.blob_mesh, gold, placed(0, 0, 0))
        self.ring = self._add(gallery.torus(context, 48, 24), gallery.plastic(context), placed(0, 0, 0))
        self.blob = self._add(self.blob_mesh, blue, placed(0, 0.55, 0, 0.5))
        self.camera = nicol.Camera(fov=36)

    def _add(self, mesh, material, to_world):
        return self.scene.add_instance(nicol.Instance(mesh=mesh, material=material, to_world=to_world))

    def show(self, frame):
        """Moves everything to its place in a frame, counted from 0."""
        turn = 2 * np.pi * frame / FRAMES
        self.scene.set_transform(self.ball, placed(1.9 * np.cos(turn), 0.35, 1.5 * np.sin(turn), 0.35))
        tumbling = rotation(np.degrees(turn), 40 + 25 * np.sin(turn))
        self.scene.set_transform(self.ring, placed(-1.1, 1.1 + 0.25 * np.sin(2 * turn), -0.9, 0.55, tumbling))
        x, y, z = self.places.T
        waves = 1 + 0.25 * np.sin(2 * turn) * np.sin(4 * y + 2 * turn) * (1 - y * y) + 0.1 * np.cos(turn) * x * z
        deformation = nicol.Deformation(vertex_count=len(self.places), positions=(self.places.T * waves).T.astype(np.float32))
        self.scene.set_mesh(self.blob, nicol.Mesh.create_deformed(self.context, self.blob_mesh, deformation))
        angle = 0.35 * np.sin(turn)
        self.camera.look_at((6 * np.sin(angle), 2.6, 6 * np.cos(angle)), (0, 0.5, 0), (0, 1, 0))

    def picture(self, **options):
        """Returns the Stokes vectors (height, width, 3, 4)."""
        with nicol.Framebuffer.create(self.context, *self.size, 3) as framebuffer:
            nicol.render(self.scene, self.camera, nicol.RenderOptions(**options), framebuffer)
            return framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS)


def placed(x, y, z, scale=1.0, axes=None):
    to_world = np.eye(4)
    to_world[:3, :3] = scale * (np.eye(3) if axes is None else axes)
    to_world[:3, 3] = x, y, z
    return list(to_world.ravel())


def rotation(about_y, about_x):
    """Returns the rotation about x and then about y, in degrees."""
    (cy, cx), (sy, sx) = np.cos(np.radians([about_y, about_x])), np.sin(np.radians([about_y, about_x]))
    return np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]]) @ np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])


def sphere(rows, columns):
    """Returns the places and triangles of a sphere of radius 1, with one vertex at each pole."""
    theta = np.pi * np.arange(1, rows) / rows
    phi = 2 * np.pi * np.arange(columns) / columns
    ring = np.stack(
        [np.outer(np.sin(theta), np.cos(phi)), np.outer(np.cos(theta), np.ones(columns)), np.outer(np.sin(theta), -np.sin(phi))], -1
    )
    places = np.concatenate([[[0, 1, 0]], ring.reshape(-1, 3), [[0, -1, 0]]])
    c = np.arange(columns)
    at = lambda row, column: 1 + row * columns + column % columns  # noqa: E731
    triangles = [np.stack([0 * c, at(0, c), at(0, c + 1)], -1), np.stack([0 * c + len(places) - 1, at(rows - 2, c + 1), at(rows - 2, c)], -1)]
    for row in range(rows - 2):
        here, beside, below, across = at(row, c), at(row, c + 1), at(row + 1, c), at(row + 1, c + 1)
        triangles += [np.stack([here, below, across], -1), np.stack([here, across, beside], -1)]
    return places.astype(np.float32), np.concatenate(triangles).astype(np.uint32)


def small(image, step):
    height, width = (side // step * step for side in image.shape[:2])
    return image[:height, :width].reshape(height // step, step, width // step, step, 3).mean(axis=(1, 3))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output")
    parser.add_argument("--frames")
    parser.add_argument("--budget", type=float, default=0)
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--size", default="320x240")
    arguments = parser.parse_args()
    if arguments.frames:
        os.makedirs(arguments.frames, exist_ok=True)
    with nicol.Context.create() as context:
        film = Film(context, tuple(map(int, arguments.size.split("x"))))
        tiles, times, errors = [], [], []
        for frame in range(FRAMES):
            start = time.perf_counter()
            film.show(frame)
            stokes = film.picture(pixel_samples=4, bake_budget_ms=arguments.budget if frame > 0 else 0)
            times.append(1e3 * (time.perf_counter() - start))
            if arguments.frames:
                gallery.write_png(os.path.join(arguments.frames, f"{frame:04}.png"), gallery.s0(stokes))
            tiles.append(gallery.tone_mapped(small(stokes[..., 0], 4)))
            if frame % 10 == 0:
                truth = film.picture(method=nicol.METHOD_REFERENCE, samples=arguments.samples)
                level = np.sqrt(np.mean(truth[..., 0] ** 2))
                errors.append(np.sqrt(np.mean((stokes - truth) ** 2, axis=(0, 1, 2))) / level)
                print(f"frame {frame}: {times[-1]:.0f} ms; s0, s1, s2 differ from rays by " + ", ".join(f"{e:.3f}" for e in errors[-1][:3]))
        print(f"median frame {np.median(times[1:]):.0f} ms; largest difference of s0 {max(e[0] for e in errors):.3f}")
        gallery.write_png(arguments.output, gallery.sheet([tiles[i : i + IN_A_ROW] for i in range(0, FRAMES, IN_A_ROW)]))


if __name__ == "__main__":
    main()
