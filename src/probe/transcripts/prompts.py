"""What a model is told of a setting, and how it is reminded: product text, kept as data."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache
from importlib.resources import files
from typing import Literal, get_args

import pydantic
import yaml

from probe.episodes.participation import Points, has_tools
from probe.errors import BadData, UnknownName
from probe.files import fault
from probe.toolshed.toolshed import MANIPULATIONS, TURNS
from probe.transcripts.coordinates import in_words
from probe.types import USUAL_SCALE, PictureScale

Setting = Literal["agentic", "text-only", "direct", "blind", "oracle-view"]
"""How a model may answer: with tools and pictures, with tools and no picture, from one picture,
none, or pictures of the evidence."""

Graphs = Literal["full", "short"]
"""How perceive_scene's lists are told in the setting "text-only"."""

_SHORT = "text-only, short graphs"

_POINTING = re.compile(r"pointer [!-~]+( [!-~]+)*")


class _Prompts(pydantic.BaseModel, extra="forbid", frozen=True):
    agentic: str
    text_only: str = pydantic.Field(alias="text-only")
    text_only_tools: dict[str, str] = pydantic.Field(alias="text-only tools")
    direct: str
    blind: str
    oracle_view: str = pydantic.Field(alias="oracle-view")
    remind_call: str
    remind_answer: str
    remind_point: str


def setting_named(name: str) -> Setting:
    """The setting of that name; what follows a comma ("agentic, pointer self") doesn't matter.

    Raises:
        UnknownName: There is none.
    """
    for setting in get_args(Setting):
        if setting == name.split(",")[0]:
            return setting
    raise UnknownName("setting", name, list(get_args(Setting)))


def check_setting(name: str) -> None:
    """Refuse what no run calls a setting.

    After its name only who points for perception may stand, or that graphs are short.

    Raises:
        UnknownName: There is no such setting, or another text follows.
    """
    setting, comma, more = name.partition(", ")
    if name != _SHORT and (
        setting_named(name) != setting
        or (comma and not (setting == "agentic" and _POINTING.fullmatch(more)))
    ):
        raise UnknownName("setting", name, [*get_args(Setting), "agentic, pointer NAME", _SHORT])


def told_with(setting: Setting, graphs: Graphs) -> str:
    """The setting as records and tables name it, with how its graphs are told."""
    return _SHORT if (setting, graphs) == ("text-only", "short") else setting


def graphs_of(name: str) -> Graphs:
    """How graphs are told in the setting of that name."""
    return "short" if name == _SHORT else "full"


def tool_words(setting: Setting) -> Mapping[str, str]:
    """What is said of tools ("push") and of arguments ("push.direction") instead of the usual."""
    return _prompts().text_only_tools if setting == "text-only" else {}


def system_prompt(
    setting: Setting,
    points: Points,
    scale: PictureScale = USUAL_SCALE,
    manipulations: int = MANIPULATIONS,
) -> str:
    """What a model is told before the question, with how many manipulations it has."""
    text: str = getattr(_prompts(), setting.replace("-", "_"))
    straight, down = ("down obliquely", "from the front") if scale.oblique else ("straight", "down")
    return text.format(
        turns=TURNS,
        manipulations=manipulations,
        places=in_words(points, scale.side_px),
        straight=straight,
        down=down,
    )


def reminder(setting: Setting, *, answered: bool = False) -> str:
    """What a model is told that neither called a tool nor answered, or only left out the point."""
    if has_tools(setting):
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
