# SPDX-License-Identifier: MIT
"""Recovers an unknown polarized environment from one picture of a known scene by least squares. usage: recover_light.py
[--order L] [--size WxH] [--noise SHARE] [--steps COUNT]

A picture is linear in the light's coefficients: picture = A light. Conjugate gradients minimise |A light - picture|^2: each
step renders a light (A) and takes the gradient of a picture (the transpose of A). A metal ball and a plastic floor are
seen once; the light that lies in front of the camera but is reflected nowhere stays unknown."""

import argparse

import nicol
import numpy

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--order", type=int, default=3, help="of the light")
parser.add_argument("--size", default="96x96")
parser.add_argument("--noise", type=float, default=0, help="of the picture, relative to its RMS")
parser.add_argument("--steps", type=int, default=60)
arguments = parser.parse_args()
width, height = map(int, arguments.size.split("x"))


def unknown_light(order, seed=1):
    """Returns coefficients of light from all directions, polarized, of one channel: (1, (order + 1)^2, 4)."""
    light = numpy.random.default_rng(seed).normal(size=(1, (order + 1) ** 2, 4))
    light /= numpy.sqrt(1 + numpy.arange((order + 1) ** 2))[:, None]
    light[:, :4, 1:3] = 0  # linear polarization begins at l = 2
    light[0, 0, 0] += 5
    return light


class Linear:
    """The linear map from light to pictures, of one scene, camera and set of options."""

    def __init__(self, context):
        self.context = context
        self.scene = nicol.Scene.create(context)
        ball = nicol.Material.create_conductor(context, nicol.Conductor(eta=3, k=3, alpha=0.15))
        floor = nicol.Material.create_pplastic(context, nicol.Pplastic(diffuse_reflectance=0.4, alpha=0.2))
        flat = [2, 0, 0, 0, 0, 0, 2, -1, 0, -2, 0, 0, 0, 0, 0, 1]
        self.scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_sphere(context), material=ball))
        self.scene.add_instance(nicol.Instance(mesh=nicol.Mesh.create_rectangle(context), material=floor, to_world=flat))
        self.scene.hide_emitters(1)
        self.camera = nicol.Camera(fov=45).look_at((0, 1.5, 4), (0, -0.2, 0), (0, 1, 0))
        # The picture must be linear in the light, and of the same components whatever the light.
        self.options = nicol.RenderOptions(
            order_low=arguments.order, order_high=arguments.order, physical=0, shade_at="pixels",
            disabled_optimisations=nicol.OPTIMISATION_LIGHT_COMPONENTS,
        )  # fmt: skip
        self.framebuffer = nicol.Framebuffer.create(context, width, height, 1)

    def picture(self, light):
        environment = nicol.Environment.create_psh(self.context, arguments.order, 1, light)
        self.scene.set_environment(environment, None, 1)
        nicol.render(self.scene, self.camera, self.options, self.framebuffer)
        return self.framebuffer.plane(nicol.PLANE_STOKES, nicol.ALL_CHANNELS).astype(float)

    def transpose(self, picture):
        return nicol.gradients(self.scene, self.camera, self.options, picture).environment


def least_squares(linear, picture, light, steps):
    """Conjugate gradients on the normal equations (CGLS), from a light on."""
    rest = picture - linear.picture(light)
    gradient = linear.transpose(rest)
    way, size = gradient, (gradient**2).sum()
    for step in range(steps):
        change = linear.picture(way)
        length = size / (change**2).sum()
        light, rest = light + length * way, rest - length * change
        gradient = linear.transpose(rest)
        former, size = size, (gradient**2).sum()
        way = gradient + size / former * way
        if step % 10 == 9:
            print(f"step {step + 1}: the picture's error is {numpy.sqrt((rest**2).sum() / (picture**2).sum()):.2e}")
    return light


def error(light, truth, components):
    difference = (light - truth)[..., components]
    return numpy.sqrt((difference**2).sum() / (truth[..., components] ** 2).sum())


with nicol.Context.create() as context:
    linear = Linear(context)
    truth = unknown_light(arguments.order)
    picture = linear.picture(truth)
    noise = numpy.random.default_rng(2).normal(size=picture.shape)
    picture += arguments.noise * numpy.sqrt((picture**2).mean()) * noise
    start = numpy.zeros_like(truth)
    start[0, 0, 0] = 1
    light = least_squares(linear, picture, start, arguments.steps)
print(f"error of the light: s0 {error(light, truth, [0]):.2e}, s1 and s2 {error(light, truth, [1, 2]):.2e}, s3 {error(light, truth, [3]):.2e}")
