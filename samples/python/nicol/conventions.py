# SPDX-License-Identifier: MIT
"""Stokes vectors and angles between Nicol's conventions and those of others. Needs numpy.

Stokes vectors are along the last axis; angles are radians, and of polarization in (-pi/2, pi/2], counter-clockwise from x."""

import numpy


def aolp(stokes):
    """Returns the angles of linear polarization."""
    return 0.5 * numpy.arctan2(stokes[..., 2], stokes[..., 1])


def dolp(stokes):
    """Returns the degrees of linear polarization, 0 without light."""
    s0 = stokes[..., 0]
    return numpy.divide(numpy.hypot(stokes[..., 1], stokes[..., 2]), s0, out=numpy.zeros_like(s0), where=s0 > 0)


def wrapped(angle):
    """Returns angles of polarization in (-pi/2, pi/2]."""
    return numpy.pi / 2 - (numpy.pi / 2 - angle) % numpy.pi


def positive(angle):
    """Returns angles of polarization in [0, pi), as polanalyser and most cameras' software have them."""
    return angle % numpy.pi


def clockwise(angle):
    """Returns angles of polarization counted the other way, as in images with y down; and back."""
    return wrapped(-angle)


def from_up(angle):
    """Returns angles of polarization counted from the image's up, counter-clockwise."""
    return wrapped(angle - numpy.pi / 2)


def mirrored(stokes):
    """Returns Stokes vectors as they are with y down or x to the left, s2 and s3 with the other sign; and back. The pixels stay
    where they are."""
    return stokes * numpy.array([1, 1, -1, -1], stokes.dtype)


def rotated(stokes, angle):
    """Returns Stokes vectors in frames that are turned counter-clockwise by an angle, or by one for each pixel."""
    c, s = numpy.cos(2 * numpy.asarray(angle)), numpy.sin(2 * numpy.asarray(angle))
    turned = stokes.copy()
    turned[..., 1] = c * stokes[..., 1] + s * stokes[..., 2]
    turned[..., 2] = c * stokes[..., 2] - s * stokes[..., 1]
    return turned


def to_image_right(camera, size):
    """Returns the angle of each pixel (height, width) from Nicol's x, which is horizontal for the camera, to the image's right
    projected across the ray, for rotated(). The first pixel's middle is that of nicol_camera_get_opencv. 0 on the image's
    middle row and column, 30 degrees in the corners of a square image of 90 degrees."""
    K, _, _ = camera.to_opencv(size)
    columns, rows = numpy.meshgrid(numpy.arange(size[0]), numpy.arange(size[1]))
    # The ray is (x, y, -1) in axes to the right, up and backward, Nicol's x is (1, 0, x), and its y (-x y, 1 + x x, y).
    x, y = (columns - K[0][2]) / K[0][0], (K[1][2] - rows) / K[1][1]
    return numpy.arctan2(-x * y, numpy.sqrt(1 + x * x + y * y))


def angles(stokes, degrees=(0, 45, 90, 135)):
    """Returns the light behind ideal polarizers at these angles, along a new first axis."""
    a = 2 * numpy.radians(numpy.asarray(degrees)).reshape(-1, *[1] * (stokes.ndim - 1))
    cosine, sine = numpy.cos(a).astype(stokes.dtype), numpy.sin(a).astype(stokes.dtype)
    return (stokes[..., 0] + stokes[..., 1] * cosine + stokes[..., 2] * sine) / 2


def from_angles(i0, i45, i90, i135):
    """Returns the Stokes vectors of light that ideal polarizers at four angles let pass, with s3 = 0. s0 is the mean of both
    pairs."""
    return numpy.stack([(i0 + i45 + i90 + i135) / 2, i0 - i90, i45 - i135, numpy.zeros_like(i0)], axis=-1)
