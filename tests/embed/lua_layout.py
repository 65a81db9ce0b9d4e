# SPDX-License-Identifier: MIT
"""LuaJIT sees every size, place and value of nicol.h as the header's reader does.

usage: lua_layout.py LUAJIT, with LUA_PATH, PYTHONPATH and NICOL_H set
"""

import os
import subprocess
import sys

import header


def assertions(model):
    for name, struct in model.structs.items():
        offsets, size, _ = model.layout(name)
        yield f'assert(ffi.sizeof("{name}") == {size}, "{name}")'
        for field, offset in zip(struct.fields, offsets):
            yield f'assert(ffi.offsetof("{name}", "{field.name}") == {offset}, "{name}.{field.name}")'
    for name, value in model.constants.items():
        yield f'assert(nicol.{name.removeprefix("NICOL_")} == {value}, "{name}")'
    for name in model.functions:
        yield f"assert(nicol.C.{name})"


script = 'local ffi, nicol = require("ffi"), require("nicol")\n' + "\n".join(assertions(header.read(os.environ["NICOL_H"])))
sys.exit(subprocess.run([sys.argv[1], "-"], input=script, text=True).returncode)
