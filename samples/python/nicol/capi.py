# SPDX-License-Identifier: MIT
"""The C interface alone: what nicol has without its shortcuts, such as render(scene, camera, options, framebuffer)."""

from ._abi import *  # noqa: F403
from ._abi import Camera, Context, Framebuffer, Scene, Sensor, render  # noqa: F401
from ._runtime import Error as Error
