"""The loss on disk, whatever happened to the process before."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from probe.train.tune.training_log import (
    DIARY,
    LoggedStep,
    LossInterval,
    diary_callback,
    effort_of,
    learning_curve,
    read_log,
)


def note(log, step: int, tokens: int = 0) -> None:
    state = SimpleNamespace(
        is_world_process_zero=True, global_step=step, num_input_tokens_seen=tokens
    )
    logs = {"loss": 1.0 / step, "learning_rate": 0.1}
    log.on_log(None, state, None, logs=logs)


def entries(*losses: float) -> list[LoggedStep]:
    return [
        LoggedStep(step=n, loss=loss, learning_rate=0.25 * n, session=0, seconds=n)
        for n, loss in enumerate(losses, 1)
    ]


def test_learning_curve():
    assert learning_curve(entries(8, 6, 5, 1, 3), 2) == [
        LossInterval(1, 2, 7, 0.5),
        LossInterval(3, 5, 3, 1.25),
    ]
    assert [it.loss for it in learning_curve(entries(8, 6), 12)] == [8, 6]
    assert learning_curve([], 12) == []


@pytest.mark.slow  # Transformers takes seconds to import.
def test_a_line_that_was_cut_off_spoils_neither_the_next_nor_the_end(tmp_path):
    first = diary_callback(tmp_path)
    note(first, 1, tokens=50)
    note(first, 2, tokens=100)
    text = (tmp_path / DIARY).read_text()
    (tmp_path / DIARY).write_text(text[:-20])
    again = diary_callback(tmp_path)
    again.on_train_begin(None, SimpleNamespace(num_input_tokens_seen=50), None)
    note(again, 2, tokens=90)
    note(again, 3, tokens=140)
    assert [(it.step, it.loss) for it in read_log(tmp_path)] == [(1, 1.0), (2, 0.5), (3, 1 / 3)]
    # The step whose entry was cut off was made twice, but only what was written down counts.
    assert effort_of(tmp_path)[1] == 50 + 90
