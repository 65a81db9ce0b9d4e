# SPDX-License-Identifier: MIT
"""The arrays of a picture."""

import nicol
import numpy

from .._runtime import words

# Names of nicol.Picture's attributes, where they differ.
_OF_PICTURE = {"normals": "normal", "normals_camera": "normal", "positions": "position", "ids": "instance"}
ANGLES = (0, 45, 90, 135)
SENSED = ("mosaic", "angles")


def aovs(names):
    """Returns the sum of NICOL_AOV_... that these arrays need."""
    known = words("aov")
    return sum({known.get(_OF_PICTURE.get(name, name), 0) for name in names})


def read(framebuffer, names, R):
    """Returns arrays of the last render by name: stokes (height, width, channels, 4); s0, dolp and aolp (height, width,
    channels), the angle in radians in (-pi/2, pi/2]; depth along the view; normals in the world, and normals_camera with x to
    the right, y up and z towards the camera; positions; ids, 4294967295 without a surface; alpha. The rows of R are the
    camera's right, down and forward."""
    picture = nicol.Picture(framebuffer)
    arrays = {}
    for name in names:
        if name in SENSED:
            continue
        arrays[name] = getattr(picture, _OF_PICTURE.get(name, name))
        if name == "normals_camera":
            axes = numpy.array(R, numpy.float32) * numpy.float32([[1], [-1], [-1]])
            # Sums term by term have the same bits everywhere; a matrix product of numpy's has those of its BLAS.
            arrays[name] = sum(picture.normal[..., i : i + 1] * axes[:, i] for i in range(3))
    return arrays


def sense(sensor, stokes, names, frame, exposure):
    """Returns the raw numbers of the sensor for light of (height, width, channels, 4), by name: mosaic (height, width), and
    angles (4, height, width), which the sensor gives without polarizers and colour filters of its own behind a polarizer at 0,
    45, 90 and 135 degrees. Each of the five has noise of its own."""
    light = numpy.ascontiguousarray(stokes * numpy.float32(exposure))
    arrays = {}
    if "mosaic" in names:
        arrays["mosaic"] = sensor.capture(light, 5 * frame)
    if "angles" in names:
        arrays["angles"] = numpy.stack([
            behind(sensor, angle).capture(light, 5 * frame + 1 + i) for i, angle in enumerate(ANGLES)
        ])  # fmt: skip
    return arrays


def behind(sensor, angle):
    """Returns the sensor without polarizers and colour filters on its pixels, behind a polarizer. An automatic exposure
    stays that of the mosaic: unpolarized light of s0 = 1 fills the well behind the polarizer."""
    fields = {name: getattr(sensor, name) for name in type(sensor)._types_ if name not in ("struct_size", "reserved")}
    plain = nicol.Sensor(**fields | {"mosaic": nicol.MOSAIC_PLAIN})
    if not plain.exposure:
        efficiency = sensor.quantum_efficiency
        plain.exposure = 2 * sensor.full_well / max(list(efficiency.values)[: efficiency.count] or [0.6])
    polarizer = nicol.PolarizationElement(kind=nicol.POLARIZATION_ELEMENT_POLARIZER, angle=angle)
    plain.add_element(polarizer, sensor.extinction_ratio)
    return plain


def exposure_of(recipe, draw, stokes):
    """Returns the factor on light before the sensor."""
    if "exposure" not in recipe.parts:
        return 1.0
    drawn = recipe.parts["exposure"].at(draw)
    if not isinstance(drawn, dict):
        return float(drawn)
    s0 = stokes[..., 0].mean(axis=-1, dtype=numpy.float64)
    bright = float(numpy.percentile(s0, drawn["percentile"]))
    return float(drawn.get("level", 0.8)) / bright if bright > 0 else 1.0
