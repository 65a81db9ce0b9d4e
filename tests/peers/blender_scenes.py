# SPDX-License-Identifier: MIT
"""Scenes of Blender for the test of the add-on, and the passes of their renders as arrays."""

import math
import os
import tempfile

import bpy
import images
import nicol_blender
import numpy

SIZE = (48, 36)


def srgb_image(name, pixels, raw=False, is_float=False):
    """Returns a new image of Blender of (height, width, 3) numbers, first row at the top."""
    height, width, _ = pixels.shape
    image = bpy.data.images.new(name, width, height, float_buffer=is_float, is_data=raw)
    rgba = numpy.ones((height, width, 4), "f")
    rgba[..., :3] = pixels[::-1]
    image.pixels.foreach_set(rgba.ravel())
    return image


def principled(name, **values):
    """Returns a Principled material; names have underscores for blanks, an image is linked as a texture."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    node = tree.nodes["Principled BSDF"]
    for key, value in values.items():
        socket = node.inputs[key.replace("_", " ")]
        if isinstance(value, bpy.types.Image):
            texture = tree.nodes.new("ShaderNodeTexImage")
            texture.image = value
            tree.links.new(texture.outputs["Color"], socket)
        else:
            socket.default_value = (*value, 1) if isinstance(value, tuple) else value
    return material


def add(kind, material=None, **where):
    getattr(bpy.ops.mesh, f"primitive_{kind}_add")(**where)
    thing = bpy.context.object
    if material:
        thing.data.materials.append(material)
    return thing


def add_light(kind, energy, location=(0, 0, 3), rotation=(0, 0, 0), **fields):
    data = bpy.data.lights.new(kind, kind)
    data.energy = energy
    for name, value in fields.items():
        setattr(data, name, value)
    thing = bpy.data.objects.new(kind, data)
    thing.location, thing.rotation_euler = location, rotation
    bpy.context.collection.objects.link(thing)
    return thing


def add_camera(location, rotation, **fields):
    data = bpy.data.cameras.new("camera")
    for name, value in fields.items():
        setattr(data, name, value)
    thing = bpy.data.objects.new("camera", data)
    thing.location, thing.rotation_euler = location, rotation
    bpy.context.collection.objects.link(thing)
    bpy.context.scene.camera = thing
    return thing


def world(color=(0, 0, 0), strength=1, image=None, turn=0):
    made = bpy.data.worlds.new("world")
    made.use_nodes = True
    node = made.node_tree.nodes["Background"]
    node.inputs["Color"].default_value, node.inputs["Strength"].default_value = (*color, 1), strength
    if image:
        texture, mapping, coordinates = (
            made.node_tree.nodes.new(f"ShaderNode{kind}") for kind in ("TexEnvironment", "Mapping", "TexCoord")
        )
        texture.image = image
        mapping.inputs["Rotation"].default_value[2] = turn
        made.node_tree.links.new(coordinates.outputs["Generated"], mapping.inputs["Vector"])
        made.node_tree.links.new(mapping.outputs["Vector"], texture.inputs["Vector"])
        made.node_tree.links.new(texture.outputs["Color"], node.inputs["Color"])
    bpy.context.scene.world = made


def start():
    """Begins an empty scene for Nicol."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    nicol_blender.register()
    scene = bpy.context.scene
    scene.render.engine = "NICOL"
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    scene.view_settings.view_transform = "Raw"
    scene.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
    scene.render.image_settings.color_depth, scene.render.image_settings.exr_codec = "32", "NONE"
    return scene


def finish():
    nicol_blender.unregister()


def render():
    """Returns channel -> (height, width), as the multilayer file of a render has them."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "render.exr")
        bpy.context.scene.render.filepath = path
        bpy.ops.render.render(write_still=True)
        with open(path, "rb") as file:
            channels = images.read_exr(file.read())
    return {name: numpy.array(numbers, "f").reshape(SIZE[1], SIZE[0]) for name, numbers in channels.items()}


def colors(channels, render_pass):
    return numpy.stack([channels[f"ViewLayer.{render_pass}.{c}"] for c in "RGB"], -1)


def by_cycles(samples=64):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.use_adaptive_sampling = samples, False, False
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BOX", 1
    scene.cycles.max_bounces = 0
    channels = render()
    scene.render.engine = "NICOL"
    return channels


def check_board(colour):
    """Returns an image whose quarters differ, so that no rotation or mirror image of it is equal."""
    pixels = numpy.full((16, 16, 3), 0.1, "f")
    pixels[:8, 8:] = 0.5
    pixels[8:, :8] = colour
    pixels[8:, 8:] = 0.9
    return pixels


def test_scene():
    """Makes a scene of every kind of light and material that is mapped."""
    scene = start()
    floor = principled("floor", Base_Color=srgb_image("board", check_board((0.8, 0.3, 0.1))), Roughness=0.3)
    add("plane", floor, size=8)
    metal = principled("metal", Base_Color=(0.9, 0.6, 0.3), Metallic=1.0, Roughness=0.45, Thin_Film_Thickness=300.0)
    add("uv_sphere", metal, location=(-1, 0, 1), segments=48, ring_count=24)
    bpy.ops.object.shade_smooth()
    normals = numpy.tile(numpy.array([0.6, 0.45, 0.9], "f"), (4, 4, 1))
    rough = principled("plastic", Base_Color=(0.1, 0.3, 0.6), Metallic=0.4, Roughness=0.5, IOR=1.7)
    tree = rough.node_tree
    texture, mapped = tree.nodes.new("ShaderNodeTexImage"), tree.nodes.new("ShaderNodeNormalMap")
    texture.image = srgb_image("normals", normals, raw=True)
    tree.links.new(texture.outputs["Color"], mapped.inputs["Color"])
    tree.links.new(mapped.outputs["Normal"], tree.nodes["Principled BSDF"].inputs["Normal"])
    add("cube", rough, location=(1.2, 0.5, 0.7), rotation=(0.3, 0.2, 0.6), size=1.2)
    add("cube", principled("lamp", Emission_Color=(1, 0.5, 0.2), Emission_Strength=2.0), location=(0.2, -1.6, 0.3), size=0.5)
    add_light("SUN", 1.0, rotation=(0.6, 0.3, 0), angle=math.radians(2))
    add_light("POINT", 80, (1, -2, 3), shadow_soft_size=0)
    add_light("SPOT", 200, (-2, -2, 4), (0.5, -0.3, 0), spot_size=0.9, shadow_soft_size=0)
    add_light("AREA", 60, (0, 2, 3), (-0.5, 0, 0), shape="RECTANGLE", size=1.5, size_y=0.7)
    lobe = numpy.linspace(0.1, 1, 32 * 16 * 3, dtype="f").reshape(16, 32, 3)
    world(image=srgb_image("sky", lobe, is_float=True), strength=0.4, turn=0.8)
    add_camera((0, -6, 3.5), (1.05, 0, 0), lens=40, shift_x=0.05, shift_y=-0.03)
    return scene
