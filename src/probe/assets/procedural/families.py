"""One data entry for many objects: a family, and a few words for each of its members."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any, cast

from probe.assets.procedural.paint.colours import NAMED, SHADES

_COLOUR = re.compile(rf"\b(?:(?:{'|'.join(SHADES)}) )?(?:{'|'.join(NAMED)})\b")
# What follows is about a part of a thing, or about what is beside it.
_ASIDE = re.compile(r",| (?:with|in|on|of|for) ")
_NAMED = ("main", "second", "third")  # what the first, second, third colour in the words is called
_OWN = ("noun", "described", "defaults", "variants")  # what a family says that its members don't
_ENTRY = (
    *("id", "name", "colours", "description", "shape", "parts", "hollow"),
    *("friction", "roughness", "metallic", "scale", "stretch"),
)

Raw = dict[str, Any]


def members(raw: Raw, words: Mapping[str, Raw]) -> list[Raw]:
    """Every object of a data entry, each as an entry of its own; one without variants is one.

    A family gives what its members share, with ``$name`` where they differ; ``defaults`` for
    those names; ``noun``, what one calls a member (its category if absent); ``described``, the
    noun with what one sees of it; its mass at scale 1. A variant is how one says what it looks
    like ("light blue", "red and white striped", "small wooden"), or that with values of its own
    ({"red": {title: CRACKERS}}). Colours in it become ``$main``, ``$second`` and ``$third`` and
    are the object's colours unless the family says otherwise; every other word stands in
    ``words.yaml`` for values. A value called like a field of an entry takes that field's place,
    and one called like an open place of a paint's template fills it.

    Raises:
        KeyError: A word or a ``$name`` that nothing explains.
    """
    if "variants" not in raw:
        return [raw]
    return [_member(raw, variant, words) for variant in raw["variants"]]


def replaced(node: Any, values: Mapping[str, Any]) -> Any:
    """Data with each ``$name`` in it replaced; a string that is nothing else takes any value."""
    if isinstance(node, dict):
        return {k: replaced(v, values) for k, v in cast(Raw, node).items()}
    if isinstance(node, list):
        return [replaced(v, values) for v in cast(list[Any], node)]
    if not isinstance(node, str) or "$" not in node:
        return node
    if re.fullmatch(r"\$\w+", node):
        return values[node[1:]]
    return re.sub(r"\$(\w+)", lambda found: str(values[found[1]]), node)


def slug(text: str) -> str:
    """A text as part of an id: lower case, digits and underscores."""
    return re.sub(r"[^a-z0-9]+", "_", text.lower())


def _member(raw: Raw, variant: str | Raw, words: Mapping[str, Raw]) -> Raw:
    spoken: dict[str, Raw] = {variant: {}} if isinstance(variant, str) else variant
    look, own = next(iter(spoken.items()))
    values = raw.get("defaults", {}) | _meaning(look, words) | own
    values |= {name: replaced(value, values) for name, value in values.items()}
    category = raw["category"]
    name = f"{look} {raw.get('noun', category)}"
    whole: Raw = {
        "id": f"proc_{slug(values.get('name', name))}",
        "name": name,
        "colours": [values[k] for k in _NAMED if k in values],
        "description": _sentence(_described(look, raw.get("described", category))),
    }
    whole |= {k: replaced(v, values) for k, v in raw.items() if k not in _OWN}
    whole |= {k: values[k] for k in _ENTRY if k in values}
    looks = cast(dict[str, Raw], whole["paints"]).items()
    whole["paints"] = {k: values | look if "template" in look else look for k, look in looks}
    whole["colours"] = list(dict.fromkeys(whole["colours"]))
    whole["mass"] = values.get("mass", _scaled_mass(whole))
    return whole


def _meaning(look: str, words: Mapping[str, Raw]) -> Raw:
    """The values that words for a look stand for; colours in them win over what words bring."""
    values: Raw = {}
    for word in _COLOUR.sub("", look).split():
        values |= words[word]
    return values | dict(zip(_NAMED, _COLOUR.findall(look), strict=False))


def _scaled_mass(whole: Raw) -> float:
    x, y, z = whole.get("stretch", (1, 1, 1))
    return float(f"{whole['mass'] * whole.get('scale', 1) ** 3 * x * y * z:.2g}")


def _described(look: str, seen: str) -> str:
    """How a member looks, each colour once, and what one sees of it, which may tell both."""
    told = " and ".join(dict.fromkeys(look.split(" and ")))
    said = _ASIDE.split(seen)[0].split()
    return seen if set(told.split()) <= set(said) else f"{told} {seen}"


def _sentence(text: str) -> str:
    return f"{'An' if text[0] in 'aeiou' else 'A'} {text}."
