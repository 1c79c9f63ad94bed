"""A plan as a task of the harness: its samples, solver, limits and scorer."""

from __future__ import annotations

from logging import getLogger
from typing import Any

from inspect_ai import Epochs
from inspect_ai import Task as HarnessTask
from inspect_ai.dataset import MemoryDataset, Sample
from inspect_ai.model import ChatMessageUser, GenerateConfig, get_model
from inspect_ai.solver import Generate, Solver, TaskState, solver
from inspect_ai.util import LimitExceededError

from probe.bench.finished import FinishedEpisode
from probe.bench.model_runner import ModelRunner
from probe.bench.plan import ModelRunPlan
from probe.bench.scoring import MISSING, RIGHT, STORE, WRONG, accuracy_by_type, graded
from probe.bench.stopping import RunStopped
from probe.texts import line
from probe.toolshed.version import TOOLS_VERSION

_LOGGER = getLogger(__name__)

RETRIES = 8
"""How often a request is tried again that the server couldn't take or lost."""

PATIENCE = 600
"""Seconds that one attempt at a reply may take."""


def harness_task(plan: ModelRunPlan, runner: ModelRunner | None = None) -> HarnessTask:
    """A task of the harness.

    Args:
        plan: What is run.
        runner: Of that plan, if the caller wants to close it.
    """
    return HarnessTask(
        dataset=MemoryDataset([_sample(plan, task.id) for task in plan.tasks], plan.suite.name),
        solver=_seat(runner or ModelRunner(plan)),
        scorer=graded(),
        metrics=[accuracy_by_type(len(plan.tasks), plan.epochs)],
        epochs=Epochs(plan.epochs, "mean"),
        config=GenerateConfig(max_retries=RETRIES, attempt_timeout=PATIENCE),
        # A sample of ours raises only where no other would fare better.
        fail_on_error=True,
        name=plan.setting.replace("-", "_"),
        metadata={
            "suite": plan.suite.name,
            "records": str(plan.out),
            "points": plan.points,
            "tools": TOOLS_VERSION,
        },
    )


def _sample(plan: ModelRunPlan, id: str) -> Sample:
    task = next(task for task in plan.tasks if task.id == id)
    lines = [task.question, *(f"{option.letter}: {option.text}" for option in task.options)]
    metadata: dict[str, Any] = {"kind": task.question_type, "arm": plan.named_setting}
    return Sample(input="\n".join(lines), target=task.answer, id=task.id, metadata=metadata)


def _seat(runner: ModelRunner) -> Solver:
    @solver(name="probe_seat")
    def seat() -> Solver:
        async def solve(state: TaskState, generate: Generate) -> TaskState:
            try:
                played = await runner.play(str(state.sample_id), state.epoch - 1, get_model())
            except (RunStopped, LimitExceededError):
                raise
            except Exception as error:  # a fault of ours; it mustn't take other samples with it
                reason = line(f"{type(error).__name__}: {error}")
                _LOGGER.warning("An episode came to nothing: %s", reason)
                _LOGGER.debug("An episode came to nothing", exc_info=error)
                state.store.set(STORE, {"value": MISSING, "explanation": reason})
                return state
            _show(state, played)
            if played.limit is not None:
                raise played.limit
            state.completed = True
            return state

        return solve

    return seat()


def _show(state: TaskState, played: FinishedEpisode) -> None:
    """The conversation and its worth, as the harness's log keeps them."""
    record, conversation = played.record, played.conversation
    if conversation is not None and conversation.messages:
        state.messages = conversation.messages
        if conversation.output is not None:
            state.output = conversation.output
    else:
        state.messages.append(ChatMessageUser(content="Played before; see the records."))
    state.store.set(STORE, _worth(played))
    state.store.set("end", record.end)


def _worth(played: FinishedEpisode) -> dict[str, Any]:
    record, score = played.record, played.score
    said = record.answer.choice if record.answer else None
    if score is None:
        return {"value": MISSING, "answer": said, "explanation": record.fault}
    metadata = {
        "outcome": score.outcome,
        "letter_correct": score.letter_correct,
        "manipulations": record.manipulations,
        "turns": len(record.steps),
        "faults": list(record.participation.faults) if record.participation else [],
    }
    value = RIGHT if score.correct else WRONG
    return {"value": value, "answer": said, "explanation": score.outcome, "metadata": metadata}
