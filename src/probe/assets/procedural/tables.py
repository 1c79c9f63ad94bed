"""The data files of procedural objects: shapes, paints, and which object has which."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from typing import Annotated, Any, Literal, Self, cast

import yaml
from pydantic import Field, TypeAdapter, ValidationError, model_validator

from probe.assets.procedural.families import members, replaced
from probe.assets.procedural.paint.data import Data
from probe.assets.procedural.paint.materials import Layers, Metal, Weave, Wood
from probe.assets.procedural.paint.mottled import Mottled
from probe.assets.procedural.paint.pattern import Pattern
from probe.assets.procedural.paint.prints import Print
from probe.assets.procedural.parts import Part, Triple
from probe.errors import BadData

AnyPaint = Annotated[
    Mottled | Wood | Metal | Weave | Layers | Print | Pattern, Field(discriminator="look")
]
FOLDER = files("probe.assets.procedural") / "data"
Edition = Literal[1, 2]
"""1 has the objects of the suites v1 to behind, in their order; 2 has these and more."""

NEWEST_EDITION: Edition = 2
"""It has every object there is."""

OBJECT_FILES: dict[Edition, tuple[str, ...]] = {
    1: (
        *("vessels", "food", "packages", "household", "tools", "toys"),
        *("produce", "bakery", "kitchen", "bottles", "desk", "home", "wear", "games", "workshop"),
    ),
    2: (
        *("table", "cookware", "larder", "bathroom", "office", "leisure", "outdoors", "hardware"),
        "more",
    ),
}
"""The files that each edition adds."""


class ProceduralEntry(Data):
    """One object: words, mass, its shape, and a paint for each name that the shape uses.

    In the file a paint may be given as ``template`` (its name in ``paints.yaml``) with values
    for what the template leaves open; ``parts`` is what ``shapes.yaml`` has under the shape's
    name, unless the entry brings its own. Entries with ``variants`` are `families`.
    """

    id: str = Field(pattern=r"^proc_[a-z0-9_]+$")
    name: str
    category: str
    colours: tuple[str, ...]
    description: str
    mass: float = Field(gt=0, le=2)
    friction: float = Field(0.6, ge=0.1, le=1.2)
    hollow: bool = False
    roughness: float = Field(0.6, ge=0, le=1)
    metallic: float = Field(0.0, ge=0, le=1)
    scale: float = Field(1.0, gt=0)
    stretch: Triple = (1, 1, 1)
    shape: str
    parts: tuple[Part, ...]
    paints: dict[str, AnyPaint]

    @model_validator(mode="after")
    def _each_part_is_painted(self) -> Self:
        missing = {name for part in self.parts for name in part.paint_names} - set(self.paints)
        if missing:
            raise ValueError(f"no paint for {', '.join(sorted(missing))}")
        return self


@cache
def entries(edition: Edition) -> dict[str, ProceduralEntry]:
    """All objects of an edition by id, those of earlier ones first, in the order of the files.

    Raises:
        BadData: A file breaks its schema; names the entry.
    """
    shapes, paints, words = (_mapping(name) for name in ("shapes", "paints", "words"))
    found: dict[str, ProceduralEntry] = {}
    families: dict[str, dict[str, Any]] = {}
    for name in (name for n, names in OBJECT_FILES.items() if n <= edition for name in names):
        for raw in cast(list[dict[str, Any]], _read(name)):
            whole = _whole(name, raw, families)
            for entry in _entries(name, whole, shapes, paints, words):
                if entry.id in found:
                    raise BadData(f"{name}.yaml", f"{entry.id} is there twice", "Rename one.")
                found[entry.id] = entry
    return found


def _whole(file: str, raw: dict[str, Any], families: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """A data entry as it stands; what `more_of` names gets more variants, with what else is said.

    Args:
        file: Where the entry is.
        raw: The entry.
        families: Those before it, by category; it is added if it is one.

    Raises:
        BadData: There is no such family before it.
    """
    if "more_of" not in raw:
        if "variants" in raw:
            families[raw["category"]] = raw
        return raw
    if raw["more_of"] not in families:
        reason = f"more_of: {raw['more_of']!r} is no category with variants in an earlier place"
        raise BadData(f"{file}.yaml", reason, "Correct the name.")
    return families[raw["more_of"]] | {k: v for k, v in raw.items() if k != "more_of"}


def _entries(
    file: str,
    raw: dict[str, Any],
    shapes: dict[str, Any],
    paints: dict[str, Any],
    words: dict[str, Any],
) -> list[ProceduralEntry]:
    """The objects of one data entry."""
    who = f"entry {raw.get('id', raw.get('category'))}"
    try:
        return [_entry(member, shapes, paints) for member in members(raw, words)]
    except KeyError as error:
        reason = f"{who} refers to {error}, which is not there"
        raise BadData(f"{file}.yaml", reason, "Add it or correct the name.") from error
    except ValidationError as error:
        raise BadData(f"{file}.yaml", f"{who}: {error}", "Correct it.") from error


def _entry(raw: dict[str, Any], shapes: dict[str, Any], paints: dict[str, Any]) -> ProceduralEntry:
    looks = {name: _filled(look, paints) for name, look in raw["paints"].items()}
    shape = raw.get("shape", f"own {raw['category']}")
    parts = raw["parts"] if "parts" in raw else shapes[shape]
    whole = raw | {"shape": shape, "parts": parts, "paints": looks}
    return TypeAdapter(ProceduralEntry).validate_python(whole)


def _filled(look: dict[str, Any], templates: dict[str, Any]) -> dict[str, Any]:
    """A paint as given, or its template with the open places filled in."""
    if "template" not in look:
        return look
    template = templates[look["template"]]
    values = template.get("defaults", {}) | look
    return replaced(template["paint"], values)


def _mapping(name: str) -> dict[str, Any]:
    return cast(dict[str, Any], _read(name))


def _read(name: str) -> Any:
    return yaml.load((FOLDER / f"{name}.yaml").read_text("utf-8"), yaml.CSafeLoader)
