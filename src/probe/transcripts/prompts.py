"""What a model is told of an arm, and how it is reminded: product text, kept as data."""

from __future__ import annotations

import re
from functools import lru_cache
from importlib.resources import files
from typing import Literal, get_args

import pydantic
import yaml

from probe.episodes.participation import Points
from probe.errors import BadData, UnknownName
from probe.files import fault
from probe.toolshed.toolshed import MANIPULATIONS, TURNS
from probe.transcripts.coordinates import IN_WORDS

Arm = Literal["agentic", "direct", "blind", "oracle-view"]
"""How a model may answer: with tools, from one picture, none, or pictures of the evidence."""


_POINTING = re.compile(r"pointer [!-~]+( [!-~]+)*")


class _Prompts(pydantic.BaseModel, extra="forbid", frozen=True):
    agentic: str
    direct: str
    blind: str
    oracle_view: str = pydantic.Field(alias="oracle-view")
    remind_call: str
    remind_answer: str
    remind_point: str


def arm_named(name: str) -> Arm:
    """The arm of that name; what follows a comma ("agentic, pointer self") doesn't matter.

    Raises:
        UnknownName: There is none.
    """
    for arm in get_args(Arm):
        if arm == name.split(",")[0]:
            return arm
    raise UnknownName("arm", name, list(get_args(Arm)))


def check_arm(name: str) -> None:
    """Refuse what no run calls an arm: after its name only who points for perception may stand.

    Raises:
        UnknownName: There is no such arm, or another text follows.
    """
    arm, comma, more = name.partition(", ")
    if arm_named(name) != arm or (comma and not (arm == "agentic" and _POINTING.fullmatch(more))):
        raise UnknownName("arm", name, [*get_args(Arm), "agentic, pointer NAME"])


def system_prompt(arm: Arm, points: Points) -> str:
    """What a model is told before the question."""
    text: str = getattr(_prompts(), arm.replace("-", "_"))
    return text.format(turns=TURNS, manipulations=MANIPULATIONS, places=IN_WORDS[points])


def reminder(arm: Arm, *, answered: bool = False) -> str:
    """What a model is told that neither called a tool nor answered, or only left out the point."""
    if arm == "agentic":
        return _prompts().remind_call
    return _prompts().remind_point if answered else _prompts().remind_answer


@lru_cache(1)
def _prompts() -> _Prompts:
    source = files("probe.transcripts") / "prompts.yaml"
    try:
        return _Prompts.model_validate(yaml.safe_load(source.read_text()))
    except (yaml.YAMLError, pydantic.ValidationError) as error:
        reason = fault(error, "it") if isinstance(error, pydantic.ValidationError) else str(error)
        raise BadData("prompts.yaml", reason, "Correct it") from error
