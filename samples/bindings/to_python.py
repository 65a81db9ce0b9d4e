# SPDX-License-Identifier: MIT
"""Generator of samples/python/nicol/_abi.py: the C headers for ctypes, with a Python function or method per C function."""

from header import Type
from python_call import CTYPES, Call, hint_of, variable_name
from roles import class_name, owner_of

HEAD = '''# SPDX-License-Identifier: MIT
"""Nicol {version} for Python. Made of the C headers by samples/bindings/generate.py: change those, not this file."""

from __future__ import annotations

import os
from collections.abc import Sequence
from ctypes import POINTER, byref, c_char_p, c_double, c_float, c_int32, c_int64, c_uint32, c_uint64, c_void_p
from typing import TYPE_CHECKING, Any

from ._runtime import (
    Buffer, Callback, Handle, Struct, array, as_is, check, counted, declare, decoded, hold, lend, paired, pointee, text, texts,
)  # fmt: skip

if TYPE_CHECKING:
    from typing_extensions import Self
'''

EXTENDED = ("Camera", "Context", "Framebuffer", "Scene", "Sensor", "render")  # names that the package defines anew
UNSEEN = ("struct_size", "reserved")  # fields that users of Python need not know


def docstring(doc, indent):
    if not doc:
        return ""
    doc = doc.replace("\\", "\\\\").replace('"', "'") if '"""' in doc or doc.endswith('"') else doc
    return f'{indent}"""' + doc.replace("\n", "\n" + indent).replace(f"\n{indent}\n", "\n\n") + '"""\n'


class Python:
    def __init__(self, header):
        self.header = header

    def ctype(self, type_, argument=True):
        """Returns the ctypes spelling of a parameter or, if `argument` is false, of a field."""
        header, base = self.header, type_.base
        if base == "char" and type_.pointers:
            return "c_char_p" if type_.pointers == 1 else "POINTER(c_char_p)"
        if base == "void":
            return "c_void_p" if type_.pointers else "None"
        if base in header.handles:
            name = class_name(base) if argument else "c_void_p"
        elif base in header.callbacks:
            name = class_name(base) + ".type"
        elif base in header.structs:
            name = class_name(base)
        else:
            name = CTYPES[header.scalar(Type(base))]
        if argument and type_.count:
            return f"POINTER({name})"  # C passes arrays as pointers
        name = f"POINTER({name})" if type_.pointers else name
        return f"{name} * {type_.count}" if type_.count else name

    # ---- types

    def callback(self, function):
        parameters = []
        for parameter in function.parameters:
            type_ = parameter.type
            if type_.base == "void" and not type_.const:  # void* user
                parameters.append("(c_void_p, None)")
            elif type_.base == "void" or type_.base in self.header.structs:  # an address
                parameters.append("(c_void_p, as_is)")
            elif type_.count:
                parameters.append(f"(POINTER({CTYPES[type_.base]} * {type_.count}), pointee)")
            elif type_.pointers:
                parameters.append("(c_char_p, decoded)")
            else:
                parameters.append(f"({self.ctype(type_)}, as_is)")
        result = self.ctype(function.result)
        return f"{class_name(function.name)} = Callback({', '.join([result, *parameters])})\n"

    def struct(self, struct):
        text = f"\n\nclass {class_name(struct.name)}(Struct):\n" + docstring(self.struct_doc(struct), "    ")
        callbacks = [f'"{f.name}": {class_name(f.type.base)}' for f in struct.fields if f.type.base in self.header.callbacks]
        if callbacks:
            text += "    _callbacks_ = {" + ", ".join(callbacks) + "}\n"
        read_only = [f'"{f.name}"' for f in struct.fields if f.type.base == "void" and f.type.const]
        if read_only:
            text += "    _read_only_ = {" + ", ".join(read_only) + "}\n"
        text += "    _fields_ = [\n"
        for field in struct.fields:
            text += f'        ("{field.name}", {self.ctype(field.type, argument=False)}),\n'
        text += "    ]\n"
        for field in struct.fields:
            if field.name not in UNSEEN:
                text += f"    {field.name}: {hint_of(self.header, field.type)}\n"
        return text

    @staticmethod
    def struct_doc(struct):
        """Returns the comment of a struct, and those of its fields by their names."""
        fields = [f"{f.name}: " + f.doc.replace("\n", "\n    ") for f in struct.fields if f.doc and f.name not in UNSEEN]
        return "\n\n".join(part for part in (struct.doc, "\n".join(["Fields:", *fields]) if fields else "") if part)

    # ---- functions

    def owner(self, function):
        """Returns the class that a function is a method of, or None, and the name in Python."""
        return owner_of(function, [*self.header.handles, *self.header.structs])

    def function(self, function):
        """Returns the text of a function or method, and the class that it belongs to or None."""
        owner, name = self.owner(function)
        if name in ("retain", "release", "init"):
            return "", owner
        call = Call(self.header, function, owner)
        indent = "    " if owner else ""
        text = "\n" if owner else "\n\n"
        if owner and not call.method:
            text += f"{indent}@classmethod\n"
        text += f"{indent}def {variable_name(name)}({', '.join(call.takes)}) -> {call.returns()}:\n" + docstring(function.doc, indent + "    ")
        return text + "".join(f"{indent}    {line}\n" for line in call.lines()), owner

    def declaration(self, function):
        owner, name = self.owner(function)
        if name == "retain":
            return ""
        if name == "release":
            return f'{class_name(owner)}._release = declare("{function.name}", c_int32, c_void_p)\n'
        if name == "init":
            owner = class_name(owner)
            return f'{owner}._init = declare("{function.name}", c_int32, POINTER({owner}), c_uint32)\n'
        types = [self.ctype(function.result), *[self.ctype(p.type) for p in function.parameters]]
        return f'_{function.name.removeprefix("nicol_")} = declare("{function.name}", {", ".join(types)})\n'

    def generate(self):
        header = self.header
        version = ".".join(str(header.constants[f"NICOL_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH"))
        members, names = {None: ""}, []
        for function in header.functions.values():
            text, owner = self.function(function)
            members[owner] = members.get(owner, "") + text
            names += [] if owner else [function.name.removeprefix("nicol_")]
        parts = [HEAD.format(version=version), "\n"]
        for name, value in header.constants.items():
            names.append(name.removeprefix("NICOL_"))
            parts.append(f"{names[-1]} = {value}\n")
        parts.append("\n")
        parts += [self.callback(function) for function in header.callbacks.values()]
        for name in header.order:
            if name in header.structs:
                parts.append(self.struct(header.structs[name]) + members.get(name, ""))
        for name, doc in header.handles.items():
            parts.append(f"\n\nclass {class_name(name)}(Handle):\n" + docstring(doc, "    ") + members[name])
        names += [class_name(name) for name in [*header.structs, *header.handles]]
        parts.append(members[None])
        parts.append("\n\n")
        parts += [self.declaration(function) for function in header.functions.values()]
        listed = "".join(f'    "{name}",\n' for name in sorted(set(names) - set(EXTENDED)))
        parts.append(f"\n__all__ = [\n{listed}]\n")
        return "".join(parts)


def generate(header):
    return Python(header).generate()
