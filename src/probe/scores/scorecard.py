"""One entrant's figures: the headline, its parts, how sure they are, and what it did."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, TypedDict

import numpy as np
import pydantic

from probe.scores.breakdown import (
    Effort,
    Execution,
    Outcomes,
    Spread,
    effort,
    execution,
    outcomes,
)
from probe.scores.estimates import corrected, macro_chance
from probe.scores.intervals import Interval, bootstrap, standard_error, student, wilson
from probe.scores.missing import Absent, Gap, Headline, gaps_of, headline, present, runs_of
from probe.scores.power import detectable_gap
from probe.scores.restraint import is_restrained, needless
from probe.scores.roster import (
    Guess,
    Listed,
    Roster,
    chance_by_type,
    guessed,
    letter_guessed,
    naive_by_type,
)
from probe.scores.row import Entrant, Row
from probe.scores.units import ContraryRows, Unit, Worth, is_correct, strata_of, units_of
from probe.tasks.type_rules import rules_of


def icc(units: Iterable[Unit]) -> float | None:
    """Intraclass correlation of runs within question types, one-way random effects.

    That is ICC(1, 1) of Shrout and Fleiss (Psychol. Bull. 86(2), 1979), with mean squares pooled
    over types. Where tasks were run unequally often, the mean number of runs is the one that keeps
    the estimate of variance unbiased (Donner, Int. Stat. Rev. 54(1), 1986). It may be a little
    below 0 where runs are unrelated.

    Returns:
        None if no task was run twice, no type has two tasks, or nothing varies.
    """
    question_types: dict[str, list[Sequence[float]]] = {}
    for unit in units:
        question_types.setdefault(unit.question_type, []).append(unit.runs)
    between = within = repeats = 0.0
    freedom = spare = 0
    for tasks in question_types.values():
        sizes = np.array([len(runs) for runs in tasks])
        means = np.array([np.mean(runs) for runs in tasks])
        middle = float(sizes @ means) / int(sizes.sum())
        between += float(sizes @ (means - middle) ** 2)
        within += sum(len(runs) * float(np.var(runs)) for runs in tasks)
        freedom += len(tasks) - 1
        spare += int(sizes.sum()) - len(tasks)
        repeats += float(sizes.sum() - (sizes**2).sum() / sizes.sum())
    if not freedom or not spare or between + within == 0:
        return None
    return _from_squares(between / freedom, within / spare, repeats / freedom)


def _from_squares(between: float, within: float, runs: float) -> float:
    return (between - within) / (between + (runs - 1) * within)


@dataclass(frozen=True)
class Figure:
    """An accuracy.

    Attributes:
        name: Of what: "macro", a type, a part of one.
        headline: The number, or why there is none.
        tasks: n, on which intervals rest.
        runs: Rows that aren't missing.
        chance: What a blind guess gives.
        naive: What a guess gives after a look: the same, but a third in Count, by counting what
            shows, and all where no manipulation is necessary.
        beyond_guessing: Accuracy beyond `chance`; None while rows are missing.
        corrected: Accuracy beyond chance, that is, beyond `naive`; None while rows are missing, and
            where a look makes all right.
        student, bootstrap: 95 % intervals of the number, by the t distribution and by drawing
            tasks; None while rows are missing.
        wilson: The same for a single type whose tasks were run once each, else None.
    """

    name: str
    headline: Headline
    tasks: int
    runs: int
    chance: float
    naive: float
    beyond_guessing: float | None
    corrected: float | None
    student: Interval | None
    bootstrap: Interval | None
    wilson: Interval | None


class Restraint(TypedDict, total=False):
    """Fields of a Scorecard that need all tasks to state what is necessary."""

    restrained: Figure
    by_necessary: tuple[Figure, ...]
    needless: Spread | None


_IF_ANY = pydantic.Field(exclude_if=lambda it: not it)


@dataclass(frozen=True)
class Scorecard:
    """All figures of one entrant.

    Attributes:
        macro: The headline: mean over types.
        question_types: Each type.
        parts: Letters alone of types that need more than a letter, and Find's hidden, open and
            partly visible targets.
        gaps: What is missing, by task and run.
        icc: Of runs, within types; None if there is nothing to tell it from.
        detectable: Difference from an equally variable agent, unrelated to this one, that 80 % of
            suites of this size would show; pairs have their own. None while rows are missing.
        outcomes, effort, execution: What it did; the last of Reduce.
        tools: Version of the tools it had; files leave it out where it is 1.
        restrained: As `macro`, of right answers with at most SPARE manipulations more than
            necessary; None, as the next two, unless all tasks state what is necessary. Files then
            leave it out.
        by_necessary: Accuracy by how many manipulations are necessary, over tasks of all types.
        needless: Manipulations more than necessary.
    """

    entrant: Entrant
    macro: Figure
    question_types: Annotated[tuple[Figure, ...], pydantic.Field(serialization_alias="kinds")]
    parts: tuple[Figure, ...]
    gaps: tuple[Gap, ...]
    icc: float | None
    detectable: float | None
    outcomes: tuple[Outcomes, ...]
    effort: Effort
    execution: Execution | None
    tools: Annotated[int, pydantic.Field(exclude_if=lambda version: version == 1)] = 1
    restrained: Annotated[Figure | None, _IF_ANY] = None
    by_necessary: Annotated[tuple[Figure, ...], _IF_ANY] = ()
    needless: Annotated[Spread | None, _IF_ANY] = None


def scorecard(rows: Sequence[Row], roster: Roster, seed: int) -> Scorecard:
    """All figures of one entrant.

    Args:
        rows: Of one agent in one setting, each run once.
        roster: All tasks of the suite.
        seed: Of the bootstrap.

    Raises:
        ContraryRows: They are of several entrants, suites or versions of the tools, or a run is
            there twice.
    """
    tools = rows[0].tools
    if odd := next((row for row in rows if row.tools != tools), None):
        raise ContraryRows(odd, f"it has version {odd.tools} of the tools, others have {tools}")
    return _card(rows[0].entrant, tools, rows, roster, seed, runs_of(rows))


def absent_card(absent: Absent, roster: Roster, seed: int) -> Scorecard:
    """The figures of an entrant of which all is missing; see scorecard."""
    return _card(absent.entrant, absent.tools, (), roster, seed, range(absent.ordered))


def _card(
    entrant: Entrant,
    tools: int,
    rows: Sequence[Row],
    roster: Roster,
    seed: int,
    runs: Collection[int],
) -> Scorecard:
    """All figures of an entrant that should have these runs of each task."""
    gaps = gaps_of(rows, roster, runs)
    error, freedom = standard_error(strata_of([] if gaps else units_of(rows)))
    return Scorecard(
        entrant=entrant,
        macro=_figure("macro", rows, roster, seed, runs=runs),
        question_types=tuple(
            _part(question_type, rows, roster, seed, _of_type(question_type), runs)
            for question_type in chance_by_type(roster)
        ),
        parts=_parts(rows, roster, seed, runs),
        gaps=tuple(gaps),
        icc=icc(units_of(present(rows))),
        detectable=detectable_gap(math.sqrt(2) * error, freedom) if error else None,
        outcomes=tuple(outcomes(rows)),
        effort=effort(rows),
        execution=execution(rows),
        tools=tools,
        **_restraint(rows, roster, seed, runs),
    )


def _restraint(rows: Sequence[Row], roster: Roster, seed: int, runs: Collection[int]) -> Restraint:
    counts = {listed.necessary for listed in roster.values()}
    steps = sorted(count for count in counts if count is not None)
    if None in counts:
        return {}
    return {
        "restrained": _figure("restrained", rows, roster, seed, is_restrained, runs),
        "by_necessary": tuple(
            _part(str(count), rows, roster, seed, _that_takes(count), runs, pool=True)
            for count in steps
        ),
        "needless": needless(rows),
    }


def _that_takes(necessary: int) -> Callable[[Listed], bool]:
    return lambda listed: listed.necessary == necessary


def _of_type(question_type: str) -> Callable[[Listed], bool]:
    return lambda listed: listed.question_type == question_type


def _of_stratum(stratum: str) -> Callable[[Listed], bool]:
    return lambda listed: listed.stratum == stratum


def _parts(
    rows: Sequence[Row], roster: Roster, seed: int, runs: Collection[int]
) -> tuple[Figure, ...]:
    strata = sorted({(it.question_type, it.stratum) for it in roster.values() if it.stratum})
    figures = [
        _part(f"{of}, {stratum}", rows, roster, seed, _of_stratum(stratum), runs)
        for of, stratum in strata
    ]
    more = {it.question_type for it in roster.values() if _needs_more(it.question_type)}
    letters = [
        _part(
            f"{of}, letter alone", rows, roster, seed, _of_type(of), runs, _letter, letter_guessed
        )
        for of in sorted(more)
    ]
    return (*letters, *figures)


def _needs_more(question_type: str) -> bool:
    """Whether a right letter alone doesn't count."""
    rules = rules_of(question_type)
    return rules.pointed or rules.exact


