# SPDX-License-Identifier: MIT
"""Reads what Blender would render: meshes, lights, world and camera."""

from __future__ import annotations

import nicol
import numpy

from .description import Instance, Mesh, Scene, Surface
from .read_light import AXES, read_light, read_world
from .read_material import read_material

_UNDRAWN = ("VOLUME", "CURVES", "POINTCLOUD", "GPENCIL", "GREASEPENCIL")


def read_scene(depsgraph) -> Scene:
    """Returns the scene of a dependency graph, which is evaluated for a render or for a viewport."""
    scene = Scene(hide_emitters=depsgraph.scene.render.film_transparent)
    read_world(depsgraph.scene.world, scene)
    parts: dict[int, list[tuple[int, Mesh]]] = {}  # by mesh: material slot and triangles
    surfaces: dict[str, Surface] = {}
    for item in depsgraph.object_instances:
        if not item.show_self:
            continue
        thing, matrix = item.object, item.matrix_world
        key = (thing.name_full, *item.persistent_id) if item.is_instance else (thing.name_full,)
        if thing.type == "LIGHT":
            read_light(thing.data, matrix, key, scene)
        elif thing.type == "MESH" and matrix.determinant() != 0:
            # Curves, text and metaballs come as instances of their meshes as well.
            _add_surfaces(thing, matrix, key, scene, parts, surfaces)
        elif thing.type in _UNDRAWN:
            scene.notice(f"object {thing.name}: what is of the type {thing.type} is not drawn")
    return scene


def _add_surfaces(thing, matrix, key, scene, parts, surfaces) -> None:
    mesh_key = thing.data.as_pointer()
    if mesh_key not in parts:
        parts[mesh_key] = read_mesh(thing.data)
    # Objects may replace the materials of their mesh.
    materials = [slot.material for slot in thing.material_slots] or [None]
    for slot, mesh in parts[mesh_key]:
        material = materials[min(slot, len(materials) - 1)]
        name = material.name_full if material else ""
        if name not in surfaces:
            surfaces[name] = read_material(material, scene)
        scene.instances.append(Instance((*key, slot), mesh, surfaces[name], AXES @ numpy.array(matrix)))


def read_mesh(mesh) -> list[tuple[int, Mesh]]:
    """Returns the triangles of an evaluated mesh by their material slot."""
    mesh.calc_loop_triangles()
    count = len(mesh.loop_triangles)
    if count == 0:
        return []
    loops = _numbers(mesh.loop_triangles, "loops", 3 * count, numpy.int32)
    slots = _numbers(mesh.loop_triangles, "material_index", count, numpy.int32)
    vertices = _numbers(mesh.loops, "vertex_index", len(mesh.loops), numpy.int32)
    positions = _numbers(mesh.vertices, "co", 3 * len(mesh.vertices)).reshape(-1, 3)
    uv = numpy.zeros((len(mesh.loops), 2), numpy.float32)  # Blender's coordinates without a map
    if mesh.uv_layers.active is not None:
        uv = _numbers(mesh.uv_layers.active.data, "uv", 2 * len(mesh.loops)).reshape(-1, 2)
    columns = [positions[vertices], _corner_normals(mesh), numpy.stack([uv[:, 0], 1 - uv[:, 1]], 1)]
    corners = numpy.concatenate(columns, 1)
    loops = loops.reshape(-1, 3)
    return [(int(slot), _merged(corners[loops[slots == slot].ravel()])) for slot in numpy.unique(slots)]


def _corner_normals(mesh) -> numpy.ndarray:
    if hasattr(mesh, "corner_normals"):
        return _numbers(mesh.corner_normals, "vector", 3 * len(mesh.loops)).reshape(-1, 3)
    mesh.calc_normals_split()  # before Blender 4.1
    return _numbers(mesh.loops, "normal", 3 * len(mesh.loops)).reshape(-1, 3)


def _numbers(collection, name: str, count: int, kind=numpy.float32) -> numpy.ndarray:
    numbers = numpy.empty(count, kind)
    collection.foreach_get(name, numbers)
    return numbers


def _merged(corners: numpy.ndarray) -> Mesh:
    """Returns the mesh of the corners of triangles; equal corners become one vertex."""
    rows = numpy.ascontiguousarray(corners + 0.0)  # -0 equals 0
    _, first, faces = numpy.unique(
        rows.view([("", rows.dtype)] * rows.shape[1]).ravel(), return_index=True, return_inverse=True
    )
    # Vertices keep the order in which triangles name them, so that neighbours stay together in memory.
    order = numpy.argsort(first)
    rank = numpy.empty_like(order)
    rank[order] = numpy.arange(len(order))
    rows = rows[first[order]]
    parts = [numpy.ascontiguousarray(rows[:, a:b]) for a, b in ((0, 3), (3, 6), (6, 8))]
    return Mesh(*parts, rank[faces.ravel()].astype(numpy.uint32).reshape(-1, 3))


def read_camera(to_world, projection, size: tuple[int, int], near: float, far: float) -> nicol.Camera:
    """Returns Nicol's camera of a camera's matrix and OpenGL's projection matrix, both of Blender."""
    width, height = size
    to_world = AXES @ numpy.array(to_world)
    to_world[:3, :3] /= numpy.linalg.norm(to_world[:3, :3], axis=0)
    p = numpy.array(projection)
    if p[3][3] == 0:
        fx, fy = p[0][0] * width / 2, p[1][1] * height / 2
        # Blender's numbers have 24 bits: square pixels are square but for their rounding.
        fy = fx if abs(fx - fy) < 1e-5 * fx else fy
        K = [[fx, 0, (1 - p[0][2]) * width / 2], [0, fy, (1 + p[1][2]) * height / 2], [0, 0, 1]]
        camera = nicol.Camera.from_opengl(to_world, K, size)
    else:
        # The image of an orthographic camera reaches from -1 to 1 across its x, and as far up as its pixels do.
        to_middle = numpy.diag([-1 / p[0][0], width / height / p[1][1], -1, 1])
        to_middle[:2, 3] = -p[0][3] / p[0][0], -p[1][3] / p[1][1]
        camera = nicol.Camera(projection=nicol.PROJECTION_ORTHOGRAPHIC, to_world=to_world @ to_middle)
    camera.near_clip, camera.far_clip = near, far
    return camera


def render_size(scene) -> tuple[int, int]:
    """Returns width and height of the scene's renders."""
    share = scene.render.resolution_percentage / 100
    return max(1, int(scene.render.resolution_x * share)), max(1, int(scene.render.resolution_y * share))


def scene_camera(depsgraph, size: tuple[int, int]) -> nicol.Camera:
    """Returns the scene's active camera."""
    scene = depsgraph.scene
    if scene.camera is None:
        raise ValueError("the scene has no active camera")
    camera = scene.camera.evaluated_get(depsgraph)
    if camera.data.type == "PANO":
        raise ValueError(f"camera {camera.name} is panoramic; it must be perspective or orthographic")
    projection = camera.calc_matrix_camera(
        depsgraph, x=size[0], y=size[1], scale_x=scene.render.pixel_aspect_x, scale_y=scene.render.pixel_aspect_y
    )
    return read_camera(camera.matrix_world, projection, size, camera.data.clip_start, camera.data.clip_end)
