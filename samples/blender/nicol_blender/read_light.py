# SPDX-License-Identifier: MIT
"""Reads Blender's lights and world.

Blender's watts become radiance as in its renderer Cycles: a point of W watts has the intensity W / (4 pi), an area the radiance
W / (pi area).
"""

from __future__ import annotations

import math

import numpy

from .description import Instance, Light, Material, Mesh, Scene, Sky, Surface, World
from .read_image import decoded, has_pixels, pixels_of

# From Blender's axes (z up) to Nicol's (y up).
AXES = numpy.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
_BACKWARDS = numpy.diag([-1.0, 1, -1, 1])  # Blender's lights shine along -z
_SIDES_OF_DISK = 64


def _placed(matrix) -> numpy.ndarray:
    """Returns rotation and translation of a light, whose scale has no effect."""
    placed = AXES @ numpy.array(matrix.normalized())
    if numpy.linalg.det(placed[:3, :3]) < 0:
        placed[:3, 0] *= -1
    return placed


def read_light(light, matrix, key: tuple, scene: Scene) -> None:
    """Adds a light to the scene: as a light, or, of an area, as a surface that emits."""
    where = f"light {light.name}"
    if light.use_nodes and any(node.type not in ("OUTPUT_LIGHT", "EMISSION") for node in light.node_tree.nodes):
        scene.notice(f"{where}: its nodes are not followed")
    power = [light.energy * 2 ** getattr(light, "exposure", 0) * x for x in light.color]  # exposure since Blender 4.4
    to_world = _placed(matrix) @ _BACKWARDS
    if light.type == "AREA":
        scene.instances.append(_area(light, power, matrix, key))
    elif light.type == "SUN":
        scene.lights.append(
            Light("directional", tuple(power), to_world, angular_radius=min(90.0, math.degrees(light.angle) / 2))
        )
    else:
        if light.shadow_soft_size > 0:
            scene.notice(f"{where}: its radius is not followed, so that its shadows have sharp edges")
        intensity = tuple(x / (4 * math.pi) for x in power)
        if light.type == "POINT":
            scene.lights.append(Light("point", intensity, to_world))
            return
        cutoff = max(0.01, math.degrees(light.spot_size) / 2)
        edge = math.cos(math.radians(cutoff))
        beam = math.degrees(math.acos(min(1.0, edge + (1 - edge) * light.spot_blend)))
        scene.lights.append(Light("spot", intensity, to_world, cutoff_angle=cutoff, beam_width=min(beam, cutoff)))


def _area(light, power, matrix, key: tuple) -> Instance:
    """Returns a surface in the plane z = 0 that emits along -z."""
    x = light.size
    y = light.size_y if light.shape in ("RECTANGLE", "ELLIPSE") else x
    if light.shape in ("DISK", "ELLIPSE"):
        angles = numpy.arange(_SIDES_OF_DISK) * (-2 * math.pi / _SIDES_OF_DISK)
        outline = numpy.stack([numpy.cos(angles), numpy.sin(angles)], 1) / 2
    else:
        outline = numpy.array([[-0.5, -0.5], [-0.5, 0.5], [0.5, 0.5], [0.5, -0.5]])
    positions = numpy.zeros((len(outline), 3), numpy.float32)
    positions[:, :2] = outline * (x, y)
    order = numpy.arange(1, len(outline) - 1)
    faces = numpy.stack([numpy.zeros_like(order), order, order + 1], 1).astype(numpy.uint32)
    normals = numpy.tile(numpy.array([0, 0, -1], numpy.float32), (len(outline), 1))
    # A light's watts are those of its size after scaling.
    scale = matrix.to_scale()
    area = max(x * y * abs(scale[0] * scale[1]) * (math.pi / 4 if light.shape in ("DISK", "ELLIPSE") else 1), 1e-12)
    surface = Surface(Material("diffuse", {"reflectance": (0.0,) * 3}), tuple(p / (math.pi * area) for p in power), False)
    return Instance(key, Mesh(positions, normals, None, faces), surface, AXES @ numpy.array(matrix))


