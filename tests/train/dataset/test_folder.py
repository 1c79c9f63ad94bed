"""Data sets for trainers: whole, or not there."""

from __future__ import annotations

import io
import json
from dataclasses import replace
from typing import Any

import pytest
from PIL import Image

from probe.errors import BadData
from probe.tasks.suite_file import CANARY
from probe.train.choose.chosen import LoadedSelection
from probe.train.dataset.folder import Form, write_dataset
from probe.train.dataset.manifest import check_dataset, objects_told

FORM = Form("test", "pixels", 64)


@pytest.fixture
def ordered(examples, chosen):
    """In the order of the selection."""
    by_task = {example.id.rpartition("-teacher-")[0]: example for example in examples}
    return [by_task[task.id] for task, _ in chosen.episodes]


@pytest.fixture
def written(tmp_path, ordered, chosen, specs):
    write_dataset(tmp_path / "data", ordered, chosen, FORM, specs)
    return tmp_path / "data"


@pytest.mark.filterwarnings("default")
def test_it_loads_with_hugging_faces_library(written, ordered, tmp_path):
    from datasets import load_dataset

    rows: Any = load_dataset(str(written), split="train", cache_dir=str(tmp_path / "cache"))
    assert [row["id"] for row in rows] == [example.id for example in ordered]
    for row, example in zip(rows, ordered, strict=True):
        assert len(row["images"]) == len(example.pictures)
        assert row["tools"] == example.tools
        texts = ["".join(p["text"] or "" for p in m["content"]) for m in row["messages"]]
        assert texts == [message.text for message in example.messages]
        first = Image.open(io.BytesIO(example.pictures[0]))
        assert row["images"][0].tobytes() == first.convert("RGB").tobytes()


def test_every_file_that_is_named_is_there(written):
    for name, key, base in (("llamafactory", "images", "llamafactory"), ("vila", "image", ".")):
        rows = json.loads((written / name / "train.json").read_text())
        for row in rows:
            assert row[key] and all((written / base / path).is_file() for path in row[key])
    info = json.loads((written / "llamafactory/dataset_info.json").read_text())
    assert info["probe"]["file_name"] == "train.json"


def test_the_card_tells_counts_licences_and_the_canarys_policy(written):
    card = (written / "README.md").read_text()
    assert "| find | 1 | 1 |" in card and "| count | 1 | 0 |" in card
    assert "| CC-BY-4.0 | somebody | 1 |" in card
    assert "9 are shown" in card
    assert "64 x 64, made smaller from 1024 x 1024, drawn by filament." in card
    whole = b"".join(path.read_bytes() for path in written.rglob("*") if path.is_file())
    assert "canary" in card and CANARY.split()[-1].encode() not in whole


def test_the_card_tells_what_the_objects_are_for(tmp_path, ordered, chosen, specs, written):
    """The tables' objects are made up, of no pool; then some are called like built-in ones."""
    plain = (written / "README.md").read_text()
    assert "0 objects are of the pool for training" in plain and "none is set aside" in plain
    other = renamed(chosen, {"thing_find_1_1": "proc_orange_mug", "thing_find_2_1": "proc_red_mug"})
    known = specs | dict.fromkeys(("proc_orange_mug", "proc_red_mug"), next(iter(specs.values())))
    write_dataset(tmp_path / "mixed", ordered, other, FORM, known)
    card = " ".join((tmp_path / "mixed" / "README.md").read_text().split())
    assert "1 objects are of the pool for training" in card
    assert "**1 are set aside for evaluation**" in card
    counts = check_dataset(tmp_path / "mixed").objects
    assert (counts["train"], counts["evaluation"]) == (1, 1)
    assert objects_told(counts) in card
    assert objects_told({}) not in card


def test_a_data_set_of_before_says_nothing_of_its_objects(written):
    path = written / "manifest.json"
    told = json.loads(path.read_text())
    del told["objects"]
    path.write_text(json.dumps(told))
    assert "doesn't say" in objects_told(check_dataset(written).objects)


def renamed(chosen: LoadedSelection, names: dict[str, str]) -> LoadedSelection:
    tasks = tuple(
        replace(task, scene=replace(task.scene, objects=tuple(
            replace(it, object_id=names.get(it.object_id, it.object_id))
            for it in task.scene.objects
        )))
        for task in chosen.suite.tasks
    )  # fmt: skip
    return replace(chosen, suite=replace(chosen.suite, tasks=tasks))


def test_it_is_checked_file_by_file(written):
    manifest = check_dataset(written, ["find", "count"])
    assert manifest.total == 3 and manifest.pictures == 9
    with pytest.raises(BadData, match=r"there is no example of size. Collect and select some"):
        check_dataset(written, ["find", "size"])
    table = next((written / "data").iterdir())
    whole = table.read_bytes()
    table.write_bytes(whole[:-10])
    with pytest.raises(BadData, match=rf"{table.name}: has \d+ bytes, .*Write the data set again"):
        check_dataset(written)
    table.write_bytes(whole[:-1] + b"x")
    with pytest.raises(BadData, match=rf"{table.name}: has been changed"):
        check_dataset(written)
    table.write_bytes(whole)
    picture = next((written / "images").iterdir())
    picture.unlink()
    with pytest.raises(BadData, match=rf"{picture.name}: No such file"):
        check_dataset(written)
    (written / "manifest.json").unlink()
    with pytest.raises(BadData, match=r"manifest.json: .*It is no whole data set"):
        check_dataset(written)


def test_what_breaks_off_leaves_nothing(tmp_path, ordered, chosen, specs):
    def breaking():
        yield ordered[0]
        raise BadData("x", "is broken", "Mend it")

    before = sorted(path.name for path in tmp_path.iterdir())
    with pytest.raises(BadData, match="is broken"):
        write_dataset(tmp_path / "data", breaking(), chosen, FORM, specs)
    with pytest.raises(BadData, match="0 find examples of the setting direct, but 1 were chosen"):
        keep = [example for example in ordered if example.setting != "direct"]
        write_dataset(tmp_path / "data", keep, chosen, FORM, specs)
    assert sorted(path.name for path in tmp_path.iterdir()) == before


def test_a_folder_that_is_there_is_left_alone(written, ordered, chosen, specs):
    with pytest.raises(BadData, match="is there already. Choose a new folder"):
        write_dataset(written, ordered, chosen, FORM, specs)
    check_dataset(written)


def test_the_card_tells_of_no_folder_that_is_not_there(tmp_path, ordered, chosen, specs):
    write_dataset(tmp_path / "alone", ordered, chosen, Form("x", "pixels", 64, False), specs)
    card = (tmp_path / "alone/README.md").read_text()
    assert "| `data/`" in card and "| `vila/`" not in card and "| `images/`" not in card
