"""The tasks that `inspect eval probe/...` knows; its entry point loads this module."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path

from inspect_ai import Task as HarnessTask
from inspect_ai import task

from probe.assets.folders import assets_folder, cache_folder, library_folder
from probe.assets.library import open_all
from probe.bench.harness import harness_task
from probe.bench.plan import ModelRunPlan, Pointer, check_folder
from probe.bench.prices import read_prices
from probe.episodes.conditions import Conditions, LightKind, RendererKind
from probe.episodes.participation import Points
from probe.episodes.tool_errors import NoiseChoice, tool_errors
from probe.perception.points import Convention
from probe.tasks.suite import check_objects
from probe.tasks.suite_file import find_suite
from probe.transcripts.prompts import Graphs, Setting

# The harness puts a package's name before its tasks' names, but doesn't recognise one that is
# installed from a checkout.
_SPACE = "" if "site-packages" in __file__ else "probe/"


@task(name=f"{_SPACE}agentic")
def agentic(
    suite: str = "v2",
    out: str = "outputs/inspect/agentic",
    epochs: int = 3,
    points: Points = "pixels",
    noise: NoiseChoice = "own",
    lighting: LightKind = "own",
    renderer: RendererKind = "own",
    pointer: Pointer = "oracle",
    pointing: Convention = "pixels",
    workers: int = 4,
    prices: str | None = None,
) -> HarnessTask:
    """Questions about a table, with the five tools to move things on it."""
    plan = _plan("agentic", suite, out, epochs, points, workers, prices)
    plan = replace(plan, pointer=pointer, convention=pointing)
    return _fit(_with_tools(plan, noise, Conditions(lighting=lighting, renderer=renderer)))


@task(name=f"{_SPACE}text_only")
def text_only(
    suite: str = "v2",
    out: str = "outputs/inspect/text_only",
    epochs: int = 3,
    points: Points = "pixels",
    graphs: Graphs = "full",
    noise: NoiseChoice = "own",
    lighting: LightKind = "own",
    renderer: RendererKind = "own",
    workers: int = 4,
    prices: str | None = None,
) -> HarnessTask:
    """The same questions, with the five tools and no picture: what shows is told in words."""
    plan = _plan("text-only", suite, out, epochs, points, workers, prices)
    plan = replace(plan, graphs=graphs)
    return _fit(_with_tools(plan, noise, Conditions(lighting=lighting, renderer=renderer)))


@task(name=f"{_SPACE}direct")
def direct(
    suite: str = "v2",
    out: str = "outputs/inspect/direct",
    epochs: int = 3,
    points: Points = "pixels",
    lighting: LightKind = "own",
    renderer: RendererKind = "own",
    workers: int = 4,
    prices: str | None = None,
) -> HarnessTask:
    """The same questions, from the first picture alone."""
    plan = _plan("direct", suite, out, epochs, points, workers, prices)
    return _fit(replace(plan, conditions=Conditions(lighting=lighting, renderer=renderer)))


@task(name=f"{_SPACE}blind")
def blind(
    suite: str = "v2",
    out: str = "outputs/inspect/blind",
    epochs: int = 3,
    points: Points = "pixels",
    workers: int = 4,
    prices: str | None = None,
) -> HarnessTask:
    """The same questions, without any picture."""
    return _fit(_plan("blind", suite, out, epochs, points, workers, prices))


@task(name=f"{_SPACE}oracle_view")
def oracle_view(
    suite: str = "v2",
    out: str = "outputs/inspect/oracle_view",
    epochs: int = 3,
    points: Points = "pixels",
    workers: int = 4,
    prices: str | None = None,
) -> HarnessTask:
    """The same questions, with pictures that show the evidence."""
    return _fit(_plan("oracle-view", suite, out, epochs, points, workers, prices))


def _plan(
    setting: Setting,
    suite: str,
    out: str,
    epochs: int,
    points: Points,
    workers: int,
    prices: str | None,
) -> ModelRunPlan:
    asked = find_suite(suite)
    return ModelRunPlan(
        setting,
        asked,
        asked.tasks,
        Path(out),
        partial(open_all, assets_folder(), cache_folder(), library_folder()),
        cache_folder() / "light",
        epochs,
        points,
        workers=workers,
        prices=read_prices(Path(prices)) if prices else {},
    )


def _with_tools(plan: ModelRunPlan, noise: NoiseChoice, conditions: Conditions) -> ModelRunPlan:
    """The plan under conditions, with tools that err as the suite says or as was asked for."""
    oracle = plan.pointer == "oracle"
    hand, conditions = tool_errors(plan.suite.headline, noise, conditions, oracle=oracle)
    return replace(plan, noise=hand, conditions=conditions)


def _fit(plan: ModelRunPlan) -> HarnessTask:
    """The task, if its folder and objects are fit; each sample would find out by itself otherwise.

    Who acts isn't known yet, so that --points and the convention of the one that points are
    compared with the first sample.
    """
    check_folder(plan, plan.order("", ""))
    check_objects(plan.suite, plan.library())
    return harness_task(plan)
