# SPDX-License-Identifier: MIT
"""samples/python/nicol/_abi.py: nicol.h for ctypes, with a Python function or method for each of its functions."""

import keyword

from header import Type
from roles import last_input, roles_of

CTYPES = {
    "char": "c_char", "int32_t": "c_int32", "uint32_t": "c_uint32", "float": "c_float", "uint64_t": "c_uint64",
    "double": "c_double",
}  # fmt: skip

HEAD = '''# SPDX-License-Identifier: MIT
"""nicol.h {version} for Python. Made by samples/bindings/generate.py: change the header, not this file."""

from ctypes import POINTER, byref, c_char_p, c_double, c_float, c_int32, c_uint32, c_uint64, c_void_p

from ._runtime import (
    Buffer, Callback, Handle, Struct, array, as_is, check, counted, declare, decoded, lend, pointee, text, texts,
)  # fmt: skip
'''


def class_name(name):
    return "".join(part.capitalize() for part in name.removeprefix("nicol_").split("_"))


def variable_name(name):
    return name + "_" if keyword.iskeyword(name) else name


def docstring(doc, indent):
    if not doc:
        return ""
    doc = doc.replace("\\", "\\\\").replace('"', "'") if '"""' in doc or doc.endswith('"') else doc
    return f'{indent}"""' + doc.replace("\n", "\n" + indent).replace(f"\n{indent}\n", "\n\n") + '"""\n'


