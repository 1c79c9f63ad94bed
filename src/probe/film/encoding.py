"""Frames to the bytes of a film. Knows no episode."""

from __future__ import annotations

import io
import itertools
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Literal, cast

import numpy as np
from PIL import Image

from probe.errors import MissingExtra
from probe.types import Array

FilmFormat = Literal["mp4", "webm", "gif"]

_CODECS = {
    "mp4": ("libx264", {"crf": "21", "preset": "medium"}),
    "webm": ("libvpx-vp9", {"crf": "33", "b": "0", "deadline": "good", "cpu-used": "4"}),
}
_GIF_WIDTH = 640
"""Films as GIF are smaller: the format knows no compression worth the name."""


def require_encoder() -> None:
    """Return if films can be written as mp4 and webm.

    Raises:
        MissingExtra: PyAV isn't installed.
    """
    try:
        import av  # noqa: F401  # pyright: ignore[reportUnusedImport]
    except ImportError as error:
        raise MissingExtra("Writing films", "film") from error


def encoded(
    frames: Iterable[tuple[Array, int]], fps: int, form: FilmFormat, comment: str = ""
) -> bytes:
    """A whole film.

    Args:
        frames: At least one: pictures, uint8, shape (h, w, 3), of one size with even sides, and for
            how many frames each stands.
        fps: Frames a second.
        form: Of the file.
        comment: What it says of itself to whoever asks.

    Raises:
        MissingExtra: PyAV isn't installed, and it isn't to be a GIF.
    """
    if form == "gif":
        return _gif(frames, fps, comment)
    return _video(frames, fps, form, comment)


def _video(frames: Iterable[tuple[Array, int]], fps: int, form: FilmFormat, comment: str) -> bytes:
    require_encoder()
    import av

    file, rest = io.BytesIO(), iter(frames)
    codec, options = _CODECS[form]
    first = next(rest)
    with av.open(file, "w", format=form, options={"fflags": "+bitexact"}) as container:
        container.metadata.update({"comment": comment} if comment else {})
        stream = cast(av.VideoStream, container.add_stream(codec, rate=fps, options=options))
        stream.height, stream.width = first[0].shape[:2]
        stream.pix_fmt = "yuv420p"
        # One thread: the same bytes on every machine.
        stream.codec_context.thread_count = 1
        every = (one for one, times in itertools.chain([first], rest) for _ in range(times))
        for number, picture in enumerate(every):
            frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(picture), format="rgb24")
            frame.pts, frame.time_base = number, Fraction(1, fps)
            container.mux(stream.encode(frame))
        container.mux(stream.encode())
    return file.getvalue()


def _gif(frames: Iterable[tuple[Array, int]], fps: int, comment: str) -> bytes:
    images: list[Image.Image] = []
    times: list[int] = []
    for picture, count in frames:
        image = Image.fromarray(picture)
        height = round(image.height * min(1.0, _GIF_WIDTH / image.width))
        size = min(_GIF_WIDTH, image.width), height
        images.append(image.resize(size, Image.Resampling.BOX))
        times.append(1000 * count // fps)
    palette = _palette(images)
    small = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    file = io.BytesIO()
    small[0].save(
        file,
        "GIF",
        save_all=True,
        append_images=small[1:],
        duration=times,
        loop=0,
        disposal=1,
        comment=comment,
    )
    return file.getvalue()


def _palette(images: Sequence[Image.Image]) -> Image.Image:
    """Colours of a film's start, middle and end; one palette a picture would flicker."""
    width, height = images[0].size
    some = Image.new("RGB", (width, 3 * height))
    for place, image in enumerate((images[0], images[len(images) // 2], images[-1])):
        some.paste(image, (0, place * height))
    return some.quantize(128)
