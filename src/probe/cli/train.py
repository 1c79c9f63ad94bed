"""`probe train`: teach a model what a data set shows."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import tyro

from probe.cli.metavars import Folder
from probe.cli.screen import say
from probe.tasks.task import QuestionType
from probe.train.tune.fine_tuning import train as trained
from probe.train.tune.run_card import told_curve
from probe.train.tune.training_log import read_log
from probe.train.tune.tuning import Tuning

_PAPER = Tuning()


def train(
    dataset: Folder,
    out: Path = Path("outputs/trained"),
    model: str = "Qwen/Qwen3-VL-8B-Instruct",
    types: tuple[QuestionType, ...] = (),
    tuning: Annotated[Tuning, tyro.conf.arg(name="")] = _PAPER,
) -> None:
    """Train a model on a data set; continues where an earlier run stopped.

    The data set is checked first; one that isn't complete is refused.

    Args:
        dataset: A folder that `probe dataset` wrote.
        out: Folder for checkpoints, the loss, the model and its card.
        model: What to start from: a folder, or a name at Hugging Face.
        types: Types of questions of which there must be examples.
        tuning: How; by default as the paper did.
    """
    speaks = os.environ.get("RANK", "0") == "0"  # of several processes one
    if speaks:
        say(f"Checkpoints go to {out}; Ctrl-C stops, the same command goes on.")
    folder = trained(dataset, model, out, tuning, types)
    if speaks:
        _tell(out, folder)


def _tell(out: Path, folder: Path) -> None:
    curve = told_curve(read_log(out))
    say("steps, mean loss, learning rate at the end:", *curve)
    say(f"The model is in {folder}, its card in {out / 'README.md'}.")
    say(f"`probe serve-model {folder}` lets `probe run` ask it.")
