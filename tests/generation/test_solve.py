"""How long scripted agents try a candidate, by deeds and not by the clock."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from probe.generation import solve
from probe.generation.solve import MOST_MANIPULATIONS, SolveAttempt, enough, trials
from probe.scene.lighting import AMBIENT
from probe.tasks.suite_file import demo_suite


def test_a_task_of_a_shadowed_room_is_tried_in_even_light_and_an_older_one_as_it_was_made(
    monkeypatch,
):
    frozen = demo_suite().tasks[0]
    setup = replace(frozen.setup, lighting="day_room_3")
    shadowed = replace(frozen, version=3, scene=replace(frozen.scene, setup=setup))
    seen = []

    def play(task, agent, name, library, renderer, circumstances):
        seen.append(circumstances.viewpoint)
        raise InterruptedError

    monkeypatch.setattr(solve, "play", play)
    for task in (shadowed, replace(shadowed, version=2)):
        with pytest.raises(InterruptedError):
            trials(task, None, None)  # pyright: ignore[reportArgumentType] # nothing is looked up
    assert shadowed.viewpoint.lighting.name == "day_room_3"
    assert seen == [replace(shadowed.viewpoint, lighting=AMBIENT), None]


def attempts(*manipulations: int, solved: int | None = None) -> Iterator[SolveAttempt]:
    """Attempts with so many manipulations each; asking for more than there are fails."""
    for number, count in enumerate(manipulations):
        yield SolveAttempt("grasp", number, number == solved, count)
    raise AssertionError("one attempt too many")


def test_the_first_success_ends_it():
    assert len(enough(attempts(3, 10, 2, solved=2))) == 3


@pytest.mark.parametrize("each", [1, 4, 10])
def test_who_has_done_enough_in_vain_stops(each: int):
    needed = -(-MOST_MANIPULATIONS // each)
    assert len(enough(attempts(*[each] * needed))) == needed


def test_the_latest_success_in_a_frozen_suite_would_come_again():
    """A Count task of v1-scans was solved at the fifth attempt, after four with ten each."""
    assert enough(attempts(10, 10, 10, 10, 6, solved=4))[-1].solved


def test_all_attempts_may_be_made():
    few = (SolveAttempt("push", number, False, 2) for number in range(6))
    assert len(enough(few)) == 6
