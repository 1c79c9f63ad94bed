"""All of the assistant's turns are learnt except those of weight 0."""

from __future__ import annotations

from typing import Any

import pytest

from probe.train.tune import libraries
from probe.train.tune.collating import IGNORED, Collator, OtherTurns

pytestmark = pytest.mark.slow  # PyTorch

ROLES = ("system", "user", "assistant", "tool", "assistant", "tool", "assistant")


class Marking:
    """A tokenizer of one token a word, whose template marks what the assistant says."""

    pad_token_id = 0

    def apply_chat_template(self, conversation, **how):
        torch = libraries.torch()
        words = [
            (len(word), said["role"] == "assistant")
            for said in conversation
            for part in said["content"]
            for word in f"{said['role']} {part['text']}".split()
        ]
        ids = torch.tensor([[size for size, _ in words]])
        return {"input_ids": ids, "assistant_masks": [[int(mine) for _, mine in words]]}


def row(weights) -> dict[str, Any]:
    left = iter(weights)
    return {
        "id": "count-1-refused",
        "tools": "",
        "images": [],
        "messages": [
            {"role": role, "content": [{"type": "text", "text": f"{'word ' * (n + 1)}"}]}
            | ({"weight": next(left)} if role == "assistant" else {"weight": None})
            for n, role in enumerate(ROLES)
        ],
    }


def learnt(example):
    """For each message, whether all, none or some of its tokens are learnt."""
    batch = Collator(Marking(), "marks")([example])
    labels, told, at = batch["labels"][0], [], 0
    for n in range(len(ROLES)):
        some = {label != IGNORED for label in labels[at : at + n + 2].tolist()}
        told.append(some.pop() if len(some) == 1 else None)
        at += n + 2
    assert at == len(labels)
    return told


@pytest.mark.parametrize("weights", [(1, 1, 1), (0, 1, 1), (1, 0, 1), (1, 1, 0), (None,) * 3])
def test_a_turn_of_weight_0_is_not_learnt(weights):
    said = iter(weight != 0 for weight in weights)
    assert learnt(row(weights)) == [role == "assistant" and next(said) for role in ROLES]


def test_rows_of_before_there_were_weights_are_learnt_whole():
    before = row((1, 1, 1))
    for message in before["messages"]:
        del message["weight"]
    assert learnt(before) == [role == "assistant" for role in ROLES]


def test_a_template_that_marks_other_turns_is_an_error():
    missing = row((1, 0, 1))
    missing["messages"][4]["content"] = []
    with pytest.raises(OtherTurns, match="^count-1-refused: .* 3 turns .* marks 2, .*Qwen's"):
        Collator(Marking(), "marks")([missing])
