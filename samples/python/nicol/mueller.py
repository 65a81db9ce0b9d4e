# SPDX-License-Identifier: MIT
"""Mueller images, as a polarimeter with a polarized lamp measures them. Needs numpy."""

import copy
import math

import nicol
import numpy

# Degree and angle of linear polarization, and s3 / s0, of four lamps whose Stokes vectors span all others.
_STATES = ((0, 0, 0), (1, 0, 0), (1, math.pi / 4, 0), (0, 0, 1))


def mueller_image(scene, camera, options, framebuffer, light):
    """Returns the Mueller matrix of each pixel for the light of one lamp, as an array (height, width, channels, 4, 4) whose
    matrices take the lamp's Stokes vector, for s0 = 1 as `light.value` says, to the pixel's. light is the id of a local light,
    see nicol_scene_add_light; its frame is that of nicol_polarization, the pixel's that of the image. Renders four times and
    bakes once. All other light must be off. options: max_depth and physical 0, so that the image is linear in the light."""
    if options.physical:
        raise ValueError("options.physical is 1; it must be 0, because moving Stokes vectors is not linear in the light")
    lamp, texture = scene.get_light(light)
    lamp.texture = texture
    given = copy.copy(lamp.polarization)
    images = []
    try:
        for dolp, aolp, docp in _STATES:
            lamp.polarization = nicol.Polarization(dolp=dolp, aolp=aolp, docp=docp, axis=list(given.axis))
            scene.set_light(light, lamp)
            nicol.render(scene, camera, options, framebuffer)
            images.append(framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS))
    finally:
        lamp.polarization = given
        scene.set_light(light, lamp)
    # A lamp's image is the first column plus the column of its state.
    columns = [images[0], *(image - images[0] for image in images[1:])]
    return numpy.stack(columns, axis=-1)
