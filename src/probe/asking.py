"""One question to a model and one chance to mend its reply. Knows no model."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

from probe.errors import ModelFailed
from probe.types import Array, Ask

LONGEST_REPLY = 20_000
"""Characters of a reply that are looked at."""

_AGAIN = """

Your last reply was:
{reply}
It can't be used: {reason}. Reply again, {form}."""

Meaning = TypeVar("Meaning")


class UnusableReply(ModelFailed):
    """A model replied, but not with what it was asked for; the message is the reason."""


def asked(
    ask: Ask,
    images: Sequence[Array],
    text: str,
    parse: Callable[[str], Meaning],
    form: str = "in the form asked for and with nothing else",
) -> Meaning:
    """What a model means; a reply that can't be used is sent back once with the reason.

    Args:
        ask: The model.
        images: Pictures, uint8, each of shape (h, w, 3).
        text: The question.
        parse: Makes sense of a reply, or raises UnusableReply.
        form: How to reply, as it is put to the model the second time.

    Raises:
        UnusableReply: Neither reply can be used; the reason is that of the second.
        ModelFailed: No reply came.
    """
    reply = ask(images, text)
    try:
        return parse(reply[:LONGEST_REPLY])
    except UnusableReply as failure:
        again = _AGAIN.format(reply=reply[:2000], reason=failure, form=form)
        return parse(ask(images, text + again)[:LONGEST_REPLY])
