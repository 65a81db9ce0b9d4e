# SPDX-License-Identifier: MIT
"""Nicol in one process with PyTorch, OpenCV and Mitsuba, which bring OpenMP, TBB, Embree and image libraries of their own:
each works after each order of imports, and Nicol's picture does not depend on the order.

usage: beside_test.py ASSETS, the folder samples/assets"""

import importlib.util
import pathlib
import subprocess
import sys
import unittest

OTHERS = [name for name in ("torch", "cv2", "mitsuba") if importlib.util.find_spec(name)]
if not OTHERS or not importlib.util.find_spec("numpy"):
    print(f"skipped: {sys.executable} has no numpy beside torch, cv2 or mitsuba; NICOL_PEER_PYTHON names an interpreter that has")
    sys.exit(77)

import numpy

SCENE = pathlib.Path(sys.argv.pop(1)).resolve() / "snail_sky.xml"

PROGRAM = """
import hashlib, sys
names, scene = sys.argv[1:-1], sys.argv[-1]
for name in names:
    __import__(name)
import numpy

def use(name):
    module = sys.modules[name]
    if name == "nicol":
        print(hashlib.sha256(module.render(scene, size=(64, 48)).stokes.tobytes()).hexdigest())
    elif name == "torch":
        a = module.rand(300, 300, requires_grad=True)
        (a @ a).sum().backward()
        assert module.isfinite(a.grad).all()
    elif name == "cv2":
        assert module.GaussianBlur(numpy.ones((64, 64), "f"), (5, 5), 1).max() > 0.9
    elif name == "mitsuba":
        module.set_variant("scalar_rgb")
        box = module.cornell_box() | {"sensor": module.cornell_box()["sensor"] | {"film": {"type": "hdrfilm", "width": 32, "height": 32}}}
        assert numpy.array(module.render(module.load_dict(box), spp=1)).max() > 0

for name in names + names:
    use(name)
"""


class BesideTest(unittest.TestCase):
    def test_every_order_of_imports(self):
        # Every pair in both orders, and all at once with Nicol first and last.
        orders = [order for other in OTHERS for order in (("nicol", other), (other, "nicol"))]
        if len(OTHERS) > 1:
            orders += [("nicol", *OTHERS), (*OTHERS, "nicol")]
        pictures = set()
        for order in [("nicol",), *orders]:
            with self.subTest(order=order):
                done = subprocess.run(
                    [sys.executable, "-c", PROGRAM, *order, str(SCENE)], capture_output=True, text=True, check=False
                )
                self.assertEqual(done.returncode, 0, done.stderr[-2000:])
                pictures.update(done.stdout.split())
        self.assertEqual(len(pictures), 1)


@unittest.skipUnless("torch" in OTHERS, "no module torch")
class TorchTest(unittest.TestCase):
    def test_a_picture_is_a_tensor_without_a_copy(self):
        import nicol
        import torch

        picture = nicol.render(str(SCENE), size=(32, 24))
        tensor = torch.from_dlpack(picture)
        self.assertEqual(tuple(tensor.shape), (24, 32, 3, 4))
        self.assertEqual(tensor.data_ptr(), picture.stokes.ctypes.data)
        self.assertTrue((tensor.numpy() == picture.stokes).all())

    def test_tensors_are_meshes_textures_and_light(self):
        import nicol
        import torch

        positions = torch.tensor([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype=torch.float32)
        faces = torch.tensor([[0, 1, 2]], dtype=torch.uint32)
        data = nicol.mesh_data(positions, faces)
        self.assertEqual((data.vertex_count, data.triangle_count), (3, 1))
        self.assertEqual(data.positions[:9], positions.flatten().tolist())
        # Tensors of indices are int64 unless a program asks for another type.
        self.assertEqual(nicol.mesh_data(positions, faces.long()).indices[:3], [0, 1, 2])
        light = torch.rand(8, 16, 3)
        self.assertEqual(nicol.texture_image(light).type, nicol.TEXEL_FLOAT32)
        # Rows of a part of a tensor lie apart.
        for given in (light, light[:, 2:10], light.permute(1, 0, 2)):
            image = nicol.image(given)
            self.assertEqual((image.width, image.height), (given.shape[1], given.shape[0]))
            nicol.Environment.create_image(nicol.default_context(), image)
        self.assertEqual(numpy.from_dlpack(light).ctypes.data, light.data_ptr())


if __name__ == "__main__":
    unittest.main()
