"""The many ways to ask a question, as data that is checked. Knows no scene."""

from __future__ import annotations

import string
from collections.abc import Sequence
from functools import lru_cache
from importlib.resources import files
from typing import Annotated

import pydantic
import yaml

from probe.errors import BadData
from probe.tasks.task import QuestionKind

FEWEST = 5
_SLOTS: dict[QuestionKind, set[str]] = {"beneath": {"cover"}, "count": {"names"}, "find": set()}
_REMEDY = "Correct that line"


def _checked(wording: str, info: pydantic.ValidationInfo) -> str:
    """Refuse a wording that lacks a slot, has one too many, or isn't a sentence."""
    if not wording[:1].isupper() or wording[-1:] not in {"?", "."}:
        raise ValueError("a wording begins with a capital and ends with '?' or '.'")
    try:
        slots = [slot for _, slot, _, _ in string.Formatter().parse(wording) if slot is not None]
    except ValueError as error:
        raise ValueError(f"its braces don't match ({error})") from error
    if "kind" in info.data and (sorted(slots) != sorted(_SLOTS[info.data["kind"]])):
        wanted = " ".join(f"{{{slot}}}" for slot in _SLOTS[info.data["kind"]]) or "none"
        raise ValueError(f"its slots are {slots or 'none'}, wanted exactly: {wanted}")
    return wording


class WordingsDocument(pydantic.BaseModel, extra="forbid", frozen=True):
    """One file of wordings."""

    kind: QuestionKind
    wordings: list[Annotated[str, pydantic.AfterValidator(_checked)]] = pydantic.Field(
        min_length=FEWEST
    )

    @pydantic.field_validator("wordings")
    @classmethod
    def _differ(cls, wordings: list[str]) -> list[str]:
        twins = sorted({wording for wording in wordings if wordings.count(wording) > 1})
        if twins:
            raise ValueError(f"{twins[0]!r} is there twice")
        return wordings


@lru_cache
def wordings(kind: QuestionKind) -> tuple[str, ...]:
    """All wordings of a type.

    Raises:
        BadData: The file breaks its schema; the message names the line.
    """
    name = f"{kind}.yaml"
    text = (files("probe.tasks") / "data" / name).read_text("utf-8")
    return parse_wordings(text, name)


def parse_wordings(text: str, path: object) -> tuple[str, ...]:
    """Wordings of a file's text; `path` is for messages.

    Raises:
        BadData: As `wordings`.
    """
    try:
        root, content = yaml.compose(text, Loader=yaml.SafeLoader), yaml.safe_load(text)
    except yaml.MarkedYAMLError as error:
        line = error.problem_mark.line + 1 if error.problem_mark else 1
        raise BadData(path, f"line {line}: {error.problem}", _REMEDY) from error
    except yaml.YAMLError as error:
        raise BadData(path, str(error), "Write it as UTF-8 YAML") from error
    try:
        return tuple(WordingsDocument.model_validate(content).wordings)
    except pydantic.ValidationError as error:
        first = error.errors()[0]
        place = ".".join(str(part) for part in first["loc"]) or "the file"
        line = _line(root, first["loc"])
        raise BadData(path, f"line {line}, {place}: {first['msg']}", _REMEDY) from error


def _line(node: yaml.Node | None, place: Sequence[str | int]) -> int:
    """Line, from 1, of a place in a YAML document, or of the last part of it that exists."""
    line = 1
    for part in place:
        if isinstance(node, yaml.MappingNode):
            found = [pair for pair in node.value if pair[0].value == part]
            if not found:
                break
            line = found[0][0].start_mark.line + 1
            node = found[0][1]
        elif isinstance(node, yaml.SequenceNode) and isinstance(part, int):
            node = node.value[part]
            line = node.start_mark.line + 1 if node else line
    return line
