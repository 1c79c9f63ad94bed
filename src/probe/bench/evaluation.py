"""Runs a plan with a model from our own command line, with our defaults."""

from __future__ import annotations

from contextlib import closing
from dataclasses import dataclass
from typing import Literal

# One of its many parameters has a type of an extra that isn't installed.
from inspect_ai import eval as run_harness  # pyright: ignore[reportUnknownVariableType]
from inspect_ai.model import Model, get_model

from probe.bench.harness import harness_task
from probe.bench.plan import Plan, take_up
from probe.bench.scoring import MISSING
from probe.bench.seating import ROLE, Seating
from probe.episodes.folder import reserved
from probe.errors import ModelFailed

LOGS = "logs"
"""Folder of the harness's own logs, beside the records."""

_SERVICE = "openai-api/endpoint/"


@dataclass(frozen=True)
class Chosen:
    """Who takes part.

    Attributes:
        model: The harness's name of the one that acts.
        endpoint: Address of a server that speaks OpenAI's protocol; None for the model's usual.
        key: For that server.
        pointer: The harness's name of the one that points for perception, if that is another.
    """

    model: str
    endpoint: str | None = None
    key: str = "none"
    pointer: str | None = None


def evaluate(plan: Plan, chosen: Chosen, display: Literal["rich", "plain", "none"]) -> int:
    """Run what the folder lacks; returns how many episodes are missing in the end.

    Raises:
        BadData: The folder is about something else.
        OutputFailed: It can't be written.
    """
    seating, model = Seating(plan), _model(chosen)
    # Before anything is asked; each sample would raise it otherwise.
    pointer = "self" if plan.pointer == "self" else chosen.pointer or ""
    take_up(plan, plan.order(str(model), pointer))
    with reserved(plan.out), closing(seating):
        (log,) = run_harness(
            harness_task(plan, seating),
            model=model,
            model_roles={ROLE: chosen.pointer} if chosen.pointer else {},
            display=display,
            log_dir=str(plan.out / LOGS),
            max_samples=plan.workers,
        )
    scores = [sample.scores or {} for sample in log.samples or []]
    good = sum(1 for each in scores if each and each["probe"].value != MISSING)
    return len(plan.tasks) * plan.epochs - good


def _model(chosen: Chosen) -> Model:
    try:
        if chosen.endpoint is None:
            return get_model(chosen.model)
        name = chosen.model.removeprefix("openai-api/vllm/")
        return get_model(_SERVICE + name, base_url=chosen.endpoint, api_key=chosen.key)
    except Exception as error:  # a missing key or client; each provider raises its own
        reason = " ".join(str(error).split())
        raise ModelFailed(f"{chosen.model} can't be asked: {reason}") from error
