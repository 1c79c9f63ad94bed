"""What the page of simulation and robot says in words. Values in, sentences and rows out."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from probe.report.formats import UNKNOWN
from probe.report.result_words import names_of
from probe.scores.correlation import ALL_ORDERS, least_telling
from probe.scores.intervals import Interval
from probe.scores.sim_real import FEWEST, SimReal
from probe.texts import plural


def result_of(found: SimReal) -> str:
    """The result: whether agents keep their order, and whose success isn't that in simulation."""
    others = [it.entrant for it in found.agents if not it.difference.tie]
    tasks = plural(len(found.tasks), "task")
    order = _order(found.spearman.value)
    if others:
        return f"{order}The robot's success differs by more than chance for {names_of(others)}."
    return f"{order}{tasks} are too few to tell the robot's success from that in simulation."


def _order(rho: float | None) -> str:
    if rho is None:
        return ""
    same = "have" if math.isclose(rho, 1) else "don't have"
    return f"Agents {same} the same order in both places. "


def telling(found: SimReal) -> list[str]:
    """Sentences on what so few models can show and what not."""
    n, r = len(found.agents), found.pearson
    if n < FEWEST:
        return [
            f"{n} models make no correlation: two points always lie on a line. Compare at least "
            f"{FEWEST}."
        ]
    if r.value is None:
        return ["All models fared alike in one of the places, so there is nothing to correlate."]
    chance = f"1 of {math.factorial(n):,}" if n <= ALL_ORDERS else "almost no"
    if r.over_models is None:
        over = (
            "A perfect r has no interval over models: it would have no width, however few they are"
        )
    else:
        over = f"With {n} models, the interval of r over models spans {span(r.over_models)}"
    return [
        f"These {n} models can show whether simulation puts them into the order that they have on "
        "this robot, and how far that depends on which tasks were drawn: the interval over tasks.",
        f"They can't show that it will do so for other models. {over}; r would have to exceed "
        f"{least_telling(n):.3f} for a t test to exclude 0. Models in an order by chance have the "
        f"same order in both places in {chance} cases.",
    ]


def causes_table(found: SimReal) -> list[tuple[str, tuple[tuple[int, int], ...]]]:
    """For each cause, how often it ended an episode of each agent: in simulation, on the robot."""
    total: dict[str, int] = {}
    for agent in found.agents:
        for causes in (agent.sim.causes, agent.real.causes):
            for cause, count in causes.items():
                total[cause] = total.get(cause, 0) + count
    ranked = sorted(total, key=lambda cause: (-total[cause], cause))
    return [
        (
            cause,
            tuple(
                (it.sim.causes.get(cause, 0), it.real.causes.get(cause, 0)) for it in found.agents
            ),
        )
        for cause in ranked
    ]


def grouped(left_out: Mapping[str, str]) -> list[tuple[str, Sequence[str]]]:
    """Tasks that don't count, by why."""
    why: dict[str, list[str]] = {}
    for task, reason in sorted(left_out.items()):
        why.setdefault(reason, []).append(task)
    return list(why.items())


def span(interval: Interval | None) -> str:
    """An interval of correlations as "-0.83 to 0.99"."""
    if interval is None:
        return UNKNOWN
    return f"{interval.low:.2f} to {interval.high:.2f}".replace("-", "\N{MINUS SIGN}")
