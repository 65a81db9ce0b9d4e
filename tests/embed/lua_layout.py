# SPDX-License-Identifier: MIT
"""LuaJIT sees every size, place and value of nicol.h as the header's reader does, and takes the header itself once it is
preprocessed.

usage: lua_layout.py LUAJIT C_COMPILER, with LUA_PATH, PYTHONPATH and NICOL_H set
"""

import os
import subprocess
import sys
import tempfile

import reader


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


def preprocessed(compiler, path):
    """The header alone: LuaJIT knows what <stdint.h> declares."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "stdint.h"), "w"):
            pass
        command = [compiler, "-E", "-P", "-I", folder, path]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def main():
    luajit, compiler = sys.argv[1:]
    path = os.environ["NICOL_H"]
    checks = list(assertions(reader.read(path)))
    module = 'local ffi, nicol = require("ffi"), require("nicol")\n' + "\n".join(checks)
    sizes = "\n".join(check for check in checks if "ffi." in check)
    plain = f'local ffi = require("ffi")\nffi.cdef[[\n{preprocessed(compiler, path)}\n]]\n' + sizes
    for script in [module, plain]:
        subprocess.run([luajit, "-"], input=script, text=True, check=True)


if __name__ == "__main__":
    main()
