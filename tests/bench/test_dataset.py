"""A suite as a data set: it loads with Hugging Face's library, pictures are those that are sent."""

from __future__ import annotations

import io
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from PIL import Image as Pillow

from bench.painted import demo
from probe.assets.library import open_library
from probe.bench.dataset import CARD, row_of, write_dataset
from probe.cli.export import export
from probe.errors import BadData
from probe.render.renderers import Renderers
from probe.runs.episode_worker import EpisodeWorker, EpisodeWorkerSetup
from probe.runs.plan import Job, RunOrder
from probe.runs.worker_messages import EpisodeStarted, StartEpisode
from probe.tasks.suite_file import CANARY, write_suite

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]


def load(folder: Path, cache: Path) -> tuple[Any, list[Any]]:
    """The data set, and its rows with pictures as files."""
    from datasets import Image, load_dataset

    table: Any = load_dataset(str(folder), split="test", cache_dir=str(cache))
    return table, list(table.cast_column("image", Image(decode=False)))


def test_what_is_written_loads_back(tmp_path):
    tasks = demo().tasks
    pictures = [bytes([n]) * 7 for n in range(len(tasks))]
    rows = [row_of(task, it, "pixels") for task, it in zip(tasks, pictures, strict=True)]
    drawn_by = ("filament", "blender")
    assert write_dataset(tmp_path / "set", "small", rows, drawn_by=drawn_by) == len(tasks)
    _, found = load(tmp_path / "set", tmp_path / "cache")
    for row, task, picture in zip(found, tasks, pictures, strict=True):
        assert row["image"]["bytes"] == picture
        assert (row["id"], row["answer"]) == (task.id, task.answer)
        assert row["question"] == task.question
        assert row["options"] == [option.text for option in task.options]
        assert row["prompt"].startswith(task.question + "\nA: " + task.options[0].text)
        assert "ANSWER: X" in row["system"] and row["canary"] == CANARY
    card = (tmp_path / "set" / CARD).read_text()
    assert CANARY in card and "6 questions" in card
    assert "drawn by blender and filament" in card


def test_pictures_are_the_files_that_direct_mode_sends(tmp_path, cache):
    suite = demo(2)
    write_suite(tmp_path / "small.json", suite)
    export(str(tmp_path / "small.json"), tmp_path / "set")
    table, found = load(tmp_path / "set", tmp_path / "cache")
    assert table[0]["image"].size == (1024, 1024)
    library = partial(open_library, "procedural", None, cache)
    with Renderers() as renderers:
        keeper = EpisodeWorker(
            EpisodeWorkerSetup(RunOrder("m", setting="direct"), library), library(), renderers
        )
        for row, task in zip(found, suite.tasks, strict=True):
            shown = keeper.do(StartEpisode(Job(task, 0)))
            assert isinstance(shown, EpisodeStarted)
            assert shown.pictures == (row["image"]["bytes"],)
            assert Pillow.open(io.BytesIO(row["image"]["bytes"])).format == "JPEG"
    with pytest.raises(BadData, match="Choose a new folder"):
        export(str(tmp_path / "small.json"), tmp_path / "set")
