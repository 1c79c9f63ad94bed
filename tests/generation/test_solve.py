"""How long scripted agents try a candidate, by deeds and not by the clock."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from probe.generation.solve import MOST_MANIPULATIONS, SolveAttempt, enough


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
