# SPDX-License-Identifier: MIT
"""A beetle whose cuticle reflects left circular light alone, as that of rose chafers does. A right circular polarizer, shown in
place of a linear one, leaves only what the clear outer layer reflects.

The cuticle is a table in the form of measured materials: layers whose direction turns with depth (a cholesteric structure)
reflect one handedness around the wavelength that fits their pitch, which moves to blue as the angle grows. Over them lies a clear layer.
"""

import os
import struct
import sys
import tempfile

import nicol
import numpy as np
import shapes

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "assets"))

import make_meshes as surfaces  # noqa: E402

WAVELENGTHS = np.arange(420, 701, 40)  # nm
PITCH, WIDTH = 585.0, 62.0  # nm: wavelength reflected along the normal, and the width of the band
ROUGHNESS, INDEX = 0.17, 1.56


def cuticle(theta_h, theta_d, phi_d):
    """Returns Mueller matrices [phi_d][theta_d][theta_h][wavelength][4][4], 1/sr, and NaN below the surface."""
    phi, d, h = np.meshgrid(phi_d, theta_d, theta_h, indexing="ij")
    half = np.stack([np.sin(h), 0 * h, np.cos(h)], -1)
    across = np.array([0.0, 1.0, 0.0])
    tangent = np.cross(across, half)
    side = np.sin(d)[..., None] * (np.cos(phi)[..., None] * tangent + np.sin(phi)[..., None] * across)
    z_light, z_viewer = ((np.cos(d)[..., None] * half + sign * side)[..., 2] for sign in (1, -1))
    there = (z_light > 0.02) & (z_viewer > 0.02)
    a2 = ROUGHNESS**2
    lobe = a2 / (np.pi * (np.cos(h) ** 2 * (a2 - 1) + 1) ** 2)
    for z in (np.where(there, z_light, 1), np.where(there, z_viewer, 1)):
        lobe = lobe / (z + np.sqrt(a2 + (1 - a2) * z * z))
    cosine, inside = np.cos(d), np.sqrt(1 - (np.sin(d) / INDEX) ** 2)
    rs = (cosine - INDEX * inside) / (cosine + INDEX * inside)
    rp = (INDEX * cosine - inside) / (INDEX * cosine + inside)
    mean, split, both = (rs * rs + rp * rp) / 2, (rs * rs - rp * rp) / 2, rs * rp
    matrices = np.zeros((*h.shape, len(WAVELENGTHS), 4, 4))
    for (row, column), value in {(0, 0): mean, (1, 1): mean, (0, 1): split, (1, 0): split, (2, 2): both, (3, 3): both}.items():
        matrices[..., row, column] += (lobe * value)[..., None]
    # A reflector of left circular light: what it reflects is left circular again.
    band = np.exp(-(((WAVELENGTHS - PITCH * inside[..., None]) / WIDTH) ** 2))
    left = 0.45 * (lobe * (1 - mean) ** 2)[..., None] * band
    for (row, column), sign in {(0, 0): 1, (0, 3): -1, (3, 0): -1, (3, 3): 1}.items():
        matrices[..., row, column] += sign * left
    matrices[..., 0, 0] += 0.008 / np.pi
    matrices[~there] = np.nan
    return matrices.astype(np.float32)


def write_table(path):
    """Writes the cuticle as a .pbsdf file."""
    theta_h = np.pi / 2 * np.linspace(0, 1, 48) ** 2
    theta_d = np.linspace(0, np.pi / 2, 31)
    phi_d = np.linspace(-np.pi, np.pi, 25)
    fields = {"theta_h": theta_h[None], "theta_d": theta_d[None], "phi_d": phi_d[None], "wvls": WAVELENGTHS[None],
              "M": cuticle(theta_h, theta_d, phi_d)}  # fmt: skip
    at = 18 + sum(2 + len(name) + 11 + 8 * values.ndim for name, values in fields.items())
    head, body = b"tensor_file\0" + struct.pack("<BBI", 1, 0, len(fields)), b""
    for name, values in fields.items():
        kind, form = (3, "<u2") if name == "wvls" else (10, "<f4")
        head += struct.pack("<H", len(name)) + name.encode() + struct.pack("<HBQ", values.ndim, kind, at + len(body))
        head += struct.pack(f"<{values.ndim}Q", *values.shape)
        body += values.astype(form).tobytes()
    with open(path, "wb") as file:
        file.write(head + body)


