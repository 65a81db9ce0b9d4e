# SPDX-License-Identifier: MIT
"""A recipe: what a data set's pictures show, and what is written of each."""

import hashlib
import json
import os

import nicol

from . import materials, reader
from .values import AnyRotation, Copies, Draw, Fixed, Path, Range, RecipeError, Row, Table, leaves

MESHES = (".obj", ".ply", ".off", ".stl", ".serialized")
SCENES = (".gltf", ".glb", ".xml")
SHAPES = ("sphere", "cube", "rectangle", "disk")
_LIGHTS = (".exr", ".hdr", ".png", ".jpg", ".jpeg", ".npz")
_RENDER = materials.fields(nicol.RenderOptions, without=(
    "seed", "aovs", "components", "disabled_optimisations", "fail_if_busy",
    "bake_budget_ms", "time_budget_ms"))  # fmt: skip

FORMATS = {
    "mosaic": ("png", "npy"), "angles": ("png", "npy"), "stokes": ("exr", "npy"), "s0": ("png", "npy", "exr"),
    "dolp": ("npy", "png", "exr"), "aolp": ("npy", "png", "exr"), "depth": ("npy", "exr"), "normals": ("npy", "exr"),
    "normals_camera": ("npy", "exr"), "positions": ("npy", "exr"), "ids": ("npy", "exr"), "alpha": ("npy", "exr"),
}  # fmt: skip
POSES = ("transforms", "llff", "colmap")


def _objects(source, json, key):
    if not isinstance(json, list):
        source.fail(key, f"{json!r}; it must be a list of objects")
    return Row(tuple(_object(source, item, f"{key}[{i}]") for i, item in enumerate(json)))


def _object(source, json, key):
    read = reader.table(_OBJECT, ["mesh"])
    parts = dict(read(source, json, key).parts)
    count = parts.pop("count", Fixed(1))
    return Copies(count, Table(parts))


def _rotation(source, json, key):
    return AnyRotation(key) if json == "any" else reader.number()(source, json, key)


def _environment(source, json, key):
    if isinstance(json, dict) and set(json) == {"sky"}:
        return reader.table({"sky": reader.table(_SKY)})(source, json, key)
    if isinstance(json, (int, float, list)):
        return reader.spectrum(source, json, key)
    return reader.file(*_LIGHTS)(source, json, key)


_SKY = {"azimuth": reader.number(), "elevation": reader.number(0, 90), "radiance": reader.spectrum,
        "turbidity": reader.number(0, 10), "dop_max": reader.number(0, 1), "ground_albedo": reader.number(0, 1)}  # fmt: skip
_SUN = {"azimuth": reader.number(), "elevation": reader.number(-90, 90), "irradiance": reader.spectrum,
        "angular_radius": reader.number(0, 90)}  # fmt: skip
_OBJECT = {
    "mesh": reader.file(*MESHES, *SCENES, names=SHAPES),
    "material": materials.read,
    "size": reader.number(1e-6),
    "position": reader.vector,
    "rotation": _rotation,
    "count": reader.number(0, 1000, whole=True),
}
_LIGHT = {"environment": reader.varied(_environment), "rotation": reader.number(), "scale": reader.number(0),
          "sun": reader.table(_SUN), "per": reader.one_of("scene", "frame")}  # fmt: skip
_LENS = {"type": reader.one_of("opencv", "fisheye", "equirectangular"), "distortion": reader.row(reader.number(), 4, 8)}
_CAMERA = {
    "lens": reader.table(_LENS, ["type"]),
    "fov": reader.number(0.1, 170), "azimuth": reader.number(), "elevation": reader.number(-90, 90),
    "distance": reader.number(1e-3), "baseline": reader.number(1e-9), "roll": reader.number(), "position": reader.vector, "target": reader.vector,
}  # fmt: skip
_EXPOSURE = {"percentile": reader.number(0, 100, ranges=()), "level": reader.number(1e-3)}


def _exposure(source, json, key):
    automatic = isinstance(json, dict) and "percentile" in json
    return (reader.table(_EXPOSURE) if automatic else reader.number(1e-9))(source, json, key)


def _sensor(source, json, key):
    if isinstance(json, dict):
        return Fixed(json)
    return reader.file(".json", ".png")(source, json, key)


def _format(name):
    def read(source, json, key):
        given = json if isinstance(json, dict) else {"format": json}
        half = {"half": reader.flag, "compression": reader.one_of("zip", "none")} if given.get("format") == "exr" else {}
        return reader.table({"format": reader.one_of(*FORMATS[name]), **half}, ["format"])(source, given, key)

    return read


def _poses(source, json, key):
    if not isinstance(json, list):
        source.fail(key, f"{json!r}; it must be a list of {', '.join(POSES)}")
    return reader.row(reader.one_of(*POSES), 1, len(POSES))(source, json, key)


def _write(source, json, key):
    if isinstance(json, list):
        for i, name in enumerate(json):
            reader.one_of(*FORMATS)(source, name, f"{key}[{i}]")
        json = {name: FORMATS[name][0] for name in json}
    formats = {name: _format(name) for name in FORMATS}
    return reader.table({**formats, "poses": _poses})(source, json, key)


