"""What a run will ask of a model, before anything is asked. Knows no harness."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass

from probe.episodes.participation import Points, has_tools
from probe.tasks.task import Task
from probe.toolshed.toolshed import TURNS
from probe.transcripts.prompts import Setting, system_prompt
from probe.transcripts.tools import tools_for

USUAL_TURNS = 12
"""Assumed calls in an episode with tools; the most is TURNS."""

PICTURE_TOKENS = 1300
"""Assumed for one of 1024 x 1024; servers count from about 800 to 1,600."""

RESULT_TOKENS, REPLY_TOKENS = 300, 80
_CHARACTERS_A_TOKEN = 4
_FIRST_PICTURES: dict[Setting, int] = {
    "agentic": 1,
    "text-only": 0,
    "direct": 1,
    "blind": 0,
    "oracle-view": 2,
}


@dataclass(frozen=True)
class Estimate:
    """Of all episodes together.

    Attributes:
        episodes: How many.
        replies: How often the model is asked.
        pictures: How many it is sent; one that is sent again counts again.
        tokens_in, tokens_out: About.
    """

    episodes: int
    replies: int
    pictures: int
    tokens_in: int
    tokens_out: int


def estimate(
    setting: Setting, points: Points, tasks: Sequence[Task], epochs: int, turns: int = USUAL_TURNS
) -> Estimate:
    """About what a run takes; a conversation is sent whole each time, so tokens grow by squares.

    Args:
        setting: How the model may answer.
        points: How it counts places.
        tasks: What is asked.
        epochs: Runs of each task.
        turns: Calls in an episode with tools.
    """
    asked = min(turns, TURNS) if has_tools(setting) else 1
    episodes = len(tasks) * epochs
    fixed = _tokens(system_prompt(setting, points))
    if has_tools(setting):
        tools = tools_for(points, setting=setting)
        fixed += _tokens(json.dumps([vars(tool) for tool in tools]))
    questions = sum(_tokens(task.question + str(task.options)) for task in tasks) * epochs
    more = 0 if setting == "text-only" else 1
    pictures = sum(_FIRST_PICTURES[setting] + more * turn for turn in range(asked)) * episodes
    grown = sum(turn * (RESULT_TOKENS + REPLY_TOKENS) for turn in range(asked)) * episodes
    inward = episodes * asked * fixed + asked * questions + pictures * PICTURE_TOKENS + grown
    return Estimate(episodes, episodes * asked, pictures, inward, episodes * asked * REPLY_TOKENS)


def _tokens(text: str) -> int:
    return len(text) // _CHARACTERS_A_TOKEN
