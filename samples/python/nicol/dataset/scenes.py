# SPDX-License-Identifier: MIT
"""Scenes of a recipe: objects, floor and light, made of drawn values."""

import collections
import math

import nicol
import numpy

from . import materials
from .recipe import SCENES, SHAPES
from .values import RecipeError

_SKY_FIELDS = ("radiance", "turbidity", "dop_max", "ground_albedo")


class Kept:
    """The results of a function for the arguments that were used last."""

    def __init__(self, make, most):
        self.make, self.most, self.kept = make, most, collections.OrderedDict()

    def __call__(self, key):
        if key in self.kept:
            self.kept.move_to_end(key)
        else:
            self.kept[key] = self.make(key)
            if len(self.kept) > self.most:
                self.kept.popitem(last=False)
        return self.kept[key]


class Part:
    """A mesh of an object: where it is in the object, and the material of its file, or None."""

    def __init__(self, mesh, to_object, material):
        self.mesh, self.to_object, self.material = mesh, to_object, material


class Stage:
    """A scene, the box that cameras look at, and the id of the recipe's sun."""

    def __init__(self, scene, lower, upper):
        self.scene, self.lower, self.upper, self.sun = scene, lower, upper, None


class Studio:
    """Makes scenes. Meshes and environments that were used last are kept."""

    def __init__(self, context, recipe):
        self.context, self.recipe, self.source = context, recipe, recipe.source
        self.parts = Kept(self._load_parts, 16)
        self.environments = Kept(self._load_environment, 4)

    def check(self):
        """Tries both ends of each range and each option of materials and skies, and fails with the key of the first that is
        out of range."""
        for i, copies in enumerate(self.recipe.parts["objects"].parts if "objects" in self.recipe.parts else ()):
            if "material" in copies.table.parts:
                key = f"objects[{i}].material"
                materials.check(self.context, self.source, key, copies.table.parts["material"])
        if "floor" in self.recipe.parts and "material" in self.recipe.parts["floor"].parts:
            material = self.recipe.parts["floor"].parts["material"]
            materials.check(self.context, self.source, "floor.material", material)
        light = self.recipe.parts["light"].parts if "light" in self.recipe.parts else {}
        for environment in light["environment"].trials() if "environment" in light else ():
            if isinstance(environment, dict):
                self._checked("light.environment.sky", self._sky, environment["sky"])

    def _checked(self, key, make, *arguments):
        try:
            return make(*arguments)
        except nicol.Error as error:
            raise RecipeError(f"{self.source.name}: {key}: {error}") from None

    def stage(self, draw):
        """Returns the stage of a draw, without the recipe's light."""
        parts = self.recipe.parts
        if "scene" in parts:
            path = self.source.path(parts["scene"].at(draw))
            scene = self._checked("scene", nicol.Scene.load, self.context, path)
        else:
            scene = nicol.Scene.create(self.context)
        for i, copies in enumerate(parts["objects"].parts if "objects" in parts else ()):
            for drawn in copies.at(draw):
                self._checked(f"objects[{i}]", self._add, scene, drawn)
        lower, upper = scene.get_bounds() if scene.get_instance_count() else ([-1.0] * 3, [1.0] * 3)
        if "floor" in parts:
            self._checked("floor", self._add_floor, scene, parts["floor"].at(draw), lower, upper)
        return Stage(scene, numpy.array(lower), numpy.array(upper))

    def light(self, stage, draw):
        """Gives a stage the light of a draw."""
        if "light" not in self.recipe.parts:
            return
        drawn = self.recipe.parts["light"].at(draw)
        if "environment" in drawn:
            environment = self._checked("light.environment", self._environment, drawn["environment"])
            rotation = materials.turn(drawn.get("rotation", 0))
            self._checked("light", stage.scene.set_environment, environment, rotation, drawn.get("scale", 1))
        if "sun" in drawn:
            sun = _sun(drawn["sun"])
            if stage.sun is None:
                stage.sun = self._checked("light.sun", stage.scene.add_light, sun)
            else:
                self._checked("light.sun", stage.scene.set_light, stage.sun, sun)

    def _add(self, scene, drawn):
        parts, lower, upper = self.parts(drawn["mesh"])
        placed = _placed(lower, upper, drawn)
        material = materials.create(self.context, self.source, drawn["material"]) if "material" in drawn else None
        for part in parts:
            own = material or part.material or nicol.Material.create_diffuse(self.context, 0.5)
            to_world = placed @ part.to_object
            scene.add_instance(nicol.Instance(mesh=part.mesh, material=own, to_world=to_world.ravel()))

    def _add_floor(self, scene, drawn, lower, upper):
        half, material = drawn.get("size", 8) / 2, drawn.get("material", {"type": "diffuse"})
        middle = [(a + b) / 2 for a, b in zip(lower, upper)]
        to_world = [half, 0, 0, middle[0], 0, 0, half, lower[1], 0, -half, 0, middle[2], 0, 0, 0, 1]
        made = materials.create(self.context, self.source, material)
        scene.add_instance(nicol.Instance(mesh=self.parts("rectangle")[0][0].mesh, material=made, to_world=to_world))

    def _load_parts(self, name):
        """Returns the parts of an object and its box."""
        if name in SHAPES:
            mesh = getattr(nicol.Mesh, f"create_{name}")(self.context)
            return [Part(mesh, numpy.eye(4), None)], *mesh.get_bounds()
        path = self.source.path(name)
        if not name.lower().endswith(SCENES):
            mesh = nicol.Mesh.load(self.context, path)
            return [Part(mesh, numpy.eye(4), None)], *mesh.get_bounds()
        with nicol.Scene.load(self.context, path) as scene:
            parts = []
            for instance in scene.get_instance_ids():
                mesh, material, to_world = scene.get_instance(instance)
                parts.append(Part(mesh, numpy.array(to_world).reshape(4, 4), material))
            if not parts:
                raise RecipeError(f"{path}: the file has no surfaces; objects need one or more")
            return parts, *scene.get_bounds()

    def _environment(self, drawn):
        if isinstance(drawn, dict):
            return self._sky(drawn["sky"])
        if isinstance(drawn, str):
            return self.environments(drawn)
        return nicol.Environment.create_constant(self.context, drawn)

    def _load_environment(self, name):
        return nicol.Environment.load(self.context, self.source.path(name))

    def _sky(self, drawn):
        fields = {name: drawn[name] for name in _SKY_FIELDS if name in drawn}
        to_sun = direction(drawn.get("azimuth", 0), drawn.get("elevation", 45))
        return nicol.Environment.create_sky(self.context, nicol.Sky(sun_direction=to_sun, **fields))


