# SPDX-License-Identifier: MIT
"""Prints what the tests of the contract need to know of the C headers.

usage: functions.py table INCLUDE_FOLDER > functions.inc   (a line a function: itself and the names of its parameters)
       functions.py names INCLUDE_FOLDER > names.txt       (a line a function: its name)
       functions.py fields INCLUDE_FOLDER > fields.inc     (a line a struct that a function reads: its numbers)
       functions.py defaults INCLUDE_FOLDER > defaults.inc (a function a struct that gives it its defaults)
       functions.py use INCLUDE_FOLDER > use.c             (a C program that initialises every struct and passes every callback)
PYTHONPATH names the folder of reader.py.
"""

import sys

import reader
from header import SCALARS


def table(model):
    for function in model.functions.values():
        if function.result.base == "nicol_result":
            names = ", ".join(f'"{p.name}"' for p in function.parameters)
            yield f'{{"{function.name}", {{{names}}}, bind({function.name})}},'


def names(model):
    return sorted(model.functions)


def numbers(model, struct, offset=0):
    """Yields each numeric field, including fields of nested structs: name, offset, element size, count, floating."""
    for field, at in zip(model.structs[struct].fields, model.layout(struct)[0]):
        scalar = model.scalar(field.type)
        if scalar:
            floating = "true" if scalar in ("float", "double") else "false"
            yield f'{{"{field.name}", {offset + at}, {SCALARS[scalar]}, {max(field.type.count, 1)}, {floating}}}'
        elif field.type.base in model.structs and not field.type.pointers:
            yield from numbers(model, field.type.base, offset + at)


def fields(model):
    for function in model.functions.values():
        for parameter in function.parameters:
            if parameter.type.base in model.structs and parameter.type.const:
                all_of_them = ", ".join(numbers(model, parameter.type.base))
                yield f'{{"{function.name}.{parameter.name}", {{{all_of_them}}}}},'


def defaults(model):
    for name, struct in model.structs.items():
        if struct.fields[0].name == "struct_size":
            # Static defaults have zeros between fields too.
            copy = "std::memcpy(&made, &defaults, sizeof made);"
            yield f"inline void initialise({name}& made) {{ static const {name} defaults = {name.upper()}_INIT; {copy} }}"


def use(model):
    callbacks = [c for c in model.callbacks.values() if c.name != "nicol_release_callback"]  # the bindings' own name
    yield "".join(f'#include "{name}"\n' for name in reader.HEADERS)
    for callback in callbacks:
        parameters = ", ".join(p.type.c(p.name) for p in callback.parameters)
        unused = " ".join(f"(void){p.name};" for p in callback.parameters)
        result = callback.result.c("")
        end = "" if result == "void" else " return 0;"
        yield f"static {result} use_{callback.name}({parameters}) {{ {unused}{end} }}"
    yield "\nint main(void) {"
    for name in model.structs:
        yield f"    {name} of_{name} = {name.upper()}_INIT;"
    for callback in callbacks:
        yield f"    {callback.name} of_{callback.name} = use_{callback.name};"
    for name, struct in model.structs.items():
        if struct.fields[0].name == "struct_size":
            yield f"    if (of_{name}.struct_size != sizeof(of_{name})) return 1;"
        else:
            yield f"    (void)of_{name};"
    yield from (f"    (void)of_{callback.name};" for callback in callbacks)
    yield "    return nicol_version() == (uint32_t)NICOL_VERSION ? 0 : 2;\n}"


if __name__ == "__main__":
    header = reader.read(sys.argv[2])
    print("\n".join({"table": table, "names": names, "fields": fields, "defaults": defaults, "use": use}[sys.argv[1]](header)))
