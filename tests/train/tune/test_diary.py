"""The loss on disk, whatever happened to the process before."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from probe.train.tune.diary import DIARY, diary_callback, read_diary

pytestmark = pytest.mark.slow  # Transformers takes seconds to import.


def note(diary, step: int) -> None:
    state = SimpleNamespace(is_world_process_zero=True, global_step=step)
    diary.on_log(None, state, None, logs={"loss": 1.0 / step, "learning_rate": 0.1})


def test_a_line_that_was_cut_off_spoils_neither_the_next_nor_the_end(tmp_path):
    first = diary_callback(tmp_path)
    note(first, 1)
    note(first, 2)
    text = (tmp_path / DIARY).read_text()
    (tmp_path / DIARY).write_text(text[:-20])
    again = diary_callback(tmp_path)
    note(again, 2)
    note(again, 3)
    assert [(it.step, it.loss) for it in read_diary(tmp_path)] == [(1, 1.0), (2, 0.5), (3, 1 / 3)]
