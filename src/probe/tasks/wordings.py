"""The many ways to ask a question, as data that is checked. Knows no scene."""

from __future__ import annotations

import string
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated

import pydantic
import yaml

from probe.errors import BadData
from probe.tasks.registry import WORDINGS, folder_of
from probe.tasks.task import QuestionType
from probe.tasks.type_rules import Form, rules_of

FEWEST = 20
"""Ways to ask each type."""

_REMEDY = "Correct that line"


@dataclass(frozen=True)
class Wording:
    """One way to ask.

    Attributes:
        form: What exactly is asked, where a type asks for several things.
        text: With its slots in braces.
    """

    form: Form
    text: str


def _sentence(wording: str) -> str:
    """Refuse a wording that isn't a sentence."""
    if not wording[:1].isupper() or wording[-1:] not in {"?", "."}:
        raise ValueError("a wording begins with a capital and ends with '?' or '.'")
    return wording


class WordingsDocument(pydantic.BaseModel, extra="forbid", frozen=True):
    """One file of wordings."""

    question_type: QuestionType
    forms: dict[Form, list[Annotated[str, pydantic.AfterValidator(_sentence)]]]

    @pydantic.field_validator("forms")
    @classmethod
    def _differ(cls, forms: dict[Form, list[str]]) -> dict[Form, list[str]]:
        texts = [text for some in forms.values() for text in some]
        twins = sorted({text for text in texts if texts.count(text) > 1})
        if twins:
            raise ValueError(f"{twins[0]!r} is there twice")
        if len(texts) < FEWEST:
            raise ValueError(f"there are {len(texts)} wordings, wanted at least {FEWEST}")
        return forms


@lru_cache
def wordings(question_type: QuestionType) -> tuple[Wording, ...]:
    """All wordings of a type.

    Raises:
        BadData: The file breaks its schema; the message names the line.
    """
    path = folder_of(question_type) / WORDINGS
    return parse_wordings(path.read_text("utf-8"), path)


def parse_wordings(text: str, path: object) -> tuple[Wording, ...]:
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
        document = WordingsDocument.model_validate(content)
    except pydantic.ValidationError as error:
        first = error.errors()[0]
        raise _broken(path, root, first["loc"], first["msg"]) from error
    known = rules_of(document.question_type).forms
    if set(document.forms) != set(known):
        wanted = ", ".join(known)
        raise _broken(path, root, ("forms",), f"the forms of {document.question_type} are {wanted}")
    for form, texts in document.forms.items():
        for number, wording in enumerate(texts):
            fault = _slot_fault(wording, known[form])
            if fault:
                raise _broken(path, root, ("forms", form, number), fault)
    return tuple(Wording(form, text) for form, texts in document.forms.items() for text in texts)


def _slot_fault(wording: str, wanted: frozenset[str]) -> str | None:
    """What is wrong with a wording's slots; None if nothing is."""
    try:
        slots = [slot for _, slot, _, _ in string.Formatter().parse(wording) if slot is not None]
    except ValueError as error:
        return f"its braces don't match ({error})"
    if sorted(slots) == sorted(wanted):
        return None
    shown = " ".join(f"{{{slot}}}" for slot in wanted) or "none"
    return f"its slots are {slots or 'none'}, wanted exactly: {shown}"


def _broken(
    path: object, root: yaml.Node | None, place: Sequence[str | int], reason: str
) -> BadData:
    where = ".".join(str(part) for part in place) or "the file"
    return BadData(path, f"line {_line(root, place)}, {where}: {reason}", _REMEDY)


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
