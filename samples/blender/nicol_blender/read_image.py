# SPDX-License-Identifier: MIT
"""Reads Blender's images and the nodes that place them on a surface."""

from __future__ import annotations

import math

import numpy

from .description import Scene, Texture

# From (u, v, 1) with v upwards, as Blender counts, to v downwards, and back.
_FLIP = numpy.array([[1.0, 0, 0], [0, -1, 1], [0, 0, 1]])
_WRAPS = {"REPEAT": "repeat", "EXTEND": "clamp", "CLIP": "clamp", "MIRROR": "mirror"}
_LINEAR = ("Non-Color", "Linear", "Linear Rec.709", "Raw")


def pixels_of(image) -> numpy.ndarray:
    """Returns (height, width, 4), first row at the top: 8-bit integers as the file has them, or floats."""
    width, height = image.size
    pixels = numpy.empty(width * height * image.channels, numpy.float32)
    image.pixels.foreach_get(pixels)
    pixels = pixels.reshape(height, width, image.channels)[::-1]
    if not image.is_float:
        pixels = numpy.rint(pixels * 255).astype(numpy.uint8)
    return numpy.ascontiguousarray(pixels)


def decoded(pixels: numpy.ndarray) -> numpy.ndarray:
    """Returns linear 32-bit floats of 8-bit integers in sRGB, or the floats as they are."""
    if pixels.dtype == numpy.float32:
        return pixels
    x = numpy.arange(256) / 255
    table = numpy.where(x <= 0.04045, x / 12.92, ((x + 0.055) / 1.055) ** 2.4).astype(numpy.float32)
    return table[pixels]


def has_pixels(image, scene: Scene, where: str) -> bool:
    """Says whether an image node has an image that can be read, and notices if not."""
    if image is None or not image.size[0] or not image.size[1]:
        scene.notice(f"{where}: the image is missing")
        return False
    if image.source not in ("FILE", "GENERATED", "VIEWER"):
        scene.notice(f"{where}: of an image of source {image.source} the present picture is taken")
    if not image.is_float and image.colorspace_settings.name not in ("sRGB", *_LINEAR):
        scene.notice(f"{where}: the colour space {image.colorspace_settings.name} is taken as sRGB")
    return True


def texture_of(node, channel: int | None, scene: Scene, where: str) -> Texture | None:
    """Returns the texture of an Image Texture node. channel: 0 to 3, or None for red, green and blue."""
    if not has_pixels(node.image, scene, where):
        return None
    if node.projection != "FLAT":
        scene.notice(f"{where}: the projection {node.projection} is taken as FLAT")
    pixels = pixels_of(node.image)
    if pixels.shape[2] == 1:
        pixels = numpy.repeat(pixels, 3, 2)
    raw = node.image.colorspace_settings.name in _LINEAR
    if channel is None:
        pixels = pixels[..., :3]
    else:
        # One number of a colour is linear; coverage is never encoded.
        pixels = pixels if raw or channel == 3 else decoded(pixels)
        opaque = channel == 3 and pixels.shape[2] < 4
        pixels = numpy.full_like(pixels[..., :1], 255) if opaque else pixels[..., channel : channel + 1]
        raw = True
    return Texture(
        numpy.ascontiguousarray(pixels), raw, "nearest" if node.interpolation == "Closest" else "mipmap",
        _WRAPS[node.extension], _to_uv(node, scene, where),
    )  # fmt: skip


def _to_uv(node, scene: Scene, where: str) -> numpy.ndarray:
    """Returns the transform of the Mapping node before an image."""
    vector = node.inputs["Vector"]
    if not vector.is_linked:
        return numpy.eye(3)
    source = vector.links[0].from_node
    if source.type == "MAPPING":
        mapped = _mapping(source, scene, where)
        if source.inputs["Vector"].is_linked:
            _check_coordinates(source.inputs["Vector"].links[0], scene, where)
        return _FLIP @ mapped @ _FLIP
    _check_coordinates(vector.links[0], scene, where)
    return numpy.eye(3)


def _check_coordinates(link, scene: Scene, where: str) -> None:
    node = link.from_node
    if node.type == "UVMAP" and not node.from_instancer:
        if node.uv_map:
            scene.notice(f"{where}: every texture takes the active UV map, not {node.uv_map} by its name")
    elif node.type != "TEX_COORD" or link.from_socket.name != "UV":
        scene.notice(f"{where}: coordinates from {node.name} are taken as UV")


def _mapping(node, scene: Scene, where: str) -> numpy.ndarray:
    if node.vector_type not in ("POINT", "TEXTURE") or any(
        node.inputs[name].is_linked for name in ("Location", "Rotation", "Scale")
    ):
        scene.notice(f"{where}: Mapping of the type {node.vector_type}, or with linked values, is not followed")
        return numpy.eye(3)
    location, rotation, scale = (node.inputs[name].default_value for name in ("Location", "Rotation", "Scale"))
    if rotation[0] or rotation[1]:
        scene.notice(f"{where}: Mapping rotates about Z alone")
    c, s = math.cos(rotation[2]), math.sin(rotation[2])
    matrix = numpy.array([[c * scale[0], -s * scale[1], location[0]], [s * scale[0], c * scale[1], location[1]], [0, 0, 1]])
    return matrix if node.vector_type == "POINT" else numpy.linalg.inv(matrix)
