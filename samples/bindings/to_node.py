# SPDX-License-Identifier: MIT
"""Generator of samples/node/nicol_abi.js: the C headers for Koffi, its constants, and which functions make objects."""

from roles import roles_of

HEAD = """// SPDX-License-Identifier: MIT
// Nicol {version} for Node.js. Made of the C headers by samples/bindings/generate.py: change those, not this file.

export const constants = {{
"""


def pointer(type_):
    return f"{'const ' if type_.const else ''}{type_.base} {'*' * (type_.pointers or bool(type_.count))}"


def of_callback(header, type_):
    """Returns the type of a callback's parameter, with the space before its name. Callbacks themselves go by pointer."""
    if type_.pointers or type_.count:
        return pointer(type_)
    return f"{type_.base} *" if type_.base in header.callbacks else f"{type_.base} "


def prototype(header, function):
    """Returns a prototype for Koffi: arrays as pointers, callbacks by pointer, and output parameters marked."""
    marks = {}
    for parameter, role, partners in roles_of(header, function):
        type_ = parameter.type
        written = (type_.pointers or type_.count) and not type_.const and role not in ("user", "text")
        for other in [parameter, *[p for p in partners if p.type.pointers]]:
            # Structs are also inputs, because of their struct_size, which initialisers do not read.
            read = type_.base in header.structs and not function.name.endswith("_init")
            marks[other.name] = "" if not written else "_Inout_ " if read else "_Out_ "
    texts = []
    for parameter in function.parameters:
        type_ = parameter.type
        if type_.base in header.callbacks:
            texts.append(f"{type_.base} *{parameter.name}")
        elif type_.pointers or type_.count:
            texts.append(f"{marks.get(parameter.name, '')}{pointer(type_)}{parameter.name}")
        else:
            texts.append(f"{type_.base} {parameter.name}")
    return f"{function.result.c('').rstrip()} {function.name}({', '.join(texts) or 'void'})"


def literal(value):
    """Returns JavaScript text of a value. Integers beyond the precision of doubles become BigInt."""
    return f"{value}n" if isinstance(value, int) and abs(value) >= 2**53 else str(value)


def field(header, variable):
    type_ = variable.type
    if type_.base in header.callbacks:
        text = f"{type_.base} *"
    elif type_.base == "char":
        text = "const char *"
    else:
        text = f"{type_.base} {'*' * type_.pointers}".rstrip()
    return f'["{variable.name}", "{text}", {type_.count}]'


def generate(header):
    version = ".".join(str(header.constants[f"NICOL_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH"))
    text = HEAD.format(version=version)
    for name, value in header.constants.items():
        text += f"  {name.removeprefix('NICOL_')}: {literal(value)},\n"
    text += "};\n\n// In the order of their declaration, as Koffi needs them.\nexport const types = [\n"
    for name in header.order:
        if name in header.aliases:
            text += f'  {{ kind: "alias", name: "{name}", of: "{header.aliases[name]}" }},\n'
        elif name in header.handles:
            text += f'  {{ kind: "handle", name: "{name}" }},\n'
        elif name in header.callbacks:
            callback = header.callbacks[name]
            parameters = ", ".join(f"{of_callback(header, p.type)}{p.name}" for p in callback.parameters)
            text += f'  {{ kind: "callback", name: "{name}", of: "{callback.result.c("").rstrip()} {name}({parameters})" }},\n'
        else:
            fields = "".join(f"      {field(header, f)},\n" for f in header.structs[name].fields)
            text += f'  {{\n    kind: "struct",\n    name: "{name}",\n    // name, type, length of a fixed array\n    fields: [\n'
            text += fields + "    ],\n  },\n"
    text += "];\n\n// Prototype, whether it answers with a result code, and the handle that comes back through the last pointer.\n"
    text += "export const functions = {\n"
    for function in header.functions.values():
        last = function.parameters[-1].type if function.parameters else None
        made = f'"{last.base}"' if last and last.pointers and last.base in header.handles else "null"
        result = str(function.result.base == "nicol_result").lower()
        name = function.name.removeprefix("nicol_")
        text += f'  {name}: ["{prototype(header, function)}", {result}, {made}],\n'
    return text + "};\n"
