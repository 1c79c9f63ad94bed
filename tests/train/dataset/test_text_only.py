"""A teacher's episodes told for students that see no pictures."""

from __future__ import annotations

from dataclasses import replace

import pytest

from lessons import lesson, training_task
from probe.episodes.turns import Call
from probe.errors import BadData
from probe.train.choose.chosen import LoadedSelection, read_selection, write_selection
from probe.train.choose.evaluation import evaluation_of
from probe.train.choose.selection import Recipe, select
from probe.train.dataset.examples import example_of
from probe.train.dataset.folder import Form, write_dataset
from probe.train.dataset.manifest import check_dataset
from probe.train.dataset.text_only import as_text_only, no_pictures
from probe.transcripts.prompts import system_prompt

SHORT = "text-only, short graphs"
WITH_TOOLS = [lesson(training_task(1)), lesson(training_task(3, "count"))]


def chosen_of(tmp_path, lessons) -> LoadedSelection:
    found = select(lessons, evaluation_of([]), Recipe())
    objects = {it.object_id: (1.0, 2.0) for each in lessons for it in each.task.scene.objects}
    write_selection(tmp_path / "selected", found, Recipe(), objects, [], ["v1"])
    return read_selection(tmp_path / "selected")


def test_an_example_has_the_settings_rules_and_no_picture(tmp_path):
    chosen = as_text_only(chosen_of(tmp_path, WITH_TOOLS), "short")
    assert chosen.document.examples == {"find": {SHORT: 1}, "count": {SHORT: 1}}
    for task, record in chosen.episodes:
        example = example_of(task, record, no_pictures(record))
        assert (example.setting, example.pictures) == (SHORT, ())
        assert example.messages[0].text == system_prompt("text-only", "pixels")
        assert "new picture" not in example.tools and "grasp_and_remove" in example.tools
        # The teacher's own words stay.
        assert example.messages[2].text == "I want the mug."


def test_a_list_is_told_in_short_to_those_who_are_told_so(tmp_path):
    (task, record), *_ = chosen_of(tmp_path, WITH_TOOLS).episodes
    listed = (
        '# x\nobjects:\n- number: 1\n  object_id: object_1\n  name: "mug"\n  description: "A mug."'
        "\n  point: [5, 6]\n  box: [0, 0, 9, 9]\nrelations: []\ncluttered: []\nclear: []"
    )
    look = replace(record.steps[0], call=Call("perceive_scene"), text=listed)
    seat = record.participation
    assert seat is not None
    looked = replace(record, steps=(look, *record.steps[1:]))
    texts = {
        setting: example_of(
            task,
            replace(looked, participation=replace(seat, setting=setting)),
            no_pictures(looked),
        )
        .messages[3]
        .text
        for setting in ("text-only", SHORT)
    }
    assert texts["text-only"] == listed
    assert texts[SHORT].endswith("\n- object_1 at [5, 6]: mug, object_1, [10, 10]")


def test_a_data_set_without_pictures_is_whole_and_says_so(tmp_path):
    chosen = as_text_only(chosen_of(tmp_path, WITH_TOOLS), "short")
    examples = [example_of(task, it, no_pictures(it)) for task, it in chosen.episodes]
    write_dataset(tmp_path / "data", examples, chosen, Form("x", "pixels", 1024), _Specs())
    manifest = check_dataset(tmp_path / "data")
    assert (manifest.total, manifest.pictures) == (2, 0)
    card = (tmp_path / "data/README.md").read_text()
    assert f"none are shown; the setting is {SHORT}" in card
    assert "| find | 1 | 0 |" in card
    assert "| `vila/`" in card and "| `images/`" not in card


@pytest.mark.parametrize("setting", ["direct", "agentic, pointer self"])
def test_what_has_no_tools_or_no_ids_is_refused(tmp_path, setting):
    chosen = chosen_of(tmp_path, WITH_TOOLS)
    (task, record), *others = chosen.episodes
    seat = record.participation
    assert seat is not None
    odd = replace(record, participation=replace(seat, setting=setting))
    with pytest.raises(BadData, match=rf"--setting text-only: .* the setting {setting}\. .*share"):
        as_text_only(replace(chosen, episodes=((task, odd), *others)), "full")


def test_who_saw_nothing_is_told_again_as_it_was_told(tmp_path):
    """A model's own episodes in this setting, as rejection sampling has them."""
    mine = lesson(training_task(1), setting=SHORT)
    chosen = chosen_of(tmp_path, [mine])
    ((_, record),) = as_text_only(chosen, "short").episodes
    assert record == mine.record
    with pytest.raises(BadData, match="Say --graphs short, as its model was told lists"):
        as_text_only(chosen, "full")


class _Specs(dict):
    """Of any object the same licence and source."""

    def __missing__(self, id):
        return type("Spec", (), {"licence": "CC0-1.0", "source": "PROBE"})
