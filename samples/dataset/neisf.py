# SPDX-License-Identifier: MIT
"""Arranges a scene of a data set as NeISF reads it: images_s0/img_001.exr ..., images_s1, images_s2, masks/img_001.png and
poses_bounds.npy. The frames have stokes and ids as npy, and poses of "llff". Cameras keep their places; NeISF's
preprocess_camera_normalization.py moves them into its sphere.
usage: neisf.py DATASET OUT [--scene N]"""

import argparse
import json
import os
import shutil

import numpy
from nicol.dataset import exr
from sheet import save_png


def frames_of(dataset, scene):
    """Returns the folders of a scene's frames, in order."""
    found = []
    for name in sorted(os.listdir(os.path.join(dataset, "frames"))):
        folder = os.path.join(dataset, "frames", name)
        with open(os.path.join(folder, "frame.json"), encoding="utf-8") as file:
            if json.load(file)["scene"] == scene:
                found.append(folder)
    return found


def save_colours(path, image):
    """Writes an image (height, width, 1 or 3) as EXR with R, G and B."""
    height, width, _ = image.shape
    image = numpy.broadcast_to(image, (height, width, 3))
    with open(path, "wb") as file:
        file.writelines(exr.encoded({name: image[..., i] for i, name in enumerate("RGB")}))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("dataset")
    parser.add_argument("out")
    parser.add_argument("--scene", type=int, default=0)
    given = parser.parse_args()
    for name in ("images_s0", "images_s1", "images_s2", "masks"):
        os.makedirs(os.path.join(given.out, name), exist_ok=True)
    for number, folder in enumerate(frames_of(given.dataset, given.scene), 1):
        stokes, ids = (numpy.load(os.path.join(folder, f"{name}.npy")) for name in ("stokes", "ids"))
        for p in range(3):
            save_colours(os.path.join(given.out, f"images_s{p}", f"img_{number:03d}.exr"), stokes[..., p])
        mask = numpy.where(ids == 0xFFFFFFFF, 0, 65535).astype(numpy.uint16)
        save_png(os.path.join(given.out, "masks", f"img_{number:03d}.png"), numpy.repeat(mask[..., None], 3, axis=2))
    poses = os.path.join(given.dataset, "poses", f"{given.scene:06d}", "poses_bounds.npy")
    shutil.copy(poses, os.path.join(given.out, "poses_bounds.npy"))


if __name__ == "__main__":
    main()
