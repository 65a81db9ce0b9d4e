# SPDX-License-Identifier: MIT
"""Sphinx's configuration of the documentation site. Its source folder is the repository, so that the READMEs are pages and
their links hold. CMakeLists.txt beside this file runs it."""

import os
import re
import sys

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(REPOSITORY, "samples", "python"))

project = "Nicol"
copyright = "the Nicol authors"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
root_doc = "samples/site/index"
include_patterns = ["README.md", "CHANGELOG.md", "capi/reference/*.md", "samples/**.md", "tests/peers/README.md"]
exclude_patterns = ["build*", ".git", "out", "src", "glsl", "**/node_modules", "**/target"]
myst_heading_anchors = 4
# Blocks of the READMEs name languages that no lexer here knows.
suppress_warnings = ["misc.highlighting_failure"]
highlight_language = "none"

html_theme = "furo"
html_title = "Nicol"
html_extra_path = ["redirect"]
html_static_path = ["style"]
html_css_files = ["site.css"]
html_copy_source = False
autodoc_member_order = "groupwise"
autodoc_typehints = "none"


def escaped(line):
    return re.sub(r"([\\*`|_])", r"\\\1", line)


def fields_of(lines):
    """Returns a list of fields, of lines "name: text" that go on with an indentation."""
    out = []
    for line in lines:
        named = re.match(r"(\w+): (.*)", line)
        if named:
            out.append(f":{named[1]}: {escaped(named[2])}")
        elif out and line.startswith(" "):
            out[-1] += " " + escaped(line.strip())
        else:
            out.append(escaped(line))
    return out


def prepare(app, what, name, obj, options, lines):
    """Docstrings are plain text: their lines stay where they stand under each other, and structs list their fields."""
    at = lines.index("Fields:") if "Fields:" in lines else len(lines)
    text, fields = lines[:at], fields_of(lines[at + 1 :])
    if any(re.match(r" +\S", line) for line in text):
        text = ["::", "", *("   " + line for line in text)]
    else:
        text = [escaped(line) for line in text]
    lines[:] = [*text, "", *fields, ""]


def setup(app):
    app.connect("autodoc-process-docstring", prepare)
