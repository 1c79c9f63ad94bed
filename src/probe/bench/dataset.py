"""A suite as a data set that Hugging Face's `datasets` loads: what direct mode shows and asks.

Knows no model and no harness.
"""

from __future__ import annotations

import io
from collections.abc import Iterable
from importlib import resources
from pathlib import Path
from typing import Any

from probe.assets.pools.division import parts_shown
from probe.episodes.grading import question_of
from probe.episodes.participation import Points
from probe.errors import MissingExtra
from probe.files import write_bytes, write_text
from probe.tasks.suite_file import CANARY
from probe.tasks.task import Task
from probe.transcripts.messages import opening

CARD, TABLE = "README.md", "data/test-00000-of-00001.parquet"
"""Files of the folder: the card, which says where the table is, and the table."""

Row = dict[str, Any]


def row_of(task: Task, picture: bytes, points: Points) -> Row:
    """One task as the data set has it.

    Args:
        task: With its answer.
        picture: The file that direct mode sends.
        points: How places are counted in the texts.
    """
    rules, question = opening("direct", points, question_of(task), ())
    return {
        "id": task.id,
        "type": task.question_type,
        "image": {"bytes": picture, "path": f"{task.id}.jpg"},
        "question": task.question,
        "options": [option.text for option in task.options],
        "answer": task.answer,
        "system": rules.text,
        "prompt": question.text,
        "canary": CANARY,
    }


def write_dataset(
    out: Path,
    name: str,
    rows: Iterable[Row],
    objects: Iterable[str] = (),
    drawn_by: Iterable[str] = ("filament",),
) -> int:
    """Write a folder with a card and a table; returns how many tasks it has.

    Args:
        out: The folder.
        name: Of the suite.
        rows: Its tasks.
        objects: Ids of what is on its tables; the card says how many are set aside for training.
        drawn_by: What drew the pictures, which the card says, too.

    Raises:
        MissingExtra: The library isn't installed.
        OutputFailed: It can't be written.
    """
    try:
        from datasets import Dataset, Features, Image, List, Value
    except ImportError as error:
        raise MissingExtra("A data set", "export") from error
    text = Value("string")
    kinds = dict.fromkeys(("id", "type"), text) | {"image": Image(), "question": text}
    kinds |= {"options": List(text)} | dict.fromkeys(("answer", "system", "prompt", "canary"), text)
    table = Dataset.from_list(list(rows), features=Features(kinds))
    buffer = io.BytesIO()
    table.to_parquet(buffer)
    write_bytes(out / TABLE, buffer.getvalue())
    # The card comes last: a folder with one is whole.
    write_text(out / CARD, _card(name, len(table), objects, drawn_by))
    return len(table)


def _card(name: str, count: int, objects: Iterable[str], drawn_by: Iterable[str]) -> str:
    words = (resources.files("probe.bench") / "data/card.md").read_text()
    seen = parts_shown(objects)["train"]
    note = (
        f"\n\n**{seen} of the objects on these tables are set aside for training.**" if seen else ""
    )
    drawn = " and ".join(sorted(drawn_by))
    return words.format(name=name, count=count, canary=CANARY, note=note, renderers=drawn)
