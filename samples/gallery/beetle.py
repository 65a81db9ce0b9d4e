# SPDX-License-Identifier: MIT
"""A beetle whose cuticle reflects left circular light alone, as that of rose chafers does. A right circular polarizer, shown in place
of a linear one, leaves only what the clear outer layer reflects.

The cuticle is a function in Python: layers whose direction turns with depth (a cholesteric structure) reflect one handedness around the
wavelength that fits their pitch, which moves to blue as the angle grows; over them lies a smooth clear layer.
"""

import os
import sys

import nicol
import numpy as np
import shapes

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "assets"))

import make_meshes as surfaces  # noqa: E402

WAVELENGTHS = 611.0, 549.0, 464.0  # nm, of red, green and blue
PITCH, WIDTH = 575.0, 75.0  # nm: wavelength reflected along the normal, and the width of the band
ROUGHNESS, INDEX = 0.16, 1.56


def cuticle(channel, towards_light, towards_viewer):
    """Returns the Mueller matrix of one colour channel, row by row, 1/sr."""
    (ax, ay, az), (bx, by, bz) = towards_light, towards_viewer
    hx, hy, hz = ax + bx, ay + by, az + bz
    length = (hx * hx + hy * hy + hz * hz) ** 0.5
    hz /= length
    cosine = (ax * hx + ay * hy) / length + az * hz
    a2 = ROUGHNESS**2
    facets = a2 / (np.pi * (hz * hz * (a2 - 1) + 1) ** 2)
    shadow = 1.0
    for z in (az, bz):
        shadow *= 2 * z / (z + (a2 + (1 - a2) * z * z) ** 0.5)
    lobe = facets * shadow / (4 * az * bz)
    inside = (1 - (1 - cosine * cosine) / INDEX**2) ** 0.5
    rs = (cosine - INDEX * inside) / (cosine + INDEX * inside)
    rp = (INDEX * cosine - inside) / (INDEX * cosine + inside)
    mean, split, both = (rs * rs + rp * rp) / 2, (rs * rs - rp * rp) / 2, rs * rp
    band = np.exp(-(((WAVELENGTHS[channel] - PITCH * inside) / WIDTH) ** 2))
    left = 0.42 * (1 - mean) ** 2 * band  # half of the light has the other handedness
    out = [0.0] * 16
    out[0], out[1], out[4], out[5] = mean, split, split, mean
    out[10] = out[15] = both
    # A reflector of left circular light: what it reflects is left circular again.
    for at, value in ((0, left), (3, -left), (12, -left), (15, left)):
        out[at] += value
    out = [lobe * value for value in out]
    out[0] += (0.008, 0.012, 0.006)[channel] / np.pi
    return out


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
    shell = nicol.Material.create_callback(context, nicol.CallbackMaterial(mueller=cuticle, channels=3, lobe_width=0.2))
    horn = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.02, 0.012, 0.008], alpha=0.15))
    green = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=[0.06, 0.16, 0.02], alpha=0.3))
    green = nicol.Material.create_twosided(context, green)
    shapes.add(scene, mesh(context, lambda p: halves(p, True), (-2.2, -0.8, -1.0), (1.5, 1.0, 1.0), 0.032), shell)
    shapes.add(scene, mesh(context, legs, (-2.55, -0.7, -2.3), (1.8, 0.4, 2.3), 0.035), horn)
    shapes.add(scene, leaf(context), green)
    camera = nicol.Camera(fov=34).look_at((-3.4, 3.6, 5.6), (-0.25, -0.15, 0), (0, 1, 0))
    return shapes.View(scene, camera, polarizer=0, exposure=0.2, circular=1)
