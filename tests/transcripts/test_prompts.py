"""What models are told is product text: a change of it has to be meant."""

from __future__ import annotations

import json
from pathlib import Path
from typing import get_args

import pytest

from probe.episodes.participation import Points
from probe.errors import UnknownName
from probe.toolshed.tools import tool_schemas
from probe.transcripts.prompts import Setting, reminder, setting_named, system_prompt
from probe.transcripts.tools import tools_for

SNAPSHOT = Path(__file__).with_name("told.json")


def test_prompts_and_tools_read_as_they_were_reviewed():
    """To accept a change: write `as_json()` to told.json and read the difference."""
    assert as_json() == SNAPSHOT.read_text()


def test_in_pixels_the_tools_are_the_toolsheds():
    assert tools_for("pixels") == tool_schemas()


def test_in_thousandths_no_pixel_is_left():
    told = json.dumps([vars(tool) for tool in tools_for("0-1000")])
    told += "".join(system_prompt(setting, "0-1000") for setting in get_args(Setting))
    assert "pixel" not in told and "1024" not in told
    assert '"maximum": 1000' in told


def test_an_arm_is_known_by_its_name_with_whatever_follows():
    assert setting_named("agentic, pointer self") == "agentic"
    with pytest.raises(UnknownName, match="sideways"):
        setting_named("sideways")


def as_json() -> str:
    told = {
        points: {
            "prompts": {setting: system_prompt(setting, points) for setting in get_args(Setting)},
            "tools": [vars(tool) for tool in tools_for(points)],
        }
        for points in get_args(Points)
    }
    reminders = {setting: reminder(setting) for setting in ("agentic", "direct")}
    reminders["point"] = reminder("direct", answered=True)
    return json.dumps({**told, "reminders": reminders}, indent=1) + "\n"
