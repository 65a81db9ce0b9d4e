# SPDX-License-Identifier: MIT
"""Makes Nicol's scene of a description."""

from __future__ import annotations

import functools

import nicol
import numpy

from . import description as d

_FILTERS = {"nearest": nicol.TEXTURE_FILTER_NEAREST, "mipmap": nicol.TEXTURE_FILTER_MIPMAP}
_WRAPS = {"repeat": nicol.TEXTURE_WRAP_REPEAT, "mirror": nicol.TEXTURE_WRAP_MIRROR, "clamp": nicol.TEXTURE_WRAP_CLAMP}


class Stage:
    """Scene of Nicol, made of a description."""

    def __init__(self, scene: d.Scene, context: nicol.Context | None = None) -> None:
        self.context = context or nicol.default_context()
        self.scene = nicol.Scene.create(self.context)
        self._ids: dict[tuple, int] = {}
        mesh, texture = functools.cache(self._mesh), functools.cache(self._texture)
        material = functools.cache(functools.partial(self._material, texture))
        for instance in scene.instances:
            id = self.scene.add_instance(
                nicol.Instance(mesh=mesh(instance.mesh), material=material(instance.surface.material),
                               to_world=instance.to_world)
            )  # fmt: skip
            self._ids[instance.key] = id
            if instance.surface.radiance is not None:
                self.scene.set_emission(id, self._emission(instance, texture))
        for light in scene.lights:
            self.scene.add_light(
                nicol.Light(kind=light.kind, value=light.value, to_world=light.to_world, angular_radius=light.angular_radius,
                            cutoff_angle=light.cutoff_angle, beam_width=light.beam_width)
            )  # fmt: skip
        if scene.world is not None:
            self.scene.set_environment(self._environment(scene.world.light), scene.world.to_world, scene.world.scale)
        self.scene.hide_emitters(int(scene.hide_emitters))

    def move(self, scene: d.Scene) -> bool:
        """Places the instances as a later description of the same objects says. Returns False if the objects differ."""
        if {instance.key for instance in scene.instances} != set(self._ids):
            return False
        for instance in scene.instances:
            self.scene.set_transform(self._ids[instance.key], instance.to_world)
        return True

    def _mesh(self, mesh: d.Mesh) -> nicol.Mesh:
        return nicol.Mesh.create(
            self.context, nicol.mesh_data(mesh.positions, mesh.faces, normals=mesh.normals, texcoords=mesh.texcoords)
        )

    def _texture(self, texture: d.Texture) -> nicol.Texture:
        options = nicol.TextureOptions(
            filter=_FILTERS[texture.filter], wrap=_WRAPS[texture.wrap], raw=int(texture.raw), to_uv=texture.to_uv
        )
        return nicol.Texture.create_image(self.context, nicol.texture_image(texture.pixels), options)

    def _material(self, texture, material: d.Material) -> nicol.Material:
        parts = [self._material(texture, part) for part in material.parts]
        first = parts[0] if parts else None
        create = nicol.Material
        if material.kind == "twosided":
            return create.create_twosided(self.context, first)
        if material.kind == "blendbsdf":
            return create.create_blend(self.context, *parts, self._as_texture(texture, material.values["weight"]))
        if material.kind == "normalmap":
            # y points to where v falls, also where texture coordinates are mirrored.
            return create.create_normal_map(self.context, first, texture(material.values["normals"]), 1)
        if material.kind == "mask":
            return create.create_mask(self.context, first, texture(material.values["opacity"]))
        if material.kind == "diffuse":
            return self._diffuse(texture, material.values["reflectance"])
        made = {"pplastic": (nicol.Pplastic, create.create_pplastic), "roughconductor": (nicol.Conductor, create.create_conductor),
                "dielectric": (nicol.Dielectric, create.create_dielectric),
                "roughdielectric": (nicol.Dielectric, create.create_dielectric)}[material.kind]  # fmt: skip
        fields = {}
        for name, value in material.values.items():
            if isinstance(value, d.Texture):
                fields[f"{name}_texture"] = texture(value)
            else:
                fields[name] = value
        film = {name.removeprefix("film_"): fields.pop(name) for name in list(fields) if name.startswith("film_")}
        return made[1](self.context, made[0](film=nicol.Film(**film), **fields))

    def _diffuse(self, texture, reflectance: d.Value) -> nicol.Material:
        if not isinstance(reflectance, d.Texture):
            return nicol.Material.create_diffuse(self.context, reflectance)
        white = nicol.Material.create_diffuse(self.context, 1)
        return nicol.Material.create_scaled(self.context, white, texture(reflectance))

    def _as_texture(self, texture, value: d.Value) -> nicol.Texture:
        if isinstance(value, d.Texture):
            return texture(value)
        return texture(d.Texture(numpy.full((1, 1, 1), value, numpy.float32), True, "nearest"))

    @staticmethod
    def _emission(instance: d.Instance, texture) -> nicol.Emission:
        radiance = instance.surface.radiance
        if isinstance(radiance, d.Texture):
            return nicol.Emission(radiance=(1.0, 1.0, 1.0), texture=texture(radiance), two_sided=instance.surface.two_sided)
        return nicol.Emission(radiance=radiance, two_sided=instance.surface.two_sided)

    def _environment(self, light) -> nicol.Environment:
        if isinstance(light, d.Sky):
            return nicol.Environment.create_sky(
                self.context, nicol.Sky(sun_direction=light.sun_direction, turbidity=light.turbidity)
            )
        if isinstance(light, numpy.ndarray):
            return nicol.Environment.create_image(self.context, nicol.image(light))
        return nicol.Environment.create_constant(self.context, light)
