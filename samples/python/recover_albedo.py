# SPDX-License-Identifier: MIT
"""Recovers the colours of a floor's tiles from one picture under known light by least squares. usage: recover_albedo.py
[--tiles N] [--size WxH] [--noise SHARE] [--steps COUNT]

Direct light is linear in the reflectance of diffuse surfaces: each tile is an instance whose gradient, divided by the
reflectance, is the derivative by it. A ball casts its shadow over some tiles and hides others."""

import argparse

import nicol
import numpy

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--tiles", type=int, default=6, help="along each side")
parser.add_argument("--size", default="96x72")
parser.add_argument("--noise", type=float, default=0, help="of the picture, relative to its RMS")
parser.add_argument("--steps", type=int, default=40)
arguments = parser.parse_args()
width, height = map(int, arguments.size.split("x"))
CHANNELS = 3


class Floor:
    """Pictures of a floor as a function of its tiles' reflectances, (tiles, channels)."""

    def __init__(self, context, tiles):
        self.context = context
        self.scene = nicol.Scene.create(context)
        mesh, half = nicol.Mesh.create_rectangle(context), 2 / tiles
        black = nicol.Material.create_diffuse(context, [0] * CHANNELS)
        places = [(2 * i - tiles + 1) * half for i in range(tiles)]
        self.ids = [
            self.scene.add_instance(nicol.Instance(
                mesh=mesh, material=black, to_world=[half, 0, 0, x, 0, 0, half, -0.5, 0, -half, 0, z, 0, 0, 0, 1]
            ))
            for z in places for x in places
        ]  # fmt: skip
        ball = nicol.Instance(mesh=nicol.Mesh.create_sphere(context), material=black)
        ball.to_world = [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]
        self.scene.add_instance(ball)
        light = nicol.Light(kind=nicol.LIGHT_POINT, value=[30, 25, 20], to_world=[1, 0, 0, 2, 0, 1, 0, 3, 0, 0, 1, 1, 0, 0, 0, 1])
        self.scene.add_light(light)
        self.scene.set_environment(nicol.Environment.create_constant(context, [0.5, 0.7, 1]), None, 1)
        self.scene.hide_emitters(1)
        self.camera = nicol.Camera(fov=45).look_at((0, 4, 5), (0, -0.3, 0), (0, 1, 0))
        self.options = nicol.RenderOptions(
            order_low=2, order_high=2, physical=0, shade_at="pixels", split_lights=0,
            disabled_optimisations=nicol.OPTIMISATION_LIGHT_COMPONENTS,
        )  # fmt: skip
        self.framebuffer = nicol.Framebuffer.create(context, width, height, CHANNELS)

    def set_colors(self, colors):
        for instance, color in zip(self.ids, colors):
            self.scene.set_material(instance, nicol.Material.create_diffuse(self.context, list(color)))

    def picture(self):
        nicol.render(self.scene, self.camera, self.options, self.framebuffer)
        return self.framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS).astype(float)

    def gradient(self, picture):
        """Returns the gradient by factors of what the tiles reflect, (tiles, channels)."""
        found = nicol.gradients(self.scene, self.camera, self.options, picture, wanted=["instances"]).instances
        return found[: len(self.ids)]


def least_squares(floor, picture, start, steps):
    """Conjugate gradients on the normal equations (CGLS), from the reflectances `start` on."""
    floor.set_colors(start)

    def change_by(way):
        """Returns the change of the picture, from two pictures whose reflectances lie within 0 to 1."""
        length = 0.4 / numpy.abs(way).max()
        pictures = []
        for sign in (1, -1):
            floor.set_colors(start + sign * length * way)
            pictures.append(floor.picture())
        floor.set_colors(start)
        return (pictures[0] - pictures[1]) / (2 * length)

    colors, rest = start, picture - floor.picture()
    gradient = floor.gradient(rest) / start
    way, size = gradient, (gradient**2).sum()
    for _ in range(steps):
        change = change_by(way)
        step = size / (change**2).sum()
        colors, rest = colors + step * way, rest - step * change
        gradient = floor.gradient(rest) / start
        former, size = size, (gradient**2).sum()
        way = gradient + size / former * way
    return colors


with nicol.Context.create() as context:
    floor = Floor(context, arguments.tiles)
    truth = numpy.random.default_rng(3).uniform(0.1, 0.9, size=(len(floor.ids), CHANNELS))
    floor.set_colors(truth)
    picture = floor.picture()
    noise = numpy.random.default_rng(4).normal(size=picture.shape)
    picture += arguments.noise * numpy.sqrt((picture**2).mean()) * noise
    seen = floor.gradient(numpy.ones_like(picture)).min(axis=1) > 0
    colors = least_squares(floor, picture, numpy.full_like(truth, 0.5), arguments.steps)
errors = numpy.abs(colors - truth)[seen]
print(f"error of the reflectances of {seen.sum()} tiles that are seen: {errors.max():.2e} at most, {numpy.sqrt((errors**2).mean()):.2e} RMS")
