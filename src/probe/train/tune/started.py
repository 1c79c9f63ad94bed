"""The folder of a training: what it was begun with, and where it stopped.

`training.json` is there from the start, `checkpoints/` grows, the card and then `model/` come last.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any, Literal

import pydantic

from probe.errors import BadData
from probe.files import read_document, write_text
from probe.train.dataset.manifest import MANIFEST
from probe.train.tune.tuning import Tuning

TRAINING, CHECKPOINTS, MODEL, ROWS = "training.json", "checkpoints", "model", "rows"
_LAST_FILE = "trainer_state.json"
"""What transformers writes last into a checkpoint: one without it, or a part of it, was cut off."""


class TrainingStart(pydantic.BaseModel, extra="forbid", frozen=True):
    """What a training was begun with.

    Attributes:
        model: Where it starts from.
        dataset: Its folder.
        dataset_sha256: Of its manifest, which has the hash of each file.
        tuning: How.
    """

    version: Literal[1] = 1
    model: str
    dataset: str
    dataset_sha256: str
    tuning: dict[str, Any]


def begun(dataset: Path, model: str, tuning: Tuning) -> TrainingStart:
    """What is to be trained; the data set must have been checked."""
    mark = hashlib.sha256((dataset / MANIFEST).read_bytes()).hexdigest()
    return TrainingStart(
        model=model, dataset=str(dataset), dataset_sha256=mark, tuning=asdict(tuning)
    )


def take_up(out: Path, asked: TrainingStart) -> None:
    """Begin a folder, or see that it was begun with the same.

    Raises:
        BadData: It was begun with something else.
        OutputFailed: It can't be written.
    """
    path = out / TRAINING
    if not path.exists():
        write_text(path, asked.model_dump_json(indent=1) + "\n")
        return
    before = read_document(path, TrainingStart, "Train into another folder")
    remedy = "Say the same again, or choose another folder"
    if before.model != asked.model:
        raise BadData(path, f"was begun with {before.model}, not {asked.model}", remedy)
    if before.dataset_sha256 != asked.dataset_sha256:
        raise BadData(path, "was begun with another data set", remedy)
    usual = asdict(Tuning())
    for name, now in asked.tuning.items():
        was = before.tuning.get(name, usual.get(name))  # older files lack newer settings
        if was != now:
            raise BadData(path, f"was begun with {name} {was}, not {now}", remedy)


def last_checkpoint(out: Path) -> Path | None:
    """The last whole one before the last step: who goes on from that makes one more.

    One that was cut off stays until the same step is saved again: several processes may look.
    """
    found = sorted((out / CHECKPOINTS).glob("checkpoint-*"), key=_step)
    return next((folder for folder in reversed(found) if _leaves_steps(folder)), None)


def _leaves_steps(checkpoint: Path) -> bool:
    try:
        state = json.loads((checkpoint / _LAST_FILE).read_bytes())
    except (OSError, ValueError):
        return False
    return state["global_step"] < state["max_steps"]


def _step(folder: Path) -> int:
    return int(folder.name.rpartition("-")[2])
