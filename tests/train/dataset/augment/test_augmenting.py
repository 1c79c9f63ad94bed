"""Augmented examples are marked and counted apart; the rest is left out with a reason."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest

from lessons import lesson, training_task
from packed_teacher import names_in
from painted_teacher import SIZE, taught
from probe.agents.phrases import plainly
from probe.assets.spec import ObjectSpec
from probe.cli.dataset import dataset
from probe.errors import BadData
from probe.train.choose.chosen import LoadedSelection, read_selection, write_selection
from probe.train.choose.evaluation import evaluation_of
from probe.train.choose.selection import Recipe, select
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.augmenting import Augmentation, augmented
from probe.train.dataset.augment.listed_ids import SayWithoutFinding
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.speech import Speech, said_otherwise
from probe.train.dataset.augment.teller import AugmentationWay
from probe.train.dataset.examples import example_of
from probe.train.dataset.folder import Form, write_dataset
from probe.train.dataset.manifest import check_dataset
from probe.train.dataset.text_only import as_text_only, no_pictures

SHORT = "text-only, short graphs"
FORM = Form("x", "pixels", 1024)
PLAINLY = Speech(plain=True)
REASON = "its teacher spoke freely, and may have quoted the question"


def silent(it):
    """An episode in which nothing is said, so that another wording contradicts nothing."""
    steps = tuple(replace(each, call=replace(each.call, words="")) for each in it.record.steps)
    return replace(it, record=replace(it.record, steps=steps))


@pytest.fixture
def chosen(tmp_path) -> LoadedSelection:
    tasks = [training_task(n, "count") for n in (1, 2, 3)]
    lessons = [silent(lesson(tasks[0])), silent(lesson(tasks[1])), lesson(tasks[2])]
    objects = {it.object_id: (1.0, 2.0) for each in lessons for it in each.task.scene.objects}
    found = select(lessons, evaluation_of([]), Recipe())
    write_selection(tmp_path / "selected", found, Recipe(), objects, [], ["v1"])
    return as_text_only(read_selection(tmp_path / "selected"), "short")


def examples_of(chosen, again):
    for task, record in chosen.episodes:
        yield example_of(task, record, no_pictures(record))
    for way, task, record in again.episodes:
        yield example_of(task, record, no_pictures(record), None, way)


def write(out, chosen, again, form=FORM):
    ids = {it.object_id for task in chosen.suite.tasks for it in task.scene.objects}
    specs = {
        id: ObjectSpec(
            id, "mug", "mug", ("red",), "A mug.", 0.1, 0.5, (0.1, 0.1, 0.1), False,
            "procedural", "CC0-1.0", "PROBE",
        )
        for id in ids
    }  # fmt: skip
    return write_dataset(out, examples_of(chosen, again), chosen, form, specs, again)


def test_they_are_marked_and_counted_apart(tmp_path, chosen):
    from datasets import load_dataset

    again = augmented(chosen.episodes, ["wordings"], 0)
    write(tmp_path / "data", chosen, again)
    manifest = check_dataset(tmp_path / "data")
    assert manifest.total == 3 and manifest.examples == {"count": {SHORT: 3}}
    assert manifest.augmented == {"wordings": {"count": 2}}
    assert manifest.not_augmented == {"wordings": {REASON: 1}}
    rows = load_dataset(
        str(tmp_path / "data"), split="train", cache_dir=str(tmp_path / "cache")
    ).to_list()
    assert [row["augmented"] for row in rows] == ["", "", "", "wordings", "wordings"]
    assert [row["id"].endswith("-wordings") for row in rows] == [False] * 3 + [True] * 2
    assert rows[3]["messages"][1] != rows[0]["messages"][1]
    assert rows[3]["messages"][2:] == rows[0]["messages"][2:]
    others = json.loads((tmp_path / "data/llamafactory/train.json").read_text())
    assert [row["id"] for row in others] == [row["id"] for row in rows]
    card = (tmp_path / "data/README.md").read_text()
    assert "| count | 3 | 0 |" in card and "2 examples more are episodes of these, asked in" in card
    assert f"1 couldn't be told so (1, as {REASON})" in card


def test_without_augmentation_nothing_is_said_of_it(tmp_path, chosen):
    manifest = write(tmp_path / "data", chosen, Augmentation())
    assert manifest.augmented == manifest.not_augmented == {}
    assert "Augmented" not in (tmp_path / "data/README.md").read_text()


def test_the_seed_decides_and_nothing_else(chosen):
    def questions(seed):
        again = augmented(chosen.episodes, ["wordings"], seed)
        return [record.question.text for _, _, record in again.episodes]

    assert questions(1) == questions(1)
    assert len({tuple(questions(seed)) for seed in range(5)}) > 1
    # An episode's wording doesn't hang on those beside it.
    alone = augmented(chosen.episodes[1:2], ["wordings"], 1)
    assert [record.question.text for _, _, record in alone.episodes] == questions(1)[1:]


def test_phrases_are_the_teachers_and_never_the_same(tmp_path, chosen):
    """A teacher who says it the same way is left out, and one that isn't the scripted one."""
    assert augmented(chosen.episodes, ["phrases"], 0).left_out == {
        "phrases": {"its teacher isn't the scripted one": 3}
    }
    told = [augmented([(SIZE, taught())], ["phrases"], seed) for seed in range(5)]
    assert all(it.episodes[0][0] == "phrases" for it in told if it.episodes)
    assert len({it.episodes[0][2].steps[0].call.words for it in told if it.episodes}) > 1
    saying = told[0].episodes[0][2]
    assert [step.text for step in saying.steps] == [step.text for step in taught().steps]


