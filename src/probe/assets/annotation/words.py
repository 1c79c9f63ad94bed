"""What is said of an object, and how a model is asked for it. Knows no model and no pictures."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from typing import Annotated

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from probe.asking import UnusableReply, asked
from probe.assets.colour.names import Colour
from probe.files import fault
from probe.types import Array, Ask

VIEWS = 6
"""Pictures of an object that a model is shown."""

_QUESTION = """The {count} pictures show one and the same object from different sides.
Reply with one JSON object and nothing else:
{{"name": "...", "category": "...", "colours": ["..."], "description": "..."}}
name: what a person would call it to tell it from others, two to four words, lower case, singular, \
colour first where that helps ("red coffee mug").
category: the common noun alone ("mug").
colours: one to three main colours, the most of its surface first, each one of: {colours}.
description: one sentence of at most 160 characters on what it looks like."""


def _plain(value: object) -> object:
    return " ".join(value.split()) if isinstance(value, str) else value


def _lower(value: object) -> object:
    plain = _plain(value)
    return plain.lower().rstrip(".") if isinstance(plain, str) else plain


Words = Annotated[str, BeforeValidator(_lower), Field(min_length=2, max_length=40)]


Name = Annotated[Words, Field(pattern=r"^[a-z0-9][a-z0-9' -]*$")]
Category = Annotated[Words, Field(pattern=r"^[a-z][a-z' -]*$")]
Colours = Annotated[tuple[Colour, ...], Field(min_length=1, max_length=3)]
Description = Annotated[str, BeforeValidator(_plain), Field(min_length=5, max_length=200)]


class Described(BaseModel):
    """What is said of an object; the schema of a model's reply."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    name: Name
    category: Category
    colours: Colours
    description: Description


def describe(views: Sequence[Array], ask: Ask) -> Described:
    """Ask a model what an object is; a reply that breaks the schema gets one more chance.

    Args:
        views: Pictures of it, uint8, each of shape (h, w, 3).
        ask: The model.

    Raises:
        UnusableReply: Neither reply can be used; the reason is that of the second.
        ModelFailed: No reply came.
    """
    colours = ", ".join(Colour.__args__)
    question = _QUESTION.format(count=len(views), colours=colours)
    return asked(ask, views, question, parse, "with the JSON alone")


def parse(reply: str) -> Described:
    """The JSON object in a reply, whatever stands around it.

    Raises:
        UnusableReply: There is none, or it breaks the schema.
    """
    found = re.search(r"\{.*\}", reply, re.DOTALL)
    if found is None:
        raise UnusableReply("there is no JSON object in the reply")
    try:
        return Described.model_validate(json.loads(found.group()))
    except (ValueError, RecursionError) as error:
        raise UnusableReply(_reason(error)) from error


def _reason(error: Exception) -> str:
    if isinstance(error, ValidationError):
        return fault(error, "reply")
    return f"its JSON is broken ({error})"
