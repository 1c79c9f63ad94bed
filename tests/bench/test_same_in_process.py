"""A policy through the wire and real physics is the same policy in this process."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import pytest

from bench.painted import demo, plan
from bench.sitting_in import run_in, seat_of
from model_server import serving
from policy_server import Policy, agent_in_run_0
from probe.assets.library import open_library
from probe.episodes.circumstances import Circumstances
from probe.episodes.files import line_of, read_records
from probe.episodes.folder import RECORDS
from probe.episodes.noise import NOISES
from probe.episodes.play import play
from probe.render.renderer import Renderer
from probe.runs.episode_worker import EpisodeWorkerSetup

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

SUITE = demo(1)


def test_a_policy_over_the_wire_gives_the_same_bytes(tmp_path, cache):
    library = partial(open_library, "procedural", None, cache)
    things = library()
    with Renderer() as renderer:
        direct = {
            (task.id, run): play(
                task, agent_in_run_0("scripted", task, run, things, renderer), "scripted", things,
                renderer, Circumstances(run, NOISES["paper"]),
            )
            for task in SUITE.tasks for run in range(2)
        }  # fmt: skip
        order = plan(tmp_path / "out", "agentic", SUITE, cache=None, workers=1, epochs=2)
        order = replace(order, library=library, called="scripted", noise=NOISES["paper"])
        with serving(Policy("scripted", SUITE, things, renderer)) as server:
            run_in(order, server.url, EpisodeWorkerSetup)
    records = {(it.task, it.run): it for it in read_records(tmp_path / "out" / RECORDS)}
    assert records.keys() == direct.keys()
    for key, record in records.items():
        assert seat_of(record).faults == ()
        alone = replace(record, participation=None)
        assert line_of(alone, timed=False) == line_of(direct[key], timed=False)
        assert seat_of(record).tokens_in == 100 * len(record.steps)
    # The hand's errors are each run's own, or a mistaken number of the run would go unseen.
    assert any(
        [step.after for step in direct[id, 0].steps] != [step.after for step in direct[id, 1].steps]
        for id, _ in direct
    )
