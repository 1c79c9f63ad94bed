"""The tools' pages say what a model is told, word for word, and show pictures that exist."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import tool_pages

from probe.toolshed.tools import tool_schemas

ROOT = Path(__file__).parents[1]


@pytest.mark.parametrize("tool", tool_schemas(), ids=lambda tool: tool.name)
def test_a_page_is_made_from_the_tools_text(tool):
    text = (ROOT / "docs/reference/tools" / f"{tool.name}.md").read_text("utf-8")
    assert tool_pages.page(tool, text) == text, "run scripts/tool_pages.py"
    told = " ".join(line[2:] for line in text.splitlines() if line.startswith("> "))
    for sentence in re.split(r"(?<=\.)\s+", " ".join(tool.description.split())):
        assert sentence in told
    for picture in re.findall(r"\]\(\.\./\.\./(pictures/[^)]+)\)", text):
        assert (ROOT / "docs" / picture).stat().st_size < 300_000
