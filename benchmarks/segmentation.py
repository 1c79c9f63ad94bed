"""How well a mask fits the object under a pixel: `python benchmarks/segmentation.py`.

Needs PROBE_ASSETS. Of each object that is seen (30 % and 400 px) in scenes of 15 scans, five
pixels are drawn evenly from what shows of it; each gives the IoU of the mask that a method finds
there with all that shows of the object. Beside the segmenter: the SLIC superpixel under the pixel
(colours alone; 100 a picture, compactness 10 and 20 and 25 to 200 of them were tried on the
fitting seeds), and the whole connected piece above the table (depth alone). `--fit` prints the
weights of perception/sameness.py instead, from seeds 60000-60039.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import tyro
from PIL import Image
from scipy import ndimage
from segmenting.fit import fit, told
from segmenting.scenes import Picture, noisy, pictures
from skimage.segmentation import slic

from probe.files import encode, write_bytes
from probe.perception.relief import relief
from probe.perception.segmenter import Segmenter
from probe.types import Array, Frame

A_THING = 5
QUANTILES = (5, 10, 25, 50, 75, 90)
FITTING = range(60_000, 60_040)
_SUPERPIXELS, _COMPACTNESS = 100, 20.0

Method = Callable[[Frame], Array]
"""A frame to what each pixel belongs to, int, shape (h, w); 0 for nothing."""


def superpixels(frame: Frame) -> Array:
    small = np.asarray(frame.rgb)[::2, ::2]
    found: Any = slic(small, n_segments=_SUPERPIXELS, compactness=_COMPACTNESS, start_label=1)
    return np.repeat(np.repeat(found, 2, axis=0), 2, axis=1)


def pieces(frame: Frame) -> Array:
    scene = relief(frame)
    found: Any = ndimage.label(scene.raised)[0]
    return np.repeat(np.repeat(found, scene.stride, axis=0), scene.stride, axis=1)


@dataclass
class Scores:
    """IoU of each pixel drawn, and of each object with the masks found in it, in one order."""

    pixels: list[float] = field(default_factory=list[float])
    things: list[float] = field(default_factory=list[float])

    def add(self, numbers: Array, picture: Picture) -> None:
        rng = np.random.default_rng(picture.seed)
        for instance in picture.seen:
            truth = picture.labels == instance
            rows, columns = np.nonzero(truth)
            chosen = rng.integers(len(rows), size=A_THING)
            hits = [overlap(numbers, (int(rows[i]), int(columns[i])), truth) for i in chosen]
            self.pixels += hits
            self.things.append(float(np.mean(hits)))


def overlap(numbers: Array, pixel: tuple[int, int], truth: Array) -> float:
    number = numbers[pixel]
    if number == 0:
        return 0.0
    found = numbers == number
    return float(np.count_nonzero(found & truth) / np.count_nonzero(found | truth))


def line(name: str, scores: Scores) -> str:
    values = np.array(scores.pixels)
    parts = " ".join(f"{q:.2f}" for q in np.percentile(values, QUANTILES))
    draws = np.random.default_rng(0).integers(len(scores.things), size=(2000, len(scores.things)))
    whole = values.reshape(-1, A_THING)
    low, high = np.percentile(np.median(whole[draws].reshape(2000, -1), axis=1), (2.5, 97.5))
    return (
        f"{name:<24} {parts}   mean {values.mean():.2f}, 0.5 or more {np.mean(values >= 0.5):.0%}, "
        f"median's 95 % interval (by object) {low:.2f}-{high:.2f}"
    )


def tinted(picture: Picture, numbers: Array) -> Array:
    """The picture beside the same with each mask in a colour of its own."""
    rgb = np.asarray(picture.frame.rgb)
    palette = np.random.default_rng(4).integers(30, 256, (int(numbers.max()) + 1, 3))
    tint = np.where((numbers > 0)[..., None], 0.45 * rgb + 0.55 * palette[numbers], 0.5 * rgb)
    inner = ndimage.minimum_filter(numbers, 5) == ndimage.maximum_filter(numbers, 5)
    tint[~inner] = 255
    return np.hstack([rgb, tint.astype(np.uint8)])[::2, ::2]


def main(
    scenes: int = 20,
    first_seed: int = 61_000,
    noise: float = 0.0,
    picture: Path | None = None,
    fit_weights: bool = False,
) -> None:
    """Print quantiles of IoU by method.

    Args:
        scenes: How many.
        first_seed: Of the first of them.
        noise: Standard deviation of noise that is added to the depth, metres.
        picture: Where to write a JPEG of the first three scenes, with what was found in them.
        fit_weights: Fit the weights instead.
    """
    if fit_weights:
        print(told(*fit(list(pictures(FITTING)))))
        return
    methods: dict[str, Method] = {
        "segmenter": lambda frame: Segmenter().numbers(frame),
        "SLIC superpixel": superpixels,
        "piece above the table": pieces,
    }
    scores = {name: Scores() for name in methods}
    rows: list[Array] = []
    for scene in pictures(range(first_seed, first_seed + scenes)):
        frame = noisy(scene.frame, noise, scene.seed)
        found = {name: method(frame) for name, method in methods.items()}
        for name, numbers in found.items():
            scores[name].add(numbers, scene)
        if len(rows) < 3:
            rows.append(tinted(scene, found["segmenter"]))
    some = scores["segmenter"]
    print(
        f"{scenes} scenes from seed {first_seed}, {len(some.things)} objects, "
        f"{len(some.pixels)} pixels, noise of depth {1000 * noise:.1f} mm"
    )
    print(f"{'IoU, quantiles in %':<24} {' '.join(f'{q:4d}' for q in QUANTILES)}")
    for name, found_scores in scores.items():
        print(line(name, found_scores))
    if picture:
        write_bytes(picture, encode(Image.fromarray(np.vstack(rows)), "JPEG"))


if __name__ == "__main__":
    tyro.cli(main)
