"""The harness's role "pointer" is never left aside without a word."""

from __future__ import annotations

from dataclasses import replace

import pytest
from inspect_ai.model import get_model

from bench.painted import demo, plan
from bench.sitting_in import run_in
from model_server import Reply, serving

pytestmark = pytest.mark.filterwarnings("default")

SUITE = demo(1)


@pytest.mark.parametrize(
    ("setting", "pointer", "given", "said"),
    [
        ("agentic", "oracle", True, "Say -T pointer=role, too"),
        ("agentic", "self", True, "the pointer is self"),
        ("agentic", "role", False, "Say --model-role pointer=NAME, too"),
        ("direct", "oracle", True, "without tools"),
    ],
)
def test_a_role_that_doesnt_fit_stops_the_run(tmp_path, setting, pointer, given, said):
    asked = replace(plan(tmp_path, setting, SUITE), pointer=pointer)
    roles = {"pointer": get_model("mockllm/eyes")} if given else {}
    with serving(lambda number, body: Reply("Hello.")) as server:
        log = run_in(asked, server.url, model_roles=roles)
    assert log.status == "error" and log.error and said in log.error.message
    assert server.bodies == []
