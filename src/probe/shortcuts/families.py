"""Families of features: what a classifier is given, from least to most."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Literal, get_args

from probe.agents.question_classifier import question_features
from probe.agents.text_features import Features, position, texts, wording
from probe.shortcuts.by_catalogue import by_catalogue
from probe.shortcuts.by_depth import by_depth
from probe.shortcuts.by_picture import by_area, by_graph, by_patch
from probe.shortcuts.comparing import joined
from probe.shortcuts.sample import CatalogueFacts, Sample

Family = Literal[
    "letter", "wording", "options", "question", "catalogue", "graph", "areas", "patches", "depth",
    "all",
]  # fmt: skip
FAMILIES: tuple[Family, ...] = get_args(Family)

LETTERS_ALONE: tuple[Family, ...] = "letter", "wording"
"""Families that know nothing of what the options say."""

Extract = Callable[[Sample, CatalogueFacts], tuple[Features, ...]]

_EXTRACTS: Mapping[Family, Extract] = {
    "letter": lambda sample, _: position(sample.options),
    "wording": lambda sample, _: wording(sample.question, sample.options),
    "options": lambda sample, _: texts(sample.question, sample.options),
    "question": lambda sample, _: question_features(sample.question, sample.options),
    "catalogue": by_catalogue,
    "graph": by_graph,
    "areas": by_area,
    "patches": by_patch,
    "depth": by_depth,
}


def features(family: Family, sample: Sample, catalogue: CatalogueFacts) -> tuple[Features, ...]:
    """Numbers about each option of a sample.

    All but the letter's and the wording's say nothing of where an option stands.
    """
    if family != "all":
        return _EXTRACTS[family](sample, catalogue)
    named = [
        [{f"{name}: {key}": x for key, x in told.items()} for told in extract(sample, catalogue)]
        for name, extract in _EXTRACTS.items()
        if name != "question"
    ]
    return joined(*named)
