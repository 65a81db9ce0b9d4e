# SPDX-License-Identifier: MIT
"""Materials of a recipe: the descriptors of nicol.h, field by field."""

import ctypes
import math

import nicol

from .._runtime import words
from . import reader
from .values import RecipeError

_IMAGES = (".png", ".jpg", ".jpeg", ".exr", ".hdr", ".bmp", ".tga")
_DESCRIBED = {"pplastic": nicol.Pplastic, "plastic": nicol.Plastic, "principled": nicol.Principled,
              "conductor": nicol.Conductor, "dielectric": nicol.Dielectric}  # fmt: skip
_LOADED = {"measured": (nicol.Measured, ".pbsdf"), "psh": (nicol.PshMatrix, ".npz")}


def fields(struct, without=()):
    """Returns the readers of a descriptor's fields that hold numbers, names, spectra or textures."""
    readers = {}
    for name, type_ in struct._types_.items():
        if name in ("struct_size", "reserved", *without):
            continue
        if name.endswith("_texture"):
            readers[name] = reader.file(*_IMAGES)
        elif type_ is nicol.Spectrum:
            readers[name] = reader.spectrum
        elif type_ is ctypes.c_char_p:
            readers[name] = reader.text
        elif type_ in (ctypes.c_float, ctypes.c_double):
            readers[name] = reader.number()
        elif type_ in (ctypes.c_uint32, ctypes.c_int32, ctypes.c_uint64):
            names = sorted(words(name))
            readers[name] = reader.one_of(*names) if names else reader.number(-1, whole=True)
    return readers


def _material(source, json, key):
    if not isinstance(json, dict) or "type" not in json:
        source.fail(key, f"type is missing; it must be one of {', '.join(sorted(_READERS))}")
    if not isinstance(json["type"], str) or json["type"] not in _READERS:
        source.fail(f"{key}.type", f"{json['type']!r}; it must be one of {', '.join(sorted(_READERS))}")
    readers, required = _READERS[json["type"]]
    return reader.table({"type": reader.text, "twosided": reader.flag, **readers}, required)(source, json, key)


_READERS = {name: (fields(struct), ()) for name, struct in _DESCRIBED.items()}
_READERS |= {name: ({"path": reader.file(s), **fields(struct)}, ("path",)) for name, (struct, s) in _LOADED.items()}
_READERS["diffuse"] = ({"reflectance": reader.spectrum, "reflectance_texture": reader.file(*_IMAGES)}, ())

read = reader.varied(_material)


def _is_color(name):
    return "reflectance" in name or "color" in name


def create(context, source, drawn):
    """Creates the material of drawn values."""
    values = dict(drawn)
    kind, twosided = values.pop("type"), values.pop("twosided", False)
    textures = {
        name: nicol.Texture.load(context, source.path(values.pop(name)), nicol.TextureOptions(raw=int(not _is_color(name))))
        for name in list(values)
        if name.endswith("_texture")
    }
    if kind == "diffuse":
        texture = textures.get("reflectance_texture")
        made = nicol.Material.create_diffuse(context, values.get("reflectance", 1 if texture else 0.5))
        made = nicol.Material.create_scaled(context, made, texture) if texture else made
    elif kind in _LOADED:
        path = values.pop("path")
        load = getattr(nicol.Material, f"load_{kind}")
        made = load(context, source.path(path), _LOADED[kind][0](**values))
    else:
        create_kind = getattr(nicol.Material, f"create_{kind}")
        made = create_kind(context, _DESCRIBED[kind](**values, **textures))
    return nicol.Material.create_twosided(context, made) if twosided else made


def check(context, source, key, value):
    """Creates the material of each trial, and fails with the library's message where one is out of range."""
    for drawn in value.trials():
        if any(name.endswith("_texture") or name == "path" for name in drawn):
            drawn = {name: v for name, v in drawn.items() if not name.endswith("_texture")}
        if "path" in drawn:
            continue
        try:
            create(context, source, drawn)
        except nicol.Error as error:
            raise RecipeError(f"{source.name}: {key}: {error}") from None


def turn(degrees):
    """Returns the matrix of a rotation about y (4 x 4, row-major), which takes +x towards -z."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1]
