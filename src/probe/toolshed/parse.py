"""From what an agent sent to a checked request, or to words about what is wrong with it."""

from __future__ import annotations

from typing import Any

import pydantic

from probe.toolshed.refusals import BadArguments, UnknownTool, quoted
from probe.toolshed.tools import TOOLS, Request
from probe.types import USUAL_SCALE

USAGE = {
    "perceive_scene": "perceive_scene()",
    "find_object": 'find_object(description="red mug")',
    "grasp_and_remove": 'grasp_and_remove(object_id="object_1")',
    "push": 'push(object_id="object_1", direction="left", distance_cm=10)',
    "answer_question": 'answer_question(choice="A") or answer_question(choice="A", '
    "point=[512, 300])",
}

_PROBLEMS_SHOWN = 3


def parse(name: object, arguments: object, side_px: int = USUAL_SCALE.side_px) -> Request:
    """Check a call.

    Args:
        name: Should be the name of a tool.
        arguments: Should be a mapping of its arguments; None stands for no arguments.
        side_px: Edge of the pictures that it is about, pixels.

    Raises:
        UnknownTool: No tool has this name.
        BadArguments: The arguments don't fit the tool.
    """
    if not isinstance(name, str) or name not in TOOLS:
        raise UnknownTool(name, list(TOOLS))
    given: Any = {} if arguments is None else arguments
    if not isinstance(given, dict):
        problem = f"its arguments have to be a JSON object, not {quoted(type(given).__name__)}"
        raise BadArguments(name, [problem], USAGE[name])
    try:
        return TOOLS[name].model_validate(given, context={"side_px": side_px})
    except pydantic.ValidationError as failure:
        raise BadArguments(name, _problems(failure), USAGE[name]) from failure


def _problems(failure: pydantic.ValidationError) -> list[str]:
    errors = failure.errors(include_input=False, include_context=False, include_url=False)
    shown = [_problem(error["loc"], error["type"], error["msg"]) for error in errors]
    rest = len(shown) - _PROBLEMS_SHOWN
    return shown[:_PROBLEMS_SHOWN] + ([f"and {rest} more"] if rest > 0 else [])


def _problem(place: tuple[int | str, ...], kind: str, message: str) -> str:
    field = quoted(str(place[0])) if place else "the arguments"
    if kind == "missing":
        return f"{field} is missing"
    if kind == "extra_forbidden":
        return f"it takes no {field}"
    return f"{field}: {message[0].lower()}{message[1:]}"
