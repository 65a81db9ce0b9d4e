# SPDX-License-Identifier: MIT
"""Moves the camera around a scene and plots the degree of polarization. usage: orbit.py SCENE.xml OUT.svg
[--views N] [--size WxH]

The degree of linear polarization is the mean over all pixels, weighted by their light."""

import argparse
import math

import nicol

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("scene")
parser.add_argument("output")
parser.add_argument("--views", type=int, default=72)
parser.add_argument("--size", default="320x240")
arguments = parser.parse_args()
width, height = map(int, arguments.size.split("x"))


def orbit(camera, degrees):
    """Returns the camera rotated about the world's vertical axis; the columns of to_world are its axes and position."""
    rotated = nicol.Camera(projection=camera.projection, fov=camera.fov)
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    m = list(camera.to_world)
    for column in range(4):
        x, z = m[column], m[8 + column]
        m[column], m[8 + column] = c * x + s * z, c * z - s * x
    rotated.to_world = m
    return rotated


def mean_dolp(framebuffer, channels):
    """Returns the polarized light divided by the light, both summed over pixels and channels."""
    light = polarized = 0.0
    for channel in range(channels):
        s0, dolp = framebuffer.plane(nicol.PLANE_S0, channel), framebuffer.plane(nicol.PLANE_DOLP, channel)
        light += float(s0.sum())
        polarized += float((s0 * dolp).sum())
    return polarized / light


def plot(points, path):
    """Writes a curve as an SVG file: angle to the right, degree of polarization upwards."""
    top = math.ceil(10 * max(dolp for _, dolp in points)) / 10
    place = lambda degrees, dolp: f"{60 + 1.5 * degrees:.1f},{260 - 220 * dolp / top:.1f}"  # noqa: E731
    text = lambda x, y, words, rotation="": f'<text x="{x}" y="{y}" {rotation}>{words}</text>'  # noqa: E731
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" width="640" height="320" font-family="sans-serif" font-size="13" '
             'text-anchor="middle"><rect width="640" height="320" fill="white"/>']  # fmt: skip
    for degrees in range(0, 361, 60):
        parts.append(text(60 + 1.5 * degrees, 280, f"{degrees}°"))
    for step in range(6):
        y = 260 - 220 * step / 5
        parts.append(f'<path d="M60 {y}H600" stroke="#ddd"/>' + text(38, y + 4, f"{top * step / 5:.2f}"))
    parts.append(text(330, 305, "camera about the vertical axis"))
    parts.append(text(14, 150, "degree of linear polarization", 'transform="rotate(-90 14 150)"'))
    parts.append(f'<polyline points="{" ".join(place(*p) for p in points)}" fill="none" stroke="#06c" stroke-width="2"/></svg>')
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "\n")


with nicol.Context.create() as context, nicol.Scene.load(context, arguments.scene) as scene:
    camera, channels = scene.get_camera(), scene.get_channels()
    with nicol.Framebuffer.create(context, width, height, channels) as framebuffer:
        points = []
        for view in range(arguments.views + 1):
            degrees = 360 * view / arguments.views
            nicol.render(scene, orbit(camera, degrees), None, framebuffer)
            points.append((degrees, mean_dolp(framebuffer, channels)))
plot(points, arguments.output)
least, most = min(points, key=lambda p: p[1]), max(points, key=lambda p: p[1])
print(f"{arguments.views} views, DoLP {least[1]:.4f} at {least[0]:.0f}° to {most[1]:.4f} at {most[0]:.0f}°")
