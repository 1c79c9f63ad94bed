"""How well a mask fits the object under a pixel: `python benchmarks/internals/segmentation.py`.

Measures internals, not the public API.

Needs PROBE_ASSETS. Of each object that is seen (30 % and 400 px) in scenes of 15 scans, five
pixels are drawn evenly from what shows of it; each gives the IoU of the mask that a method finds
there with all that shows of the object. Beside the segmenter: the SLIC superpixel under the pixel
(colours alone; 100 a picture, compactness 10 and 20 and 25 to 200 of them were tried on the
fitting seeds), and the whole connected piece above the table (depth alone). `--fit-weights` prints
the weights of perception/sameness.py instead, from seeds 60000-60039.
"""

from __future__ import annotations

import time
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
from probe.perception.segmenter import SMALLEST_PX, Segmenter
from probe.scene.lighting import AMBIENT
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
    """What one method scores.

    Attributes:
        pixels: IoU of each pixel drawn.
        things: Mean of these by object, in the same order.
        best: IoU of each object with whichever mask fits it best.
        found: Masks of 200 px or more, by scene.
        seconds: CPU seconds, by scene.
    """

    pixels: list[float] = field(default_factory=list[float])
    things: list[float] = field(default_factory=list[float])
    best: list[float] = field(default_factory=list[float])
    found: list[int] = field(default_factory=list[int])
    seconds: list[float] = field(default_factory=list[float])

    def add(self, numbers: Array, picture: Picture) -> None:
        rng = np.random.default_rng(picture.seed)
        sizes = np.bincount(numbers.ravel())
        self.found.append(int(np.count_nonzero(sizes[1:] >= SMALLEST_PX)))
        for instance in picture.seen:
            truth = picture.labels == instance
            rows, columns = np.nonzero(truth)
            chosen = rng.integers(len(rows), size=A_THING)
            hits = [overlap(numbers, (int(rows[i]), int(columns[i])), truth) for i in chosen]
            self.pixels += hits
            self.things.append(float(np.mean(hits)))
            shared = np.bincount(numbers[truth], minlength=len(sizes))
            self.best.append(float((shared / (sizes + len(rows) - shared))[1:].max(initial=0.0)))


def overlap(numbers: Array, pixel: tuple[int, int], truth: Array) -> float:
    number = numbers[pixel]
    if number == 0:
        return 0.0
    found = numbers == number
    return float(np.count_nonzero(found & truth) / np.count_nonzero(found | truth))


def line(name: str, scores: Scores) -> str:
    values, best = np.array(scores.pixels), np.array(scores.best)
    parts = " ".join(f"{q:.2f}" for q in np.percentile(values, QUANTILES))
    draws = np.random.default_rng(0).integers(len(scores.things), size=(2000, len(scores.things)))
    whole = values.reshape(-1, A_THING)
    low, high = np.percentile(np.median(whole[draws].reshape(2000, -1), axis=1), (2.5, 97.5))
    return (
        f"{name:<24} {parts}   mean {values.mean():.2f}, 0.5 or more {np.mean(values >= 0.5):.0%}, "
        f"median's 95 % interval (by object) {low:.2f}-{high:.2f}; {np.mean(scores.found):.1f} "
        f"masks a scene, one fits by 0.5 or more for {np.mean(best >= 0.5):.0%} of objects; "
        f"{np.median(scores.seconds):.2f} CPU s"
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
    lighting: str = AMBIENT.name,
    picture: Path | None = None,
    fit_weights: bool = False,
) -> None:
    """Print quantiles of IoU by method.

    Args:
        scenes: How many.
        first_seed: Of the first of them.
        noise: Standard deviation of noise that is added to the depth, metres.
        lighting: As in `probe scene`.
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
    for scene in pictures(range(first_seed, first_seed + scenes), lighting):
        frame = noisy(scene.frame, noise, scene.seed)
        for name, method in methods.items():
            start = time.process_time()
            numbers = method(frame)
            scores[name].seconds.append(time.process_time() - start)
            scores[name].add(numbers, scene)
            if name == "segmenter" and len(rows) < 3:
                rows.append(tinted(scene, numbers))
    some = scores["segmenter"]
    print(
        f"{scenes} scenes from seed {first_seed}, {len(some.things)} objects, "
        f"{len(some.pixels)} pixels, light {lighting}, noise of depth {1000 * noise:.1f} mm"
    )
    print(f"{'IoU, quantiles in %':<24} {' '.join(f'{q:4d}' for q in QUANTILES)}")
    for name, found_scores in scores.items():
        print(line(name, found_scores))
    if picture:
        write_bytes(picture, encode(Image.fromarray(np.vstack(rows)), "JPEG"))


if __name__ == "__main__":
    tyro.cli(main)
