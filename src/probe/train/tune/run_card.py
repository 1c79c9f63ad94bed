"""The card of a training: what was trained on what, with which libraries, and how the loss went."""

from __future__ import annotations

import json
import platform
from collections.abc import Sequence
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import Literal

import pydantic

from probe.files import write_text
from probe.train.dataset.manifest import (
    Manifest,
    augmented_told,
    objects_told,
    words_told,
)
from probe.train.tune import libraries
from probe.train.tune.started import TrainingStart
from probe.train.tune.training_log import (
    LoggedStep,
    LossInterval,
    effort_of,
    learning_curve,
    read_log,
)

RUN, CARD = "run.json", "README.md"
_LINES = 12
"""Of the learning curve; the loss of each step is in the diary."""


class Run(pydantic.BaseModel, extra="forbid", frozen=True):
    """A training that is over.

    Attributes:
        begun: What it was begun with.
        examples: Those that are told as they went, by type and setting.
        augmented: Those that are told otherwise, by way and type.
        versions: Of libraries, ours included.
        hardware: What it ran on, in words.
        weights: Type of the numbers that were trained, such as "float32".
        computed: Type of the numbers that were computed with; empty in older files.
        steps: How many.
        seconds: Of all sessions together, from when the model is loaded to their last step's log.
        tokens: That were read, in all sessions together; 0 for trainings of before they were
            counted.
        first_loss, last_loss: Means over a tenth of the steps.
    """

    version: Literal[1] = 1
    begun: TrainingStart
    examples: dict[str, dict[str, int]]
    augmented: dict[str, dict[str, int]] = {}
    versions: dict[str, str]
    hardware: str
    weights: str
    computed: str = ""
    steps: int
    seconds: float
    tokens: int = 0
    first_loss: float
    last_loss: float


def write_card(
    out: Path, begun: TrainingStart, manifest: Manifest, weights: str, computed: str
) -> Run:
    """Write run.json and README.md into a training's folder.

    Args:
        out: The folder.
        begun: What it was begun with.
        manifest: The data set's.
        weights: Type of the numbers that were trained.
        computed: Type of the numbers that were computed with.

    Raises:
        OutputFailed: They can't be written.
    """
    log = read_log(out)
    tenth = max(1, len(log) // 10)
    seconds, tokens = effort_of(out)
    run = Run(
        begun=begun,
        examples=manifest.examples,
        augmented=manifest.augmented,
        versions={"probe-vqa": version("probe-vqa"), **libraries.versions()},
        hardware=hardware(),
        weights=weights,
        computed=computed,
        steps=len(log),
        seconds=round(seconds, 1),
        tokens=tokens,
        first_loss=round(_mean(log[:tenth]), 4),
        last_loss=round(_mean(log[-tenth:]), 4),
    )
    write_text(out / RUN, run.model_dump_json(indent=1) + "\n")
    write_text(out / CARD, _page(run, manifest, told_curve(log)))
    return run


def told_curve(log: Sequence[LoggedStep]) -> list[str]:
    """A training's learning curve as rows of Markdown: steps, mean loss, learning rate at the end.

    Args:
        log: Of all its steps, in order.
    """
    return [_row(stretch) for stretch in learning_curve(log, _LINES)]


def hardware() -> str:
    """What this machine computes with."""
    torch = libraries.torch()
    if torch.cuda.is_available():
        return f"{torch.cuda.device_count()} x {torch.cuda.get_device_name(0)}"
    threads = f"{torch.get_num_threads()} threads"
    return f"{platform.machine()}, {threads}, no GPU"


def _row(it: LossInterval) -> str:
    return f"| {it.first}-{it.last} | {it.loss:.4f} | {it.learning_rate:.2e} |"


def _page(run: Run, manifest: Manifest, curve: Sequence[str]) -> str:
    words = (files("probe.train") / "data/run_card.md").read_text("utf-8")
    again = sum(sum(by_type.values()) for by_type in run.augmented.values())
    return words.format(
        model=run.begun.model,
        dataset=run.begun.dataset,
        mark=run.begun.dataset_sha256,
        total=manifest.total,
        objects=" ".join(filter(None, _told(manifest))),
        counts="\n".join(
            f"| {question_type} | {sum(settings.values()) - settings.get('direct', 0)} "
            f"| {settings.get('direct', 0)} |"
            for question_type, settings in sorted(run.examples.items())
        ),
        settings=json.dumps(run.begun.tuning, indent=1),
        versions=", ".join(f"{name} {number}" for name, number in run.versions.items()),
        hardware=run.hardware,
        weights=run.weights,
        computed=run.computed,
        told_again=f" and {again} that tell them again" if again else "",
        steps=run.steps,
        tokens=f"{run.tokens:,}",
        minutes=f"{run.seconds / 60:.1f}",
        loss="\n".join(curve),
    )


def _told(manifest: Manifest) -> list[str]:
    """What there is to know about the data set; a sentence that doesn't apply is empty."""
    return [objects_told(manifest.objects), augmented_told(manifest), words_told(manifest)]


def _mean(log: Sequence[LoggedStep]) -> float:
    return sum(it.loss for it in log) / len(log) if log else float("nan")