def halves(p, wing):
    """Returns the distance to the body: wing cases with a seam, the shield before them, and the head."""
    x, y, z = np.moveaxis(p, -1, 0)
    case = np.sqrt((x / 1.32) ** 2 + ((y - 0.1) / 0.72) ** 2 + (z / 0.86) ** 2) - 1
    ribs = 0.012 * np.cos(26 * z / np.maximum(1.02 - 0.35 * x * x, 0.3)) * np.clip(1 - (x / 1.2) ** 4, 0, 1)
    case = case * 0.72 + ribs + 0.05 * np.exp(-((z / 0.025) ** 2)) * (y > 0)
    shield = (np.sqrt(((x + 1.28) / 0.5) ** 2 + ((y - 0.06) / 0.5) ** 2 + (z / 0.68) ** 2) - 1) * 0.45
    head = (np.sqrt(((x + 1.78) / 0.3) ** 2 + ((y + 0.05) / 0.26) ** 2 + (z / 0.36) ** 2) - 1) * 0.25
    return np.minimum(np.minimum(case, shield), head) if wing else case


def legs(p):
    out = np.full(p.shape[:-1], 9.0)
    for side in (-1, 1):
        for root, knee, foot, claw in (
            ((-1.2, -0.2, 0.5), (-1.65, 0.12, 1.05), (-2.0, -0.42, 1.35), (-2.3, -0.5, 1.45)),
            ((-0.5, -0.3, 0.7), (-0.45, 0.15, 1.4), (-0.5, -0.42, 1.85), (-0.65, -0.5, 2.15)),
            ((0.4, -0.3, 0.7), (0.9, 0.15, 1.3), (1.35, -0.42, 1.7), (1.6, -0.5, 1.95)),
        ):
            turn = np.array([1, 1, side])
            radii = 0.11, 0.085, 0.05, 0.03
            points = [(*(np.array(q) * turn), r) for q, r in zip((root, knee, foot, claw), radii)]
            out = np.minimum(out, surfaces.chain(p, points, 0.03))
        feeler = [(-1.95, 0.05, 0.2 * side, 0.035), (-2.2, 0.25, 0.5 * side, 0.025), (-2.35, 0.2, 0.85 * side, 0.055)]
        out = np.minimum(out, surfaces.chain(p, feeler, 0.02))
        out = np.minimum(out, np.linalg.norm(p - np.array([-1.86, 0.04, 0.27 * side]), axis=-1) - 0.09)
    return out


def mesh(context, field, low, high, spacing):
    vertices, quads = surfaces.surface_net(field, low, high, spacing)
    vertices = surfaces.project(field, vertices, 4)
    vertices, triangles = surfaces.without_slivers(vertices, surfaces.triangles_of(vertices, quads), 0.3 * spacing)
    return nicol.Mesh.create(context, nicol.mesh_data(vertices, triangles))


def leaf(context):
    u, v = np.meshgrid(np.linspace(-1, 1, 90), np.linspace(-1, 1, 60))
    x, z = 4.6 * u, 2.3 * v * (1 - np.abs(u) ** 3) ** 0.7
    y = -0.62 - 0.055 * x**2 * 0.35 - 0.1 * np.exp(-((z / 0.07) ** 2)) - 0.05 * z**2
    y += 0.028 * np.abs(np.sin(7.5 * (0.55 * x - 0.7 * np.abs(z)))) ** 0.5
    return shapes.sheet(context, np.stack([x, y, -z], -1))


def make_view(context):
    scene = nicol.Scene.create(context)
    light = [
        ((0.2, 1.0, 0.5), 70, 60, (3.6, 3.6, 3.5)), ((-1, 0.5, 0.6), 40, 50, (2.2, 2.3, 2.6)), ((1, 0.3, -0.4), 30, 60, (2.0, 1.8, 1.4)),
        ((0, 0.1, -1), 120, 40, (0.25, 0.35, 0.15)),
    ]  # fmt: skip
    scene.set_environment(shapes.studio(context, light, ambient=0.12), None, 1)
    with tempfile.TemporaryDirectory() as folder:
        table = os.path.join(folder, "cuticle.pbsdf")
        write_table(table)
        shell = nicol.Material.load_measured(context, table)
    horn = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.02, 0.012, 0.008], alpha=0.15))
    green = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.06, 0.16, 0.02], alpha=0.3))
    green = nicol.Material.create_twosided(context, green)
    shapes.add(scene, mesh(context, lambda p: halves(p, True), (-2.2, -0.8, -1.0), (1.5, 1.0, 1.0), 0.032), shell)
    shapes.add(scene, mesh(context, legs, (-2.55, -0.7, -2.3), (1.8, 0.4, 2.3), 0.035), horn)
    shapes.add(scene, leaf(context), green)
    camera = nicol.Camera(fov=40).look_at((-3.2, 3.7, 5.8), (-0.3, -0.2, 0.05), (0, 1, 0))
    return shapes.View(scene, camera, polarizer=0, exposure=0.2, circular=1)
