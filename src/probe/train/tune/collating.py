"""Rows of a data set as a batch of tokens and pictures, with labels on the turns to be learnt.

TRL's own collator leaves out the tools. Each row is encoded alone: rows have other tools or none.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from probe.errors import ProbeError
from probe.train.tune.conversations import Conversation, NotUnderstood, of_row, tools_of_row
from probe.train.tune.libraries import torch
from probe.train.tune.processors import sees, tokenizer_of

IGNORED = -100
"""Label of a token on which no loss is taken."""


class OtherTurns(ProbeError):
    """Turns that a chat template marks aren't the assistant's, one by one."""

    def __init__(self, id: str, said: int, marked: int) -> None:
        super().__init__(
            f"{id}: of the assistant's {said} turns the chat template marks {marked}, so that "
            "those of weight 0 can't be left out. Write the data set without --augment refused, or "
            "train a model with Qwen's template."
        )


def encoded(
    processor: Any,
    conversation: Conversation,
    tools: Sequence[Mapping[str, Any]] | None,
    *,
    template: str | None = None,
    asking: bool = False,
) -> Any:
    """Tokens and pictures of one conversation, for training and for serving.

    Args:
        processor: Of the model.
        conversation: What was said.
        tools: What may be called.
        template: Another than the processor's; one that marks the assistant's turns makes masks.
        asking: Whether a reply is to follow.

    Raises:
        NotUnderstood: Something is shown to a model that sees nothing.
    """
    how: dict[str, Any] = {"processor_kwargs": {"add_special_tokens": False}}
    if not sees(processor):
        if any(part["type"] == "image" for said in conversation for part in said["content"]):
            raise NotUnderstood("it shows pictures, and this model takes none: --setting text-only")
        how = {}  # a tokenizer adds none to a conversation
    return processor.apply_chat_template(
        conversation,
        tools=tools,
        chat_template=template,
        tokenize=True,
        return_dict=True,
        return_tensors="pt",
        return_assistant_tokens_mask=template is not None,
        add_generation_prompt=asking,
        **how,
    )


class Collator:
    """Makes batches.

    Args:
        processor: Of the model.
        template: One that marks the assistant's turns.
    """

    def __init__(self, processor: Any, template: str) -> None:
        self._processor = processor
        self._template = template

    def __call__(self, rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
        """The batch of some rows."""
        return _joined([self._one(row) for row in rows], tokenizer_of(self._processor).pad_token_id)

    def _one(self, row: Mapping[str, Any]) -> dict[str, Any]:
        tools = tools_of_row(row)
        made = dict(encoded(self._processor, of_row(row), tools, template=self._template))
        mask = torch().as_tensor(made.pop("assistant_masks")).reshape(1, -1)
        learnt = _of_weight(mask, _weights(row), row["id"])
        made["labels"] = made["input_ids"].masked_fill(learnt == 0, IGNORED)
        return made


def _weights(row: Mapping[str, Any]) -> list[int]:
    """0 for each of the assistant's turns that isn't to be learnt, else 1.

    Rows that were written before there were weights have none, and are learnt whole.
    """
    said = (it for it in row["messages"] if it["role"] == "assistant")
    return [1 if it.get("weight") is None else it["weight"] for it in said]


def _of_weight(mask: Any, weights: Sequence[int], id: str) -> Any:
    """A mask of the assistant's turns, shape (1, tokens), without those of weight 0."""
    if all(weights):
        return mask
    turns = (mask.diff(prepend=mask.new_zeros(1, 1)) == 1).cumsum(dim=1)
    if int(turns[0, -1]) != len(weights):
        raise OtherTurns(id, len(weights), int(turns[0, -1]))
    return mask * mask.new_tensor([0, *weights])[turns]


def _joined(made: Sequence[dict[str, Any]], pad: int) -> dict[str, Any]:
    """One batch: what goes with tokens is filled up on the right, the rest is appended."""
    longest = max(each["input_ids"].shape[1] for each in made)
    filler = {"input_ids": pad, "labels": IGNORED}
    batch: dict[str, Any] = {}
    for name in made[0]:
        parts = [each[name] for each in made]
        if parts[0].shape == made[0]["input_ids"].shape:
            parts = [_filled(part, longest, filler.get(name, 0)) for part in parts]
        batch[name] = torch().cat(parts)
    return batch


def _filled(part: Any, longest: int, filler: int) -> Any:
    missing = longest - part.shape[1]
    return torch().nn.functional.pad(part, (0, missing), value=filler)
