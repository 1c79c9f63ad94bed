"""The scripted teacher's episodes in runs/data."""

from __future__ import annotations

import tarfile
from pathlib import Path

import teacher_words

from probe.train.collect.batches import batches

PACKED = Path(__file__).parents[3] / "runs/data/teacher.tar.xz"


def test_they_have_the_words_of_todays_phrases(tmp_path):
    """Else `probe dataset` couldn't tell them again; scripts/teacher_words.py writes them anew."""
    with tarfile.open(PACKED) as archive:
        archive.extractall(tmp_path, filter="data")
    found = batches(tmp_path / "collected")
    assert len(found) > 5
    assert [it.folder.name for it in found if teacher_words.say_again(it)] == []
