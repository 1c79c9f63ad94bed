"""The tools' texts are product text: a change of theirs has to be meant."""

import json
from pathlib import Path

from probe.toolshed.tools import tool_schemas

SNAPSHOT = Path(__file__).with_name("tools.json")


def test_the_five_tools_read_as_they_were_reviewed():
    """To accept a change: write `as_json()` to tools.json and read the difference."""
    assert as_json() == SNAPSHOT.read_text()


def test_schemas_allow_nothing_undeclared():
    for tool in tool_schemas():
        assert tool.parameters["type"] == "object"
        assert tool.parameters["additionalProperties"] is False
        assert set(tool.parameters.get("required", [])) <= set(tool.parameters["properties"])


def as_json() -> str:
    tools = [
        {"name": t.name, "description": t.description, "parameters": t.parameters}
        for t in tool_schemas()
    ]
    return json.dumps(tools, indent=1) + "\n"
