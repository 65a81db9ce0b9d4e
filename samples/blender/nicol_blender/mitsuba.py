# SPDX-License-Identifier: MIT
"""Writes a description as a scene of Mitsuba 3, which nicol-render reads, and the files that it names."""

from __future__ import annotations

import os
from xml.sax.saxutils import quoteattr

import nicol
import numpy

from . import description as d
from .files import write_exr, write_ply, write_png


def export(scene: d.Scene, camera: nicol.Camera, size: tuple[int, int], options: nicol.RenderOptions, path: str) -> None:
    """Writes the scene to `path`, and meshes and images beside it, with names that begin as that of `path`."""
    if camera.pixel_aspect != 1:
        raise ValueError(f"pixels are {camera.pixel_aspect:g} times as wide as high; a Mitsuba scene needs square ones")
    text = _Writer(os.path.splitext(path)[0]).scene(scene, camera, size, options)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _numbers(values) -> str:
    return ",".join(repr(float(x)) for x in numpy.asarray(values).ravel())


def _matrix(matrix, name: str = "to_world") -> str:
    return f'<transform name="{name}"><matrix value="{_numbers(matrix).replace(",", " ")}"/></transform>'


def _float(name: str, value: float) -> str:
    return f'<float name="{name}" value="{float(value)!r}"/>'


class _Writer:
    def __init__(self, stem: str) -> None:
        self.stem = stem
        self._names: dict[int, str] = {}  # of files that are written, by the identity of their content

    def _file(self, content, ending: str, write, *arguments) -> str:
        """Returns the name of the file of a mesh, texture or image, which is written when it is first asked for."""
        if id(content) not in self._names:
            path = f"{self.stem}_{len(self._names)}.{ending}"
            write(path, *arguments)
            self._names[id(content)] = os.path.basename(path)
        return quoteattr(self._names[id(content)])

    def scene(self, scene: d.Scene, camera: nicol.Camera, size: tuple[int, int], options: nicol.RenderOptions) -> str:
        hidden = '<boolean name="hide_emitters" value="true"/>' if scene.hide_emitters else ""
        depth = options.max_depth or 2
        lines = [
            '<scene version="3.0.0">',
            f'<integrator type="stokes"><integrator type="path"><integer name="max_depth" value="{depth}"/>{hidden}</integrator></integrator>',
            self._camera(camera, size, options.pixel_samples or 1),
        ]
        if scene.world is not None:
            lines.append(self._world(scene.world))
        lines += [self._light(light) for light in scene.lights]
        lines += [self._instance(instance) for instance in scene.instances]
        return "\n".join([*lines, "</scene>", ""])

    def _camera(self, camera: nicol.Camera, size: tuple[int, int], samples: int) -> str:
        perspective = camera.projection == nicol.PROJECTION_PERSPECTIVE
        shift = "".join(_float(f"principal_point_offset_{axis}", x) for axis, x in zip("xy", camera.shift))
        fov = f'{_float("fov", camera.fov)}<string name="fov_axis" value="x"/>{shift}' if perspective else ""
        return (
            f'<sensor type="{"perspective" if perspective else "orthographic"}">{fov}'
            f'{_float("near_clip", camera.near_clip)}{_float("far_clip", camera.far_clip)}{_matrix(list(camera.to_world))}'
            f'<film type="hdrfilm"><integer name="width" value="{size[0]}"/><integer name="height" value="{size[1]}"/>'
            f'<rfilter type="box"/></film><sampler type="independent"><integer name="sample_count" value="{samples}"/></sampler></sensor>'
        )

    def _world(self, world: d.World) -> str:
        if isinstance(world.light, d.Sky):
            direction = "".join(f' {axis}="{float(x)!r}"' for axis, x in zip("xyz", world.light.sun_direction))
            radiance = f'<rgb name="radiance" value="{_numbers([world.scale] * 3)}"/>'
            return (
                f'<emitter type="sky"><vector name="sun_direction"{direction}/>{_float("turbidity", world.light.turbidity)}'
                f"{radiance}</emitter>"
            )
        if isinstance(world.light, numpy.ndarray):
            name = self._file(world.light, "exr", write_exr, world.light)
            return (
                f'<emitter type="envmap"><string name="filename" value={name}/>{_float("scale", world.scale)}'
                f"{_matrix(world.to_world)}</emitter>"
            )
        return f'<emitter type="constant"><rgb name="radiance" value="{_numbers([x * world.scale for x in world.light])}"/></emitter>'

    def _light(self, light: d.Light) -> str:
        name = {"directional": "irradiance"}.get(light.kind, "intensity")
        more = ""
        if light.kind == "directional" and light.angular_radius:
            more = _float("angular_radius", light.angular_radius)
        elif light.kind == "spot":
            more = _float("cutoff_angle", light.cutoff_angle) + _float("beam_width", light.beam_width)
        value = f'<rgb name="{name}" value="{_numbers(light.value)}"/>'
        return f'<emitter type="{light.kind}">{value}{more}{_matrix(light.to_world)}</emitter>'

    def _instance(self, instance: d.Instance) -> str:
        name = self._file(instance.mesh, "ply", write_ply, instance.mesh)
        emitter = ""
        if instance.surface.radiance is not None:
            two_sided = '<boolean name="two_sided" value="true"/>' if instance.surface.two_sided else ""
            emitter = f'<emitter type="area">{self._value("radiance", instance.surface.radiance)}{two_sided}</emitter>'
        return (
            f'<shape type="ply"><string name="filename" value={name}/>{_matrix(instance.to_world)}'
            f"{self._material(instance.surface.material)}{emitter}</shape>"
        )

    def _material(self, material: d.Material) -> str:
        values = "".join(self._value(name, value) for name, value in material.values.items())
        if material.kind == "normalmap":
            values += '<boolean name="use_shadowing_function" value="false"/>'
        return f'<bsdf type="{material.kind}">{values}{"".join(self._material(part) for part in material.parts)}</bsdf>'

    def _value(self, name: str, value: d.Value) -> str:
        if isinstance(value, str):
            return f'<string name="{name}" value="{value}"/>'
        if isinstance(value, d.Texture):
            return self._texture(name, value)
        if isinstance(value, tuple):
            return f'<rgb name="{name}" value="{_numbers(value)}"/>'
        return _float(name, value)

    def _texture(self, name: str, texture: d.Texture) -> str:
        integers = texture.pixels.dtype == numpy.uint8
        file = self._file(texture, "png" if integers else "exr", write_png if integers else write_exr, texture.pixels)
        raw = "true" if texture.raw else "false"
        kinds = {"nearest": "nearest", "mipmap": "bilinear"}
        to_uv = numpy.eye(4)
        to_uv[:2, :2], to_uv[:2, 3] = texture.to_uv[:2, :2], texture.to_uv[:2, 2]
        return (
            f'<texture name="{name}" type="bitmap"><string name="filename" value={file}/>'
            f'<boolean name="raw" value="{raw}"/><string name="filter_type" value="{kinds[texture.filter]}"/>'
            f'<string name="wrap_mode" value="{texture.wrap}"/>{_matrix(to_uv, "to_uv")}</texture>'
        )