def _letter(row: Row) -> bool:
    return row.letter_correct


def _part(
    name: str,
    rows: Sequence[Row],
    roster: Roster,
    seed: int,
    keep: Callable[[Listed], bool],
    runs: Collection[int],
    worth: Worth = is_correct,
    guess: Guess = guessed,
    *,
    pool: bool = False,
) -> Figure:
    some = {task: listed for task, listed in roster.items() if keep(listed)}
    mine = [row for row in rows if row.task in some]
    return _figure(name, mine, some, seed, worth, runs, guess, pool=pool)


def _floor(by_type: Mapping[str, float], roster: Roster, *, pool: bool) -> float:
    """What doesn't take any skill, averaged over types or, pooled, over tasks."""
    if not pool:
        return macro_chance(by_type)
    return float(np.mean([by_type[listed.question_type] for listed in roster.values()]))


def _figure(
    name: str,
    rows: Sequence[Row],
    roster: Roster,
    seed: int,
    worth: Worth = is_correct,
    runs: Collection[int] = (),
    guess: Guess = guessed,
    *,
    pool: bool = False,
) -> Figure:
    top = headline(rows, roster, worth, runs, pool=pool)
    chance, naive = (
        _floor(by(roster, guess), roster, pool=pool) for by in (chance_by_type, naive_by_type)
    )
    known = top.value is not None
    units = units_of(rows, worth) if known else []
    strata = strata_of(units, pool=pool)
    single = len(strata) == 1 and all(len(unit.runs) == 1 for unit in units)
    return Figure(
        name=name,
        headline=top,
        tasks=len(roster),
        runs=len(present(rows)),
        chance=chance,
        naive=naive,
        beyond_guessing=None if top.value is None else corrected(top.value, chance),
        corrected=None if top.value is None or naive == 1 else corrected(top.value, naive),
        student=student(strata) if known else None,
        bootstrap=bootstrap(strata, seed) if known else None,
        wilson=wilson(units) if single else None,
    )