_RECIPE = {
    "seed": reader.number(0, 2**64 - 1, whole=True, ranges=()),
    "size": reader.row(reader.number(1, nicol.MAX_SIZE, whole=True, ranges=()), 2, 2),
    "views": reader.number(1, 10**9, whole=True, ranges=()),
    "scene": reader.file(*SCENES),
    "objects": _objects,
    "floor": reader.table({"material": materials.read, "size": reader.number(1e-6)}),
    "light": reader.table(_LIGHT),
    "camera": reader.table(_CAMERA),
    "exposure": _exposure,
    "sensor": _sensor,
    "render": reader.table(_RENDER),
    "write": _write,
}


def _loaded(path):
    """Returns what a file says, YAML by its ending or JSON."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if not path.lower().endswith((".yaml", ".yml")):
        try:
            return json.loads(text)
        except ValueError as error:
            raise RecipeError(f"{path}: not JSON: {error}") from None
    try:
        import yaml
    except ImportError:
        raise RecipeError(f"{path}: YAML needs the Python package PyYAML; install it, or write the recipe as JSON") from None
    try:
        return yaml.safe_load(text)
    except (yaml.YAMLError, ValueError) as error:
        raise RecipeError(f"{path}: not YAML: {error}") from None


class Recipe:
    """Description of a data set by a JSON or YAML file, or by a dictionary of the same form. Paths are relative to the file, or to
    `folder`. Raises RecipeError, and OSError where the file cannot be read."""

    def __init__(self, recipe, folder="."):
        if isinstance(recipe, (str, os.PathLike)):
            name, folder = os.fspath(recipe), os.path.dirname(os.fspath(recipe))
            recipe = _loaded(name)
        else:
            name = "recipe"
        self.json, self.source = recipe, reader.Source(name, folder)
        self.parts = reader.table(_RECIPE)(self.source, recipe, "").parts
        if not ("objects" in self.parts or "scene" in self.parts):
            self.source.fail("", "objects is missing; a recipe has objects, or a scene to start from")
        self.seed, self.views = self._given("seed", 0), self._given("views", 1)
        self.width, self.height = self._given("size", [512, 512])
        self.render, self.write = self._given("render", {}), self._given("write", {})
        self.poses = self.write.pop("poses", [])
        self.light_per_frame = self._given("light", {}).get("per") == "frame" if "light" in recipe else False
        self.lens = self._checked_lens()
        self._check_camera()
        self._check_sweeps()
        for name, value in self.parts["render"].parts.items() if "render" in self.parts else ():
            if not isinstance(value, Fixed):
                self.source.fail(f"render.{name}", "drawn; it must be the same in all frames")

    def _given(self, name, default):
        return self.parts[name].at(Draw(0, "recipe", 0)) if name in self.parts else default

    def _check_camera(self):
        names = self.parts["camera"].parts if "camera" in self.parts else {}
        for name in ("azimuth", "elevation", "distance"):
            if name in names and "position" in names:
                self.source.fail(f"camera.{name}", "position already says where the camera is; give one or the other")
        if "baseline" in names and self.views % 2:
            self.source.fail("camera.baseline", f"a rig of two cameras needs an even number of views, not {self.views}")

    def _checked_lens(self):
        """Returns the lens of all frames, or None; refuses what is not written of pictures through a lens."""
        value = self.parts["camera"].parts.get("lens") if "camera" in self.parts else None
        if value is None:
            return None
        if len(value.trials()) > 1:
            self.source.fail("camera.lens", "drawn; it must be the same in all frames")
        lens = value.at(None)
        for name, how in self.write.items():
            if name in ("s0", "dolp", "aolp") and how["format"] == "png":
                self.source.fail(f"write.{name}", "png is not written of pictures through a lens; choose npy or exr")
        for name in self.poses:
            if name == "llff" or (name == "colmap" and lens["type"] == "equirectangular"):
                self.source.fail("write.poses", f"{name} knows no {lens['type']} lens")
        return lens

    def _check_sweeps(self):
        """Refuses values that follow the views of a scene where they are drawn once for the scene."""
        shared = ["scene", "objects", "floor"] + ([] if self.light_per_frame else ["light"])
        for value in (leaf for name in shared if name in self.parts for leaf in leaves(self.parts[name])):
            if isinstance(value, Path) or (isinstance(value, Range) and value.kind == "sweep"):
                where = "the camera, and light that is drawn per frame, follow the views of a scene"
                self.source.fail(value.key, f"is the same in all views of a scene; {where}")

    def scene_of(self, frame):
        return frame // self.views

    def scene_draw(self, scene):
        """Returns the numbers of what the frames of a scene share."""
        return Draw(self.seed, "scene", scene)

    def frame_draw(self, frame):
        """Returns the numbers of a frame."""
        return Draw(self.seed, "frame", frame, frame % self.views / self.views)

    def camera_draw(self, frame):
        """Returns the numbers of a frame's camera, which a rig of two cameras shares."""
        rig = "camera" in self.parts and "baseline" in self.parts["camera"].parts
        return self.frame_draw(frame - frame % 2 if rig else frame)

    def fingerprint(self):
        """Returns the SHA-256 of what decides the bytes of a frame: the recipe, the files of its folders with their sizes,
        and the library."""
        source = self.source
        files = {key: [[f, os.path.getsize(source.path(f))] for f in found] for key, found in source.files.items()}
        facts = {"recipe": self.json, "files": files, "library": library()}
        return hashlib.sha256(json.dumps(facts, sort_keys=True).encode()).hexdigest()


def library():
    """Returns the library's version and source, as nicol_build_info has them."""
    facts, index = {"version": nicol.version_string()}, 0
    while fact := nicol.build_info(index):
        name, _, value = fact.partition("=")
        if name == "source":
            facts[name] = value
        index += 1
    return facts
