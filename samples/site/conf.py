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


def escaped(app, what, name, obj, options, lines):
    """Docstrings are plain text. Lines that stand under each other stay so."""
    if any(re.match(r" +\S", line) for line in lines):
        lines[:] = ["::", "", *("   " + line for line in lines), ""]
    else:
        lines[:] = [re.sub(r"([\\*`|_])", r"\\\1", line) for line in lines]


def setup(app):
    app.connect("autodoc-process-docstring", escaped)
