# SPDX-License-Identifier: MIT
"""Parser of the C headers, for exactly the subset of C that they use."""

import os
import re

from header import SCALARS, Function, Header, HeaderError, Struct, Type, Variable

TOKEN = re.compile(
    r"""(?P<comment>/\*.*?\*/)
      | (?P<directive>^[ \t]*\#(?:[^\\\n]|\\\n|\\.)*)
      | (?P<name>[A-Za-z_]\w*)
      | (?P<number>\d+)
      | (?P<string>"[^"\n]*")
      | (?P<mark>[{}()\[\];,*])
      | (?P<line>\n)
      | (?P<space>[ \t]+)
      | (?P<other>.)""",
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)


def text_of(comment):
    """Returns the text of a comment without its marks, with its line breaks."""
    lines = [re.sub(r"^\s*\* ?", "", line).rstrip() for line in comment[2:-2].split("\n")]
    return "\n".join(lines).strip()


# Headers of include/ in the order of their dependencies.
HEADERS = ("nicol.h", "nicol_psh.h", "nicol_files.h")


class Parser:
    def __init__(self, text, name="nicol.h", header=None):
        self.name = name
        self.header = header or Header()  # with the declarations of earlier headers
        self.tokens = []  # (kind, text, line)
        self.at = 0
        self.tokenize(text)
        self.parse()

    def fail(self, what, line=None):
        line = line or (self.tokens[self.at][2] if self.at < len(self.tokens) else "the end")
        raise HeaderError(f"{self.name}, line {line}: {what}")

    def tokenize(self, text):
        line, taken = 1, []  # taken: truth of each open #if
        for match in TOKEN.finditer(text):
            kind, value = match.lastgroup, match.group()
            if kind == "directive":
                self.directive(" ".join(value.replace("\\\n", " ").split()), taken, line)
            elif kind == "other":
                self.fail(f"unexpected {value!r}", line)
            elif kind != "space" and all(taken):
                self.tokens.append((kind, value, line))
            line += value.count("\n")

    def directive(self, text, taken, line):
        word, _, rest = text[1:].strip().partition(" ")
        if word in ("ifdef", "if"):
            taken.append(False)  # neither C++ nor Windows, nor the library's build
            if word == "if" and not re.fullmatch(r"defined\(\w+\)( && defined\(\w+\))*", rest):
                self.fail(f"cannot judge #{text}", line)
        elif word == "ifndef":
            taken.append(True)
        elif word == "else":
            taken[-1] = not taken[-1]
        elif word == "endif":
            taken.pop()
        elif word == "define" and all(taken):
            self.define(rest, line)
        elif word not in ("define", "elif", "include"):
            self.fail(f"unexpected #{text}", line)

    def define(self, text, line):
        text = re.sub(r"/\*.*", "", text).strip()
        name, _, value = text.partition(" ")
        if name in ("NICOL_API", "NICOL_DEPRECATED(text)") or name.endswith("_H"):
            return
        if value.startswith("{"):  # nicol_<type>_init() sets the same values
            return
        if not re.fullmatch(r"NICOL_[A-Z0-9_]+", name):
            self.fail(f"the macro {name} does not start with NICOL_", line)
        number = self.value(value, line)
        if not isinstance(number, int):
            self.fail(f"cannot evaluate {value!r}", line)
        self.header.constants[name] = number

    def value(self, text, line):
        """Evaluates an expression of numbers and constants."""
        if not re.fullmatch(r"[\w\s+*|<().-]+", text):
            self.fail(f"cannot evaluate {text!r}", line)
        text = re.sub(r"\b(0x[0-9a-fA-F]+|\d+)(u|ULL)\b", r"\1", text)
        try:
            return eval(text, {"__builtins__": {}}, dict(self.header.constants))
        except (NameError, SyntaxError, TypeError):
            self.fail(f"cannot evaluate {text!r}", line)

    # ---- tokens

    def peek(self):
        """Returns the next word or mark and skips comments and ends of lines before it."""
        while self.at < len(self.tokens) and self.tokens[self.at][0] in ("comment", "line"):
            self.at += 1
        return self.tokens[self.at][1] if self.at < len(self.tokens) else None

    def take(self, *expected):
        token = self.peek()
        if token is None or (expected and token not in expected):
            self.fail(f"{token!r} where {' or '.join(expected)} was expected")
        self.at += 1
        return token

    def doc_before(self):
        """Returns the comment on separate lines that ends right above the next word."""
        self.peek()
        at = self.at
        while at >= 3 and [kind for kind, _, _ in self.tokens[at - 3 : at]] == ["line", "comment", "line"]:
            comment = text_of(self.tokens[at - 2][1])
            if not comment.startswith("clang-format"):
                return "" if comment.startswith("----") else comment
            at -= 2
        return ""

    def doc_after(self):
        """Returns the comment that follows on the current line."""
        if self.at < len(self.tokens) and self.tokens[self.at][0] == "comment":
            return text_of(self.tokens[self.at][1])
        return ""

    # ---- declarations

    def parse(self):
        while self.peek() is not None:
            doc = self.doc_before()
            if self.take("typedef", "NICOL_API") == "NICOL_API":
                function = self.function(doc)
                self.take(";")
                self.header.functions[function.name] = function
            elif self.peek() == "struct":
                self.struct(doc)
            else:
                self.alias_or_callback(doc)

    def declare(self, table, name, value):
        if not re.fullmatch(r"nicol_[a-z0-9_]+", name) or name in self.header.order:
            self.fail(f"{name} is declared twice or does not start with nicol_")
        self.header.order.append(name)
        table[name] = value

    def struct(self, doc):
        self.take("struct")
        tag = self.take()
        if self.peek() == "*":
            self.take("*")
            name = self.take()
            self.take(";")
            if tag != name + "_impl":
                self.fail(f"the handle {name} points to struct {tag}")
            self.declare(self.header.handles, name, self.doc_after() or doc)
            return
        self.take("{")
        fields = []
        while self.peek() != "}":
            fields += self.field()
        self.take("}")
        self.take(tag)
        self.take(";")
        self.declare(self.header.structs, tag, Struct(tag, fields, doc))

    def field(self):
        doc = self.doc_before()
        base = self.type()
        if self.peek() == "(":  # a callback without a type name
            self.take("(")
            self.take("*")
            name = self.take()
            self.take(")")
            owner = f"nicol_{name}_callback"
            callback = Function(owner, base, self.parameters())
            self.take(";")
            if owner not in self.header.callbacks:
                self.declare(self.header.callbacks, owner, callback)
            elif self.header.callbacks[owner] != callback:
                self.fail(f"two kinds of {owner}")
            return [Variable(name, Type(owner), doc)]
        fields = []
        while True:
            fields.append(self.variable(base))
            if self.take(",", ";") == ";":
                break
            if base.pointers:
                self.fail("two pointers in one declaration")
        doc = self.doc_after() or doc
        for each in fields:
            each.doc = doc
        return fields

    def variable(self, base):
        name, count = self.take(), 0
        if self.peek() == "[":
            self.take("[")
            text = ""
            while self.peek() != "]":
                text += self.take()
            self.take("]")
            count = self.value(text, None)
        return Variable(name, Type(base.base, base.pointers, base.const, count))

    def type(self):
        const = self.peek() == "const" and bool(self.take("const"))
        base = self.take()
        if base not in SCALARS and base not in self.header.order and base != "void":
            self.fail(f"the type {base} is unknown")
        pointers = 0
        while self.peek() in ("*", "const"):
            pointers += self.take("*", "const") == "*"
        return Type(base, pointers, const)

    def parameters(self):
        self.take("(")
        if self.peek() == "void" and self.tokens[self.at + 1][1] == ")":
            self.take("void")
        parameters = []
        while self.peek() != ")":
            parameters.append(self.variable(self.type()))
            if self.peek() == ",":
                self.take(",")
        self.take(")")
        return parameters

    def function(self, doc):
        result = self.type()
        name = self.take()
        return Function(name, result, self.parameters(), doc)

    def alias_or_callback(self, doc):
        base = self.type()
        if self.peek() == "(":
            self.take("(")
            self.take("*")
            name = self.take()
            self.take(")")
            callback = Function(name, base, self.parameters(), doc)
            self.take(";")
            self.declare(self.header.callbacks, name, callback)
        else:
            name = self.take()
            self.take(";")
            self.declare(self.header.aliases, name, base.base)


def read(folder):
    """Returns the declarations of all headers of a folder."""
    header = Header()
    for name in HEADERS:
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            Parser(file.read(), name, header)
    return header
