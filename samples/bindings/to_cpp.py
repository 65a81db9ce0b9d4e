# SPDX-License-Identifier: MIT
"""Generator of include/nicol_classes.hpp: a C++ class with methods for each handle of the C headers."""

from roles import class_name, last_input, owner_of, roles_of

HEAD = """// SPDX-License-Identifier: MIT
// Classes of nicol.hpp, which includes this file. Made of the C headers by samples/bindings/generate.py:
// change those, not this file. nicol_scene_load() is the function Scene::load(), nicol_scene_get_camera()
// the method get_camera() of a Scene, and nicol_render() the function nicol::render(). The C headers say
// what each function does. Arguments are those of C, with std::span for an array and its length. Results
// are returned instead of written through pointers. A failure throws Error.
#ifndef NICOL_CLASSES_HPP
#define NICOL_CLASSES_HPP

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>

#include "nicol.hpp"

// clang-format off
namespace nicol {
"""


class Call:
    """C++ text of a function: its parameters, the lines before the call, the arguments for C, and the results."""

    def __init__(self, header, function, owner):
        self.header, self.function = header, function
        self.takes, self.before, self.arguments, self.types, self.values = [], [], [], [], []
        roles = roles_of(header, function)
        self.last = last_input(roles)
        self.method = bool(owner and roles[0][0].type.base == owner and roles[0][1] == "value")
        if self.method:
            self.arguments.append("get()")
        for parameter, role, partners in roles[self.method :]:
            getattr(self, role, self.as_in_c)(parameter, partners)

    def as_in_c(self, parameter, partners):
        default = " = nullptr" if parameter.name == "options" and parameter is self.last else ""
        self.takes.append(parameter.type.c(parameter.name) + default)
        self.takes += [partner.type.c(partner.name) for partner in partners]
        self.arguments += [parameter.name, *[partner.name for partner in partners]]

    def buffer(self, parameter, partners):
        type_, length = parameter.type, partners[0].type
        default = " = {}" if type_.base == "char" and parameter is self.last else ""
        element = "const char* const" if type_.base == "char" else ("const " if type_.const else "") + type_.base
        self.takes.append(f"std::span<{element}> {parameter.name}{default}")
        size = f"{parameter.name}.size()"
        self.arguments += [f"{parameter.name}.data()", size if length.base == "uint64_t" else f"static_cast<{length.base}>({size})"]

    texts = buffer

    def result(self, parameter, partners):
        base, name = parameter.type.base, parameter.name
        handle = base in self.header.handles
        made = f"defaults({base}_init)" if base in self.header.structs else f"{base}{{}}"
        self.before.append(f"auto {name} = {made};")
        self.arguments.append(f"&{name}")
        self.types.append(class_name(base) if handle else base)
        self.values.append(f"{class_name(base)}({name})" if handle else name)

    def filled(self, parameter, partners):
        type_ = f"std::array<{parameter.type.base}, {parameter.type.count}>"
        self.before.append(f"{type_} {parameter.name}{{}};")
        self.arguments.append(f"{parameter.name}.data()")
        self.types.append(type_)
        self.values.append(parameter.name)

    def definition(self, name, indent, kind):
        result = {0: "void", 1: "".join(self.types)}.get(len(self.types), f"std::tuple<{', '.join(self.types)}>")
        made = {class_name(handle) for handle in self.header.handles}
        nodiscard = "[[nodiscard]] " if self.types and (name.startswith("get_") or made & set(self.types)) else ""
        constant = " const" if self.method else ""
        lines = [*self.before, f"check({self.function.name}({', '.join(self.arguments)}));"]
        if len(self.values) > 1:
            lines.append(f"return {{{', '.join(self.values)}}};")
        elif self.values:
            lines.append(f"return {self.values[0]};")
        body = "".join(f"{indent}    {line}\n" for line in lines)
        return f"{indent}{nodiscard}{kind}{result} {name}({', '.join(self.takes)}){constant} {{\n{body}{indent}}}\n"


def generate(header):
    members = {handle: "" for handle in header.handles}
    free = ""
    for function in header.functions.values():
        owner, name = owner_of(function, header.handles)
        if function.result.base != "nicol_result" or name in ("retain", "release") or name.endswith("_init"):
            continue
        call = Call(header, function, owner)
        if owner:
            members[owner] += call.definition(name, "    ", "" if call.method else "static ")
        else:
            free += "\n" + call.definition(name, "", "inline ")
    text = HEAD
    for handle, body in members.items():
        name = class_name(handle)
        text += f"\nclass {name} : public Owned<{handle}, {handle}_release> {{\npublic:\n    using Owned::Owned;\n{body}}};\n"
    return text + free + "\n}  // namespace nicol\n// clang-format on\n\n#endif\n"
