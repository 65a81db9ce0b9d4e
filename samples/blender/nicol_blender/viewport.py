# SPDX-License-Identifier: MIT
"""Pictures of a viewport: the scene is kept between frames, and a frame costs what has changed since the last."""

from __future__ import annotations

import colorsys

import nicol
import numpy
from nicol import conventions

from .read_scene import read_scene
from .stage import Stage


class Viewport:
    """Scene and picture of one viewport, without drawing."""

    def __init__(self) -> None:
        self.notices: list[str] = []  # of the last update that read the whole scene
        self.improves = False  # whether another picture of the same view would be better
        self._stage: Stage | None = None
        self._framebuffer: nicol.Framebuffer | None = None

    def update(self, depsgraph) -> None:
        """Takes over what has changed in Blender's scene."""
        description = read_scene(depsgraph)
        only_moved = depsgraph.updates and all(
            type(update.id).__name__ == "Object" and update.is_updated_transform and not update.is_updated_geometry
            and not update.is_updated_shading and update.id.type not in ("LIGHT", "CAMERA")
            for update in depsgraph.updates
            if type(update.id).__name__ not in ("Scene", "Collection")
        )  # fmt: skip
        if self._stage is not None and only_moved and self._stage.move(description):
            return
        self._stage, self.notices = Stage(description), description.notices

    def picture(
        self, camera: nicol.Camera, size: tuple[int, int], options: nicol.RenderOptions, what: str, polarizer_angle: float
    ) -> numpy.ndarray:
        """Returns what a view shows as (height, width, 4) floats in scene-linear colours, first row at the bottom."""
        if self._framebuffer is None:
            self._framebuffer = nicol.Framebuffer.create(self._stage.context, *size, 3)
        elif self._framebuffer.get_size()[:2] != size:
            self._framebuffer.resize(*size)
        nicol.render(self._stage.scene, camera, options, self._framebuffer)
        picture = nicol.Picture(self._framebuffer)
        self.improves = picture.statistics.vertices_pending > 0
        pixels = numpy.ones((size[1], size[0], 4), numpy.float32)
        pixels[..., :3] = shown(picture, what, polarizer_angle)[::-1]
        return pixels


def shown(picture: nicol.Picture, what: str, polarizer_angle: float) -> numpy.ndarray:
    """Returns red, green and blue of what a viewport shows: "s0", "polarizer", "dolp" or "aolp"."""
    if what == "s0":
        return picture.s0
    if what == "polarizer":
        return picture.polarizer(numpy.degrees(polarizer_angle))
    stokes = picture.stokes.mean(2)
    dolp = conventions.dolp(stokes)
    if what == "dolp":
        return numpy.repeat(dolp[..., None], 3, 2)
    # The hue goes once round in half a turn.
    hues = numpy.array([colorsys.hsv_to_rgb(i / 180, 1, 1) for i in range(180)], numpy.float32)
    angle = numpy.degrees(conventions.aolp(stokes)).astype(int) % 180
    return hues[angle] * dolp[..., None]
