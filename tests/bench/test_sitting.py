"""An episode's seat while perception asks a model, and tables that fail or hang meanwhile."""

from __future__ import annotations

from typing import Any

import anyio
import pytest

from bench.odd_tables import CuriousPlace, HangingPlace, StillbornPlace
from probe.bench.process_pool import Assignment, EpisodeProcessLost, EpisodeProcessPool
from probe.episodes.participation import Participation
from probe.episodes.turns import Call
from probe.errors import WorkerDied
from probe.runs.worker_messages import FinishEpisode, PointerRequest

pytestmark = pytest.mark.slow

WHERE = PointerRequest((), "where?")
ANY: Any = None
SILENCE, PATIENCE = 6.0, 300.0
"""Seconds: more than a busy machine takes to start a process, and more than three times that."""


class LimitReached(Exception):
    """As the harness raises it, from wherever a model is asked."""


def test_a_limit_reached_while_pointing_leaves_a_table_that_can_be_left():
    """The record is that of the calls before; the one that came to nothing isn't in it."""
    asked: list[PointerRequest] = []

    async def ask(what: PointerRequest) -> str:
        asked.append(what)
        if len(asked) == 2:
            raise LimitReached
        return "there"

    async def sitting_down() -> bytes:
        pool = EpisodeProcessPool(CuriousPlace(ANY, ANY), 1, pointing=True)
        async with pool.seat(ask) as assignment:
            await assignment.sit(ANY)
            assert (await assignment.call(Call("find_object"))).text == "there"
            with pytest.raises(LimitReached):
                await assignment.call(Call("find_object"))
            left = await _in_time(assignment)
        pool.close()
        return left

    assert anyio.run(sitting_down) == b"find_object"
    # The call before was done anew at another table, which had to ask again.
    assert asked == [WHERE] * 3


async def _in_time(assignment: Assignment) -> bytes:
    with anyio.fail_after(60):
        return (await assignment.leave(FinishEpisode(Participation("agentic")))).line


def test_a_table_that_hangs_is_lost_and_not_waited_for():
    async def sitting_down() -> None:
        pool = EpisodeProcessPool(HangingPlace(ANY, ANY), 1, silence=SILENCE)
        async with pool.seat(_nobody) as assignment:
            await assignment.sit(ANY)
            with (
                anyio.fail_after(PATIENCE),
                pytest.raises(EpisodeProcessLost, match="said nothing"),
            ):
                await assignment.call(Call("push"))
            assert len(assignment.failures) == 3

    anyio.run(sitting_down)


def test_tables_that_die_before_they_are_set_up_stop_everything():
    async def sitting_down() -> None:
        pool = EpisodeProcessPool(StillbornPlace(ANY, ANY), 1)
        async with pool.seat(_nobody) as assignment:
            await assignment.sit(ANY)

    with pytest.raises(WorkerDied):
        anyio.run(sitting_down)


async def _nobody(asked: PointerRequest) -> str:
    raise AssertionError
