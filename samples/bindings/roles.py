# SPDX-License-Identifier: MIT
"""Roles of a function's parameters, and the class that it belongs to, derived from names and types."""


def class_name(name):
    return "".join(part.capitalize() for part in name.removeprefix("nicol_").split("_"))


def owner_of(function, types):
    """Returns the longest name of a type that begins the function's name, or None, and the rest of the function's name."""
    owner = max((name for name in types if function.name.startswith(name + "_")), key=len, default=None)
    return owner, function.name.removeprefix(f"{owner or 'nicol'}_")


def roles_of(header, function):
    """Returns (parameter, role, partners) for each parameter; partners are the later parameters that state its length."""
    parameters, roles, at = function.parameters, [], 0
    while at < len(parameters):
        parameter, type_ = parameters[at], parameters[at].type
        rest = parameters[at + 1 :]
        names = [p.name for p in rest]
        if type_.base == "void" and type_.pointers:
            role, partners = "user", 0
        elif type_.pointers == 2:
            role, partners = "texts", 1
        elif type_.base == "char" and type_.pointers:
            role, partners = "text", 0
        elif names[:2] == ["row_stride", "byte_size"]:
            role, partners = "rows", 2
        elif type_.pointers and names and (names[0] == "count" or names[0].endswith("_count")):
            role, partners = "buffer", 1
        elif type_.pointers and type_.const and rest and not rest[0].type.pointers and rest[0].type.base == type_.base:
            role, partners = "buffer", 1  # textures of a number of channels
        elif type_.pointers and names[1:2] == ["count"] and rest[0].type == type_:
            role, partners = "buffers", 2
        elif type_.pointers and names[1:2] == ["count"] and type_.base in header.structs and rest[0].type.base in header.handles:
            role, partners = "paired", 2
        elif type_.pointers and type_.base in header.structs:
            role, partners = ("struct" if type_.const or at == 0 else "result"), 0
        elif type_.pointers:
            role, partners = "result", 0
        elif type_.count:
            role, partners = ("array" if type_.const else "filled"), 0
        elif type_.base in header.callbacks:
            role, partners = "callback", 0
        else:
            role, partners = "value", 0
        roles.append((parameter, role, rest[:partners]))
        at += 1 + partners
    return roles


def last_input(roles):
    inputs = [parameter for parameter, role, _ in roles if role not in ("result", "filled", "user")]
    return inputs[-1] if inputs else None
