"""Training writes tools out as servers get them from the harness, byte for byte."""

from __future__ import annotations

import json
from typing import get_args

import pytest
from inspect_ai.model._openai import openai_chat_tools

from probe.bench.wire import tool_infos
from probe.chat.tools import as_sent
from probe.episodes.seat import Points


@pytest.mark.parametrize("points", get_args(Points))
def test_tools_are_told_as_they_are_sent(points):
    assert json.dumps(as_sent(points)) == json.dumps(openai_chat_tools(tool_infos(points)))
