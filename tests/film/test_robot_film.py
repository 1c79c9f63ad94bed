"""A film of a robot's episode: the pictures that were kept, in their order and for their time."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from probe.episodes.film import Film
from probe.episodes.grading import NoPoses, question_of
from probe.episodes.record import EpisodeRecord, Step, TableState
from probe.episodes.turns import Call
from probe.errors import BadData
from probe.film.cutting import FPS
from probe.film.layout import SIZE_PX, STAGE_PX
from probe.film.robot_filming import film_robot
from probe.film.robot_footage import photographed
from probe.scene.scene import Scene
from probe.station.motion_camera import MotionPicture
from probe.tasks.suite_file import demo_suite
from probe.toolshed.result import Answer
from probe.types import Array, Frame

TASK = next(task for task in demo_suite().tasks if task.question_type == "beneath")
CAMERA = TASK.setup.camera("front")
BARE = TableState(Scene(TASK.scene.seed, TASK.scene.table, (), TASK.setup), (0.0,) * 6)
RED, GREEN, BLUE = (200, 30, 30), (30, 200, 30), (30, 30, 200)
GREYS = (60, 90, 120, 150, 180)
"""Of the pictures in motion, in their order."""

MOVED = (0.1, 0.35, 0.6, 1.6, 1.85)
"""Seconds for which it had moved; one picture was lost."""

STAMPS = (10.0, 10.25, 10.5, 14.0, 14.25)
"""Seconds by the robot's clock; it rested, too, before the fourth, for a person's yes."""


def plain(colour: tuple[int, int, int] | int, edge: int) -> Array:
    return np.full((edge, edge, 3), colour, np.uint8)


def table(colour: tuple[int, int, int]) -> Frame:
    return Frame(CAMERA, np.ones((96, 96), np.float32), plain(colour, 96))


def episode(out: Path, *, moves: bool) -> EpisodeRecord:
    """A look, a grasp in motion and an answer: the table is red, red, green and blue."""
    film = Film(out, TASK.id)
    names = [film.keep(table(RED)), film.keep(table(RED))]
    for grey, stamp, moved in zip(GREYS if moves else (), STAMPS, MOVED, strict=False):
        film.keep_motion(MotionPicture(plain(grey, 64), stamp, (stamp,) * 6, moved))
    names += [film.keep(table(GREEN)), film.keep(table(BLUE))]
    calls = (
        (Call.of("perceive_scene"), "objects:\n- number: 1\n"),
        (Call.of("grasp_and_remove", {"object_id": "object_1"}), "Done: it lies in the basket."),
        (Call.of("answer_question", {"choice": TASK.answer}), "Your answer is recorded."),
    )
    steps = tuple(Step(call, "done", text, None, BARE) for call, text in calls)
    question, answer = question_of(TASK), Answer(TASK.answer)
    return EpisodeRecord(
        TASK.id, "somebody", 0, question, BARE, steps, answer, "answered", frames=tuple(names)
    )


def stage_of(path: Path) -> list[int | str]:
    """What the middle of the stage shows in each frame: a grey, or a colour's name."""
    av = pytest.importorskip("av")
    with av.open(path) as container:
        frames = [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]
    assert frames[0].shape == (SIZE_PX[1], SIZE_PX[0], 3)
    row, column = SIZE_PX[1] - STAGE_PX[1] // 2, STAGE_PX[0] // 2
    return [named(frame[row, column].astype(int)) for frame in frames]


def named(pixel: Array) -> int | str:
    if np.ptp(pixel) < 40:
        return min(GREYS, key=lambda grey: abs(grey - int(pixel.mean())))
    return ("red", "green", "blue")[int(np.argmax(pixel))]


def in_order(shown: list[int | str]) -> list[int | str]:
    return [now for before, now in zip([None, *shown], shown, strict=False) if now != before]


@pytest.mark.slow
@pytest.mark.parametrize("speed", [1.0, 2.0])
def test_pictures_come_in_order_for_their_time_and_pauses_are_cut(
    tmp_path: Path, speed: float
) -> None:
    record, path = episode(tmp_path, moves=True), tmp_path / "one.mp4"
    facts = film_robot(TASK, record, tmp_path, path, speed=speed)
    shown = stage_of(path)
    assert in_order(shown) == ["red", *GREYS, "green", "blue"]
    assert len(shown) == round(facts.seconds * FPS)
    for grey, seconds in zip(GREYS, (0.25, 0.25, 1.0, 0.25, 0.25), strict=True):
        assert shown.count(grey) / FPS == pytest.approx(seconds / speed, abs=1.01 / FPS)


@pytest.mark.slow
def test_without_pictures_of_motions_stills_are_shown_and_it_is_said(tmp_path: Path) -> None:
    pytest.importorskip("av")
    moving, still = tmp_path / "moving", tmp_path / "still"
    films = {
        folder: film_robot(
            TASK, episode(folder, moves=folder == moving), folder, folder / "one.mp4"
        )
        for folder in (moving, still)
    }
    assert films[moving].seconds - films[still].seconds == pytest.approx(2.0, abs=0.1)
    assert in_order(stage_of(still / "one.mp4")) == ["red", "green", "blue"]
    assert not photographed(TASK, episode(tmp_path, moves=False), tmp_path).moves


def test_half_a_line_of_the_index_is_left_out_and_a_broken_one_named(tmp_path: Path) -> None:
    record = episode(tmp_path, moves=True)
    index = tmp_path / Path(record.frames[0]).parent / "motion.jsonl"
    whole = index.read_bytes()
    index.write_bytes(whole[:-9])
    assert len(photographed(TASK, record, tmp_path).pictures) == 4 + len(GREYS) - 1
    index.write_bytes(whole.replace(b"stamp", b"stump"))
    with pytest.raises(BadData, match="motion.jsonl"):
        photographed(TASK, record, tmp_path)


def test_a_missing_picture_is_named(tmp_path: Path) -> None:
    pytest.importorskip("av")
    record = episode(tmp_path, moves=True)
    (tmp_path / f"{record.frames[2]}.jpg").unlink()
    with pytest.raises(BadData, match=r"002\.jpg"):
        film_robot(TASK, record, tmp_path, tmp_path / "one.mp4")
    assert not (tmp_path / "one.mp4").exists()


def test_what_only_poses_can_tell_isn_t_filmed(tmp_path: Path) -> None:
    find = next(task for task in demo_suite().tasks if task.question_type == "find")
    record = replace(episode(tmp_path, moves=False), task=find.id, question=question_of(find))
    record = replace(record, answer=Answer(find.answer, (5.0, 5.0)))
    with pytest.raises(NoPoses, match="asks for a point"):
        film_robot(find, record, tmp_path, tmp_path / "one.gif", "gif")
