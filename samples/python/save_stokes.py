# SPDX-License-Identifier: MIT
"""Renders a scene and saves the Stokes vectors of its green channel. usage: save_stokes.py SCENE.xml OUT.npy [name=value...]"""

import sys

import nicol
import numpy

scene_file, output, *definitions = sys.argv[1:]

with nicol.Context.create() as context, nicol.Scene.load(context, scene_file, definitions) as scene:
    width, height = scene.get_film_size()
    channels = scene.get_channels()
    with nicol.Framebuffer.create(context, width, height, channels) as framebuffer:
        nicol.render(scene, scene.get_camera(), nicol.RenderOptions(order_low=4), framebuffer)
        stokes = framebuffer.plane(nicol.PLANE_STOKES, channel=min(1, channels - 1))
        vertices = framebuffer.get_statistics().vertices

numpy.save(output, stokes)
s0, s1, s2, _ = stokes.reshape(-1, 4).mean(axis=0)
print(f"{width} x {height}, {vertices} vertices, mean s0 {s0:.4f}, s1 {s1:+.4f}, s2 {s2:+.4f}")
