"""Makes the README's loop of a film: `scripts/readme_loop.py FILM.mp4 docs/pictures/loop.gif`.

    probe run demo --task beneath-8af85510 --out outputs/loop
    probe film outputs/loop --speed 4

What stands still is shown for a moment, so that question, grasp and answer fit a few seconds.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import av
import numpy as np
from PIL import Image

from probe.film.encoding import encoded
from probe.types import Array

FPS = 10
CHANGED = 30
STILL = 2e-4
"""Share of values that differ by more than CHANGED, of 255, up to which nothing moves."""

HOLDS = 3, 12
"""Frames for what stands still between motions, and for the first and the last picture."""


def pictures(film: Path) -> Iterator[Image.Image]:
    """All frames of a film."""
    with av.open(str(film)) as opened:
        for frame in opened.decode(video=0):
            yield frame.to_image()


def runs(film: Path) -> list[tuple[Image.Image, int]]:
    """Pictures that differ, and how many frames each stood."""
    found: list[tuple[Image.Image, int]] = []
    last = np.zeros(())
    for picture in pictures(film):
        values = np.asarray(picture, float)
        if found and (np.abs(values - last) > CHANGED).mean() < STILL:
            found[-1] = found[-1][0], found[-1][1] + 1
        else:
            found.append((picture, 1))
            last = values
    return found


def main(film: Path, out: Path) -> None:
    """Write the loop."""
    found = runs(film)
    moving = [n for n, (_, stood) in enumerate(found) if stood < FPS]
    kept = set(moving[:: max(1, round(len(moving) / 30))]) | {
        n for n, (_, stood) in enumerate(found) if stood >= FPS
    }
    frames: list[tuple[Array, int]] = []
    for number in sorted(kept):
        picture, stood = found[number]
        held = HOLDS[number in (0, len(found) - 1)] if stood >= FPS else 1
        frames.append((np.asarray(picture), held))
    out.write_bytes(encoded(frames, FPS, "gif"))
    seconds = sum(held for _, held in frames) / FPS
    print(f"{out}: {seconds:.1f} s, {out.stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
