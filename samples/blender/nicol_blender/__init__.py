# SPDX-License-Identifier: MIT
"""Nicol for Blender: a render engine whose pixels are Stokes vectors."""

bl_info = {
    "name": "Nicol",
    "description": "Renders polarized light as Stokes images",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "category": "Render",
}


def register():
    from . import engine, panels, settings

    settings.register()
    engine.register()
    panels.register()


def unregister():
    from . import engine, panels, settings

    panels.unregister()
    engine.unregister()
    settings.unregister()
