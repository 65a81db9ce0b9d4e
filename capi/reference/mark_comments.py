# SPDX-License-Identifier: MIT
"""Prints a C header with its comments marked for Doxygen, which reads /** and not /*."""

import re
import sys

COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
RULE = re.compile(r"/\* -{10,} (?P<title>.*?) \*/")
FUNCTION = re.compile(r"NICOL_API [\w ]+?\*? ?(?P<name>nicol_\w+)\(")
SHARED = re.compile(r"\n(NICOL_API nicol_result nicol_\w+_(retain|release|init)\()")
# Texts that the header says once, at its top, for every kind of object and struct.
SHARED_TEXTS = {
    "retain": "Adds a reference.",
    "release": "Drops a reference; NULL does nothing.",
    "init": "Sets all fields to their defaults; struct_size is sizeof(the struct).",
}


def lines_of(comment):
    return [re.sub(r"^\s*\* ?", "", line).rstrip() for line in comment[2:-2].split("\n")]


def escaped(text):
    """Without a meaning to Doxygen or Markdown."""
    return re.sub(r"([\\@#<>&*`~|\[\]])", r"\\\1", text)


def preformatted(lines):
    """A comment whose columns stand under each other."""
    text = "\n".join(lines).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return "<pre>" + re.sub(r"([\\@#])", r"\\\1", text) + "</pre>"


def body_of(lines):
    if any(re.match(r" {3,}\S", line) for line in lines[1:]):
        return preformatted(lines)
    # The brief description ends with the first sentence, not with an abbreviation.
    return re.sub(r"\b(Eqs?)\.\s", r"\1.\\ ", "\n".join(linked(line.strip()) for line in lines))


def linked(line):
    """Names of ours stay plain, so that they become links."""
    parts = re.split(r"(\b(?:nicol|NICOL)_\w*[a-zA-Z0-9]\b)", line)
    return "".join(part if at % 2 else escaped(part) for at, part in enumerate(parts))


class Marks:
    def __init__(self):
        self.group = ""

    def mark(self, match):
        text, before = match.group(), match.string[: match.start()]
        rule = RULE.fullmatch(text)
        if rule:
            return self.open(rule["title"])
        if text.startswith(("/* clang-format", "/* SPDX")):
            return ""
        code_before = before[before.rfind("\n") + 1 :].strip() != ""
        if code_before and match.string[match.end() :].lstrip(" ")[:1] != "\n":
            return text
        # After a field, lines are aligned under the first: their indentation says nothing.
        lines = [line.strip() for line in lines_of(text)] if code_before else lines_of(text)
        return ("/**< " if code_before else "/** ") + body_of(lines) + " */"

    def open(self, title):
        close, name = self.close(), re.sub(r"\W+", "_", title)
        self.group = name
        return close + f"/** @defgroup {name} {title.capitalize()}\n@{{ */"

    def close(self):
        return "/** @} */\n" if self.group else ""


def documented(text):
    """A function right below another shares its comment."""
    out, above, last = [], "", ""
    for line in text.split("\n"):
        function = FUNCTION.match(line)
        if function and not above.endswith("*/"):
            if not above.endswith(";"):
                sys.exit(f"{sys.argv[1]}: {function['name']} has no comment")
            out.append(f"/** As @ref {last}() says. */")
        last = function["name"] if function else last
        above = line.rstrip() or above.removesuffix(";")
        out.append(line)
    return "\n".join(out)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        text = file.read()
    marks = Marks()
    text = COMMENT.sub(marks.mark, text)
    text = SHARED.sub(lambda match: f"\n/** {SHARED_TEXTS[match[2]]} */\n{match[1]}", text)
    text = documented(text)
    end = text.rindex("#ifdef __cplusplus")
    print("/** @file */\n" + text[:end] + marks.close() + text[end:])


main()
