# SPDX-License-Identifier: MIT
"""Arranges a scene of a data set as others read it. The frames have stokes and ids as npy, for NeISF also poses of "llff".

    neisf    images_s0/img_001.exr ..., images_s1, images_s2, masks/img_001.png, poses_bounds.npy; cameras keep their places,
             and NeISF's preprocess_camera_normalization.py moves them into its sphere
    pandora  images_stokes/01_s0.hdr, 01_s0p1.hdr (s0 + s1), 01_s0p2.hdr (s0 + s2), images/01.png, mask/01.png (alpha),
             cameras.npz, pts3d.npz: as dataio/Ours.py reads them, whose pictures have 2448 x 2048 pixels
    nersp    s0/0000.npy, s1, s2, image/0000.png, input_azimuth_maps/0000.png (angle of polarization clockwise, alpha is the
             mask), cameras.npz: as data_type ours_synthetic of NeRSP reads them

usage: layouts.py LAYOUT DATASET OUT [--scene N]"""

import argparse
import json
import os
import shutil

import numpy
from nicol import conventions
from nicol.dataset import exr
from sheet import save_png, tone_mapped


class View:
    """A frame: what frame.json says, its Stokes image with three channels, and where objects are."""

    def __init__(self, folder):
        with open(os.path.join(folder, "frame.json"), encoding="utf-8") as file:
            self.facts = json.load(file)
        stokes, ids = (numpy.load(os.path.join(folder, f"{name}.npy")) for name in ("stokes", "ids"))
        self.stokes = numpy.broadcast_to(stokes, (*stokes.shape[:2], 3, 4))
        self.mask = ids != 0xFFFFFFFF

    def projection(self):
        """Returns the 4 x 4 matrix from the world to pixels, the first of which has its middle at 0."""
        camera, matrix = self.facts["camera"], numpy.eye(4)
        K = numpy.array(camera["K"]) - [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]]
        matrix[:3] = K @ numpy.column_stack([camera["R"], camera["t"]])
        return matrix

    def with_mask(self, image):
        """Returns an image (height, width, 3) with the mask as alpha."""
        return numpy.concatenate([image, (self.mask * numpy.iinfo(image.dtype).max)[..., None].astype(image.dtype)], axis=2)


def views_of(dataset, scene):
    """Yields a scene's views, in order."""
    frames = os.path.join(dataset, "frames")
    for name in sorted(os.listdir(frames)):
        with open(os.path.join(frames, name, "frame.json"), encoding="utf-8") as file:
            if json.load(file)["scene"] == scene:
                yield View(os.path.join(frames, name))


def save_colours(path, image):
    """Writes an image (height, width, 3) as EXR with R, G and B."""
    with open(path, "wb") as file:
        file.writelines(exr.encoded({name: image[..., i] for i, name in enumerate("RGB")}))


def save_hdr(path, image):
    """Writes an image (height, width, 3) of light as Radiance's RGBE."""
    image = numpy.maximum(image, 0)
    _, exponent = numpy.frexp(image.max(axis=2))
    numbers = numpy.empty((*image.shape[:2], 4), numpy.uint8)
    numbers[..., :3] = numpy.ldexp(image, 8 - exponent[..., None])
    numbers[..., 3] = numpy.where(numbers[..., :3].any(axis=2), exponent + 128, 0)
    with open(path, "wb") as file:
        file.write(f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {image.shape[0]} +X {image.shape[1]}\n".encode())
        file.write(numbers.tobytes())


def to_world(views):
    """Returns the matrix that takes the unit sphere to the sphere around the objects."""
    lower, upper = (numpy.array(bound) for bound in views[0].facts["bounds"])
    matrix = numpy.diag([*[numpy.linalg.norm(upper - lower) / 2] * 3, 1.0])
    matrix[:3, 3] = (lower + upper) / 2
    return matrix


def save_cameras(path, views, names):
    sphere = to_world(views)
    named = {f"world_mat_{name}": view.projection() for name, view in zip(names, views)}
    numpy.savez(path, **named, **{f"scale_mat_{name}": sphere for name in names})


def shown(view):
    return numpy.rint(255 * tone_mapped(view.stokes[..., 0])).astype(numpy.uint8)


def neisf(views, place, poses):
    for number, view in enumerate(views, 1):
        for p in range(3):
            save_colours(place(f"images_s{p}", f"img_{number:03d}.exr"), view.stokes[..., p])
        mask = numpy.where(view.mask, 65535, 0).astype(numpy.uint16)
        save_png(place("masks", f"img_{number:03d}.png"), numpy.repeat(mask[..., None], 3, axis=2))
    shutil.copy(os.path.join(poses, "poses_bounds.npy"), place("poses_bounds.npy"))


def pandora(views, place, _):
    names = [f"{number:02d}" for number in range(1, len(views) + 1)]
    for name, view in zip(names, views):
        s0, s1, s2, _ = numpy.moveaxis(view.stokes, -1, 0)
        for suffix, image in (("s0", s0), ("s0p1", s0 + s1), ("s0p2", s0 + s2)):
            save_hdr(place("images_stokes", f"{name}_{suffix}.hdr"), image)
        save_png(place("images", f"{name}.png"), shown(view))
        save_png(place("mask", f"{name}.png"), view.with_mask(shown(view)))
    save_cameras(place("cameras.npz"), views, names)
    # Its points stand for the object: the corners of the box around it.
    lower, upper = views[0].facts["bounds"]
    corners = [[(lower, upper)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]
    numpy.savez(place("pts3d.npz"), pts3d=numpy.array(corners))


def nersp(views, place, _):
    for number, view in enumerate(views):
        for p in range(3):
            numpy.save(place(f"s{p}", f"{number:04d}.npy"), view.stokes[..., p])
        save_png(place("image", f"{number:04d}.png"), shown(view))
        clockwise = conventions.positive(conventions.clockwise(conventions.aolp(view.stokes.sum(axis=2))))
        angle = numpy.rint(clockwise * 65535 / numpy.pi).astype(numpy.uint16)
        image = view.with_mask(numpy.repeat(angle[..., None], 3, axis=2))
        save_png(place("input_azimuth_maps", f"{number:04d}.png"), image)
    save_cameras(place("cameras.npz"), views, range(len(views)))


LAYOUTS = {"neisf": neisf, "pandora": pandora, "nersp": nersp}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("layout", choices=LAYOUTS)
    parser.add_argument("dataset")
    parser.add_argument("out")
    parser.add_argument("--scene", type=int, default=0)
    given = parser.parse_args()

    def place(*names):
        path = os.path.join(given.out, *names)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        return path

    views = list(views_of(given.dataset, given.scene))
    if not views:
        parser.error(f"{given.dataset} has no frame of scene {given.scene}")
    LAYOUTS[given.layout](views, place, os.path.join(given.dataset, "poses", f"{given.scene:06d}"))


if __name__ == "__main__":
    main()
