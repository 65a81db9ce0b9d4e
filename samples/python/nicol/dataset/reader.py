# SPDX-License-Identifier: MIT
"""Readers of a recipe's JSON: each takes (source, json, key) and returns a value, or raises RecipeError that names the key.

Any reader of varied() also takes {"choice": [...]}; numbers take {"uniform": [low, high]} and the other kinds of Range."""

import difflib
import math
import os

from .values import Choice, Fixed, Path, Range, RecipeError, Row, Table

RANGES = ("uniform", "log_uniform", "uniform_sine", "integer", "sweep")


class Source:
    """The file that a recipe came from: its name in messages, and the folder that its paths are relative to. files collects
    the paths that folders were found to hold."""

    def __init__(self, name, folder):
        self.name, self.folder, self.files = name, folder, {}

    def fail(self, key, text):
        raise RecipeError(f"{self.name}: {key}: {text}" if key else f"{self.name}: {text}")

    def path(self, path):
        return os.path.join(self.folder, path)


def _shown(json):
    text = repr(json)
    return text if len(text) < 60 else text[:57] + "..."


def _is_number(json):
    return isinstance(json, (int, float)) and not isinstance(json, bool) and math.isfinite(json)


def join(key, name):
    return f"{key}.{name}" if key else name


def varied(leaf):
    """Returns the reader of what `leaf` reads, or of a choice."""

    def read(source, json, key):
        if not (isinstance(json, dict) and set(json) == {"choice"}):
            return leaf(source, json, key)
        options = json["choice"]
        if not isinstance(options, list) or not options:
            source.fail(join(key, "choice"), f"{_shown(options)}; it must be a list of one value or more")
        return Choice(key, tuple(read(source, option, f"{key}.choice[{i}]") for i, option in enumerate(options)))

    return read


def number(low=-math.inf, high=math.inf, whole=False, ranges=RANGES):
    """Returns the reader of numbers from low to high."""
    kind = "whole number" if whole else "number"
    if low == -math.inf and high == math.inf:
        limits = f"a {kind}"
    elif high == math.inf:
        limits = f"a {kind} of at least {low:g}"
    else:
        limits = f"a {kind} from {low:.10g} to {high:.10g}"

    def fits(json):
        return _is_number(json) and low <= json <= high and not (whole and json != int(json))

    def read(source, json, key):
        if isinstance(json, dict) and len(json) == 1 and next(iter(json)) in ranges:
            kind, ends = next(iter(json.items()))
            if not isinstance(ends, list) or len(ends) != 2 or not all(map(fits, ends)):
                source.fail(f"{key}.{kind}", f"{_shown(ends)}; it must be two ends, each {limits}")
            if ends[0] > ends[1] and kind != "sweep":
                source.fail(f"{key}.{kind}", f"{_shown(ends)}; the first end must not be above the second")
            if kind == "log_uniform" and ends[0] <= 0:
                source.fail(f"{key}.{kind}", f"{_shown(ends)}; both ends must be above 0")
            if kind == "uniform_sine" and not -90 <= ends[0] <= ends[1] <= 90:
                source.fail(f"{key}.{kind}", f"{_shown(ends)}; both ends must be degrees from -90 to 90")
            if (kind == "integer" or whole) and any(end != int(end) for end in ends):
                source.fail(f"{key}.{kind}", f"{_shown(ends)}; both ends must be whole numbers")
            if kind == "integer":
                ends = [int(end) for end in ends]
            return Range(key, kind, *ends)
        if not fits(json):
            more = f", or an object of one of {', '.join(ranges)} and choice" if ranges else ""
            source.fail(key, f"{_shown(json)}; it must be {limits}{more}")
        return Fixed(json)

    return varied(read) if ranges else read


def row(part, least, most):
    """Returns the reader of a list of values."""

    def read(source, json, key):
        if not isinstance(json, list) or not least <= len(json) <= most:
            count = str(least) if least == most else f"{least} to {most}"
            source.fail(key, f"{_shown(json)}; it must be a list of {count}")
        return Row(tuple(part(source, item, f"{key}[{i}]") for i, item in enumerate(json)))

    return read


def _vector(source, json, key):
    if not (isinstance(json, dict) and set(json) == {"path"}):
        return row(number(), 3, 3)(source, json, key)
    points = json["path"]
    if not isinstance(points, list) or len(points) < 2:
        source.fail(join(key, "path"), f"{_shown(points)}; it must be a list of two points or more")
    plain = row(number(ranges=()), 3, 3)
    return Path(key, tuple(tuple(plain(source, p, f"{key}.path[{i}]").at(None)) for i, p in enumerate(points)))


vector = varied(_vector)


def _spectrum(source, json, key):
    return row(number(), 1, 16)(source, json, key) if isinstance(json, list) else number()(source, json, key)


spectrum = varied(_spectrum)


def one_of(*names):
    """Returns the reader of one of these names."""

    def read(source, json, key):
        if json not in names:
            source.fail(key, f"{_shown(json)}; it must be one of {', '.join(names)}")
        return Fixed(json)

    return varied(read)


def _text(source, json, key):
    if not isinstance(json, str):
        source.fail(key, f"{_shown(json)}; it must be a text")
    return Fixed(json)


text = varied(_text)


def flag(source, json, key):
    if not isinstance(json, bool):
        source.fail(key, f"{_shown(json)}; it must be true or false")
    return Fixed(json)


def file(*suffixes, names=()):
    """Returns the reader of a file, or of {"folder": PATH}: one of the files below it that end in these suffixes. Values are
    paths relative to the recipe, or one of `names`, which are no files."""

    def read(source, json, key):
        if isinstance(json, dict) and set(json) == {"folder"}:
            folder = _text(source, json["folder"], join(key, "folder")).value
            if not os.path.isdir(source.path(folder)):
                source.fail(join(key, "folder"), f"{source.path(folder)} is no folder")
            found = sorted(
                os.path.join(os.path.relpath(place, source.path("") or "."), name)
                for place, _, files in os.walk(source.path(folder))
                for name in files
                if name.lower().endswith(suffixes)
            )
            if not found:
                source.fail(join(key, "folder"), f"{source.path(folder)} holds no file of {' '.join(suffixes)}")
            source.files[key] = found
            return Choice(key, tuple(map(Fixed, found)))
        if isinstance(json, str) and json in names:
            return Fixed(json)
        known = f"a file of {' '.join(suffixes)}" + (f", or one of {', '.join(names)}" if names else "")
        if not isinstance(json, str) or not json.lower().endswith(suffixes):
            source.fail(key, f"{_shown(json)}; it must be {known}, or an object of folder or choice")
        if not os.path.isfile(source.path(json)):
            source.fail(key, f"{source.path(json)} does not exist")
        return Fixed(json)

    return varied(read)


def table(readers, required=()):
    """Returns the reader of an object with these keys."""

    def read(source, json, key):
        if not isinstance(json, dict):
            source.fail(key, f"{_shown(json)}; it must be an object")
        for name in json:
            if name not in readers:
                near = difflib.get_close_matches(name, readers, 1)
                hint = f"did you mean {near[0]}?" if near else f"known are {', '.join(sorted(readers))}"
                source.fail(join(key, name), f"unknown key; {hint}")
        for name in required:
            if name not in json:
                source.fail(key, f"{name} is missing")
        return Table({name: readers[name](source, value, join(key, name)) for name, value in json.items()})

    return read
