# SPDX-License-Identifier: MIT
"""The bindings are what the C headers make them, and a C compiler reads the headers as they do.

usage: layout_test.py BINDINGS_FOLDER INCLUDE_FOLDER C_COMPILER
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest

BINDINGS, INCLUDE = (os.path.abspath(sys.argv.pop(1)) for _ in range(2))
COMPILER = sys.argv.pop(1)
sys.path.insert(0, BINDINGS)
sys.dont_write_bytecode = True

import reader  # noqa: E402
from header import HeaderError  # noqa: E402

MODEL = reader.read(INCLUDE)


def parse(text):
    return reader.Parser(text).header


class LayoutTest(unittest.TestCase):
    def test_bindings_are_up_to_date(self):
        ended = subprocess.run(
            [sys.executable, "-B", os.path.join(BINDINGS, "generate.py"), "--check"], capture_output=True, text=True
        )
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)

    def compiles(self, lines):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "layout.c")
            with open(path, "w") as file:
                includes = [f'#include "{name}"' for name in reader.HEADERS]
                file.write("\n".join(["#include <stddef.h>", *includes, *lines]) + "\n")
            command = [COMPILER, "-std=c11", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"]
            ended = subprocess.run([*command, "-I", INCLUDE, path], capture_output=True, text=True)
            return ended.returncode == 0, ended.stderr

    @staticmethod
    def layout():
        """Yields static assertions of every size, offset, type and value that the parser found."""
        for name, struct in MODEL.structs.items():
            offsets, size, _ = MODEL.layout(name)
            yield f'_Static_assert(sizeof({name}) == {size}, "{name}");'
            for field, offset in zip(struct.fields, offsets):
                yield f'_Static_assert(offsetof({name}, {field.name}) == {offset}, "{name}.{field.name}");'
        for name, value in MODEL.constants.items():
            yield f'_Static_assert({name} == {value}{"u" * (value >= 2**63)}, "{name}");'
        for name, scalar in MODEL.aliases.items():
            yield f'_Static_assert(_Generic(({name})0, {scalar}: 1, default: 0), "{name}");'
        for function in MODEL.functions.values():
            parameters = ", ".join(p.type.c(p.name) for p in function.parameters) or "void"
            yield f"{function.result.c('')} (*const use_{function.name})({parameters}) = {function.name};"

    def test_every_struct_has_an_initialiser(self):
        for name in MODEL.structs:
            function = MODEL.functions[name + "_init"]
            self.assertEqual([p.type.c("") for p in function.parameters], [f"{name}*", "uint32_t"], name)

    def test_constants_have_the_types_of_their_parameters(self):
        def type_of(name):
            if name == "NICOL_NO_LIMIT":
                return "unsigned long long"
            # Results, split_lights and max_depth are signed; limits are compared with numbers of any type.
            signed = re.match("NICOL_(OK$|ERROR_|SPLIT_|DEPTH_UNLIMITED|VERSION|MAX_|PSH_MAX_|PSH_BAND_)", name)
            return "int32_t" if signed else "uint32_t"

        lines = [f'_Static_assert(_Generic({n}, {type_of(n)}: 1, default: 0), "{n}");' for n in MODEL.constants]
        agrees, message = self.compiles(lines)
        self.assertTrue(agrees, message)

    def test_compiler_agrees(self):
        lines = list(self.layout())
        self.assertGreater(len(lines), 300)
        agrees, message = self.compiles(lines)
        self.assertTrue(agrees, message)

    def test_compiler_would_disagree(self):
        self.assertFalse(self.compiles(['_Static_assert(sizeof(nicol_spectrum) == 64, "");'])[0])

    def test_everything_was_read(self):
        lines = []
        for name in reader.HEADERS:
            with open(os.path.join(INCLUDE, name), encoding="utf-8") as file:
                lines += file.read().split("\n")
        self.assertEqual(len(MODEL.functions), sum(line.startswith("NICOL_API ") for line in lines))
        types = sum(line.startswith("typedef ") for line in lines)
        unnamed = sum("(*release)(" in line for line in lines) > 0
        self.assertEqual(len(MODEL.order) - unnamed, types)

    def test_unknown_constructs_are_refused(self):
        for text in [
            "typedef unsigned nicol_x;",
            "typedef uint32_t other_x;",
            "typedef struct nicol_a { bool b; } nicol_a;",
            "typedef struct nicol_a { uint32_t b : 3; } nicol_a;",
            "typedef struct nicol_a { uint32_t b; } nicol_b;",
            "#define OTHER 1",
            "#define NICOL_X 1.5f",
            "#if NICOL_X > 3",
            "NICOL_API int32_t nicol_x(size_t y);",
            "NICOL_API int32_t nicol_x(uint32_t y)",
            "typedef enum nicol_e { A } nicol_e;",
        ]:
            with self.subTest(text):
                self.assertRaises(HeaderError, parse, "\n" + text + "\n")

    def test_padding_and_arrays(self):
        model = parse("""
#define NICOL_N (1u << 1)
typedef struct nicol_inner { uint32_t a; double b[NICOL_N * 3]; } nicol_inner;
typedef struct nicol_outer { uint32_t a, c; nicol_inner inner[2]; float d; } nicol_outer;
""")
        self.assertEqual(model.layout("nicol_inner"), ([0, 8], 56, 8))
        self.assertEqual(model.layout("nicol_outer"), ([0, 4, 8, 120], 128, 8))


if __name__ == "__main__":
    unittest.main()
