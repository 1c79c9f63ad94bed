"""Table tops drawn by formula, all seamless: a few generators, and data. Knows no renderer."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Annotated, Any

import yaml
from pydantic import Field, TypeAdapter, ValidationError

from probe.assets.tabletops.cloth import Felt, Gingham, Laminate, Leather, Linen, Striped
from probe.assets.tabletops.laid import SheetMetal, Tiles
from probe.assets.tabletops.sheet import TableTile, Top
from probe.assets.tabletops.stone import CastStone, Cork, Granite, Marble, Slate, Terrazzo
from probe.assets.tabletops.wood import Planks
from probe.assets.tabletops.worn import paint_worn
from probe.errors import BadData
from probe.files import fault

_Cloth = Linen | Gingham | Striped | Felt | Laminate | Leather
_Stone = Granite | Marble | Slate | Terrazzo | Cork | CastStone
_AnyTop = Annotated[Planks | _Stone | _Cloth | Tiles | SheetMetal, Field(discriminator="kind")]


@cache
def tops() -> Mapping[str, Top]:
    """All table tops by id, in the order of the file.

    Raises:
        BadData: The file breaks its schema; names the entry.
    """
    text = (files("probe.assets.tabletops") / "tabletops.yaml").read_text("utf-8")
    found: dict[str, Top] = {}
    for raw in yaml.load(text, yaml.CSafeLoader):
        top = _top(raw)
        if top.id in found:
            raise BadData("tabletops.yaml", f"{top.id} is there twice", "Rename one.")
        found[top.id] = top
    return found


def _top(raw: dict[str, Any]) -> Top:
    try:
        return TypeAdapter[Top](_AnyTop).validate_python(raw)
    except ValidationError as error:
        reason = f"entry {raw.get('id')}, {fault(error, 'all of it')}"
        raise BadData("tabletops.yaml", reason, "Correct it.") from error


__all__ = ["TableTile", "Top", "paint_worn", "tops"]
