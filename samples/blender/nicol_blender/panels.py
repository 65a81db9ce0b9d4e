# SPDX-License-Identifier: MIT
"""Panel of the engine's settings, and the export of a scene for nicol-render."""

import bpy
import nicol

from .engine import NicolEngine
from .mitsuba import export
from .read_scene import read_scene, render_size, scene_camera
from .settings import render_options


class NICOL_PT_settings(bpy.types.Panel):
    bl_label = "Nicol"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"
    COMPAT_ENGINES = {NicolEngine.bl_idname}

    @classmethod
    def poll(cls, context) -> bool:
        return context.engine in cls.COMPAT_ENGINES

    def draw(self, context) -> None:
        self.layout.use_property_split = True
        for name in ("method", "samples", "max_depth", "tolerance", "polarizer_angle", "show", "stokes_path"):
            self.layout.prop(context.scene.nicol, name)
        self.layout.operator(NICOL_OT_export.bl_idname)


class NICOL_OT_export(bpy.types.Operator):
    """Writes the scene for nicol-render and Mitsuba 3: an XML file, with meshes and images beside it"""

    bl_idname = "nicol.export"
    bl_label = "Export for nicol-render"

    filepath: bpy.props.StringProperty(subtype="FILE_PATH")
    filter_glob: bpy.props.StringProperty(default="*.xml", options={"HIDDEN"})

    def invoke(self, context, event):
        self.filepath = self.filepath or bpy.path.ensure_ext(bpy.data.filepath.removesuffix(".blend") or "scene", ".xml")
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        depsgraph = context.evaluated_depsgraph_get()
        size = render_size(depsgraph.scene)
        try:
            description = read_scene(depsgraph)
            camera, options = scene_camera(depsgraph, size), render_options(context.scene.nicol)
            export(description, camera, size, options, bpy.path.abspath(self.filepath))
        except (nicol.Error, ValueError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for text in description.notices:
            self.report({"WARNING"}, text)
        return {"FINISHED"}


_CLASSES = (NICOL_OT_export, NICOL_PT_settings)


def register() -> None:
    for each in _CLASSES:
        bpy.utils.register_class(each)


def unregister() -> None:
    for each in reversed(_CLASSES):
        bpy.utils.unregister_class(each)
