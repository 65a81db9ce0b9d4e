# SPDX-License-Identifier: MIT
"""Mitsuba 3 as a peer: Stokes images of one scene file by Mitsuba and by Nicol, and their difference.

Images are arrays (height, width, 4) of s0, s1, s2, s3 in double precision, of the luminance of the colours: Mitsuba's fastest
polarized mode has no colours. Rows, frames and signs are those of Mitsuba's integrator `stokes`, which equal Nicol's."""

import glob
import os
import re

import mitsuba
import nicol
import numpy

LUMINANCE = numpy.array([0.2126, 0.7152, 0.0722])
# Oldest usable version. Older ones end the process, because they lack the minimum of two floats that Mitsuba's kernels
# use on x86.
OLDEST_LLVM = 17


def newest_llvm():
    """Returns the path of the newest libLLVM in Linux's usual folder, or None if all are too old."""
    found = []
    for path in glob.glob("/usr/lib/*/libLLVM*.so*"):
        version = re.search(r"libLLVM(?:-|\.so\.)(\d+)", path)
        if version and int(version[1]) >= OLDEST_LLVM:
            found.append((int(version[1]), path))
    return max(found, default=(0, None))[1]


def choose_variant(colors=False):
    """Makes the fastest mode that runs here, polarized or with colours, Mitsuba's mode and returns its name."""
    library = os.environ.get("DRJIT_LIBLLVM_PATH") or newest_llvm()
    if library:
        os.environ["DRJIT_LIBLLVM_PATH"] = library
    variants = ("scalar_rgb", "llvm_ad_rgb") if colors else ("scalar_spectral_polarized", "llvm_ad_mono_polarized")
    variant = variants[library is not None]
    mitsuba.set_variant(variant)
    mitsuba.set_log_level(mitsuba.LogLevel.Error)
    return variant


def write_luminance(image, target):
    """Converts an image file with R, G and B to one with Y. Negative numbers become 0, as in Nicol."""
    bitmap = mitsuba.Bitmap(str(image)).convert(mitsuba.Bitmap.PixelFormat.RGB, mitsuba.Struct.Type.Float32, False)
    pixels = numpy.maximum(numpy.array(bitmap), 0) @ LUMINANCE
    mitsuba.Bitmap(pixels[:, :, None].astype("f4")).write(str(target))


def mitsuba_scene(scene_file, **definitions):
    return mitsuba.load_file(str(scene_file), **{name: str(value) for name, value in definitions.items()})


def mitsuba_image(scene, samples, seed):
    """Renders with the scene's integrator, which must be `stokes`."""
    pixels = numpy.array(mitsuba.render(scene, spp=samples, seed=seed), dtype=float)
    # The displayed image precedes S0.R ... S3.B.
    return pixels[:, :, -12:].reshape(*pixels.shape[:2], 4, 3) @ LUMINANCE


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
