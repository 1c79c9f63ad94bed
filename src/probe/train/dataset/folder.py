"""Writes a data set for training: the whole folder appears at once, or nothing does."""

from __future__ import annotations

import hashlib
import json
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path

from probe.assets.pools.division import parts_shown
from probe.assets.spec import ObjectSpec
from probe.errors import BadData
from probe.files import check_new, whole_folder, write_bytes, write_text
from probe.train.choose.chosen import LoadedSelection
from probe.train.dataset.augment.augmenting import Augmentation
from probe.train.dataset.augment.speech import AS_TAUGHT, Speech
from probe.train.dataset.card import card, shown_in
from probe.train.dataset.examples import TrainingExample
from probe.train.dataset.manifest import Manifest, mark_of, write_manifest
from probe.train.dataset.rows import IMAGE, Row, sharegpt_row, trl_row, vila_row
from probe.train.dataset.table import SHARD_ROWS, table_names, write_table

CARD = "README.md"
NAME = "probe"
"""Under which LLaMA-Factory knows it."""

NONE_AGAIN = Augmentation()

_INFO: Row = {
    NAME: {
        "file_name": "train.json",
        "formatting": "sharegpt",
        "columns": {
            "messages": "conversations",
            "system": "system",
            "tools": "tools",
            "images": "images",
        },
        "tags": {
            "role_tag": "from",
            "content_tag": "value",
            "user_tag": "human",
            "assistant_tag": "gpt",
            "observation_tag": "observation",
            "function_tag": "function_call",
        },
    }
}


@dataclass(frozen=True)
class Form:
    """What a data set is called and how it is told.

    Attributes:
        name: For its card.
        points: How places are counted.
        side_px: Width and height of pictures.
        others: Whether LLaMA-Factory's and VILA's forms are written too.
        speech: How the teacher speaks.
    """

    name: str
    points: str
    side_px: int
    others: bool = True
    speech: Speech = AS_TAUGHT


@dataclass
class _Written:
    """What has gone into the folder so far."""

    examples: defaultdict[str, Counter[str]] = field(
        default_factory=lambda: defaultdict[str, Counter[str]](Counter)
    )
    augmented: defaultdict[str, Counter[str]] = field(
        default_factory=lambda: defaultdict[str, Counter[str]](Counter)
    )
    pictures: int = 0
    sharegpt: list[Row] = field(default_factory=list[Row])
    vila: list[Row] = field(default_factory=list[Row])


def write_dataset(
    out: Path,
    examples: Iterable[TrainingExample],
    chosen: LoadedSelection,
    form: Form,
    specs: Mapping[str, ObjectSpec],
    again: Augmentation = NONE_AGAIN,
) -> Manifest:
    """Write a data set.

    Args:
        out: A new folder.
        examples: As many as were chosen and told again, one after another: all of them may not fit
            into memory.
        chosen: What they were made of.
        form: How to write them.
        specs: What the catalogue says of the objects that are shown.
        again: What of it was told otherwise, too.

    Raises:
        BadData: The folder is there already, or there are more or fewer examples.
        MissingExtra: Hugging Face's library isn't installed.
        OutputFailed: It can't be written; nothing is left of it.
    """
    check_new(out)
    with whole_folder(out) as folder:
        written = _Written()
        left = iter(examples)
        for name in table_names(len(chosen.episodes) + len(again.episodes)):
            some = list(islice(left, SHARD_ROWS))
            _add(folder, name, some, written, others=form.others)
        _check(written, chosen, again, out)
        if form.others:
            _write_others(folder, written)
        files = sorted(path for path in folder.rglob("*") if path.is_file())
        manifest = Manifest(
            points=form.points,
            side_px=form.side_px,
            examples={
                question_type: dict(settings)
                for question_type, settings in sorted(written.examples.items())
            },
            pictures=written.pictures,
            objects={
                part or "neither": count for part, count in parts_shown(shown_in(chosen)).items()
            },
            augmented={way: dict(sorted(written.augmented[way].items())) for way in again.left_out},
            not_augmented={way: dict(some) for way, some in again.left_out.items()},
            find=form.speech.find,
            plain=form.speech.plain,
            files={path.relative_to(folder).as_posix(): mark_of(path) for path in files},
        )
        write_text(folder / CARD, card(form.name, manifest, chosen, specs))
        write_manifest(folder, manifest)
    return manifest


def _add(
    folder: Path, name: str, examples: list[TrainingExample], written: _Written, *, others: bool
) -> None:
    write_table(folder / name, [trl_row(example) for example in examples])
    for example in examples:
        if example.augmented:
            written.augmented[example.augmented][example.question_type] += 1
        else:
            written.examples[example.question_type][example.setting] += 1
        written.pictures += len(example.pictures)
        # These forms can't tell which turns aren't to be learnt.
        if others and not example.not_learnt:
            paths = [_kept(folder, picture) for picture in example.pictures]
            written.sharegpt.append(sharegpt_row(example, [f"../{path}" for path in paths]))
            written.vila.append(vila_row(example, paths))


def _kept(folder: Path, picture: bytes) -> str:
    """The path of a picture's file; one that is shown twice is there once."""
    name = f"images/{hashlib.sha256(picture).hexdigest()[:24]}.jpg"
    if not (folder / name).exists():
        write_bytes(folder / name, picture)
    return name


def _write_others(folder: Path, written: _Written) -> None:
    for row in written.sharegpt:
        places = sum(turn["value"].count(IMAGE) for turn in row["conversations"])
        if places != len(row["images"]):
            reason = f"{places} places for {len(row['images'])} pictures"
            raise BadData(row["id"], reason, f"Leave this episode out: its words hold {IMAGE}")
    write_text(folder / "llamafactory/train.json", json.dumps(written.sharegpt, indent=1))
    write_text(folder / "llamafactory/dataset_info.json", json.dumps(_INFO, indent=1))
    write_text(folder / "vila/train.json", json.dumps(written.vila, indent=1))


def _check(written: _Written, chosen: LoadedSelection, again: Augmentation, out: Path) -> None:
    """As many of each type and setting as were chosen, and as many of each way as told again."""
    wanted = Counter(way for way, _, _ in again.episodes)
    told = Counter({way: some.total() for way, some in written.augmented.items()})
    if told != wanted:
        reason = f"augmented examples are {dict(told)}, but {dict(wanted)} were told"
        raise BadData(out, reason, "Write the data set again")
    for question_type, settings in chosen.document.examples.items():
        for setting, count in settings.items():
            found = written.examples[question_type][setting]
            if found != count:
                what = f"{question_type} examples of the setting {setting}"
                reason = f"{found} {what}, but {count} were chosen"
                raise BadData(out, reason, "Select again")
