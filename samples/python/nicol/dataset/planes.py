# SPDX-License-Identifier: MIT
"""The arrays of a picture."""

import nicol
import numpy

from .. import conventions
from .._runtime import words

# Names of nicol.Picture's attributes, where they differ.
_OF_PICTURE = {"normals": "normal", "normals_camera": "normal", "positions": "position", "ids": "instance"}
ANGLES = (0, 45, 90, 135)
SENSED = ("mosaic", "angles")


def aovs(names):
    """Returns the sum of NICOL_AOV_... that these arrays need."""
    known = words("aov")
    return sum({known.get(_OF_PICTURE.get(name, name), 0) for name in names})


def read(framebuffer, names, R, half=()):
    """Returns arrays of the last render by name: stokes (height, width, channels, 4); s0, dolp and aolp (height, width,
    channels), the angle in radians in (-pi/2, pi/2]; depth along the view; normals in the world, and normals_camera with x to
    the right, y up and z towards the camera; positions; ids, 4294967295 without a surface; alpha. The rows of R are the
    camera's right, down and forward. half: may name stokes, which then has 16-bit floats."""
    picture = nicol.Picture(framebuffer)
    arrays = {}
    for name in names:
        if name in SENSED:
            continue
        if name in half:
            room = numpy.empty((picture.height, picture.width, picture.channels, 4), numpy.float16)
            arrays[name] = framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS, room)
            continue
        arrays[name] = getattr(picture, _OF_PICTURE.get(name, name))
        if name == "normals_camera":
            arrays[name] = _turned(picture.normal, R)
    return arrays


def _turned(normals, R):
    """Returns normals with x to the right, y up and z towards the camera."""
    axes = numpy.array(R, numpy.float32) * numpy.float32([[1], [-1], [-1]])
    # Sums term by term have the same bits everywhere; a matrix product of numpy's has those of its BLAS.
    return sum(normals[..., i : i + 1] * axes[:, i] for i in range(3))


def through_lens(picture, names, R, half=()):
    """Returns the arrays of read() of a picture that nicol.lens.render() gave, but depth, which is the distance from the camera."""
    stokes = picture["stokes"]
    made = {
        "stokes": lambda: stokes, "s0": lambda: stokes[..., 0], "dolp": lambda: conventions.dolp(stokes),
        "aolp": lambda: conventions.aolp(stokes), "normals_camera": lambda: _turned(picture["normal"], R),
    }  # fmt: skip
    of = _OF_PICTURE | {"depth": "distance"}
    arrays = {name: made[name]() if name in made else picture[of.get(name, name)] for name in names if name not in SENSED}
    return {name: array.astype(numpy.float16) if name in half else array for name, array in arrays.items()}


def lens_aovs(names):
    """Returns the aovs of nicol.lens.render() that these arrays need."""
    of = _OF_PICTURE | {"depth": "distance"}
    return tuple({of.get(name, name) for name in names if name in of or name == "alpha"})


def sense(sensor, light, names, frame, exposure):
    """Returns the raw numbers of the sensor for light, a framebuffer or an array (height, width, channels, 4), by name: mosaic (height, width), and angles (4, height,
    width), which the sensor gives without polarizers and colour filters of its own behind a polarizer at 0, 45, 90 and 135
    degrees. Each of the five has noise of its own. exposure: factor on the light."""
    arrays = {}
    if "mosaic" in names:
        arrays["mosaic"] = _exposed(sensor, exposure).capture(light, 5 * frame)
    if "angles" in names:
        arrays["angles"] = numpy.stack([
            _exposed(behind(sensor, angle), exposure).capture(light, 5 * frame + 1 + i) for i, angle in enumerate(ANGLES)
        ])  # fmt: skip
    return arrays


def _automatic_exposure(sensor):
    """Returns the photons of s0 = 1 that fill the well of a sensor with polarizers, see nicol_sensor."""
    efficiency = sensor.quantum_efficiency
    return 2 * sensor.full_well / max(list(efficiency.values)[: efficiency.count] or [0.6])


def _changed(sensor, **changes):
    fields = {name: getattr(sensor, name) for name in type(sensor)._types_ if name not in ("struct_size", "reserved")}
    return nicol.Sensor(**fields | changes)


def _exposed(sensor, factor):
    """Returns the sensor with more photons by a factor."""
    half = 0.5 if sensor.mosaic == nicol.MOSAIC_PLAIN else 1
    return _changed(sensor, exposure=factor * (sensor.exposure or half * _automatic_exposure(sensor)))


def behind(sensor, angle):
    """Returns the sensor without polarizers and colour filters on its pixels, behind a polarizer. An automatic exposure
    stays that of the mosaic: unpolarized light of s0 = 1 fills the well behind the polarizer."""
    plain = _changed(sensor, mosaic=nicol.MOSAIC_PLAIN, exposure=sensor.exposure or _automatic_exposure(sensor))
    polarizer = nicol.PolarizationElement(kind=nicol.POLARIZATION_ELEMENT_POLARIZER, angle=angle)
    plain.add_element(polarizer, sensor.extinction_ratio)
    return plain


def exposure_of(recipe, draw, light):
    """Returns the factor on light before the sensor."""
    if "exposure" not in recipe.parts:
        return 1.0
    drawn = recipe.parts["exposure"].at(draw)
    if not isinstance(drawn, dict):
        return float(drawn)
    if isinstance(light, numpy.ndarray):
        s0 = numpy.moveaxis(light[..., 0], -1, 0)
    else:
        s0 = [light.plane(nicol.PLANE_S0, channel) for channel in range(light.get_size()[2])]
    bright = percentile(sum(s0), drawn["percentile"]) / len(s0)
    return float(drawn.get("level", 0.8)) / bright if bright > 0 else 1.0


def percentile(numbers, percent):
    """Returns numpy.percentile() of 32-bit floats, which are put into another order, with the same bits for every version of
    numpy, in a third of its time."""
    numbers = numbers.reshape(-1)
    place = (numbers.size - 1) * (percent / 100)
    below = int(place)
    numbers.partition(below)
    lower, part = numbers[below], place - below
    upper = numbers[below + 1 :].min() if below + 1 < numbers.size else lower
    step = float(upper - lower)
    return float(lower) + step * part if part < 0.5 else float(upper) - step * (1 - part)
