"""The scripted teacher's episodes in runs/data."""

from __future__ import annotations

import teacher_words

from packed_teacher import packed_batches


def test_they_have_the_words_of_todays_phrases(tmp_path):
    """Else `probe dataset` couldn't tell them again; scripts/teacher_words.py writes them anew."""
    found = packed_batches(tmp_path)
    assert len(found) > 5
    assert [it.folder.name for it in found if teacher_words.say_again(it)] == []
