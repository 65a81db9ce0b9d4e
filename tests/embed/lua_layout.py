# SPDX-License-Identifier: MIT
"""LuaJIT finds every size, place and value of the C headers where their reader does, and takes the headers themselves
once they are preprocessed.

usage: lua_layout.py LUAJIT C_COMPILER, with LUA_PATH, PYTHONPATH and NICOL_INCLUDE set
"""

import os
import subprocess
import sys
import tempfile

import reader
import to_lua


def assertions(model):
    for name, struct in model.structs.items():
        offsets, size, _ = model.layout(name)
        yield f'assert(ffi.sizeof("{name}") == {size}, "{name}")'
        for field, offset in zip(struct.fields, offsets):
            yield f'assert(ffi.offsetof("{name}", "{field.name}") == {offset}, "{name}.{field.name}")'
    for name, value in model.constants.items():
        yield f'assert(nicol.{name.removeprefix("NICOL_")} == {to_lua.literal(value)}, "{name}")'
    for name in model.functions:
        yield f"assert(nicol.C.{name})"


def preprocessed(compiler, include):
    """Returns the preprocessed headers with an empty <stdint.h>, because LuaJIT declares its types itself."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "stdint.h"), "w"):
            pass
        command = [compiler, "-E", "-P", "-x", "c", "-I", folder, "-I", include, "-"]
        source = "".join(f'#include "{name}"\n' for name in reader.HEADERS)
        return subprocess.run(command, input=source, check=True, capture_output=True, text=True).stdout


def main():
    luajit, compiler = sys.argv[1:]
    include = os.environ["NICOL_INCLUDE"]
    checks = list(assertions(reader.read(include)))
    module = 'local ffi, nicol = require("ffi"), require("nicol")\n' + "\n".join(checks)
    sizes = "\n".join(check for check in checks if "ffi." in check)
    plain = f'local ffi = require("ffi")\nffi.cdef[[\n{preprocessed(compiler, include)}\n]]\n' + sizes
    for script in [module, plain]:
        subprocess.run([luajit, "-"], input=script, text=True, check=True)


if __name__ == "__main__":
    main()
