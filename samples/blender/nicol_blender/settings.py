# SPDX-License-Identifier: MIT
"""Settings of the engine, kept with each of Blender's scenes as scene.nicol."""

import bpy
import nicol

_METHODS = (
    ("FACTORED", "Real time", "Harmonics at vertices, sharp shadows and mirrors by rays"),
    ("REFERENCE", "Reference", "Paths by rays: slow, noisy and right in the mean"),
)
SHOWN = (
    ("s0", "s0", "Brightness"),
    ("polarizer", "Polarizer", "Brightness behind an ideal polarizer"),
    ("dolp", "DoLP", "Degree of linear polarization"),
    ("aolp", "AoLP", "Angle of linear polarization by colour, as bright as the degree"),
)


class NicolSettings(bpy.types.PropertyGroup):
    method: bpy.props.EnumProperty(name="Method", items=_METHODS)
    samples: bpy.props.IntProperty(name="Samples", description="Samples of a pixel", default=8, min=1, max=1024)
    max_depth: bpy.props.IntProperty(
        name="Max Depth", description="Segments of a path from the camera to a light: 2 is direct light; -1 sets no limit",
        default=4, min=-1, max=64,
    )  # fmt: skip
    tolerance: bpy.props.FloatProperty(
        name="Tolerance", description="Error of the harmonics, relative to the image, for which their orders are chosen",
        default=0.03, min=0.001, max=0.5, precision=3,
    )  # fmt: skip
    polarizer_angle: bpy.props.FloatProperty(
        name="Polarizer", description="Angle of the polarizer, counter-clockwise from the image's right", subtype="ANGLE"
    )
    show: bpy.props.EnumProperty(name="Viewport", description="What the viewport shows", items=SHOWN)
    stokes_path: bpy.props.StringProperty(
        name="Stokes EXR", description="File to which each render writes its Stokes image; # becomes the frame's number",
        subtype="FILE_PATH",
    )  # fmt: skip


# Functions, because a PropertyGroup with methods crashes the module bpy 4.2 when Python ends.
def render_options(settings: NicolSettings) -> nicol.RenderOptions:
    """Returns the options of a final render."""
    options = nicol.RenderOptions(
        method=settings.method.lower(), max_depth=2 if settings.max_depth in (0, 1) else settings.max_depth,
        tolerance=round(settings.tolerance, 6), pixel_samples=settings.samples,
    )  # fmt: skip
    if settings.method == "REFERENCE":
        options.samples = settings.samples
    options.aovs = nicol.AOV_DEPTH | nicol.AOV_NORMAL | nicol.AOV_ALPHA
    return options


def view_options() -> nicol.RenderOptions:
    """Returns the options of a viewport, whose frames come fast and improve while nothing moves."""
    return nicol.RenderOptions(bake_budget_ms=200, max_depth=2)


def register() -> None:
    bpy.utils.register_class(NicolSettings)
    bpy.types.Scene.nicol = bpy.props.PointerProperty(type=NicolSettings)


def unregister() -> None:
    del bpy.types.Scene.nicol
    bpy.utils.unregister_class(NicolSettings)