class Python:
    def __init__(self, header):
        self.header = header

    def ctype(self, type_, argument=True):
        """The ctypes spelling of a parameter or, where not an argument, of a field."""
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
            return f"POINTER({name})"  # as C has it
        name = f"POINTER({name})" if type_.pointers else name
        return f"{name} * {type_.count}" if type_.count else name

    # ---- types

    def callback(self, function):
        parameters = []
        for parameter in function.parameters:
            type_ = parameter.type
            if type_.base == "void":
                parameters.append("(c_void_p, None)")
            elif type_.count:
                parameters.append(f"(POINTER({CTYPES[type_.base]} * {type_.count}), pointee)")
            elif type_.pointers:
                parameters.append("(c_char_p, decoded)")
            else:
                parameters.append(f"({self.ctype(type_)}, as_is)")
        result = self.ctype(function.result)
        return f"{class_name(function.name)} = Callback({', '.join([result, *parameters])})\n"

    def struct(self, struct):
        text = f"\n\nclass {class_name(struct.name)}(Struct):\n" + docstring(struct.doc, "    ")
        callbacks = [f'"{f.name}": {class_name(f.type.base)}' for f in struct.fields if f.type.base in self.header.callbacks]
        if callbacks:
            text += "    _callbacks_ = {" + ", ".join(callbacks) + "}\n"
        text += "    _fields_ = [\n"
        for field in struct.fields:
            text += f'        ("{field.name}", {self.ctype(field.type, argument=False)}),\n'
        return text + "    ]\n"

    # ---- functions

    def owner(self, function):
        """The class that a function is a method of, and the method's name."""
        owners = [name for name in self.header.order if function.name.startswith(name + "_")]
        owners = [name for name in owners if name in self.header.handles or name in self.header.structs]
        if not owners:
            return None, function.name.removeprefix("nicol_")
        owner = max(owners, key=len)
        return owner, function.name[len(owner) + 1 :]

    def function(self, function):
        """The text of a function or method, the class it belongs to or None."""
        header = self.header
        owner, name = self.owner(function)
        if name in ("retain", "release"):
            return "", owner
        roles = roles_of(header, function)
        method = owner and roles and roles[0][0].type.base == owner and roles[0][1] in ("value", "struct")
        creates = [p for p, role, _ in roles if role == "result" and p.type.base in header.handles]
        takes, before, arguments, results = [], [], [], []
        for parameter, role, partners in roles:
            item = variable_name(parameter.name)
            base = parameter.type.base
            scalar = CTYPES.get(header.aliases.get(base, base))
            writable = "" if parameter.type.const else ", writable=True"
            optional = ""
            if method and parameter is function.parameters[0]:
                arguments.append("self" if role == "value" else "byref(self)")
                continue
            if role == "user":
                arguments.append("None")
                continue
            if role in ("value", "text", "array", "callback"):
                arguments.append({"value": item, "text": f"text({item})", "callback": f"{class_name(base)}({item})",
                                  "array": f"array({item}, {scalar}, {parameter.type.count})"}[role])  # fmt: skip
            elif role == "struct":
                optional = "=None" if parameter.name == "options" and parameter is last_input(roles) else ""
                arguments.append(f"byref({item}) if {item} is not None else None")
                if self.lends(base, creates):
                    before.append(f"{item} = lend({item})")
                if base == "nicol_spectrum":
                    before.append(f"{item} = {item} if {item} is None or isinstance({item}, Spectrum) else Spectrum.of({item})")
            elif role == "texts":
                optional = "=()" if parameter is last_input(roles) else ""
                before.append(f"{item} = texts({item})")
                arguments += [item, f"len({item})"]
            elif role == "buffer":
                optional = "=None" if "NULL" in function.doc and parameter is last_input(roles) else ""
                before.append(f"{item} = Buffer({item}, {scalar}{writable})")
                arguments += [f"{item}.pointer", f"{item}.count"]
            elif role == "buffers":
                other = variable_name(partners[0].name)
                before.append(f"{item}, {other} = Buffer({item}, {scalar}{writable}), Buffer({other}, {scalar}{writable})")
                arguments += [f"{item}.pointer", f"{other}.pointer", f"counted({item}, {other})"]
                takes.append(item)
                item = other
            elif role == "rows":
                before.append(f"{item} = Buffer({item}, {scalar}{writable}, rows=True)")
                arguments += [f"{item}.pointer", f"{item}.stride", f"{item}.nbytes"]
            elif role == "result":
                made = class_name(base) if not scalar else scalar
                if parameter in creates and base == owner and not method:
                    made = "cls"
                before.append(f"{item} = {made}()")
                arguments.append(f"byref({item})")
                # The only handle that a successful call leaves NULL is one that it was asked for.
                results.append(f"{item}.value" if scalar else f"{item} if {item}.value else None"
                               if base in header.handles and method else item)  # fmt: skip
                continue
            elif role == "results":
                before.append(f"{item} = ({scalar} * {parameter.type.count})()")
                arguments.append(item)
                results.append(f"tuple({item})")
                continue
            takes.append(item + optional)
        return self.write(function, owner, name, method, takes, before, arguments, results), owner

    def lends(self, name, creates):
        fields = self.header.structs[name].fields
        callback = any(f.type.base in self.header.callbacks for f in fields)
        return callback and (bool(creates) or any(f.name == "release" for f in fields))

    def write(self, function, owner, name, method, takes, before, arguments, results):
        indent = "    " if owner else ""
        head = ["self"] if method else ["cls"] if owner else []
        text = "\n" if owner else "\n\n"
        if owner and not method:
            text += f"{indent}@classmethod\n"
        text += f"{indent}def {variable_name(name)}({', '.join(head + takes)}):\n" + docstring(function.doc, indent + "    ")
        call = f"_{function.name.removeprefix('nicol_')}({', '.join(arguments)})"
        if function.result.base == "nicol_result":
            before += [f"check({call})"] + ([f"return {', '.join(results)}"] if results else [])
        else:
            before.append(f"return decoded({call})" if function.result.base == "char" else f"return {call}")
        return text + "".join(f"{indent}    {line}\n" for line in before)

    def declaration(self, function):
        owner, name = self.owner(function)
        if name == "retain":
            return ""
        if name == "release":
            return f'{class_name(owner)}._release = declare("{function.name}", c_int32, c_void_p)\n'
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
        listed = "".join(f'    "{name}",\n' for name in sorted(names))
        parts.append(f"\n__all__ = [\n{listed}]\n")
        return "".join(parts)


def generate(header):
    return Python(header).generate()
