# SPDX-License-Identifier: MIT
"""Pictures of a recipe by frame number."""

import json
import tempfile

import nicol

from .. import lens
from . import cameras, planes
from .scenes import Kept, Studio
from .values import RecipeError


class Picture:
    """A frame: what frame.json says about it, its arrays by name, and the light that falls on a sensor: a framebuffer, or an
    array. The arrays of a framebuffer are None until Renderer.read()."""

    def __init__(self, facts, arrays, light):
        self.facts, self.arrays, self.light = facts, arrays, light


class Renderer:
    """Renders the frames of a recipe, in any order, with the same bits. threads 0: one per core."""

    def __init__(self, recipe, threads=0, log=None):
        self.recipe = recipe
        self.context = nicol.Context.create(nicol.ContextOptions(threads=threads, log=log))
        self.studio = Studio(self.context, recipe)
        self.stages = Kept(self._stage, 2)
        self.lenses = Kept(lambda fov: cameras.lens(recipe, fov), 1)
        self.sensor = _sensor(recipe)
        self.options = self._options()

    def check(self):
        """Fails with RecipeError for values that the library would refuse in the middle of the work."""
        self.studio.check()

    def channels(self, frame):
        """Returns the number of colour channels of a frame."""
        return self.stages(self.recipe.scene_of(frame)).scene.get_channels()

    def framebuffer(self, frame):
        """Returns a framebuffer for a frame."""
        size = self.recipe.width, self.recipe.height
        return nicol.Framebuffer.create(self.context, *size, self.channels(frame))

    def render(self, frame, names, framebuffer, half=()):
        """Renders a frame for read(), which any thread may call while the next frame is rendered into another framebuffer.
        names: the arrays that read() shall give. half: may name stokes, which then has 16-bit floats."""
        recipe = self.recipe
        scene, draw = recipe.scene_of(frame), recipe.frame_draw(frame)
        stage = self.stages(scene)
        if recipe.light_per_frame:
            self.studio.light(stage, draw)
        camera = cameras.camera(recipe, stage, frame)
        self.options.seed = draw.bits("render")
        self.options.aovs = planes.aovs(names)
        pose, light, arrays = cameras.pose(recipe, stage, camera), framebuffer, None
        try:
            if recipe.lens:
                K, through = self.lenses(camera.fov)
                pose["K"] = (K + [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]]).tolist()
                shown = lens.render(stage.scene, camera, through, self.options, planes.lens_aovs(names))
                arrays, light = planes.through_lens(shown, names, pose["R"], half), shown["stokes"]
            else:
                nicol.render(stage.scene, camera, self.options, framebuffer)
        except (nicol.Error, ValueError) as error:
            raise RecipeError(f"{recipe.source.name}: frame {frame}: {error}") from None
        facts = {"frame": frame, "scene": scene, "size": [recipe.width, recipe.height], "camera": pose}
        facts["bounds"] = [stage.lower.tolist(), stage.upper.tolist()]
        facts["drawn"] = self._drawn(scene, frame)
        return Picture(facts, arrays, light)

    def read(self, picture, names, half=()):
        """Sets the arrays of a picture of render(), which must be its framebuffer's last."""
        facts, light = picture.facts, picture.light
        if picture.arrays is None:
            picture.arrays = planes.read(light, names, facts["camera"]["R"], half)
        if any(name in planes.SENSED for name in names):
            draw = self.recipe.frame_draw(facts["frame"])
            facts["exposure"] = planes.exposure_of(self.recipe, draw, light)
            picture.arrays |= planes.sense(self.sensor, light, names, facts["frame"], facts["exposure"])

    def _drawn(self, scene, frame):
        shared = self.recipe.scene_draw(scene)
        of = {name: shared for name in ("scene", "objects", "floor", "light")} | {"camera": self.recipe.camera_draw(frame)}
        if self.recipe.light_per_frame:
            of["light"] = self.recipe.frame_draw(frame)
        return {name: self.recipe.parts[name].at(of[name]) for name in of if name in self.recipe.parts}

    def _stage(self, scene):
        draw = self.recipe.scene_draw(scene)
        stage = self.studio.stage(draw)
        # The number of channels depends on the light, so a scene has one from the start.
        first = self.recipe.frame_draw(scene * self.recipe.views)
        self.studio.light(stage, first if self.recipe.light_per_frame else draw)
        return stage

    def _history(self):
        """Returns the optimisations through which a picture depends on the pictures of its scene before: what the bake infers
        instead of tracing, and, with light that surfaces reflect to each other, vertices that no picture has shown."""
        if self.recipe.views == 1:
            return 0
        direct = self.recipe.render.get("max_depth", 0) in (0, 2)
        return nicol.OPTIMISATION_RAYS | (0 if direct else nicol.OPTIMISATION_HIDDEN)

    def _options(self):
        try:
            options = nicol.RenderOptions(**self.recipe.render)
        except (ValueError, TypeError) as error:
            raise RecipeError(f"{self.recipe.source.name}: render: {error}") from None
        options.disabled_optimisations = self._history()
        return options


def _sensor(recipe):
    """Returns the sensor of a recipe: a file that the library reads, or an object of the same form."""
    given = recipe.parts["sensor"].at(None) if "sensor" in recipe.parts else {}
    sensor = nicol.Sensor(seed=recipe.seed)
    try:
        if isinstance(given, str):
            return sensor.load(recipe.source.path(given))
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump(given, file)
            file.flush()
            return sensor.load(file.name)
    except nicol.Error as error:
        text = str(error) if isinstance(given, str) else str(error).replace(file.name, "sensor")
        raise RecipeError(f"{recipe.source.name}: {text}") from None
