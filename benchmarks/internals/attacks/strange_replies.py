"""What a model may say instead of a call; every episode must go on to its answer all the same."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from threading import Lock
from typing import Any

from command import probe
from verdict import Attack, some

ROOT = Path(__file__).resolve().parents[3]
sys.path.append(str(ROOT / "tests"))

from model_server import Reply, serving  # noqa: E402
from probe.episodes.files import read_records  # noqa: E402
from probe.episodes.folder import RECORDS  # noqa: E402
from probe.tasks.suite_file import demo_suite  # noqa: E402

KIND = "model replies"
_ANSWER = Reply(calls=(("answer_question", '{"choice": "A"}'),))


def _calls(name: str, *arguments: str) -> list[tuple[str, Reply]]:
    return [(f"{name} {text[:40]}", Reply(calls=((name, text),))) for text in arguments]


REPLIES: list[tuple[str, Reply]] = [
    *_calls(
        "answer_question", '{"choice": "\\ud800"}', '{"choice": 7}', '{"choice": null}', "[]", "",
        "null", '"A"', '{"choice": ["A"]}', '{"choice": "A", "point": [NaN, Infinity]}',
        '{"choice": "\\u0000"}', '{"\\udfff": "A"}', '{"choice": "A", "choice": "Q"}',
        '{"choice": "' + "A" * 1_000_000 + '"}', '{"choice": "F"}',
    ),
    *_calls(
        "find_object", '{"description": "\\ud83d"}', '{"description": {"a": []}}',
        '{"description": ' + "[" * 5_000 + "]" * 5_000 + "}", '{"description": "\\u001b[2J"}',
        '{"description": 1' + "0" * 5_000 + "}", "{", "\ufeff{}", '{"a": 1}',
    ),
    *_calls("push", '{"object_id": "object_1", "direction": "up", "distance_cm": 1e999}',
            '{"object_id": "object_1", "direction": "up", "distance_cm": -0.0}'),
    *_calls("grasp_and_remove", '{"object_id": "../../etc"}', '{"object_id": 1e400}'),
    *_calls("no_such_tool", "{}"), *_calls("", "{}"), *_calls("\ud800", "{}"),
    *_calls("a" * 10_000, "{}"), *_calls("__class__", "{}"),
    ("nothing", Reply("")), ("no words", Reply(None)), ("a refusal", Reply(refusal="No.")),
    ("half a pair", Reply("\ud800")), ("a megabyte", Reply("word " * 200_000)),
    ("escapes", Reply("\x1b[2J\x00\u202e")), ("markup", Reply("[/red] [bold")),
    ("two answers", Reply(calls=_ANSWER.calls * 2)),
    ("fifty calls", Reply(calls=_ANSWER.calls * 50)),
]  # fmt: skip


class _Script:
    """Says something strange first in each conversation, then answers."""

    def __init__(self, replies: list[Reply]) -> None:
        self._replies = replies
        self._said = 0
        self._lock = Lock()

    def __call__(self, number: int, body: dict[str, Any]) -> Reply:
        if any(message["role"] == "assistant" for message in body["messages"]):
            return _ANSWER
        with self._lock:
            self._said += 1
            return self._replies[(self._said - 1) % len(self._replies)]


def attack_with_replies(folder: Path, scale: float) -> Iterator[Attack]:
    """Evaluate a model over the demo's tasks, each reply first in one of its episodes.

    Args:
        folder: For the run.
        scale: The share of replies that is tried.
    """
    replies = some(REPLIES, scale)
    tasks = len(demo_suite().tasks)
    epochs = -(-len(replies) // tasks)
    with serving(_Script([reply for _, reply in replies]), keep=False) as server:
        ended = probe(
            "run", "demo", "--model", "strange", "--endpoint", server.url, "--epochs", str(epochs),
            "--workers", "2", "--out", folder, patience=1800,
        )  # fmt: skip
    records = read_records(folder / RECORDS) if (folder / RECORDS).exists() else []
    answered = sum(record.end == "answered" for record in records)
    whole = epochs * tasks
    for number in range(whole):
        name = replies[number][0] if number < len(replies) else "one of them again"
        yield Attack(KIND, name, "harmless" if number < answered else "crashed")
    if answered < whole:
        told = ended.returncode != 0 and "Traceback" not in ended.stderr
        yield Attack(KIND, "what is missing is said", "refused" if told else "crashed",
                     ended.stderr[-300:])  # fmt: skip
