# SPDX-License-Identifier: MIT
"""Recovers the texture of a floor from one picture under known light by least squares. usage: recover_albedo.py
[--texels N] [--size WxH] [--noise SHARE] [--steps COUNT]

Direct light is linear in the reflectance of diffuse surfaces, so the gradient by the texels of a texture and pictures of other
textures are all that conjugate gradients need. A ball casts its shadow over some texels and hides others."""

import argparse

import nicol
import numpy

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--texels", type=int, default=8, help="along each side")
parser.add_argument("--size", default="96x72")
parser.add_argument("--noise", type=float, default=0, help="of the picture, relative to its RMS")
parser.add_argument("--steps", type=int, default=100)
arguments = parser.parse_args()
width, height = map(int, arguments.size.split("x"))
CHANNELS = 3


class Floor:
    """Pictures of a floor as a function of its texture's reflectances, (rows, columns, channels)."""

    def __init__(self, context):
        self.context = context
        self.scene = nicol.Scene.create(context)
        self.white = nicol.Material.create_diffuse(context, [1] * CHANNELS)
        black = nicol.Material.create_diffuse(context, [0] * CHANNELS)
        self.floor = self.scene.add_instance(nicol.Instance(
            mesh=nicol.Mesh.create_rectangle(context), material=black,
            to_world=[2, 0, 0, 0, 0, 0, 2, -0.5, 0, -2, 0, 0, 0, 0, 0, 1],
        ))  # fmt: skip
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
        self.shape = colors.shape
        self.texture = nicol.Texture.create_image(self.context, nicol.texture_image(colors.astype("f4")))
        self.scene.set_material(self.floor, nicol.Material.create_scaled(self.context, self.white, self.texture))

    def picture(self):
        nicol.render(self.scene, self.camera, self.options, self.framebuffer)
        return self.framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS).astype(float)

    def gradient(self, picture):
        """Returns the gradient by the reflectances."""
        return nicol.gradients(
            self.scene, self.camera, self.options, picture, wanted=(), texture=self.texture, shape=self.shape
        ).texels


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
    gradient = floor.gradient(rest)
    way, size = gradient, (gradient**2).sum()
    for _ in range(steps):
        change = change_by(way)
        step = size / (change**2).sum()
        colors, rest = colors + step * way, rest - step * change
        gradient = floor.gradient(rest)
        former, size = size, (gradient**2).sum()
        way = gradient + size / former * way
    return colors


with nicol.Context.create() as context:
    floor = Floor(context)
    random = numpy.random.default_rng(3)
    truth = random.uniform(0.1, 0.9, size=(arguments.texels, arguments.texels, CHANNELS))
    floor.set_colors(truth)
    picture = floor.picture()
    noise = numpy.random.default_rng(4).normal(size=picture.shape)
    picture += arguments.noise * numpy.sqrt((picture**2).mean()) * noise
    seen = floor.gradient(numpy.ones_like(picture)).min(axis=2)
    seen = seen > 0.1 * numpy.median(seen)
    # Materials take equal texels as a number, of which there is no gradient.
    start = numpy.full_like(truth, 0.5)
    start[0, 0] = 0.501
    colors = least_squares(floor, picture, start, arguments.steps)
errors = numpy.abs(colors - truth)[seen]
print(f"error of the reflectances of {seen.sum()} texels that are seen: {errors.max():.2e} at most, {numpy.sqrt((errors**2).mean()):.2e} RMS")
