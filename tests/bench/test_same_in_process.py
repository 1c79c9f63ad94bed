"""A policy through the wire and real physics is the same policy in this process."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import pytest

from bench.painted import demo, plan
from bench.sitting_in import kept, seat_of, sit_in
from model_server import serving
from policy_server import Policy, agent_in_run_0
from probe.assets.library import open_library
from probe.assets.tables import load_table
from probe.episodes.files import line_of
from probe.episodes.play import play
from probe.render.renderer import Renderer
from probe.runs.table import TablePlace

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

SUITE = demo(2)


def test_a_policy_over_the_wire_gives_the_same_bytes(tmp_path):
    library = partial(open_library, "procedural", None, tmp_path / "cache")
    things = library()
    with Renderer() as renderer:
        direct = {
            task.id: play(
                task, agent_in_run_0("scripted", task, 0, things, renderer), "scripted", things,
                load_table(task.scene.table, None), renderer,
            )
            for task in SUITE.tasks
        }  # fmt: skip
        order = plan(tmp_path / "out", "agentic", SUITE, cache=None, workers=1)
        order = replace(order, library=library, called="scripted")
        with serving(Policy("scripted", SUITE, things, renderer)) as server:
            sit_in(order, server.url, TablePlace)
    for id, record in kept(tmp_path / "out").items():
        assert seat_of(record).faults == ()
        alone = replace(record, seat=None)
        assert line_of(alone, timed=False) == line_of(direct[id], timed=False)
        assert seat_of(record).tokens_in == 100 * len(record.steps)
