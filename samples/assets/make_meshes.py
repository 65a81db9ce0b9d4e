#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the meshes of the demonstration: snail.ply and plinth.ply. usage: make_meshes.py [FOLDER]

The snail is a signed distance field: a tube along a logarithmic spiral, and a body of cones with round ends. Surface nets
give it vertices, which are then spread evenly over the surface. The snail faces -x, stands on y = 0 and is two units high.
The script needs only numpy, and writes the same files each time.
"""

import os
import sys

import numpy as np

SPACING = 0.034  # cell size of the grid on which the field is sampled


def smooth_min(a, b, radius):
    """Returns the smaller of both, rounded if they are within `radius` of each other."""
    blend = np.maximum(radius - np.abs(a - b), 0) / radius
    return np.minimum(a, b) - blend**3 * radius / 6


def round_cone(p, a, b, radius_a, radius_b):
    """Returns the distance to a cone from a to b with round ends, to first order of its slope."""
    a, b = np.asarray(a), np.asarray(b)
    along = b - a
    t = np.clip((p - a) @ along / (along @ along), 0, 1)
    return np.linalg.norm(p - a - t[..., None] * along, axis=-1) - (radius_a + t * (radius_b - radius_a))


def chain(p, points, radius):
    """Returns the distance to cones through points (x, y, z, r), joined smoothly."""
    d = np.full(p.shape[:-1], 9.0)
    for a, b in zip(points, points[1:]):
        d = smooth_min(d, round_cone(p, a[:3], b[:3], a[3], b[3]), radius)
    return d


def shell(p):
    """Returns the distance to whorls of a tube whose size and distance from the axis grow equally. The axis is z, tilted
    towards the viewer."""
    end, growth, size, ratio, height = np.radians(112), np.log(2.05) / (2 * np.pi), 0.70, 0.47, 0.62
    center = np.array([0.22, 1.14, 0.0])
    tilt, yaw = np.radians(-14), np.radians(-12)
    q = p - center
    y = q[..., 1] * np.cos(tilt) - q[..., 2] * np.sin(tilt)
    z = q[..., 1] * np.sin(tilt) + q[..., 2] * np.cos(tilt)
    x, z = q[..., 0] * np.cos(yaw) - z * np.sin(yaw), q[..., 0] * np.sin(yaw) + z * np.cos(yaw)
    rho, angle = np.hypot(x, y), np.arctan2(-y, x)
    angle = np.where(angle > end, angle - 2 * np.pi, angle)

    def tube(phi):
        r = size * np.exp(growth * (phi - end))
        return r, ratio * r, height * (size - r) - 0.12

    # The last turn ends in half a ball, inside the body.
    r, a, axial = tube(end)
    d = np.sqrt((x - r * np.cos(end)) ** 2 + (y + r * np.sin(end)) ** 2 + (z - axial) ** 2) - a
    for turn in range(6):
        phi = angle - 2 * np.pi * turn
        r, a, axial = tube(phi)
        # Growth lines need a sufficiently fine grid.
        a = a * (1 + 0.022 * np.clip((a - 0.07) / 0.08, 0, 1) * np.cos(34 * phi))
        d = smooth_min(d, np.hypot(rho - r, z - axial) - a, 0.07)
    return d


def snail(p):
    body = chain(
        p,
        [
            (1.50, 0.05, -0.16, 0.06),
            (1.05, 0.12, -0.06, 0.14),
            (0.50, 0.22, 0.0, 0.24),
            (-0.10, 0.30, 0.0, 0.29),
            (-0.60, 0.36, 0.02, 0.27),
            (-0.95, 0.62, 0.07, 0.22),
            (-1.13, 0.92, 0.14, 0.19),
            (-1.27, 1.10, 0.20, 0.185),
        ],
        0.12,
    )
    flat = p * [1, 2.4, 1]
    foot = chain(
        flat,
        [
            (1.56, 0.10, -0.17, 0.14),
            (1.0, 0.12, -0.06, 0.28),
            (0.2, 0.14, 0.0, 0.40),
            (-0.55, 0.14, 0.02, 0.38),
            (-0.86, 0.16, 0.05, 0.26),
        ],
        0.1,
    )
    body = smooth_min(body, foot / 1.8, 0.2)
    for side in (-1, 1):
        root = np.array([-1.31, 1.17, 0.21]) + side * np.array([0.03, 0, 0.09])
        middle = root + [-0.12, 0.27, 0.03 + 0.09 * side]
        tip = middle + [-0.04, 0.25, 0.01 + 0.08 * side]
        stalk = chain(p, [(*root, 0.065), (*middle, 0.05), (*tip, 0.048)], 0.03)
        stalk = smooth_min(stalk, np.linalg.norm(p - tip, axis=-1) - 0.082, 0.05)
        body = smooth_min(body, stalk, 0.07)
        feeler = root + [-0.11, -0.12, -0.01 * side]
        body = smooth_min(body, round_cone(p, feeler, feeler + [-0.20, -0.07, 0.02 + 0.06 * side], 0.05, 0.042), 0.06)
    whole = smooth_min(body, shell(p), 0.09)
    return -smooth_min(-whole, p[..., 1], 0.03)  # flat below


def gradient(field, p, step=1e-3):
    axes = np.eye(3) * step
    return np.stack([field(p + axis) - field(p - axis) for axis in axes], axis=-1) / (2 * step)


def project(field, p, times):
    """Applies Newton's method along the gradient."""
    for _ in range(times):
        g = gradient(field, p)
        p = p - np.clip(field(p) / np.maximum((g * g).sum(-1), 0.05), -SPACING, SPACING)[:, None] * g
    return p


