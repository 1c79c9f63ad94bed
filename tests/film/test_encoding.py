"""Films hold the frames that they were given."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image

from probe.film.encoding import FilmFormat, encoded
from probe.types import Array

FRAMES = [(np.full((48, 64, 3), grey, np.uint8), count) for grey, count in ((20, 3), (230, 5))]


def decoded(content: bytes) -> list[Array]:
    av = pytest.importorskip("av")
    with av.open(io.BytesIO(content)) as film:
        return [frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)]


@pytest.mark.parametrize("form", ["mp4", "webm"])
def test_a_decoder_reads_every_frame(form: FilmFormat) -> None:
    pytest.importorskip("av")
    pictures = decoded(encoded(FRAMES, 25, form))
    assert len(pictures) == 8
    assert pictures[0].shape == (48, 64, 3)
    assert abs(int(pictures[2].mean()) - 20) < 6
    assert abs(int(pictures[3].mean()) - 230) < 6


@pytest.mark.parametrize("form", ["mp4", "webm", "gif"])
def test_the_same_frames_give_the_same_bytes(form: FilmFormat) -> None:
    if form != "gif":
        pytest.importorskip("av")
    assert encoded(FRAMES, 25, form) == encoded(FRAMES, 25, form)


@pytest.mark.parametrize("form", ["mp4", "webm"])
def test_a_film_says_what_drew_it(form: FilmFormat) -> None:
    av = pytest.importorskip("av")
    for said in ("Stage drawn by blender", ""):
        with av.open(io.BytesIO(encoded(FRAMES, 25, form, said))) as film:
            told = {name.lower(): value for name, value in film.metadata.items()}
        assert told.get("comment", "") == said


def test_a_gif_says_what_drew_it() -> None:
    with Image.open(io.BytesIO(encoded(FRAMES, 25, "gif", "Stage drawn by blender"))) as film:
        assert film.info["comment"] == b"Stage drawn by blender"


def test_a_gif_holds_a_frame_as_long_as_it_stands() -> None:
    with Image.open(io.BytesIO(encoded(FRAMES, 25, "gif"))) as film:
        assert film.n_frames == 2  # pyright: ignore[reportAttributeAccessIssue]
        assert film.info["duration"] == 3 * 40
        film.seek(1)
        assert film.info["duration"] == 5 * 40
