# SPDX-License-Identifier: MIT
"""Data sets: pictures that a recipe describes, by frame number. See samples/dataset/README.md for recipes. Needs numpy.

The program is python3 -m nicol.dataset RECIPE --frames 0:1000 --output DIR."""

from .loader import Dataset
from .recipe import Recipe
from .renderer import Picture, Renderer
from .values import RecipeError

__all__ = ["Dataset", "Picture", "Recipe", "RecipeError", "Renderer"]
