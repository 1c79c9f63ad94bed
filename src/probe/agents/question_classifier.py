"""The question-only classifier: weights learnt on training tasks, and what they choose."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import resources
from pathlib import Path

import pydantic

from probe.agents.baselines import Rule
from probe.agents.text_features import Features, texts, wording
from probe.episodes.turns import Question
from probe.files import read_document

WEIGHTS = "data/question_only.json"
"""Where the package keeps what was learnt; `probe suite learn` writes it."""

_REMEDY = "Write it anew: probe suite learn SUITE... --out FILE, with training tasks"


class QuestionClassifier(pydantic.BaseModel, extra="forbid", frozen=True, allow_inf_nan=False):
    """What was learnt of one type of question.

    Attributes:
        tasks: How many it was learnt from.
        weights: Of each feature.
    """

    tasks: int = pydantic.Field(ge=1)
    weights: dict[str, float]


class QuestionClassifierDocument(pydantic.RootModel[dict[str, QuestionClassifier]], frozen=True):
    """What was learnt, by type."""


def read_learnt(path: Path | None = None) -> Mapping[str, QuestionClassifier]:
    """What was learnt, from a file or from the package.

    Raises:
        BadData: The file is missing or breaks its schema.
    """
    if path is not None:
        return read_document(path, QuestionClassifierDocument, _REMEDY, _REMEDY).root
    with resources.as_file(resources.files("probe.agents") / WEIGHTS) as packaged:
        return read_document(packaged, QuestionClassifierDocument, _REMEDY, _REMEDY).root


def question_features(question: str, options: tuple[str, ...]) -> tuple[Features, ...]:
    """All that a question and its options tell, by option."""
    pairs = zip(wording(question, options), texts(question, options), strict=True)
    return tuple({**places, **said} for places, said in pairs)


def most_likely(weights: Mapping[str, float]) -> Rule:
    """The option with the largest sum of weights, the first of several."""

    def rule(question: Question) -> str:
        letters = [letter for letter, _ in question.options]
        told = question_features(question.text, tuple(text for _, text in question.options))
        sums = [sum(weights.get(name, 0.0) * x for name, x in each.items()) for each in told]
        return letters[sums.index(max(sums))]

    return rule
