"""What the teacher says of a later list: which things have other object_ids, and which count."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

import pytest

from packed_teacher import all_episodes
from probe.episodes.record import EpisodeRecord
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.listed_ids import SayWithoutFinding, without_finding
from probe.train.dataset.augment.rephrasing import rephrased
from probe.transcripts.result_texts import ResultTexts

LINE = re.compile(
    r"^- (object_\d+) at \[\d+, \d+\](, new|, another)?: (.*), \1, \[.*$", re.MULTILINE
)
UNNAMED = "without a name"
MOVED = re.compile(r"These have other object_ids now: (.*?)\. ")
LATER = re.compile(r"New, from top to bottom: (.*?)\. I could search this: ")


@dataclass
class Change:
    """A later list, and what is said before the next manipulation.

    Attributes:
        before: Names that were known, by object_id.
        lines: object_ids and names in the later list, in its order.
        marked: Those of them that it marks.
        words: Of the teacher.
    """

    before: dict[str, str]
    lines: list[tuple[str, str]]
    marked: list[tuple[str, str]]
    words: str


@pytest.fixture(scope="module")
def changes(tmp_path_factory) -> list[tuple[str, Change]]:
    found = list[tuple[str, Change]]()
    for task, record in all_episodes(tmp_path_factory.mktemp("packed")):
        words = SayWithoutFinding(speaker(task, record.run))
        told = without_finding(rephrased(task, record, words))
        found += [(task.question_type, it) for it in changes_in(told)]
    return found


def changes_in(record: EpisodeRecord) -> Iterator[Change]:
    texts, known = ResultTexts("0-1000", "short"), dict[str, str]()
    for step, after in zip(record.steps, record.steps[1:], strict=False):
        text = texts.told(step.call.name, step.text)
        if step.call.name != "perceive_scene":
            continue
        found = [
            (id, UNNAMED if is_part(what) else what, mark) for id, mark, what in LINE.findall(text)
        ]
        lines = [(id, what) for id, what, _ in found]
        if known:
            marked = [(id, what) for id, what, mark in found if mark]
            yield Change(dict(known), lines, marked, after.call.words)
        gone = re.findall(r"object_\d+", text.partition("out of date: ")[2])
        known = {id: what for id, what in known.items() if id not in gone} | dict(lines)


def is_part(what: str) -> bool:
    return what.startswith("part of something")


def test_known_things_with_other_object_ids_are_told_and_no_others(changes):
    told = 0
    for kind, change in changes:
        if kind not in ("find", "reduce", "beneath", "behind"):
            assert not MOVED.search(change.words)
            continue
        names = {*change.before.values()} - {UNNAMED}
        moved = [
            f"{what}, {id}"
            for id, what in change.lines
            if id not in change.before and what in names
        ]
        found = MOVED.search(change.words)
        assert (found[1].split("; ") if found else []) == moved
        told += bool(moved)
    assert told > 50


def test_to_count_it_goes_through_what_a_later_list_calls_otherwise(changes):
    told = 0
    for kind, change in changes:
        found = LATER.search(change.words)
        if kind != "count":
            assert not found
            continue
        named = [it for it in change.lines if it[1] != UNNAMED]
        assert change.marked == [it for it in named if change.before.get(it[0]) != it[1]]
        each = [
            re.fullmatch(r"(object_\d+) (.*?)(?:, so \((\d+)\) \2, \1)?", it)
            for it in (found[1].split("; ") if found else [])
        ]
        assert [it and it.groups()[:2] for it in each] == change.marked
        told += bool(each)
    assert told > 100
