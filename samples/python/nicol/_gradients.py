# SPDX-License-Identifier: MIT
"""Gradients of a function of a picture by the picture's light, as numpy arrays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from . import Scene, Texture, _abi, _stokes_image, numpy


class Gradients(NamedTuple):
    """Derivatives of a function of a picture, or None where they were not wanted, see Gradient."""

    environment: Any  # (channels, (order_low + 1)^2, 4)
    lights: Any  # (lights, channels, 4)
    instances: Any  # (instances, channels)
    texels: Any  # (rows, columns, channels of the texture)


def gradients(
    scene: Scene,
    camera: _abi.Camera,
    options: _abi.RenderOptions,
    picture: Any,
    wanted: Sequence[str] = ("environment",),
    texture: Texture | None = None,
    shape: tuple[int, int, int] | None = None,
) -> Gradients:
    """Returns the gradients of a function of the picture that render() makes, see nicol_render_adjoint. picture: the
    derivatives by the picture's Stokes vectors, (height, width, channels, 4). wanted: some of "environment", "lights" and
    "instances". texture: an image of the given shape, (rows, columns, channels), whose texels are wanted as well."""
    channels = scene.get_channels()
    shapes = {
        "environment": (channels, (options.order_low + 1) ** 2, 4),
        "lights": (scene.get_light_count(), channels, 4),
        "instances": (scene.get_instance_count(), channels),
    }
    if (texture is None) != (shape is None):
        raise ValueError("give the texture and its shape, or neither")
    for name in wanted:
        if name not in shapes:
            raise ValueError(f"the gradient by '{name}' is wanted; it must be one of {', '.join(shapes)}")
    if "environment" in wanted and options.order_low == _abi.ORDER_AUTOMATIC:
        raise ValueError("order_low is automatic; the gradient by the environment needs a number, equal to order_high")
    room = _abi.Gradient()
    found = {name: numpy.zeros(shapes[name]) for name in wanted}
    for name, values in found.items():
        setattr(room, name, values)
        setattr(room, f"{name}_count", values.size)
    if texture is not None and shape is not None:
        found["texels"] = texels = numpy.zeros(shape)
        room.texture, room.texels, room.texels_count = texture, texels, texels.size
    picture = _stokes_image(numpy.ascontiguousarray(picture, numpy.float32))
    _abi.render_adjoint(scene, camera, options, picture, room)
    return Gradients(**{name: found.get(name) for name in Gradients._fields})
