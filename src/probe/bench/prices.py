"""What a model's tokens cost, by a file that the user keeps: prices change."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import pydantic
import yaml

from probe.errors import BadData
from probe.files import fault
from probe.reading import words

if TYPE_CHECKING:
    from inspect_ai.model import ModelUsage

_REMEDY = "See docs/how-to/models.md for its form"
_MILLION = 1e6
_MOST = 2**18
"""Bytes of the file: thousands of models; reading YAML takes long."""


class Price(pydantic.BaseModel, extra="forbid", frozen=True, allow_inf_nan=False):
    """US dollars for a million tokens.

    Attributes:
        tokens_in, tokens_out: Of requests and of replies.
        cached: Of requests, where the server has them already; by default as any other.
    """

    tokens_in: float = pydantic.Field(ge=0)
    tokens_out: float = pydantic.Field(ge=0)
    cached: float | None = pydantic.Field(default=None, ge=0)


Prices = Mapping[str, Price]
"""By the name of a model."""


def read_prices(path: Path) -> Prices:
    """Read a file of prices: YAML, a price under the name of each model.

    Raises:
        BadData: It can't be read, or breaks the schema.
    """
    try:
        found = yaml.safe_load(words(path, _MOST))
        return pydantic.TypeAdapter(dict[str, Price]).validate_python(found)
    except (OSError, ValueError, RecursionError, yaml.YAMLError) as error:
        if isinstance(error, pydantic.ValidationError):
            raise BadData(path, fault(error, "the file"), _REMEDY) from error
        raise BadData(path, _told(error), _REMEDY) from error


def _told(error: Exception) -> str:
    if isinstance(error, RecursionError):
        return "is nested too deep"
    if isinstance(error, OSError) and error.strerror:
        return error.strerror
    return " ".join(str(error).split())


def tokens_in(usage: ModelUsage) -> int:
    """All tokens of a request, those included that the server had already."""
    cached = (usage.input_tokens_cache_read or 0) + (usage.input_tokens_cache_write or 0)
    return usage.input_tokens + cached


def cost_of(usage: ModelUsage, price: Price | None) -> float | None:
    """US dollars; None without a price."""
    if price is None:
        return None
    read = usage.input_tokens_cache_read or 0
    cached = price.tokens_in if price.cached is None else price.cached
    fresh = tokens_in(usage) - read
    dollars = fresh * price.tokens_in + read * cached + usage.output_tokens * price.tokens_out
    return dollars / _MILLION