def read_world(world, scene: Scene) -> None:
    """Sets the light from all around."""
    if world is None:
        return
    if not world.use_nodes:
        scene.world = World(tuple(world.color))
        return
    output = next((node for node in world.node_tree.nodes if node.type == "OUTPUT_WORLD" and node.is_active_output), None)
    if output is None or not output.inputs["Surface"].is_linked:
        return
    node = output.inputs["Surface"].links[0].from_node
    if node.type != "BACKGROUND":
        scene.notice(f"world {world.name}: the node {node.name} is not followed, the world is dark")
        return
    if node.inputs["Strength"].is_linked:
        scene.notice(f"world {world.name}: what is linked to Strength is not followed, its value is taken")
    color, scale = node.inputs["Color"], float(node.inputs["Strength"].default_value)
    source = color.links[0].from_node if color.is_linked else None
    if source is not None and source.type == "TEX_ENVIRONMENT":
        _environment_image(source, scale, scene)
    elif source is not None and source.type == "TEX_SKY":
        scene.notice(f"world {world.name}: the Sky Texture becomes Nicol's clear sky, without the sun's disc")
        scene.world = World(_sky(source), scale)
    else:
        if source is not None:
            scene.notice(f"world {world.name}: the node {source.name} is not followed, the socket's colour is taken")
        scene.world = World(tuple(color.default_value[:3]), scale)


def _sky(node) -> Sky:
    if node.sky_type in ("PREETHAM", "HOSEK_WILKIE"):
        sun, turbidity = tuple(node.sun_direction), min(max(node.turbidity, 1.7), 10)
    else:
        # Blender turns the sun clockwise from +y, seen from above.
        flat = math.cos(node.sun_elevation)
        sun = (flat * math.sin(node.sun_rotation), flat * math.cos(node.sun_rotation), math.sin(node.sun_elevation))
        turbidity = 2.5
    return Sky(tuple(AXES[:3, :3] @ (sun[0], sun[1], max(sun[2], 0.0))), turbidity)


def _environment_image(node, scale: float, scene: Scene) -> None:
    where = f"world, {node.name}"
    if not has_pixels(node.image, scene, where):
        return
    if node.projection != "EQUIRECTANGULAR":
        scene.notice(f"{where}: the projection {node.projection} is taken as EQUIRECTANGULAR")
    pixels = decoded(pixels_of(node.image))[..., :3]
    if pixels.shape[2] == 1:
        pixels = numpy.repeat(pixels, 3, 2)
    pixels = numpy.ascontiguousarray(numpy.clip(pixels, 0, None))
    # The image's middle, quarter and top are Nicol's z, x and y, and Blender's x, y and z.
    turn = numpy.array([[0.0, 0, 1, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    scene.world = World(pixels, scale, AXES @ _rotation(node, scene, where) @ turn)


def _rotation(node, scene: Scene, where: str) -> numpy.ndarray:
    """Returns the rotation of the environment by the Mapping node before it."""
    vector = node.inputs["Vector"]
    if not vector.is_linked:
        return numpy.eye(4)
    source = vector.links[0].from_node
    if source.type == "TEX_COORD" and vector.links[0].from_socket.name == "Generated":
        return numpy.eye(4)
    if source.type != "MAPPING" or source.inputs["Rotation"].is_linked:
        scene.notice(f"{where}: coordinates from {source.name} are not followed")
        return numpy.eye(4)
    from mathutils import Euler  # Blender's own

    if tuple(source.inputs["Scale"].default_value) != (1, 1, 1) or any(source.inputs.get("Location").default_value):
        scene.notice(f"{where}: Mapping's Location and Scale are not followed")
    rotation = numpy.array(Euler(source.inputs["Rotation"].default_value).to_matrix().to_4x4())
    # Mapping rotates the directions with which the image is looked up, Texture by the inverse.
    return rotation if source.vector_type == "TEXTURE" else rotation.T
