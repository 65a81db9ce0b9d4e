# SPDX-License-Identifier: MIT
"""Draws one scene under the conventions of several programs: OUT.png of 4 x 3 pictures.

    s0                   s1                     s2                       AoLP, counter-clockwise from image right
    behind a polarizer at 0, 45, 90 and 135 degrees
    mosaic, 24 x 24      AoLP from image up     AoLP clockwise           AoLP from the image's right across each ray

s1 and s2: red negative, green positive. AoLP: hue = angle / 180 degrees, brightness = the square root of the DoLP.
usage: conventions.py OUT.png"""

import sys

import nicol
import numpy
from nicol import conventions
from sheet import save_png

SIZE = 168


def rendered():
    """Returns the camera and the Stokes image (SIZE, SIZE, 4) of a plastic ball under a clear sky, seen at 90 degrees."""
    with nicol.Context.create() as context:
        scene = nicol.Scene.create(context)
        scene.set_environment(nicol.Environment.create_sky(context, nicol.Sky(sun_direction=(1, 0.5, 0.6))), None, 1.0)
        material = nicol.Material.create_pplastic(context, nicol.Pplastic(alpha=0.1, diffuse_reflectance=0.1))
        scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_sphere(context), material=material))
        camera = nicol.Camera(fov=90).look_at((0, 0, 1.6), (0, 0, 0), (0, 1, 0))
        framebuffer = nicol.Framebuffer.create(context, SIZE, SIZE, 1)
        nicol.render(scene, camera, nicol.RenderOptions(pixel_samples=8), framebuffer)
        return camera, framebuffer.plane(nicol.PLANE_STOKES, 0)


def grey(light, white):
    light = numpy.clip(light / white, 0, 1)
    return numpy.repeat(light[..., None] ** (1 / 2.2), 3, axis=-1)


def signed(values, full):
    share = numpy.clip(values / full, -1, 1)
    return numpy.stack([numpy.maximum(-share, 0), numpy.maximum(share, 0), numpy.zeros_like(share)], axis=-1)


def wheel(angle, dolp):
    hue = 6 * conventions.positive(angle)[..., None] / numpy.pi
    colours = numpy.clip(numpy.abs((hue + numpy.array([0, 4, 2])) % 6 - 3) - 1, 0, 1)
    return colours * numpy.sqrt(numpy.clip(dolp, 0, 1))[..., None]


def main(path):
    camera, stokes = rendered()
    s0, s1, s2, _ = numpy.moveaxis(stokes, -1, 0)
    white, full = numpy.percentile(s0, 99.5), numpy.percentile(numpy.abs(stokes[..., 1:3]), 99.5)
    angle, dolp = conventions.aolp(stokes), numpy.hypot(s1, s2) / numpy.maximum(s0, 1e-9)
    across = conventions.rotated(stokes, conventions.to_image_right(camera, (SIZE, SIZE)))
    raw = nicol.Sensor(shot_noise=0, read_noise=0).capture(numpy.ascontiguousarray(stokes[:, :, None] / white))
    cells = numpy.kron(numpy.asarray(raw)[70:94, 14:38], numpy.ones((SIZE // 24, SIZE // 24)))
    rows = [
        [grey(s0, white), signed(s1, full), signed(s2, full), wheel(angle, dolp)],
        [grey(behind, white / 2) for behind in conventions.angles(stokes)],
        [grey(cells, 4095), wheel(conventions.from_up(angle), dolp), wheel(conventions.clockwise(angle), dolp),
         wheel(conventions.aolp(across), dolp)],
    ]  # fmt: skip
    save_png(path, numpy.concatenate([numpy.concatenate(row, axis=1) for row in rows]))


if __name__ == "__main__":
    main(*sys.argv[1:])