def test_what_comes_out_as_it_was_is_left_out():
    """Its teacher has said each thing in the one way that it has."""
    plain = rephrased(SIZE, taught(), plainly)
    told = augmented([(SIZE, plain)], ["phrases"], 0, Speech(plain=True))
    assert not told.episodes
    assert told.left_out == {"phrases": {"it comes out the same": 1}}


def test_balanced_rare_types_are_told_several_times_and_each_time_otherwise(chosen):
    episodes = [*chosen.episodes, (SIZE, taught())]
    plain = augmented(episodes, ["phrases", "mirrored"], 0)
    again = augmented(episodes, ["phrases", "mirrored"], 0, balanced=True)
    said = [record for way, task, record in again.episodes if (way, task) == ("phrases", SIZE)]
    words = {tuple(step.call.words for step in record.steps) for record in said}
    # Three times as many of the other type are there; some may come out the same.
    assert 2 <= len(said) == len(words) <= 3
    assert said[0] == next(
        it for way, task, it in plain.episodes if (way, task) == ("phrases", SIZE)
    )
    mirrored = [way for way, task, _ in again.episodes if (way, task) == ("mirrored", SIZE)]
    assert mirrored == ["mirrored"]
    of_the_others = [it for it in again.episodes if it[1] != SIZE]
    assert of_the_others == [it for it in plain.episodes if it[1] != SIZE]


@pytest.mark.parametrize("kind", ["reduce", "compare", "size"])
def test_from_the_second_time_on_things_have_other_names_and_other_sizes(episodes, kind):
    others = [it for it in episodes if it[0].question_type != kind]
    rare = next(
        (task, it)
        for task, it in episodes
        if task.question_type == kind and it.answer and it.answer.choice == task.answer
    )
    again = augmented([*others, rare], ["ids", "names", "sizes"], 0, balanced=True)
    told = [it for way, task, it in again.episodes if (way, task.question_type) == ("ids", kind)]
    names = [{name for it in names_in(record) for name in it if name} for record in told]
    assert len(told) > 1 and names[0] == {it for each in names_in(rare[1]) for it in each if it}
    assert not any(names[0] & each for each in names[1:])
    boxes = [re.findall(r"\[\d+, \d+\]", record.steps[-1].call.words) for record in told]
    assert len({*map(tuple, boxes)}) == (len(told) if kind == "size" else 1)


def test_ids_tell_how_often_an_episode_was_told_so():
    task, record = SIZE, taught()
    first, second = (
        example_of(task, record, no_pictures(record), augmented="phrases", time=time).id
        for time in (1, 2)
    )
    assert first.endswith("-phrases") and second == f"{first}-2"


def test_balance_without_augmentation_is_refused(tmp_path):
    with pytest.raises(BadData, match=r"--balance: does nothing without --augment"):
        dataset(Path("selected"), tmp_path / "out", setting="text-only", balance=True)


