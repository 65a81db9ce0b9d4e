# SPDX-License-Identifier: MIT
"""Renders a pair for the removal of reflections: a picture behind a window pane, and without the pane, each behind a
polarizer at four angles. usage: reflection_pair.py ENVIRONMENT.exr OUT_FOLDER [--angle DEGREES] [--size WxH]

Writes pane_0.png to pane_135.png, open_0.png to open_135.png and both as Stokes vectors, pane.npy and open.npy of the
green channel. At 56 degrees, Brewster's angle, the polarizer at 90 degrees removes nearly all of the reflection."""

import argparse
import math
import os

import nicol
import numpy

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("environment")
parser.add_argument("folder")
parser.add_argument("--angle", type=float, default=56, help="between the view and the pane's normal")
parser.add_argument("--size", default="320x240")
arguments = parser.parse_args()
width, height = map(int, arguments.size.split("x"))
POLARIZER_ANGLES = (0, 45, 90, 135)


def placed(degrees, half_width, half_height, z):
    """Returns a rectangle's matrix: rotated about the horizontal axis, its middle at (0, 0, z)."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [half_width, 0, 0, 0, 0, half_height * c, -s, 0, 0, half_height * s, c, z, 0, 0, 0, 1]


def make_scene(context, environment):
    """Returns a scene with a picture behind a pane, and the pane's id."""
    square = nicol.Mesh.create_rectangle(context)
    tiles = nicol.Texture.create_checkerboard(context, [0.7, 0.5, 0.2], [0.08, 0.2, 0.4], [4, 0, 0, 0, 3, 0, 0, 0, 1])
    picture = nicol.Material.create_scaled(context, nicol.Material.create_diffuse(context, 1), tiles)
    pane = nicol.Material.create_dielectric(context, nicol.Dielectric(thin=1, int_ior=1.5, ext_ior=1))
    scene = nicol.Scene.create(context)
    scene.set_environment(environment, None, 1.0)
    scene.add_instance(nicol.Instance(mesh=square, material=picture, to_world=placed(0, 1.6, 1.2, -2.2)))
    return scene, scene.add_instance(nicol.Instance(mesh=square, material=pane, to_world=placed(-arguments.angle, 2, 3, 0)))


def save(framebuffer, name):
    """Writes the image behind each polarizer; returns the mean light behind the polarizer at 0 and at 90 degrees."""
    for angle in POLARIZER_ANGLES:
        observation = nicol.Observation(kind=nicol.OBSERVATION_POLARIZER, polarizer_angle=angle, exposure=1)
        framebuffer.write_png(observation, os.path.join(arguments.folder, f"{name}_{angle}.png"))
    stokes = framebuffer.plane(nicol.PLANE_STOKES, channel=1)
    numpy.save(os.path.join(arguments.folder, f"{name}.npy"), stokes)
    s0, s1 = stokes[..., 0].mean(), stokes[..., 1].mean()
    return (s0 + s1) / 2, (s0 - s1) / 2


os.makedirs(arguments.folder, exist_ok=True)
with nicol.Context.create() as context:
    environment = nicol.Environment.load(context, arguments.environment)
    scene, pane = make_scene(context, environment)
    camera = nicol.Camera(fov=30).look_at((0, 0, 5), (0, 0, 0), (0, 1, 0))
    options = nicol.RenderOptions(pixel_samples=4)
    with nicol.Framebuffer.create(context, width, height, scene.get_channels()) as framebuffer:
        nicol.render(scene, camera, options, framebuffer)
        behind_pane = save(framebuffer, "pane")
        scene.remove_instance(pane)
        nicol.render(scene, camera, options, framebuffer)
        without = save(framebuffer, "open")
for angle, with_pane, alone in zip((0, 90), behind_pane, without):
    print(f"polarizer at {angle}°: {with_pane:.4f} with the pane, {alone:.4f} without")
