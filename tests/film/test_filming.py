"""A whole film: from a record to a file that a player reads."""

from __future__ import annotations

import io

import numpy as np
import pytest

from probe.episodes.play import play
from probe.episodes.turns import Call
from probe.film import drawing
from probe.film.clips import CLIP_PX, FRAMES, clips_of
from probe.film.cutting import FPS
from probe.film.filming import film
from probe.film.layout import SIZE_PX, STAGE_PX
from probe.tasks.suite_file import demo_suite

TASK = demo_suite().tasks[0]
CALLS = (
    Call.of("find_object", {"description": "clay flower pot"}),
    Call.of("grasp_and_remove", {"object_id": "object_1"}),
    Call.of("answer_question", {"choice": "E"}),
)


class Fixed:
    """Makes the calls above."""

    def act(self, question, history):
        return CALLS[len(history)] if len(history) < len(CALLS) else None


@pytest.fixture(scope="module")
def record(library, renderer):
    return play(TASK, Fixed(), "fixed", library, renderer)


@pytest.mark.slow
def test_a_film_has_the_frames_that_it_says_and_things_move_in_it(
    record, library, renderer, tmp_path, monkeypatch
):
    av = pytest.importorskip("av")
    # Of the few pictures that a fast film has, there are still more than one series.
    monkeypatch.setitem(drawing.SERIES, "filament", 32)
    path = tmp_path / "films" / "one.mp4"
    watched: list[int] = []
    facts = film(
        TASK,
        record,
        library,
        renderer,
        path,
        speed=20.0,
        watch=lambda numbers, _: track(numbers, watched),
    )
    with av.open(path) as container:
        # All of them at once, as arrays, would fill two gigabytes.
        decoded = container.decode(video=0)
        first = last = next(decoded)
        count = 1
        for last in decoded:  # noqa: B007
            count += 1
    ends = [frame.to_ndarray(format="rgb24") for frame in (first, last)]
    assert ends[0].shape == (SIZE_PX[1], SIZE_PX[0], 3)
    assert count == round(facts.seconds * FPS)
    assert 32 < facts.drawn < count
    assert watched == sorted(watched) and len(watched) >= facts.drawn
    assert facts.cpu_seconds > 0
    # The pot stands on the table at first and not at last; the arm is parked both times.
    top = SIZE_PX[1] - STAGE_PX[1]
    first, last = (frame[top:, : STAGE_PX[0]].astype(int) for frame in ends)
    changed = np.abs(first - last).max(axis=2) > 40
    assert 2_000 < changed.sum() < 60_000
    assert [each.name for each in path.parent.iterdir()] == ["one.mp4"]


def track(numbers, seen: list[int]):
    for number in numbers:
        seen.append(number)
        yield number


@pytest.mark.slow
def test_a_clip_is_made_of_each_manipulation_and_is_small(record, library, renderer):
    av = pytest.importorskip("av")
    (clip,) = clips_of(TASK, record, library, renderer)
    assert clip.call == 1
    assert len(clip.content) < 150_000
    with av.open(io.BytesIO(clip.content)) as container:
        frames = [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]
    assert len(frames) == FRAMES
    assert frames[0].shape == (CLIP_PX[1], CLIP_PX[0], 3)
    assert clip.speed > 1
