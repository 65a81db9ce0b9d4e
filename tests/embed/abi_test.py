# SPDX-License-Identifier: MIT
"""The C headers keep what capi/nicol.abi promised, and what would break a promise is noticed.

usage: abi_test.py INCLUDE_FOLDER NICOL_ABI, with PYTHONPATH naming the folder of abi.py
"""

import sys
import unittest

import abi
import reader

INCLUDE, NICOL_ABI = sys.argv[1:]

OLD = """
#define NICOL_RED 1
#define NICOL_BITS_ALL 3
typedef uint32_t nicol_kind;
typedef struct nicol_spectrum { uint32_t count; } nicol_spectrum;
typedef struct nicol_options { uint32_t struct_size; nicol_kind kind; double scale; uint32_t reserved; } nicol_options;
typedef int32_t (*nicol_call)(void* user, double at);
NICOL_API int32_t nicol_do(const nicol_options* options, nicol_call call);
NICOL_API int32_t nicol_tint(const nicol_spectrum* tint);
"""


# Changes that older programs survive: (text, replacement).
ADDITIONS = [
    ("#define NICOL_RED 1", "#define NICOL_RED 1\n#define NICOL_BLUE 2"),
    ("NICOL_BITS_ALL 3", "NICOL_BITS_ALL 7"),
    ("uint32_t reserved;", "uint32_t reserved; double more;"),
    ("uint32_t reserved;", "nicol_kind seed;"),
    ("NICOL_API int32_t nicol_do", "NICOL_API int32_t nicol_more(void);\nNICOL_API int32_t nicol_do"),
    ("double at", "double angle"),
]

# Changes that break older programs: ((text, replacement), words of the report).
BREAKS = [
    (("RED 1", "RED 2"), "NICOL_RED was 1 and is 2"),
    (("#define NICOL_RED 1", ""), "NICOL_RED was 1 and is gone"),
    (("typedef uint32_t nicol_kind", "typedef int32_t nicol_kind"), "nicol_kind was uint32_t"),
    (("uint32_t count;", "uint32_t count; float more;"), "nicol_spectrum has grown"),
    (("double scale;", ""), "nicol_options has shrunk"),
    (("double scale;", "double factor;"), "nicol_options.scale was at 8"),
    (("nicol_kind kind; double scale;", "double scale; nicol_kind kind;"), "nicol_options.kind was at 4"),
    (("double scale;", "uint64_t scale;"), "nicol_options.scale"),
    (("uint32_t reserved;", "float seed;"), "nicol_options.reserved was at 16"),
    (("void* user, double at", "void* user, float at"), "nicol_call was"),
    (("const nicol_options* options, ", ""), "nicol_do was"),
    (("nicol_do(", "nicol_do_it("), "nicol_do was"),
]


def interfaces(change):
    """Returns the interfaces of OLD before and after the change."""
    if change[0] not in OLD:
        raise ValueError(f"{change[0]!r} is not there to be changed")
    texts = (OLD, OLD.replace(*change))
    return tuple(abi.parse(abi.interface(reader.Parser(text).header)) for text in texts)


class AbiTest(unittest.TestCase):
    def test_promises_are_kept(self):
        with open(NICOL_ABI, encoding="utf-8") as file:
            old = abi.parse(file)
        self.assertGreater(sum(kind == "function" for kind, _ in old), 80)
        self.assertEqual(list(abi.breaks(old, abi.parse(abi.interface(reader.read(INCLUDE))))), [])

    def test_additions(self):
        for change in ADDITIONS:
            with self.subTest(change):
                self.assertEqual(list(abi.breaks(*interfaces(change))), [])

    def test_breaks(self):
        for change, words in BREAKS:
            with self.subTest(change):
                found = list(abi.breaks(*interfaces(change)))
                self.assertTrue(any(words in line for line in found), found)

    def test_fields_in_old_padding(self):
        change = ("uint32_t reserved;", "uint32_t reserved; uint32_t late; double more;")
        (line,) = abi.breaks(*interfaces(change))
        self.assertIn("nicol_options.late lies in what was padding of nicol_options", line)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
