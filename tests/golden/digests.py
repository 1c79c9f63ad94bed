"""What twelve frozen tasks give, as digests: `PYTHONPATH=tests python -m golden.digests`.

The file beside this one was written by v0.1's code. It is written again only when a change is meant
to alter what tasks give, which a new version of the suites has to say.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from pathlib import Path

import probe  # first: it decides how NumPy sums
from probe.api.agents import make_agent
from probe.api.resources import everything
from probe.assets.library import Library
from probe.episodes.circumstances import Circumstances
from probe.episodes.files import line_of
from probe.episodes.noise import NOISES
from probe.episodes.play import play, score
from probe.episodes.turns import Agent, Call, Question, Turn
from probe.render.photograph import load_scene, photograph
from probe.render.renderer import Renderer
from probe.scene.document import SceneDocument
from probe.tasks.suite_file import digest_of, packaged_suite
from probe.tasks.task import Task

GOLDEN = Path(__file__).parent / "golden.json"

CHOSEN = (
    *(
        ("v1", question_type)
        for question_type in ("beneath", "compare", "count", "find", "reduce", "size")
    ),
    *(("demo", question_type) for question_type in ("beneath", "count", "find")),
    *(("v1-scans", question_type) for question_type in ("beneath", "find", "size")),
)
"""Suites and types; the last task of each is taken, which no other test plays."""


class Watched:
    """Lets an agent act, and keeps every picture that it is handed."""

    def __init__(self, agent: Agent) -> None:
        self._agent = agent
        self.seen = hashlib.sha256()

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        picture = history[-1].result.picture if history else question.picture
        self.seen.update(b"none" if picture is None else picture.tobytes())
        return self._agent.act(question, history)


def chosen(suite: str, question_type: str) -> Task:
    return [task for task in packaged_suite(suite).tasks if task.question_type == question_type][-1]


def digests(task: Task, library: Library, renderer: Renderer) -> dict[str, str]:
    """What a task is, shows and gives, by name; 64 hex digits each, but for the grade."""
    return looks(task, library, renderer) | plays(task, library, renderer)


def looks(task: Task, library: Library, renderer: Renderer) -> dict[str, str]:
    """What a task is and shows, by name; 64 hex digits each."""
    table = library.table(task.scene.table)
    load_scene(renderer, task.scene, library, table)
    frame = photograph(renderer, task.scene)
    assert frame.rgb is not None and frame.labels is not None
    return {
        "task": digest_of(task),
        "scene": _hash(SceneDocument.of(task.scene).model_dump_json().encode()),
        "picture": _hash(frame.rgb.tobytes()),
        "depth": _hash(frame.depth.tobytes()),
        "labels": _hash(frame.labels.tobytes()),
    }


def plays(task: Task, library: Library, renderer: Renderer) -> dict[str, str]:
    """What the scripted agent is told and does, by name; 64 hex digits each, but for the grade."""
    agent = Watched(make_agent("scripted", task, 0, library, renderer))
    paper = Circumstances(noise=NOISES["paper"])
    record = play(task, agent, "scripted", library, renderer, paper, pictures=True)
    worth = score(task, record, renderer)
    texts = "\n".join(step.text for step in record.steps)
    return {
        "texts": _hash(texts.encode()),
        "pictures given": agent.seen.hexdigest(),
        "record": _hash(line_of(record, timed=False)),
        "grade": f"{worth.outcome} after {len(record.steps)} calls",
    }


def _hash(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def main() -> None:
    assert probe.SUMS_BOUND
    library = everything()
    with Renderer() as renderer:
        found = {
            f"{suite} {question_type}": digests(chosen(suite, question_type), library, renderer)
            for suite, question_type in CHOSEN
        }
    GOLDEN.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