def direction(azimuth, elevation):
    """Returns the unit vector of an azimuth, counted from +z towards +x, and an elevation above the horizon."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return [math.sin(a) * math.cos(e), math.sin(e), math.cos(a) * math.cos(e)]


def _sun(drawn):
    to_sun = direction(drawn.get("azimuth", 0), drawn.get("elevation", 45))
    up = [0, 0, 1] if abs(to_sun[1]) > 0.999 else [0, 1, 0]
    towards = nicol.Camera().look_at(to_sun, [0, 0, 0], up)
    return nicol.Light(kind=nicol.LIGHT_DIRECTIONAL, value=drawn.get("irradiance", 1), to_world=list(towards.to_world),
                       angular_radius=drawn.get("angular_radius", 0.27))  # fmt: skip


def _placed(lower, upper, drawn):
    """Returns the matrix that takes an object to the scene: the middle of its box to `position`, its longest side to `size`."""
    lower, upper = numpy.array(lower), numpy.array(upper)
    longest = max(upper - lower)
    scale = drawn.get("size", 1.0) / longest if longest > 0 else 1.0
    rotation = drawn.get("rotation", 0)
    turned = numpy.array(materials.turn(rotation)).reshape(4, 4)[:3, :3] if not isinstance(rotation, list) else rotation
    placed = numpy.eye(4)
    placed[:3, :3] = scale * numpy.array(turned)
    placed[:3, 3] = numpy.array(drawn.get("position", [0, 0, 0])) - placed[:3, :3] @ ((lower + upper) / 2)
    return placed
