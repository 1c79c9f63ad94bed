"""Training writes tools out as servers get them from the harness, byte for byte."""

from __future__ import annotations

import json
from typing import Any, get_args

import pytest
from inspect_ai.model import get_model

from probe.bench.wire import tool_infos
from probe.episodes.participation import Points
from probe.transcripts.tools import as_sent


@pytest.mark.filterwarnings("default")  # the client is never closed
@pytest.mark.parametrize("points", get_args(Points))
@pytest.mark.parametrize("setting", ["agentic", "text-only"])
def test_tools_are_told_as_they_are_sent(points, setting):
    model = get_model("openai-api/local/x", base_url="http://localhost", api_key="none")
    api: Any = model.api
    sent = api.tools_to_openai(tool_infos(points, setting=setting))
    assert json.dumps(as_sent(points, setting=setting)) == json.dumps(sent)
