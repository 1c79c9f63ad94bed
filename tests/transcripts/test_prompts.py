"""What models are told is product text: a change of it has to be meant."""

from __future__ import annotations

import json
from pathlib import Path
from typing import get_args

import pytest

from probe.episodes.participation import Points
from probe.errors import UnknownName
from probe.toolshed.tools import tool_schemas
from probe.transcripts.prompts import (
    Setting,
    check_setting,
    graphs_of,
    reminder,
    setting_named,
    system_prompt,
    told_with,
)
from probe.transcripts.tools import tools_for

SNAPSHOT = Path(__file__).with_name("told.json")


def test_prompts_and_tools_read_as_they_were_reviewed():
    """To accept a change: write `as_json()` to told.json and read the difference."""
    assert as_json() == SNAPSHOT.read_text()


def test_in_pixels_the_tools_are_the_toolsheds():
    assert tools_for("pixels") == tool_schemas()


def test_in_thousandths_no_pixel_is_left():
    tools = [*tools_for("0-1000"), *tools_for("0-1000", setting="text-only")]
    told = json.dumps([vars(tool) for tool in tools])
    told += "".join(system_prompt(setting, "0-1000") for setting in get_args(Setting))
    assert "pixel" not in told and "1024" not in told
    assert '"maximum": 1000' in told


def test_an_arm_is_known_by_its_name_with_whatever_follows():
    assert setting_named("agentic, pointer self") == "agentic"
    with pytest.raises(UnknownName, match="sideways"):
        setting_named("sideways")


def test_a_setting_may_say_who_points_or_that_graphs_are_short():
    for name in (*get_args(Setting), "agentic, pointer self", "text-only, short graphs"):
        check_setting(name)
    for name in ("text-only, pointer self", "agentic, short graphs", "text-only, long graphs"):
        with pytest.raises(UnknownName):
            check_setting(name)
    assert graphs_of("text-only, short graphs") == "short"
    assert graphs_of("text-only") == graphs_of("agentic, pointer self") == "full"
    assert told_with("text-only", "short") == "text-only, short graphs"
    assert told_with("agentic", "full") == "agentic"


def test_without_pictures_no_text_promises_one():
    told = json.dumps([vars(tool) for tool in tools_for("pixels", setting="text-only")])
    assert "new picture" not in told and "the picture with" not in told
    assert "You see no picture" in system_prompt("text-only", "pixels")
    # What depends on the set-up is told all the same.
    assert "The picture is 58 cm wide." in told


def as_json() -> str:
    told = {
        points: {
            "prompts": {setting: system_prompt(setting, points) for setting in get_args(Setting)},
            "tools": [vars(tool) for tool in tools_for(points)],
            "text-only tools": [vars(tool) for tool in tools_for(points, setting="text-only")],
        }
        for points in get_args(Points)
    }
    reminders = {setting: reminder(setting) for setting in ("agentic", "direct")}
    reminders["point"] = reminder("direct", answered=True)
    return json.dumps({**told, "reminders": reminders}, indent=1) + "\n"
