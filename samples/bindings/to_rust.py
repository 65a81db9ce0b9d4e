# SPDX-License-Identifier: MIT
"""Generator of samples/rust/src/abi.rs: the C headers as Rust's extern block, with compile-time checks of struct layouts."""

SCALARS = {"char": "c_char", "int32_t": "i32", "uint32_t": "u32", "float": "f32", "int64_t": "i64", "uint64_t": "u64", "double": "f64",
           "void": "c_void"}  # fmt: skip
KEYWORDS = {"in", "type", "ref", "match", "move", "use"}

HEAD = """// SPDX-License-Identifier: MIT
//! Nicol {version} for Rust. Made of the C headers by samples/bindings/generate.py: change those, not this file.
#![allow(non_camel_case_types)]
use std::ffi::{{c_char, c_void}};
use std::mem::{{offset_of, size_of, MaybeUninit}};

macro_rules! defaults {{
    ($name:ident, $init:ident) => {{
        impl Default for $name {{
            fn default() -> Self {{
                let mut made = MaybeUninit::zeroed();
                // Fails only in a child of fork(), where every call fails; zeros are values of every field.
                unsafe {{
                    $init(made.as_mut_ptr(), size_of::<Self>() as u32);
                    made.assume_init()
                }}
            }}
        }}
    }};
}}

"""


def word(name):
    return f"r#{name}" if name in KEYWORDS else name


def comment(doc, indent=""):
    return "".join(f"{indent}/// {line}".rstrip() + "\n" for line in doc.split("\n")) if doc else ""


def rust(type_, argument=True):
    text = SCALARS.get(type_.base, type_.base)
    for level in range(type_.pointers):
        # In char* const* the outer pointer also points to a constant.
        text = f"*{'const' if type_.const or level else 'mut'} {text}"
    if type_.count:
        text = f"[{text}; {type_.count}]"
        text = f"*{'const' if type_.const else 'mut'} {text}" if argument else text
    return text


def parameters(function):
    return ", ".join(f"{word(p.name)}: {rust(p.type)}" for p in function.parameters)


def result(function):
    return "" if function.result.base == "void" and not function.result.pointers else f" -> {rust(function.result)}"


def struct(header, name):
    found = header.structs[name]
    text = "\n" + comment(found.doc) + f"#[repr(C)]\n#[derive(Clone, Copy)]\npub struct {name} {{\n"
    for field in found.fields:
        text += f"    pub {word(field.name)}: {rust(field.type, argument=False)},\n"
    text += f"}}\ndefaults!({name}, {name}_init);\nconst _: () = {{\n"
    offsets, size, _ = header.layout(name)
    text += f"    assert!(size_of::<{name}>() == {size});\n"
    for field, offset in zip(found.fields, offsets):
        text += f"    assert!(offset_of!({name}, {word(field.name)}) == {offset});\n"
    return text + "};\n"


def generate(header):
    version = ".".join(str(header.constants[f"NICOL_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH"))
    text = HEAD.format(version=version)
    for name, value in header.constants.items():
        type_ = "nicol_result" if name == "NICOL_OK" or name.startswith("NICOL_ERROR_") else "u32"
        type_ = "u64" if value >= 2**32 else "i32" if value < 0 else type_
        text += f"pub const {name}: {type_} = {value};\n"
    text += "\n"
    for name in header.order:
        if name in header.aliases:
            text += f"pub type {name} = {SCALARS[header.aliases[name]]};\n"
        elif name in header.handles:
            text += f"\n#[repr(C)]\npub struct {name}_impl {{\n    _private: [u8; 0],\n}}\n"
            text += comment(header.handles[name]) + f"pub type {name} = *mut {name}_impl;\n"
        elif name in header.callbacks:
            callback = header.callbacks[name]
            text += "\n" + comment(callback.doc)
            text += f'pub type {name} = Option<unsafe extern "C" fn({parameters(callback)}){result(callback)}>;\n'
        else:
            text += struct(header, name)
    text += '\nextern "C" {\n'
    for function in header.functions.values():
        text += comment(function.doc, "    ") + f"    pub fn {function.name}({parameters(function)}){result(function)};\n"
    return text + "}\n"