def surface_net(field, low, high, spacing):
    """Makes one vertex per grid cell that the surface crosses, and one quadrilateral per crossing edge."""
    axes = [np.arange(a, b, spacing) for a, b in zip(low, high)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    inside = field(points) < 0
    count = np.zeros([n - 1 for n in inside.shape], int)
    for corner in np.ndindex(2, 2, 2):
        count += inside[tuple(slice(c, n - 1 + c) for c, n in zip(corner, inside.shape))]
    crossed = (count > 0) & (count < 8)
    index = np.full(crossed.shape, -1)
    index[crossed] = np.arange(crossed.sum())
    vertices = points[:-1, :-1, :-1][crossed] + spacing / 2
    quads = []
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        ahead = np.moveaxis(inside, (axis, b, c), (0, 1, 2))
        cells = np.moveaxis(index, (axis, b, c), (0, 1, 2))
        leaves = ahead[:-1, 1:-1, 1:-1].astype(int) - ahead[1:, 1:-1, 1:-1]
        quad = np.stack([cells[:, :-1, :-1], cells[:, 1:, :-1], cells[:, 1:, 1:], cells[:, :-1, 1:]], axis=-1)
        quads += [quad[leaves == 1], quad[leaves == -1][:, ::-1]]
    return vertices, np.concatenate(quads)


def relax(field, vertices, quads, times):
    """Moves vertices towards the mean of their neighbours, along the surface."""
    edges = np.concatenate([quads[:, [i, (i + 1) % 4]] for i in range(4)])
    edges = np.unique(np.sort(edges, axis=1), axis=0)
    a, b = np.concatenate([edges, edges[:, ::-1]]).T
    number = np.bincount(a, minlength=len(vertices))[:, None]
    for _ in range(times):
        mean = np.stack([np.bincount(a, vertices[b, i], len(vertices)) for i in range(3)], axis=-1) / number
        vertices = project(field, vertices + 0.6 * (mean - vertices), 1)
    # In sharp grooves the projection may fold a triangle over, so the mean of the neighbours is used there.
    for _ in range(6):
        triangles = triangles_of(vertices, quads)
        corner = vertices[triangles]
        normals = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
        outward = gradient(field, corner.mean(axis=1))
        lengths = np.linalg.norm(normals, axis=1) * np.linalg.norm(outward, axis=1)
        near = np.zeros(len(vertices), bool)
        near[triangles[(normals * outward).sum(-1) < 0.5 * lengths]] = True
        near[a[near[b]]] = True
        for _ in range(8):
            mean = np.stack([np.bincount(a, vertices[b, i], len(vertices)) for i in range(3)], axis=-1) / number
            vertices[near] = mean[near]
    return vertices


def triangles_of(vertices, quads):
    """Cuts each quadrilateral along its shorter diagonal."""
    corner = vertices[quads]
    first = np.linalg.norm(corner[:, 0] - corner[:, 2], axis=1) <= np.linalg.norm(corner[:, 1] - corner[:, 3], axis=1)
    cuts = np.where(first[:, None, None], [[[0, 1, 2], [0, 2, 3]]], [[[0, 1, 3], [1, 2, 3]]])
    return np.take_along_axis(quads[:, None, :].repeat(2, 1), cuts, axis=2).reshape(-1, 3)


def without_slivers(vertices, triangles, shortest):
    """Joins the ends of edges below `shortest`, and drops triangles that this leaves without area or back to back."""
    edges = np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)])
    short = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1) < shortest
    target = np.arange(len(vertices))
    for a, b in np.sort(edges[short], axis=1):
        target[target == target[b]] = target[a]
    triangles = target[triangles]
    distinct = np.sort(triangles, axis=1)
    triangles = triangles[(distinct[:, 0] < distinct[:, 1]) & (distinct[:, 1] < distinct[:, 2])]
    _, first, count = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True, return_counts=True)
    triangles = triangles[np.sort(first[count == 1])]
    kept = np.unique(triangles)
    return vertices[kept], np.searchsorted(kept, triangles)


