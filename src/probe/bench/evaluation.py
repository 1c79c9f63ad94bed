"""Runs a plan with a model from our own command line, with our defaults."""

from __future__ import annotations

import re
import warnings
from asyncio import CancelledError
from collections.abc import Generator, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
from importlib.util import find_spec
from typing import Literal

import anyio

# One of its many parameters has a type of an extra that isn't installed.
from inspect_ai import eval as run_harness  # pyright: ignore[reportUnknownVariableType]
from inspect_ai.model import GenerateConfig, Model, get_model

from probe.bench.harness import PATIENCE, harness_task
from probe.bench.model_runner import ROLE, ModelRunner
from probe.bench.models import asked_as
from probe.bench.plan import ModelRunPlan, missing_of
from probe.bench.prices import Price
from probe.bench.raw_arguments import as_sent
from probe.bench.reasons import said, unreached
from probe.errors import MissingExtra, ModelFailed

LOGS = "logs"
"""Folder of the harness's own logs, beside the records."""

_MARKUP = re.compile(r"\[/?(?:bold|italic|underline|blue|red|green|yellow)\b[^\]\n]*\]")
"""Of the harness's words for a terminal."""


@dataclass(frozen=True)
class Participants:
    """Who takes part.

    Attributes:
        model: The harness's name of the one that acts.
        endpoint: Address of a server that speaks OpenAI's protocol; None for the model's usual.
        key: For that server.
        pointer: The harness's name of the one that points for perception, if that is another.
        pointer_price: Of its tokens.
    """

    model: str
    endpoint: str | None = None
    key: str = "none"
    pointer: str | None = None
    pointer_price: Price | None = None


def evaluate(
    plan: ModelRunPlan, chosen: Participants, display: Literal["rich", "plain", "none"]
) -> int:
    """Run what the folder lacks; returns how many episodes are missing in the end.

    Raises:
        BadData: The folder is about something else, or another run is at work there.
        OutputFailed: It can't be written.
        MissingExtra: A model's client isn't installed.
        ModelFailed: Nobody answers.
        WorkerUnfit: No table can be set up.
        WorkerDied: Tables die before they can be set up.
    """
    model = _model(chosen, chosen.model)
    pointer = _model(chosen, chosen.pointer) if chosen.pointer else None
    if pointer is not None and chosen.pointer_price is not None:
        plan = replace(plan, prices={**plan.prices, str(pointer): chosen.pointer_price})
    runner = ModelRunner(plan)
    order = plan.order(str(model), str(pointer or plan.pointer.removeprefix("oracle")))
    with closing(runner):
        # Before anything is asked; each sample would raise it otherwise.
        if runner.take_up(order):
            greet([_model(chosen, name) for name in (chosen.model, chosen.pointer) if name])
        with _interruptible(), warnings.catch_warnings():
            # Of a reply whose fields have other types than they should.
            warnings.filterwarnings("ignore", message="Pydantic serializer warnings")
            run_harness(
                harness_task(plan, runner),
                model=model,
                model_roles={ROLE: pointer} if pointer else {},
                display=display,
                log_dir=str(plan.out / LOGS),
                max_samples=plan.workers,
            )
    if runner.stopped is not None:
        raise runner.stopped
    return missing_of(plan, order)


@contextmanager
def _interruptible() -> Generator[None]:
    """Lets Ctrl-C end the harness alone, whatever it raises then; what is missing is told after."""
    try:
        yield
    except KeyboardInterrupt:
        return
    except BaseExceptionGroup as group:
        if group.subgroup((KeyboardInterrupt, CancelledError)) is None:
            raise


def greet(models: Sequence[Model]) -> None:
    """See that models answer at all, before hundreds of episodes wait for them.

    Raises:
        ModelFailed: One doesn't.
    """
    for model in models:
        try:
            anyio.run(_greet, model)
        except Exception as error:  # whatever a provider's client may raise
            raise ModelFailed(_unanswered(model, error)) from error


def _unanswered(model: Model, error: Exception) -> str:
    reason, address = unreached(error), getattr(model.api, "base_url", None)
    if reason is None:
        remedy = "Check --endpoint, the name and the key"
        return f"{model} doesn't answer: {said(error)}. {remedy}."
    where = address or "The address of its provider"
    remedy = "Start the server there, or say where it is with --endpoint"
    return f"{model} doesn't answer: {where} can't be reached ({reason}). {remedy}."


async def _greet(model: Model) -> None:
    async with model:
        config = GenerateConfig(max_retries=2, attempt_timeout=PATIENCE)
        await as_sent(model).generate("Say hello.", config=config)


def _model(chosen: Participants, name: str) -> Model:
    """One of the models; none is shared between two event loops.

    Raises:
        MissingExtra: Its client isn't installed.
        ModelFailed: It can't be asked.
    """
    asked = asked_as(name, chosen.model, chosen.endpoint)
    if name.startswith("grok/") and find_spec("xai_sdk") is None:
        raise MissingExtra(name, "bench,grok")
    try:
        if asked == name:
            return get_model(name, memoize=False)
        return get_model(asked, base_url=chosen.endpoint, api_key=chosen.key, memoize=False)
    except Exception as error:  # a missing key or client; each provider raises its own
        reason = " ".join(_MARKUP.sub("", str(error)).split())
        raise ModelFailed(f"{name} can't be asked: {reason}") from error
