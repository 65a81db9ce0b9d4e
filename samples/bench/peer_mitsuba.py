# SPDX-License-Identifier: MIT
"""Mitsuba 3 as a peer: Stokes images of a scene file.

Images are those of stokes_images, because Mitsuba's fastest polarized mode has no colours. Rows, frames and signs are those of
Mitsuba's integrator `stokes`, which equal Nicol's."""

import glob
import os
import re

import mitsuba
import numpy
from stokes_images import LUMINANCE

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
