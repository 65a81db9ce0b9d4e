# SPDX-License-Identifier: MIT
"""A recipe's pictures for training."""

from .recipe import FORMATS, Recipe
from .renderer import Renderer


class Dataset:
    """Frames of a recipe as dictionaries of numpy arrays, rendered when they are asked for: a map-style dataset for PyTorch's
    DataLoader, and an iterable.

        dataset = nicol.dataset.Dataset("recipe.json", range(10000), ["mosaic", "normals_camera"])
        loader = torch.utils.data.DataLoader(dataset, batch_size=8, num_workers=2)

    Each item has the arrays of `names` and "frame", the frame's number. Frames of one scene in succession are fast; another
    scene is baked first. A dataset can be pickled, and opens the library in the process that asks for the first picture, so
    that workers may be spawned or forked, if the parent has rendered nothing before the fork. threads: of each process, 0 for
    one per core."""

    def __init__(self, recipe, frames, names=("stokes",), threads=0):
        self.recipe = recipe if isinstance(recipe, Recipe) else Recipe(recipe)
        self.frames, self.names, self.threads, self._here = frames, tuple(names), threads, None
        unknown = [name for name in self.names if name not in FORMATS]
        if unknown:
            raise ValueError(f"{unknown[0]!r} is no array; known are {', '.join(FORMATS)}")

    def __len__(self):
        return len(self.frames)

    def __getitem__(self, index):
        frame = self.frames[index]
        renderer, framebuffers = self._opened()
        channels = renderer.channels(frame)
        if channels not in framebuffers:
            framebuffers[channels] = renderer.framebuffer(frame)
        picture = renderer.render(frame, self.names, framebuffers[channels])
        renderer.read(picture, self.names)
        return {name: picture.arrays[name] for name in self.names} | {"frame": frame}

    def __iter__(self):
        return map(self.__getitem__, range(len(self)))

    def __getstate__(self):
        return self.__dict__ | {"_here": None}

    def _opened(self):
        """Returns the renderer and the framebuffers by number of channels, opened for the first picture."""
        if self._here is None:
            self._here = Renderer(self.recipe, self.threads), {}
        return self._here
