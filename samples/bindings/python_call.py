# SPDX-License-Identifier: MIT
"""Conversion of a call from Python to C: a line or two for each role that a parameter can have."""

import keyword

from roles import class_name, last_input, roles_of

CTYPES = {
    "char": "c_char", "int32_t": "c_int32", "uint32_t": "c_uint32", "float": "c_float", "int64_t": "c_int64",
    "uint64_t": "c_uint64", "double": "c_double",
}  # fmt: skip


def variable_name(name):
    return name + "_" if keyword.iskeyword(name) else name


def hint_of(header, type_):
    """Returns the type hint of a value: Any for constants, which have words, and for what many things convert to."""
    base = type_.base
    if base == "char" and type_.pointers:
        return "str | None"
    if type_.pointers or type_.count or base in header.aliases or base in header.callbacks or base == "nicol_spectrum":
        return "Any"
    if base in header.structs or base in header.handles:
        return class_name(base)
    return "float" if base in ("float", "double") else "int"


class Call:
    """Python text of a function: its parameters, the lines before the call, the arguments for C, and the results."""

    def __init__(self, header, function, owner):
        self.header, self.function, self.owner = header, function, owner
        self.takes, self.before, self.arguments, self.after = [], [], [], []
        self.results, self.hints = [], []  # hints of the results
        roles = roles_of(header, function)
        self.last = last_input(roles)
        first, role, _ = roles[0] if roles else (None, None, None)
        self.method = bool(owner and first and first.type.base == owner and role in ("value", "struct"))
        self.creates = any(role == "result" and p.type.base in header.handles for p, role, _ in roles)
        if self.method:
            self.takes.append("self")
            self.arguments.append("self" if role == "value" else "byref(self)")
        elif owner:
            self.takes.append("cls")
        for parameter, role, partners in roles[self.method :]:
            getattr(self, role)(parameter, variable_name(parameter.name), partners)
        # A function that changes a struct returns it, so that Camera(fov=40).look_at(...) is a camera.
        if "byref(self)" in self.arguments and not self.results:
            self.results.append("self")
            self.hints.append("Self")

    def lines(self):
        call = f"_{self.function.name.removeprefix('nicol_')}({', '.join(self.arguments)})"
        if self.function.result.base == "nicol_result":
            returned = [f"return {', '.join(self.results)}"] if self.results else []
            return [*self.before, f"check({call})", *self.after, *returned]
        return [*self.before, f"return decoded({call})" if self.function.result.base == "char" else f"return {call}"]

    def returns(self):
        """Returns the type hint of the result."""
        result = self.function.result
        hints = self.hints if result.base == "nicol_result" else ["str" if result.base == "char" else hint_of(self.header, result)]
        if self.function.name == "nicol_build_info":  # NULL ends its list
            hints = ["str | None"]
        return {0: "None", 1: "".join(hints)}.get(len(hints), f"tuple[{', '.join(hints)}]")

    def scalar(self, parameter):
        base = parameter.type.base
        return CTYPES.get(self.header.aliases.get(base, base))

    def take(self, parameter, item, optional=None, hint="Any"):
        """Adds a parameter, which is optional only if it is the last one."""
        nullable = hint not in ("Any", "int", "float") and (optional == "None" or "NULL" in self.function.doc)
        item = f"{item}: {hint} | None" if nullable else f"{item}: {hint}"
        self.takes.append(f"{item} = {optional}" if optional and parameter is self.last else item)

    # ---- roles

    def user(self, parameter, item, partners):
        self.arguments.append("None")

    def value(self, parameter, item, partners):
        self.take(parameter, item, hint=hint_of(self.header, parameter.type))
        self.arguments.append(item)

    def text(self, parameter, item, partners):
        self.take(parameter, item, hint="str | os.PathLike[str]")
        self.arguments.append(f"text({item})")

    def callback(self, parameter, item, partners):
        self.take(parameter, item)
        made = f"{class_name(parameter.type.base)}({item})"
        if self.method and "_set_" in self.function.name:  # the library calls the function later, too
            self.before.append(f"{item} = {made}")
            self.arguments.append(item)
            self.after.append(f"hold(self, {item})")
        else:
            self.arguments.append(made)

    def array(self, parameter, item, partners):
        self.take(parameter, item)
        self.arguments.append(f"array({item}, {self.scalar(parameter)}, {parameter.type.count})")

    def struct(self, parameter, item, partners):
        base = parameter.type.base
        optional = "None" if parameter.name == "options" else None
        self.take(parameter, item, optional, "Any" if base == "nicol_spectrum" or self.is_lent(base) else class_name(base))
        if base == "nicol_spectrum":
            self.before.append(f"{item} = {item} if {item} is None or isinstance({item}, Spectrum) else Spectrum.of({item})")
        if self.is_lent(base):
            self.before.append(f"{item} = lend({item})")
        self.arguments.append(f"byref({item}) if {item} is not None else None")

    def is_lent(self, struct):
        """Returns whether the library continues to use the memory that the struct points to. Loading from memory does not."""
        fields = self.header.structs[struct].fields
        callback = any(f.type.base in self.header.callbacks for f in fields)
        creates = self.creates and "_load_" not in self.function.name
        return callback and (creates or any(f.name == "release" for f in fields))

    def texts(self, parameter, item, partners):
        self.take(parameter, item, "()")
        self.before.append(f"{item} = texts({item})")
        self.arguments += [item, f"len({item})"]

    def made(self, parameter, item, more=""):
        writable = "" if parameter.type.const else ", writable=True"
        return f"Buffer({item}, {self.scalar(parameter)}{writable}{more})"

    def buffer(self, parameter, item, partners):
        self.take(parameter, item, "None" if "NULL" in self.function.doc else None)
        self.before.append(f"{item} = {self.made(parameter, item)}")
        self.arguments += [f"{item}.pointer", f"{item}.count"]

    def buffers(self, parameter, item, partners):
        other = variable_name(partners[0].name)
        self.takes += [f"{item}: Any", f"{other}: Any"]
        self.before.append(f"{item}, {other} = {self.made(parameter, item)}, {self.made(parameter, other)}")
        self.arguments += [f"{item}.pointer", f"{other}.pointer", f"counted({item}, {other})"]

    def paired(self, parameter, item, partners):
        """Adds an array of structs and one of as many handles."""
        other = variable_name(partners[0].name)
        struct, handle = class_name(parameter.type.base), class_name(partners[0].type.base)
        self.takes += [f"{item}: Sequence[{struct}]", f"{other}: Sequence[{handle}]"]
        self.before.append(f"{item}, {other} = paired({item}, {struct}, {other}, {handle})")
        self.arguments += [item, other, f"len({item})"]

    def rows(self, parameter, item, partners):
        self.take(parameter, item)
        self.before.append(f"{item} = {self.made(parameter, item, ', rows=True')}")
        self.arguments += [f"{item}.pointer", f"{item}.stride", f"{item}.nbytes"]

    def result(self, parameter, item, partners):
        base = parameter.type.base
        handle = base in self.header.handles
        made = "cls" if handle and base == self.owner and not self.method else self.scalar(parameter) or class_name(base)
        self.before.append(f"{item} = {made}()")
        self.arguments.append(f"byref({item})")
        if self.scalar(parameter):
            self.results.append(f"{item}.value")
            self.hints.append("float" if parameter.type.base in ("float", "double") else "int")
        elif handle and self.method:  # only this handle may be NULL after a successful call: the object was asked for it
            self.results.append(f"{item} if {item}.value else None")
            self.hints.append(f"{class_name(base)} | None")
        else:
            self.results.append(item)
            self.hints.append("Self" if made == "cls" else class_name(base))

    def filled(self, parameter, item, partners):
        self.before.append(f"{item} = ({self.scalar(parameter)} * {parameter.type.count})()")
        self.arguments.append(item)
        self.results.append(f"tuple({item})")
        self.hints.append("tuple[float, ...]")
