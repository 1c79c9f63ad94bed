"""The tokenizer of a very small model cuts texts as Qwen's does."""

from __future__ import annotations

import pytest

from probe.train.tune.loading import load
from small_models import small_dataset, small_model

pytestmark = pytest.mark.slow  # PyTorch takes seconds to import.


def test_the_break_before_a_call_is_not_the_one_in_it(tmp_path):
    model = small_model(tmp_path / "model", small_dataset(tmp_path / "data"))
    tokenizer = load(str(model))[1].tokenizer
    said = '{"name": "push", "arguments": {"push_length_cm": 12}}'
    cut = tokenizer.encode(f"I push it.\n<tool_call>\n{said}\n</tool_call>")
    pieces = [tokenizer.decode([token]) for token in cut]
    call = pieces.index("<tool_call>")
    assert pieces[call - 1] == ".\n" and pieces[call + 1] == "\n"
    assert pieces[-1] == "</tool_call>" and pieces[-2].endswith("}\n")
    assert pieces[-4:-2] == ["1", "2"]