def test_fewer_than_were_told_is_an_error(tmp_path, chosen):
    again = augmented(chosen.episodes, ["wordings"], 0)
    fewer = replace(again, episodes=again.episodes[:1])
    with pytest.raises(BadData, match="augmented examples are"):
        write_dataset(tmp_path / "data", examples_of(chosen, fewer), chosen, FORM, {}, again)
    assert not (tmp_path / "data").exists()


def test_episodes_with_pictures_are_not_told_again(tmp_path):
    with pytest.raises(BadData, match=r"--augment: .*Say --setting text-only, too"):
        dataset(Path("selected"), tmp_path / "out", augment=["mirrored"])


def test_with_pictures_find_object_is_told(tmp_path):
    with pytest.raises(BadData, match=r"--no-find: .*Say --setting text-only, too"):
        dataset(Path("selected"), tmp_path / "out", find=False)


def test_with_pictures_words_stay_as_they_were(tmp_path):
    with pytest.raises(BadData, match=r"--plain: .*Say --setting text-only, too"):
        dataset(Path("selected"), tmp_path / "out", plain=True)


def test_plain_words_have_no_other_phrases(tmp_path):
    with pytest.raises(BadData, match=r"--augment phrases: there are no other phrases"):
        dataset(
            Path("selected"), tmp_path / "out", setting="text-only", plain=True, augment=["phrases"]
        )


def test_plain_words_are_so_however_an_episode_is_told(chosen, episodes):
    taught = replace(chosen, episodes=tuple(episodes[::4]))
    plain = said_otherwise(taught, PLAINLY)
    ways: list[AugmentationWay] = ["wordings", "options", "names", "ids", "sizes", "fewer"]
    again = augmented(plain.episodes, ways, 1, PLAINLY)
    assert {way for way, _, _ in again.episodes} == {*ways}
    # Where marks change places, what was done first for A is done first for B.
    others = [(task, it) for way, task, it in again.episodes if way != "options" or not task.marks]
    told = [*plain.episodes, *others]
    assert all(rephrased(task, record, plainly) == record for task, record in told)
    assert any(rephrased(task, record, plainly) != record for task, record in taught.episodes)


def test_a_data_set_in_plain_words_says_so(tmp_path, chosen):
    manifest = write(
        tmp_path / "data", chosen, Augmentation(), Form("x", "pixels", 1024, speech=PLAINLY)
    )
    assert manifest.plain
    assert "says each thing in one way alone" in (tmp_path / "data/README.md").read_text()


def test_a_data_set_without_find_object_says_so(tmp_path, chosen):
    form = Form("x", "pixels", 1024, speech=Speech(find=False))
    manifest = write(tmp_path / "data", chosen, Augmentation(), form)
    assert not manifest.find
    card = (tmp_path / "data/README.md").read_text()
    assert "Calls of find_object are left out" in card
    write(tmp_path / "whole", chosen, Augmentation())
    assert "Calls of find_object" not in (tmp_path / "whole/README.md").read_text()


def test_without_find_object_no_way_has_it():
    said = rephrased(SIZE, taught(), SayWithoutFinding(speaker(SIZE, 0)))
    again = augmented([(SIZE, said)], ["mirrored", "wordings", "phrases"], 1, Speech(find=False))
    assert [way for way, _, _ in again.episodes] == ["mirrored", "wordings", "phrases"]
    for _, _, told in again.episodes:
        calls = [step.call for step in told.steps]
        assert "grasp_and_remove" in [call.name for call in calls]
        assert not [call for call in calls if call.name == "find_object" or "ind" in call.words]


def test_an_example_with_a_slip_is_marked_and_in_no_form_that_cannot_leave_it_out(
    tmp_path, chosen, episodes
):
    episodes = [it for it in episodes if it[0].question_type == "count"]
    said = said_otherwise(replace(chosen, episodes=tuple(episodes)), Speech(find=False))
    again = augmented(said.episodes, ["refused"], 1, Speech(find=False))
    assert again.episodes and {way for way, _, _ in again.episodes} == {"refused"}
    manifest = write(tmp_path / "data", chosen, again, Form("x", "pixels", 1024))
    assert manifest.augmented == {"refused": {"count": len(again.episodes)}}
    assert "with a call that is refused" in (tmp_path / "data/README.md").read_text()
    for name in ("llamafactory", "vila"):
        rows = json.loads((tmp_path / f"data/{name}/train.json").read_text())
        assert len(rows) == len(chosen.episodes)
        assert not [row for row in rows if row["id"].endswith("refused")]
