# SPDX-License-Identifier: MIT
"""Scene between Blender and Nicol: plain data in Nicol's axes (+y up), independent of both programs."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Union

import numpy

Color = tuple[float, float, float]
IDENTITY = numpy.eye(4)


@dataclass(eq=False)
class Texture:
    """Image over a surface."""

    pixels: numpy.ndarray  # (height, width, 1, 3 or 4) of 8-bit integers or 32-bit floats, first row at the top
    raw: bool = False  # whether 8-bit integers are linear values instead of sRGB
    filter: str = "mipmap"  # "nearest" or "mipmap"
    wrap: str = "repeat"  # "repeat", "mirror" or "clamp"
    to_uv: numpy.ndarray = field(default_factory=lambda: numpy.eye(3))  # from (u, v, 1) of the mesh, v downwards


Value = Union[float, str, Color, Texture]


@dataclass(eq=False)
class Material:
    """Material by the name and the parameters of Mitsuba 3's plug-in; parts are the materials that it is made of."""

    kind: str
    values: dict[str, Value] = field(default_factory=dict)
    parts: tuple[Material, ...] = ()


@dataclass(eq=False)
class Mesh:
    """Triangles with one normal and one pair of texture coordinates per vertex."""

    positions: numpy.ndarray  # (vertices, 3) 32-bit floats
    normals: numpy.ndarray
    texcoords: numpy.ndarray | None  # (vertices, 2), v downwards
    faces: numpy.ndarray  # (triangles, 3) unsigned 32-bit integers


@dataclass(eq=False)
class Surface:
    """Material of a mesh, and the light that it emits, from its front or from both sides."""

    material: Material
    radiance: Color | Texture | None = None  # None: no light
    two_sided: bool = True


@dataclass(eq=False)
class Instance:
    key: tuple  # identity of the instance from one reading of a scene to the next
    mesh: Mesh
    surface: Surface
    to_world: numpy.ndarray


@dataclass(eq=False)
class Light:
    """Light without a surface, along its own +z. kind: "directional", "point" or "spot"; value: as nicol_light says. Angles
    are degrees."""

    kind: str
    value: Color
    to_world: numpy.ndarray
    angular_radius: float = 0
    cutoff_angle: float = 20
    beam_width: float = 15


@dataclass(eq=False)
class Sky:
    """Clear sky without the sun's disc."""

    sun_direction: Color
    turbidity: float


@dataclass(eq=False)
class World:
    """Light from all around: one colour, an equirectangular image (height, width, 3) of linear 32-bit floats, or a sky."""

    light: Color | numpy.ndarray | Sky
    scale: float = 1
    to_world: numpy.ndarray = field(default_factory=lambda: IDENTITY)


@dataclass(eq=False)
class Scene:
    instances: list[Instance] = field(default_factory=list)
    lights: list[Light] = field(default_factory=list)
    world: World | None = None
    hide_emitters: bool = False
    notices: list[str] = field(default_factory=list)  # what of the scene is not followed, one sentence each

    def notice(self, text: str) -> None:
        if text not in self.notices:
            self.notices.append(text)
