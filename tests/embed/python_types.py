# SPDX-License-Identifier: MIT
"""mypy must accept this, as users write it, and must refuse what is ignored: an ignored error that is none is an error."""

import nicol

picture = nicol.render("scene.xml", size=(640, 480), quality="final", shade_at="pixels")
largest: float = picture.dolp.max()
scene = nicol.load("scene.xml", light_angle=30)
ids: list[int] = scene.get_instance_ids()
camera = nicol.Camera(fov=40).look_at([0, 0, 5], (0, 0, 0), [0, 1, 0])
field_of_view: float = camera.fov
options = nicol.RenderOptions(order_low=4, shade_at="vertices")
options.shade_at = "pixels"
options.order_low = 5
lower, upper = scene.get_bounds()
middle: float = (lower[0] + upper[0]) / 2
with nicol.Context.create() as context:
    mesh = nicol.Mesh.create(context, nicol.mesh_data([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    framebuffer = nicol.Framebuffer.create(context, 64, 48, 3)
    nicol.render(scene, camera, options, framebuffer)
    error: float = framebuffer.get_statistics().predicted_error
    backend: str = nicol.version_string()

options.order_low = "four"  # type: ignore[assignment]
camera.fov = None  # type: ignore[assignment]
nicol.Framebuffer.create(context, 64, "48", 3)  # type: ignore[arg-type]
nicol.Mesh.create(scene, None)  # type: ignore[arg-type]
nicol.render(scene, camera, options, framebuffer).stokes  # type: ignore[attr-defined]
nicol.load(3)  # type: ignore[arg-type]
