"""Examples in the forms of three trainers. Pictures are left where they are shown; writes nothing.

- TRL: messages whose content is a list of parts, pictures as parts without content.
- LLaMA-Factory (ShareGPT): turns that alternate, pictures as `<image>`.
- VILA: the same without tools or a system turn; its rules stand in the first turn.

The last two have no message of the user's after a tool's: its picture ends the tool's own turn.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from probe.train.dataset.examples import TrainingExample, call_arguments
from probe.transcripts.messages import PICTURE_FOLLOWS, Message

Row = dict[str, Any]
IMAGE = "<image>"


def trl_row(example: TrainingExample) -> Row:
    """As TRL takes it; arguments and tools are JSON text, since a table's columns have one form."""
    return {
        "id": example.id,
        "type": example.question_type,
        "arm": example.setting,
        "answer": example.letter,
        "augmented": example.augmented,
        "messages": [
            _trl_message(message, learnt=at not in example.not_learnt)
            for at, message in enumerate(example.messages)
        ],
        "images": [{"bytes": picture, "path": None} for picture in example.pictures],
        "tools": example.tools,
    }


def sharegpt_row(example: TrainingExample, files: Sequence[str]) -> Row:
    """As LLaMA-Factory takes it.

    Calls are written out as Qwen's template does, in a turn of "gpt": its own turn for calls takes
    no words beside them.

    Args:
        example: The conversation.
        files: Of its pictures.
    """
    rules, turns = _turns(example)
    return {
        "id": example.id,
        "conversations": [{"from": who, "value": text} for who, text in turns],
        "system": rules,
        "tools": _functions(example),
        "images": list(files),
    }


def vila_row(example: TrainingExample, files: Sequence[str]) -> Row:
    """As VILA's LLaVANextDataset takes it; see sharegpt_row."""
    rules, turns = _turns(example)
    first = "\n\n".join(filter(None, [rules, _tools_in_words(example), turns[0][1]]))
    named = [("human" if who != "gpt" else "gpt", text) for who, text in [("human", first)]]
    named += [("gpt" if who == "gpt" else "human", text) for who, text in turns[1:]]
    return {
        "id": example.id,
        "image": list(files),
        "conversations": [{"from": who, "value": text} for who, text in named],
    }


def _trl_message(message: Message, *, learnt: bool) -> Row:
    parts: list[Row] = [{"type": "text", "text": message.text}] if message.text else []
    parts += [{"type": "image", "text": None} for _ in message.pictures]
    calls = [
        {
            "id": id,
            "type": "function",
            "function": {"name": call.name, "arguments": call.arguments},
        }
        for id, call in message.calls
    ]
    return {
        "role": message.role,
        "content": parts,
        "tool_calls": calls or None,
        "tool_call_id": message.call_id or None,
        # Name and values are those of OpenAI's files for fine-tuning.
        "weight": int(learnt) if message.role == "assistant" else None,
    }


def _turns(example: TrainingExample) -> tuple[str, list[tuple[str, str]]]:
    """The rules, and turns of "human" or "observation" and of "gpt" by turns."""
    rules, turns = "", list[tuple[str, str]]()
    for message in example.messages:
        if message.role == "system":
            rules = message.text
            continue
        who = {"user": "human", "assistant": "gpt", "tool": "observation"}[message.role]
        text = _in_words(message)
        if turns and who != "gpt" and turns[-1][0] != "gpt":
            turns[-1] = (turns[-1][0], f"{turns[-1][1]}\n{text}")
        else:
            turns.append((who, text))
    return rules, turns


def _in_words(message: Message) -> str:
    """Words, calls and places of pictures as one text."""
    calls = [
        "<tool_call>\n"
        + json.dumps({"name": call.name, "arguments": call_arguments(call.arguments)})
        + "\n</tool_call>"
        for _, call in message.calls
    ]
    text = message.text
    if message.role == "tool":
        # Here the picture stands where this sentence says that one follows.
        text = text.removesuffix(f"\n{PICTURE_FOLLOWS}")
    return "\n".join(filter(None, [text, *calls, *(IMAGE for _ in message.pictures)]))


def _functions(example: TrainingExample) -> str:
    """The tools without the wrapping that LLaMA-Factory adds itself."""
    tools: list[Row] = json.loads(example.tools) if example.tools else []
    return json.dumps([tool["function"] for tool in tools]) if tools else ""


def _tools_in_words(example: TrainingExample) -> str:
    """What Qwen's template says of tools, for a trainer that knows none."""
    if not example.tools:
        return ""
    lines = "\n".join(json.dumps(tool) for tool in json.loads(example.tools))
    return (
        "You may call these tools, described in JSON:\n"
        f"<tools>\n{lines}\n</tools>\n"
        "To call one, write a JSON object within <tool_call></tool_call>:\n"
        '<tool_call>\n{"name": <name>, "arguments": <arguments>}\n</tool_call>'
    )
