# SPDX-License-Identifier: MIT
"""Values of a recipe that are fixed, or drawn for each scene or frame."""

import hashlib
import math
from dataclasses import dataclass


class RecipeError(ValueError):
    """A fault of a recipe; the text is one line that names the file and the key, and says what would be right."""


class Draw:
    """Random numbers of one scene or frame. A number depends on the seed, the kind ("scene" or "frame"), the index and the
    key of the recipe that it is for, so that frames may be rendered in any order and a new key changes no other value.
    progress runs from 0 to 1 over the views of a scene, without reaching 1."""

    def __init__(self, seed, kind, index, progress=0.0):
        self.stem, self.progress = f"{seed}/{kind}/{index}/", progress

    def uniform(self, key):
        """Returns a number in [0, 1): a multiple of 2^-53."""
        return (self.bits(key) >> 11) * 2.0**-53

    def bits(self, key):
        """Returns a whole number of 64 bits."""
        return int.from_bytes(hashlib.sha256((self.stem + key).encode()).digest()[:8], "big")


@dataclass(frozen=True)
class Fixed:
    value: object

    def at(self, draw):
        return self.value

    def trials(self):
        """Returns values that together show every option, and both ends of every range."""
        return [self.value]


@dataclass(frozen=True)
class Range:
    """A number between low and high. kind: uniform; log_uniform, whose logarithm is uniform; uniform_sine, an angle in
    degrees whose sine is uniform, as the elevation of points that are even on a sphere; integer, whole numbers with both
    ends; sweep, evenly over the views of a scene."""

    key: str
    kind: str
    low: float
    high: float

    def at(self, draw):
        if self.kind == "sweep":
            return self.low + (self.high - self.low) * draw.progress
        u = draw.uniform(self.key)
        if self.kind == "integer":
            return self.low + int(u * (self.high - self.low + 1))
        if self.kind == "log_uniform":
            return min(self.high, math.exp(math.log(self.low) + (math.log(self.high) - math.log(self.low)) * u))
        if self.kind == "uniform_sine":
            low, high = (math.sin(math.radians(end)) for end in (self.low, self.high))
            return math.degrees(math.asin(low + (high - low) * u))
        return self.low + (self.high - self.low) * u

    def trials(self):
        return [self.low, self.high]


@dataclass(frozen=True)
class Choice:
    """One of several values, all with the same probability."""

    key: str
    options: tuple

    def at(self, draw):
        return self.options[int(draw.uniform(self.key) * len(self.options))].at(draw)

    def trials(self):
        return [value for option in self.options for value in option.trials()]


@dataclass(frozen=True)
class Row:
    """A list of values."""

    parts: tuple

    def at(self, draw):
        return [part.at(draw) for part in self.parts]

    def trials(self):
        trials = [part.trials() for part in self.parts]
        return [[t[i % len(t)] for t in trials] for i in range(max(map(len, trials), default=0))]


@dataclass(frozen=True)
class Table:
    """Values by name."""

    parts: dict

    def at(self, draw):
        return {name: part.at(draw) for name, part in self.parts.items()}

    def trials(self):
        return [dict(zip(self.parts, values)) for values in Row(tuple(self.parts.values())).trials()]


@dataclass(frozen=True)
class Path:
    """A point on a line through points (lists of numbers), evenly over the views of a scene."""

    key: str
    points: tuple

    def at(self, draw):
        place = draw.progress * (len(self.points) - 1)
        first = min(int(place), len(self.points) - 2)
        t = place - first
        return [a + (b - a) * t for a, b in zip(self.points[first], self.points[first + 1])]

    def trials(self):
        return [list(point) for point in self.points]


@dataclass(frozen=True)
class AnyRotation:
    """A rotation, all with the same probability: the rows of its matrix (Shoemake 1992)."""

    key: str

    def at(self, draw):
        u, v, w = (draw.uniform(f"{self.key}/{axis}") for axis in "uvw")
        a, b = math.sqrt(1 - u), math.sqrt(u)
        x, y = a * math.sin(2 * math.pi * v), a * math.cos(2 * math.pi * v)
        z, r = b * math.sin(2 * math.pi * w), b * math.cos(2 * math.pi * w)
        return [
            [1 - 2 * (y * y + z * z), 2 * (x * y - r * z), 2 * (x * z + r * y)],
            [2 * (x * y + r * z), 1 - 2 * (x * x + z * z), 2 * (y * z - r * x)],
            [2 * (x * z - r * y), 2 * (y * z + r * x), 1 - 2 * (x * x + y * y)],
        ]

    def trials(self):
        return [0]


@dataclass(frozen=True)
class Copies:
    """A list of draws of one table: `count` of them, each with numbers of its own."""

    count: object
    table: object

    def at(self, draw):
        return [self.table.at(_Numbered(draw, i)) for i in range(self.count.at(draw))]

    def trials(self):
        return [[table] for table in self.table.trials()]


def leaves(value):
    """Yields the values of which a value is made."""
    if isinstance(value, Choice):
        parts = value.options
    elif isinstance(value, Row):
        parts = value.parts
    elif isinstance(value, Table):
        parts = value.parts.values()
    elif isinstance(value, Copies):
        parts = value.count, value.table
    else:
        yield value
        return
    for part in parts:
        yield from leaves(part)


class _Numbered:
    """The numbers of one of several copies."""

    def __init__(self, draw, index):
        self.draw, self.index, self.progress = draw, index, draw.progress

    def uniform(self, key):
        return self.draw.uniform(f"{key}#{self.index}")
