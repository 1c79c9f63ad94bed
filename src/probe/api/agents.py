"""The agents that `probe run` knows by name, and what each is told."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, get_args

from probe.agents.baselines import AtOnce, Rule, always, always_none, extreme, middle_number
from probe.agents.question_classifier import most_likely, read_learnt
from probe.agents.random import Random
from probe.agents.scripted import Scripted
from probe.api.scenes import running
from probe.assets.library import Library
from probe.episodes.turns import Agent
from probe.errors import BadData
from probe.generation.first_look import visible_areas
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.task import Task

_Blind = Literal[
    "always-A", "always-B", "always-C", "always-D", "always-E", "always-none", "middle-number",
    "question-only",
]  # fmt: skip
_Sizing = Literal["smallest", "largest"]
AgentName = Literal["scripted", "random", _Blind, _Sizing]

SETTINGS: Mapping[str, str] = {
    "scripted": "scripted",
    "random": "random",
    # These see the question and its options, and nothing else.
    **dict.fromkeys(get_args(_Blind), "blind"),
    # These know the catalogue too, and the visible parts of marked objects.
    **dict.fromkeys(get_args(_Sizing), "rule"),
}
"""Setting of each agent."""


def builtin_agent(
    name: AgentName,
    task: Task,
    library: Library,
    *,
    run: int = 0,
    renderer: Renderer | None = None,
) -> Agent:
    """One of the built-in agents, fresh for one episode.

    Args:
        name: "scripted", "random", or one of the baselines.
        task: What it will be asked. The scripted agent is told the question's type and subject.
        library: Has the task's objects, and those that its options name.
        run: Number of the run; the random draws of an agent depend on it.
        renderer: One that is running already; by default one is started, and ended afterwards.
    """
    with running(renderer) as drawing:
        return make_agent(name, task, run, library, drawing)


def make_agent(name: str, task: Task, run: int, library: Library, renderer: Renderer) -> Agent:
    """An agent, fresh for one episode; see probe.runs.work.AgentOf.

    Args:
        name: Which.
        task: What it will be asked.
        run: Number of the run.
        library: Has the task's objects, and those that its options name.
        renderer: Draws what an agent is told of the first picture; what was loaded is replaced.

    Raises:
        BadData: What the question-only agent learnt is missing.
    """
    rng = generator(task.seed, "run", name, run)
    if name == "random":
        return Random(rng)
    if name == "scripted":
        return Scripted(task.question_type, task.subject, rng, form=task.form, bold=True)
    return AtOnce(_rule(name, task, library, renderer))


def _rule(name: str, task: Task, library: Library, renderer: Renderer) -> Rule:
    if name == "smallest" or name == "largest":
        sizes = {spec.name: max(spec.size) for spec in reversed(library.specs)}
        areas = visible_areas(task, library, renderer) if task.marks else {}
        return extreme(sizes, areas, largest=name == "largest")
    if name == "always-none":
        return always_none
    if name == "middle-number":
        return middle_number
    if name == "question-only":
        return _learnt(task)
    return always(name.removeprefix("always-"))


def _learnt(task: Task) -> Rule:
    learnt = read_learnt()
    if task.question_type not in learnt:
        raise BadData(
            "question_only.json",
            f"nothing was learnt about {task.question_type} questions",
            "Learn it: probe suite learn SUITE... --out src/probe/agents/data/question_only.json",
        )
    return most_likely(learnt[task.question_type].weights)
