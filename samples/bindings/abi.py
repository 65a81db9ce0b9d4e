#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the binary interface that the C headers define, or checks that it is compatible with an older one.

usage: abi.py              prints the interface; capi/nicol.abi holds that of the last release
       abi.py BASELINE     ends with 1, and says why, if programs built against the baseline would break
"""

import os
import re
import sys
from dataclasses import replace

import reader

FOLDER = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# Constants that state a number or a set; growth of these is compatible.
GROWING = re.compile(r"NICOL_VERSION.*|NICOL_\w+_ALL")


def signature(function):
    return f"{function.result.c('').rstrip()} ({', '.join(p.type.c('').rstrip() for p in function.parameters)})"


def interface(model):
    """Yields lines `kind name value`, by name; fields are `field struct.name offset size type`."""
    for name, value in model.constants.items():
        yield f"constant {name} {value}"
    for name, scalar in model.aliases.items():
        yield f"alias {name} {scalar}"
    for name in model.handles:
        yield f"handle {name} pointer"
    for name, callback in model.callbacks.items():
        yield f"callback {name} {signature(callback)}"
    for name, struct in model.structs.items():
        offsets, size, _ = model.layout(name)
        yield f"struct {name} {size}"
        for field, offset in zip(struct.fields, offsets):
            type_ = replace(field.type, base=model.aliases.get(field.type.base, field.type.base))
            yield f"field {name}.{field.name} {offset} {model.size(type_)[0]} {type_.c('').rstrip()}"
    for name, function in model.functions.items():
        yield f"function {name} {signature(function)}"


def parse(lines):
    """Returns {(kind, name): value}."""
    found = {}
    for line in lines:
        kind, name, value = line.strip().split(" ", 2)
        found[kind, name] = value
    return found


def embedded(interface_):
    """Returns structs that are part of others, whose size must stay."""
    return {value.split(" ")[2].split("[")[0] for (kind, _), value in interface_.items() if kind == "field"}


def breaks(old, new):
    """Yields the changes that would break programs built against the old interface."""
    places = {}
    for (kind, name), value in new.items():
        if kind == "field":
            struct, offset = name.split(".")[0], value.split(" ")[0]
            places[struct, offset] = (name, value)
    sizes = {name: int(value) for (kind, name), value in old.items() if kind == "struct"}
    for (kind, name), value in old.items():
        now = new.get((kind, name))
        if kind == "struct":
            if now is None:
                yield f"{name} is gone"
            elif int(now) < int(value):
                yield f"{name} has shrunk from {value} to {now} bytes"
            elif now != value and (name in embedded(old) or ("field", f"{name}.struct_size") not in old):
                yield f"{name} has grown from {value} to {now} bytes, and its callers do not say its size"
        elif kind == "field":
            struct, field = name.split(".")
            was_reserved = field.startswith("reserved")
            there, same = places.get((struct, value.split(" ")[0]), (None, None))
            if there is None or same != value or (there != name and not was_reserved):
                yield f"{name} was at {value.replace(' ', ', of size ', 1).replace(' ', ', ', 3)}; there is now {there or 'nothing'}"
        elif now != value and not (kind == "constant" and now is not None and GROWING.fullmatch(name)):
            yield f"{name} was {value} and is {now or 'gone'}"
    for (kind, name), value in new.items():
        if kind == "field" and (kind, name) not in old:
            struct = name.split(".")[0]
            offset = int(value.split(" ")[0])
            taken = [v for (k, n), v in old.items() if k == "field" and n.startswith(struct + ".")]
            over_reserved = any(int(v.split(" ")[0]) == offset for v in taken)
            if struct in sizes and offset < sizes[struct] and not over_reserved:
                yield f"{name} lies in what was padding of {struct}: older callers leave it unset"


def main():
    now = list(interface(reader.read(os.path.join(FOLDER, "include"))))
    if len(sys.argv) == 1:
        print("\n".join(now))
        return
    with open(sys.argv[1], encoding="utf-8") as file:
        broken = list(breaks(parse(file), parse(now)))
    if broken:
        sys.exit("\n".join(broken))


if __name__ == "__main__":
    main()
