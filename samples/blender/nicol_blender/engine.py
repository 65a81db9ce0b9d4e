# SPDX-License-Identifier: MIT
"""Render engine "Nicol"."""

from __future__ import annotations

import bpy
import nicol
import numpy

from .read_scene import read_camera, read_scene, render_size, scene_camera
from .settings import render_options, view_options
from .stage import Stage
from .viewport import Viewport

# Passes of a render beside Combined, in red, green and blue. AoLP is in radians, counter-clockwise from the image's right.
PASSES = ("S0", "S1", "S2", "S3", "DoLP", "AoLP", "Polarizer")


class NicolEngine(bpy.types.RenderEngine):
    bl_idname = "NICOL"
    bl_label = "Nicol"
    bl_use_preview = False
    bl_use_shading_nodes_custom = False  # Cycles' nodes

    def update_render_passes(self, scene=None, renderlayer=None) -> None:
        self.register_pass(scene, renderlayer, "Combined", 4, "RGBA", "COLOR")
        for name in PASSES:
            self.register_pass(scene, renderlayer, name, 3, "RGB", "COLOR")

    def render(self, depsgraph) -> None:
        scene = depsgraph.scene
        size = render_size(scene)
        try:
            picture = self._picture(depsgraph, size)
        except (nicol.Error, ValueError) as error:
            if not (isinstance(error, nicol.Error) and error.code == nicol.ERROR_CANCELLED):
                self.report({"ERROR"}, str(error))
            return
        if scene.nicol.stokes_path:
            path = frame_path(scene.nicol.stokes_path, scene.frame_current)
            try:
                picture.save(path)
            except (nicol.Error, ValueError) as error:
                self.report({"ERROR"}, str(error))
        self._hand_over(picture, scene, size)

    def _picture(self, depsgraph, size: tuple[int, int]) -> nicol.Picture:
        if depsgraph.scene.render.use_border:
            self.report({"WARNING"}, "the render region is not followed; the whole picture is rendered")
        camera = scene_camera(depsgraph, size)
        description = read_scene(depsgraph)
        for text in description.notices:
            self.report({"WARNING"}, text)
        stage = Stage(description)
        options = render_options(depsgraph.scene.nicol)
        options.progress = self._progress
        framebuffer = nicol.Framebuffer.create(stage.context, *size, 3)
        nicol.render(stage.scene, camera, options, framebuffer)
        return nicol.Picture(framebuffer)

    def _progress(self, verb: str, fraction: float) -> bool:
        self.update_stats("Nicol", verb)
        self.update_progress(fraction)
        return not self.test_break()

    def _hand_over(self, picture: nicol.Picture, scene, size: tuple[int, int]) -> None:
        planes = {f"S{i}": getattr(picture, f"s{i}") for i in range(4)}
        angle = numpy.degrees(scene.nicol.polarizer_angle)
        planes |= {"DoLP": picture.dolp, "AoLP": picture.aolp, "Polarizer": picture.polarizer(angle)}
        alpha = picture.alpha if scene.render.film_transparent else numpy.ones_like(picture.alpha)
        planes["Combined"] = numpy.dstack([picture.s0, alpha])
        planes |= {"Depth": picture.depth, "Normal": picture.normal}
        for name in PASSES:
            self.add_pass(name, 3, "RGB")
        result = self.begin_result(0, 0, *size)
        for render_pass in result.layers[0].passes:
            if render_pass.name in planes:
                rows = planes[render_pass.name][::-1].reshape(-1, render_pass.channels)
                render_pass.rect = rows.astype(numpy.float32)
        self.end_result(result)

    def view_update(self, context, depsgraph) -> None:
        if not hasattr(self, "viewport"):
            self.viewport = Viewport()
        self.viewport.update(depsgraph)
        for text in self.viewport.notices:
            self.report({"WARNING"}, text)

    def view_draw(self, context, depsgraph) -> None:
        region, view = context.region, context.region_data
        space, settings = context.space_data, depsgraph.scene.nicol
        size = region.width, region.height
        camera = read_camera(view.view_matrix.inverted(), view.window_matrix, size, space.clip_start, space.clip_end)
        shown = self.viewport.picture(camera, size, view_options(), settings.show, settings.polarizer_angle)
        self.bind_display_space_shader(depsgraph.scene)
        draw_pixels(shown, size)
        self.unbind_display_space_shader()
        if self.viewport.improves:
            self.tag_redraw()


def draw_pixels(pixels: numpy.ndarray, size: tuple[int, int]) -> None:
    """Draws (height, width, 4) floats, first row at the bottom, over the whole region."""
    import gpu  # which does not exist without a window
    from gpu_extras.presets import draw_texture_2d

    buffer = gpu.types.Buffer("FLOAT", pixels.size, pixels.ravel())
    texture = gpu.types.GPUTexture(size, format="RGBA16F", data=buffer)
    gpu.state.blend_set("ALPHA_PREMULT")
    draw_texture_2d(texture, (0, 0), *size)
    gpu.state.blend_set("NONE")


def frame_path(path: str, frame: int) -> str:
    """Returns the absolute path in which the last run of # has become the frame's number."""
    path = bpy.path.abspath(path)
    head, marks, tail = path.rpartition("#")
    digits = len(head) - len(head.rstrip("#")) + 1 if marks else 0
    return f"{head.rstrip('#')}{frame:0{digits}d}{tail}" if marks else path


def _panels():
    """Yields Blender's own panels that make sense for this engine: those of its simplest engine, nodes and lights."""
    left_out = {"VIEWLAYER_PT_filter", "VIEWLAYER_PT_layer_passes"}
    nodes_and_lights = {"EEVEE_MATERIAL_PT_context_material", "EEVEE_MATERIAL_PT_surface", "EEVEE_WORLD_PT_surface", "DATA_PT_EEVEE_light"}
    for panel in bpy.types.Panel.__subclasses__():
        engines = getattr(panel, "COMPAT_ENGINES", ())
        if ("BLENDER_RENDER" in engines and panel.__name__ not in left_out) or panel.__name__ in nodes_and_lights:
            yield panel


def register() -> None:
    bpy.utils.register_class(NicolEngine)
    for panel in _panels():
        panel.COMPAT_ENGINES.add(NicolEngine.bl_idname)


def unregister() -> None:
    for panel in _panels():
        panel.COMPAT_ENGINES.discard(NicolEngine.bl_idname)
    bpy.utils.unregister_class(NicolEngine)
