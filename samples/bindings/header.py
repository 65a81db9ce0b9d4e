# SPDX-License-Identifier: MIT
"""Model of the C headers: constants, types with their layout, and functions."""

from dataclasses import dataclass, field

SCALARS = {"char": 1, "int32_t": 4, "uint32_t": 4, "float": 4, "int64_t": 8, "uint64_t": 8, "double": 8}
POINTER_SIZE = 8

class HeaderError(Exception):
    pass


@dataclass
class Type:
    base: str  # a scalar, void, or the name of a handle, alias, struct or callback
    pointers: int = 0
    const: bool = False  # constness of the first pointer's target
    count: int = 0  # size of a fixed array; 0: none

    def c(self, name):
        text = ("const " if self.const else "") + self.base + ("* const" * (self.pointers - 1)) + "*" * (self.pointers > 0)
        return f"{text} {name}".rstrip() + (f"[{self.count}]" if self.count else "")


@dataclass
class Variable:
    name: str
    type: Type
    doc: str = ""


@dataclass
class Function:
    name: str
    result: Type
    parameters: list
    doc: str = ""


@dataclass
class Struct:
    name: str
    fields: list
    doc: str = ""


@dataclass
class Header:
    constants: dict = field(default_factory=dict)  # name: value
    aliases: dict = field(default_factory=dict)  # name: scalar
    handles: dict = field(default_factory=dict)  # name: doc
    callbacks: dict = field(default_factory=dict)  # name: Function
    structs: dict = field(default_factory=dict)  # name: Struct
    functions: dict = field(default_factory=dict)  # name: Function
    order: list = field(default_factory=list)  # names of all types in order of declaration

    def scalar(self, type_):
        """Returns the scalar behind a type that is not a pointer, or None."""
        base = self.aliases.get(type_.base, type_.base)
        return base if type_.pointers == 0 and base in SCALARS else None

    def size(self, type_):
        """Returns (size, alignment) on every 64-bit system."""
        one = type_.base
        if type_.pointers or one in self.handles or one in self.callbacks:
            size = alignment = POINTER_SIZE
        elif one in self.structs:
            _, size, alignment = self.layout(one)
        else:
            size = alignment = SCALARS[self.scalar(Type(one))]
        return size * max(type_.count, 1), alignment

    def layout(self, name):
        """Returns (offsets of the fields, size, alignment) of a struct."""
        offsets, at, widest = [], 0, 1
        for variable in self.structs[name].fields:
            size, alignment = self.size(variable.type)
            at = -(-at // alignment) * alignment
            offsets.append(at)
            at, widest = at + size, max(widest, alignment)
        return offsets, -(-at // widest) * widest, widest
