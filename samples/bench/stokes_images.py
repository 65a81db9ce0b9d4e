# SPDX-License-Identifier: MIT
"""Stokes images of Nicol as arrays, and the difference of two images.

Images are arrays (height, width, 4) of s0, s1, s2, s3 in double precision, of the luminance of the colours."""

import nicol
import numpy

LUMINANCE = numpy.array([0.2126, 0.7152, 0.0722])


def nicol_stokes(framebuffer, finer=1):
    """Returns means over finer x finer pixels."""
    planes = framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS).astype(float)
    stokes = numpy.einsum("ijck,c->ijk", planes, LUMINANCE if planes.shape[2] == 3 else [1])
    height, width = stokes.shape[:2]
    return stokes.reshape(height // finer, finer, width // finer, finer, 4).mean((1, 3))


def nicol_image(scene_file, definitions=(), finer=1, **options):
    """Renders with nicol.RenderOptions(**options) at finer times the width and height, and averages."""
    with nicol.Context.create() as context, nicol.Scene.load(context, str(scene_file), list(definitions)) as scene:
        width, height = scene.get_film_size()
        with nicol.Framebuffer.create(context, finer * width, finer * height, scene.get_channels()) as framebuffer:
            nicol.render(scene, scene.get_camera(), nicol.RenderOptions(**options), framebuffer)
            return nicol_stokes(framebuffer, finer)


def squared_error(ours, truth):
    """Returns (mean, standard error of the mean) of the squared error of each Stokes component over the mean square of s0.

    Each argument is two images of one scene with independent noise, or one noiseless image twice: the mean of (x - a) (y - b)
    equals that of the squared error without noise."""
    x, y = (image.reshape(-1, 4) for image in ours)
    a, b = (image.reshape(-1, 4) for image in truth)
    products = (x - a) * (y - b) / (a[:, 0] * b[:, 0]).mean()
    return products.mean(0), products.std(0) / len(products) ** 0.5
