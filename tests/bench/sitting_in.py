"""A scripted model behind the wire, and evaluations of it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from inspect_ai import eval as evaluate
from inspect_ai.log import EvalLog
from inspect_ai.model import get_model

from bench.painted import PaintedPlace
from model_server import Reply
from probe.bench.harness import harness_task
from probe.bench.model_runner import ModelRunner
from probe.bench.plan import ModelRunPlan
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.episodes.participation import Participation
from probe.episodes.record import EpisodeRecord
from probe.runs.episode_worker import EpisodeWorkerSetup

NAME = "openai-api/local/scripted"

FIND = ("find_object", '{"description": "white ball"}')
GRASP = ("grasp_and_remove", '{"object_id": "object_1"}')
LOOK = ("perceive_scene", "{}")


def answer(letter: str) -> tuple[str, str]:
    return "answer_question", json.dumps({"choice": letter, "point": [640, 490]})


def replies_so_far(body: dict[str, Any]) -> int:
    return sum(message["role"] == "assistant" for message in body["messages"])


def run_in(
    plan: ModelRunPlan, url: str, place: type[EpisodeWorkerSetup] = PaintedPlace, **config: Any
) -> EvalLog:
    """Let the scripted model of a server take the seat."""
    runner = ModelRunner(plan, place)
    model = get_model(NAME, base_url=url, api_key="none", memoize=False)
    try:
        (log,) = evaluate(
            harness_task(plan, runner),
            model=model,
            display="none",
            log_dir=str(plan.out / "logs"),
            max_samples=plan.workers,
            **config,
        )
    finally:
        runner.close()
    return log


def kept(out: Path) -> dict[str, EpisodeRecord]:
    return {record.task: record for record in read_records(out / RECORDS)}


def seat_of(record: EpisodeRecord) -> Participation:
    assert record.participation is not None
    return record.participation


def values_of(log: EvalLog) -> dict[str, Any]:
    """What each sample of one epoch is worth in the harness's log."""
    return {str(it.id): (it.scores or {})["probe"].value for it in log.samples or []}


def metrics_of(log: EvalLog) -> dict[str, float]:
    assert log.results is not None
    return {name: it.value for name, it in log.results.scores[0].metrics.items()}


Script = Callable[[int, dict[str, Any]], Reply]
