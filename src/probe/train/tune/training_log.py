"""How the loss went, step by step, on disk while a model is trained."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import isfinite
from pathlib import Path
from time import time
from typing import Any

import pydantic

from probe.episodes.files import append_line, set_aside_cut
from probe.errors import BadData
from probe.train.tune.libraries import transformers

DIARY = "loss.jsonl"


class LoggedStep(pydantic.BaseModel, extra="ignore", frozen=True):
    """One step.

    Attributes:
        step: Its number, from 1 on.
        loss: Mean over the tokens of its examples.
        learning_rate: That it was made with.
        session: When the process began that made it, in seconds since 1970.
        seconds: Since then.
        tokens: That were read since then; 0 in logs of before they were counted.
    """

    step: int
    loss: float
    learning_rate: float
    session: float
    seconds: float
    tokens: int = 0


@dataclass(frozen=True)
class LossInterval:
    """Some steps in a row.

    Attributes:
        first, last: Numbers of its steps, both included.
        loss: Mean over them.
        learning_rate: Of the last one.
    """

    first: int
    last: int
    loss: float
    learning_rate: float


def diary_callback(out: Path) -> Any:
    """Adds each step's entry to the file; for transformers' Trainer."""
    session = time()
    set_aside_cut(out / DIARY)
    base: Any = transformers().TrainerCallback

    class Diary(base):
        """A TrainerCallback.

        Attributes:
            before: Tokens that earlier sessions had read.
        """

        before = 0

        def on_train_begin(self, args: Any, state: Any, control: Any, **told: Any) -> None:
            self.before = int(state.num_input_tokens_seen)

        def on_log(self, args: Any, state: Any, control: Any, **told: Any) -> None:
            logs: dict[str, Any] = told.get("logs") or {}
            if "loss" in logs:
                _check_finite(float(logs["loss"]), state.global_step)
            if state.is_world_process_zero and "loss" in logs:
                entry = LoggedStep(
                    step=state.global_step,
                    loss=float(logs["loss"]),
                    learning_rate=float(logs.get("learning_rate", 0.0)),
                    session=session,
                    seconds=time() - session,
                    tokens=int(state.num_input_tokens_seen) - self.before,
                )
                append_line(out / DIARY, entry.model_dump_json().encode() + b"\n")

    return Diary()


def _check_finite(loss: float, step: int) -> None:
    if not isfinite(loss):
        remedy = "Choose a smaller one, and train into another folder"
        raise BadData("--learning-rate", f"the loss of step {step} is {loss}", remedy)


def read_log(out: Path) -> list[LoggedStep]:
    """The entry of each step; of one that was made twice, after a resumption, the later one.

    Raises:
        BadData: A line is broken.
    """
    by_step: dict[int, LoggedStep] = {}
    for line in _lines(out / DIARY):
        try:
            entry = LoggedStep.model_validate_json(line)
        except pydantic.ValidationError as error:
            raise BadData(out / DIARY, "a line can't be read", "Delete that line") from error
        by_step[entry.step] = entry
    return [by_step[step] for step in sorted(by_step)]


def learning_curve(entries: Sequence[LoggedStep], most: int) -> list[LossInterval]:
    """The loss in stretches of about as many steps each: that of one step depends on its examples.

    Args:
        entries: Of all steps, in order.
        most: How many stretches; fewer where there are fewer steps.
    """
    count = min(most, len(entries))
    bounds = [len(entries) * n // count for n in range(count + 1)] if count else []
    return [_stretch(entries[start:end]) for start, end in pairwise(bounds)]


def _stretch(entries: Sequence[LoggedStep]) -> LossInterval:
    loss = sum(it.loss for it in entries) / len(entries)
    return LossInterval(entries[0].step, entries[-1].step, loss, entries[-1].learning_rate)


def effort_of(out: Path) -> tuple[float, int]:
    """Seconds and tokens of all sessions together, as far as they made steps."""
    last: dict[float, LoggedStep] = {}
    for line in _lines(out / DIARY):
        entry = LoggedStep.model_validate_json(line)
        last[entry.session] = entry
    return sum(it.seconds for it in last.values()), sum(it.tokens for it in last.values())


def _lines(path: Path) -> Sequence[str]:
    """Whole lines: the last one may have been cut off."""
    text = path.read_text() if path.exists() else ""
    return text[: text.rfind("\n") + 1].splitlines()
