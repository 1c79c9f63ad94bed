"""What a model's tokens cost, by a file that the user keeps: prices change."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import pydantic
import yaml

from probe.errors import BadData
from probe.files import fault

if TYPE_CHECKING:
    from inspect_ai.model import ModelUsage

_REMEDY = "See docs/models.md for its form"
_MILLION = 1e6


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
        found = yaml.safe_load(path.read_text())
        return pydantic.TypeAdapter(dict[str, Price]).validate_python(found)
    except (OSError, yaml.YAMLError) as error:
        raise BadData(path, " ".join(str(error).split()), _REMEDY) from error
    except pydantic.ValidationError as error:
        raise BadData(path, fault(error, "the file"), _REMEDY) from error


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
