"""Write each tool's text, and a picture of it at work, into its page in docs/reference/tools.

What stands there between the marks is made from the text that a model reads; a test sees that it
still is. `--draw` plays a few calls on a demo task and draws them as well.
"""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import tyro
from beside import beside, write_picture

from probe.agents.reading import read_handle
from probe.api.resources import library
from probe.episodes.play import set_table
from probe.render.renderer import Renderer
from probe.tasks.suite_file import demo_suite
from probe.toolshed.tools import ToolSchema, tool_schemas
from probe.toolshed.toolshed import Toolshed
from probe.types import Array

DOCS = Path(__file__).parents[1] / "docs"
BEGIN, END = "<!-- from the tool's own text: scripts/tool_pages.py -->", "<!-- until here -->"
TASK = "beneath-8af85510"
COVER = "green mug"
SIDE_PX = 480
SEEN = {
    "perceive_scene": "The picture that comes with the list.",
    "find_object": f'The picture before, and the one that comes with `find_object("{COVER}")`.',
    "grasp_and_remove": f"Before and after the {COVER} was lifted into the basket.",
    "push": f"Before and after the {COVER} was pushed 10 cm to the left.",
}


def block(tool: ToolSchema) -> str:
    """The part of a page that is made from the tool's text."""
    quoted = "\n".join(f"> {line}".rstrip() for line in tool.description.splitlines())
    lines = [BEGIN, "", "What a model is told of it:", "", quoted, ""]
    for name, told in _arguments(tool.parameters).items():
        lines += textwrap.wrap(f"> `{name}`: {told}", 100, subsequent_indent="> ") + [""]
    if tool.name in SEEN:
        words = SEEN[tool.name]
        lines += [
            f"![{words.replace('`', '')}](../../pictures/tool_{tool.name}.jpg)",
            "",
            words,
            "",
        ]
    return "\n".join([*lines, END])


def page(tool: ToolSchema, text: str) -> str:
    """A page with its part made anew; it goes below the first paragraph where there is none yet."""
    if BEGIN in text:
        before, rest = text.split(BEGIN, 1)
        return before + block(tool) + rest.split(END, 1)[1]
    title, first, rest = text.split("\n\n", 2)
    return f"{title}\n\n{first}\n\n{block(tool)}\n\n{rest}"


def _arguments(schema: Mapping[str, Any]) -> dict[str, str]:
    properties: Mapping[str, Mapping[str, str]] = schema.get("properties", {})
    return {name: about.get("description", "") for name, about in properties.items()}


def pictures() -> dict[str, Array]:
    """What a few calls show, side by side with the table before."""
    task = next(task for task in demo_suite().tasks if task.id == TASK)
    things, shown = library("procedural"), dict[str, Array]()
    with Renderer() as renderer:
        tools, _ = set_table(task, things, renderer, pictures=True)
        _, start = _called(tools, "perceive_scene", {})
        shown["perceive_scene"] = start
        cover, found = _called(tools, "find_object", {"description": COVER})
        shown["find_object"] = beside(start, found, SIDE_PX)
        _, taken = _called(tools, "grasp_and_remove", {"object_id": cover})
        shown["grasp_and_remove"] = beside(start, taken, SIDE_PX)
        tools, _ = set_table(task, things, renderer, pictures=True)
        cover, _ = _called(tools, "find_object", {"description": COVER})
        way = {"object_id": cover, "direction": "left", "distance_cm": 10}
        _, pushed = _called(tools, "push", way)
        shown["push"] = beside(start, pushed, SIDE_PX)
    return shown


def _called(tools: Toolshed, name: str, arguments: Mapping[str, object]) -> tuple[str, Array]:
    """The first id that the reply names, and its picture."""
    result = tools.call(name, arguments)
    print(f"{name}: {result.text.splitlines()[0]}")
    assert result.picture is not None
    return read_handle(result.text) or "", result.picture


def main(*, draw: bool = False) -> None:
    """Write the pages anew.

    Args:
        draw: Draw the pictures as well.
    """
    for tool in tool_schemas():
        path = DOCS / "reference" / "tools" / f"{tool.name}.md"
        path.write_text(page(tool, path.read_text("utf-8")), "utf-8")
    for name, picture in (pictures() if draw else {}).items():
        write_picture(f"tool_{name}.jpg", picture, SIDE_PX)


if __name__ == "__main__":
    tyro.cli(main)
