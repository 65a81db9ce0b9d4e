# SPDX-License-Identifier: MIT
"""Generator of samples/lua/nicol_ffi.lua: the C headers for LuaJIT's ffi, its constants, and which functions make
objects."""

HEAD = """-- SPDX-License-Identifier: MIT
-- Nicol {version} for LuaJIT. Made of the C headers by samples/bindings/generate.py: change those, not this file.
local ffi = require("ffi")

ffi.cdef[[
"""


def parameters(function):
    return ", ".join(p.type.c(p.name) for p in function.parameters) or "void"


def declarations(header):
    for name in header.order:
        if name in header.aliases:
            yield f"typedef {header.aliases[name]} {name};"
        elif name in header.handles:
            yield f"typedef struct {name}_impl* {name};"
        elif name in header.callbacks:
            callback = header.callbacks[name]
            yield f"typedef {callback.result.c('').rstrip()} (*{name})({parameters(callback)});"
        else:
            fields = "".join(f"    {field.type.c(field.name)};\n" for field in header.structs[name].fields)
            yield f"typedef struct {name} {{\n{fields}}} {name};"
    for function in header.functions.values():
        yield f"{function.result.c('').rstrip()} {function.name}({parameters(function)});"


def literal(value):
    """Returns Lua text of a value. Integers beyond the precision of doubles become 64-bit ones."""
    return f"{value}ULL" if isinstance(value, int) and value >= 2**53 else str(value)


def generate(header):
    version = ".".join(str(header.constants[f"NICOL_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH"))
    text = HEAD.format(version=version) + "\n".join(declarations(header)) + "\n]]\n\nreturn {\n"
    text += "    constants = {\n"
    for name, value in header.constants.items():
        text += f"        {name.removeprefix('NICOL_')} = {literal(value)},\n"
    text += "    },\n    -- Functions that answer with a result code, and the handle that comes back through the last pointer.\n"
    text += "    results = {\n"
    for function in header.functions.values():
        if function.result.base == "nicol_result" and not function.name.endswith(("_retain", "_release", "_init")):
            last = function.parameters[-1].type
            made = f'"{last.base}"' if last.pointers and last.base in header.handles else "true"
            text += f"        {function.name.removeprefix('nicol_')} = {made},\n"
    text += "    },\n    -- Descriptors: nicol_<name> with its nicol_<name>_init.\n    structs = {\n"
    for struct in header.structs.values():
        text += f"        {struct.name.removeprefix('nicol_')} = true,\n"
    return text + "    },\n}\n"