def plinth(radius=2.15, rings=30, bevel=0.07, depth=0.22):
    """Makes a round plate whose top is y = 0: rings of evenly spaced vertices, a round edge, and a side.

    The texture coordinates are x and z on the top; edge and side are unfolded around it."""
    profile = [(radius - bevel) * i / rings for i in range(rings + 1)]
    profile = [(r, 0.0, 6 * i) for i, r in enumerate(profile)]
    around = profile[-1][2]
    for angle in np.radians([18, 36, 54, 72, 90]):
        profile.append((radius - bevel + bevel * np.sin(angle), bevel * (np.cos(angle) - 1), around))
    profile += [(radius, -bevel - (depth - bevel) * t, around) for t in (0.33, 0.67, 1.0)]
    vertices, texcoords, starts = [], [], []
    length, last = 0.0, profile[0]
    for r, y, number in profile:
        starts.append(len(vertices))
        length, last = length + np.hypot(r - last[0], y - last[1]), (r, y)
        angles = 2 * np.pi * np.arange(max(number, 1)) / max(number, 1)
        vertices += [(r * np.cos(a), y, r * np.sin(a)) for a in angles]
        texcoords += [(length * np.cos(a), length * np.sin(a)) for a in angles]
    faces = []
    for ring in range(1, len(profile)):
        inner, outer = max(profile[ring - 1][2], 1), profile[ring][2]
        i = o = 0
        while i < (inner if ring > 1 else 0) or o < outer:
            here = starts[ring - 1] + i % inner, starts[ring] + o % outer
            if i == inner or ring == 1 or (o + 0.5) * inner <= (i + 0.5) * outer and o < outer:
                faces.append((here[0], starts[ring] + (o + 1) % outer, here[1]))
                o += 1
            else:
                faces.append((here[0], starts[ring - 1] + (i + 1) % inner, here[1]))
                i += 1
    return np.array(vertices), np.array(faces), np.array(texcoords)


def write_ply(path, vertices, faces, texcoords=None):
    """Writes binary PLY with positions as floats. Readers make smooth normals."""
    head = (
        "ply\nformat binary_little_endian 1.0\ncomment made by make_meshes.py\n"
        f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
    )
    if texcoords is not None:
        head += "property float s\nproperty float t\n"
        vertices = np.hstack([vertices, texcoords])
    head += (
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.empty(len(faces), [("n", "u1"), ("i", "<i4", 3)])
    rows["n"], rows["i"] = 3, faces
    with open(path, "wb") as file:
        file.write(head.encode() + vertices.astype("<f4").tobytes() + rows.tobytes())
    print(f"{path}: {len(vertices)} vertices, {len(faces)} triangles")


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    vertices, quads = surface_net(snail, (-2.0, -0.08, -0.9), (1.9, 2.35, 1.1), SPACING)
    vertices = relax(snail, project(snail, vertices, 4), quads, 12)
    write_ply(os.path.join(folder, "snail.ply"), *without_slivers(vertices, triangles_of(vertices, quads), 0.4 * SPACING))
    write_ply(os.path.join(folder, "plinth.ply"), *plinth())


if __name__ == "__main__":
    main()
