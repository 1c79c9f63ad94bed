"""Where a training goes on."""

from __future__ import annotations

import pytest

from probe.train.tune.started import last_checkpoint

WHOLE = '{"global_step": 2, "max_steps": 12, "log_history": [{"loss": 1.5}]}\n'
LAST = '{"global_step": 12, "max_steps": 12, "log_history": [{"loss": 1.5}]}\n'


def checkpoint(out, step, state):
    folder = out / "checkpoints" / f"checkpoint-{step}"
    folder.mkdir(parents=True)
    (folder / "model.safetensors").write_bytes(b"?")
    if state is not None:
        (folder / "trainer_state.json").write_text(state)
    return folder


@pytest.mark.parametrize("cut", [None, "", WHOLE[:20], WHOLE[:-3]])
def test_a_checkpoint_that_was_cut_off_is_passed_over(tmp_path, cut):
    whole = checkpoint(tmp_path, 9, WHOLE)
    later = checkpoint(tmp_path, 10, cut)
    assert last_checkpoint(tmp_path) == whole
    # Another process may be looking at it.
    assert later.exists()
    (later / "trainer_state.json").write_text(WHOLE)
    assert last_checkpoint(tmp_path) == later


def test_one_of_the_last_step_is_passed_over(tmp_path):
    """Who goes on from it makes a step more than there are."""
    before = checkpoint(tmp_path, 9, WHOLE)
    checkpoint(tmp_path, 12, LAST)
    assert last_checkpoint(tmp_path) == before


def test_without_a_whole_one_it_begins_anew(tmp_path):
    assert last_checkpoint(tmp_path) is None
    checkpoint(tmp_path, 2, "")
    assert last_checkpoint(tmp_path) is None
