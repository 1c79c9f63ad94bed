"""All scores of a table of rows, as one document."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import Annotated

import pydantic

from probe.files import write_text
from probe.scene.seeds import generator
from probe.scores.holm import ties
from probe.scores.missing import Absent, present, settled
from probe.scores.pairs import Pair, Results, family, share_tasks
from probe.scores.roster import Roster
from probe.scores.row import Entrant, Row
from probe.scores.scorecard import Scorecard, absent_card, scorecard
from probe.scores.setting_effect import Both, SettingEffect, setting_effect
from probe.scores.units import ContraryRows, by_entrant, units_of

AGENTIC, DIRECT = "agentic", "direct"


@dataclass(frozen=True)
class Scores:
    """What a table of rows says.

    Attributes:
        suite: Its name.
        seed: Of all draws.
        complete: Nothing is missing, and the tasks are all that its suite has; where rows are
            missing comparisons rest on what is there, and headlines are refused.
        cards: One an entrant, best first by the worst case.
        agentic_against_direct: A family of comparisons: each agent that has both settings.
        all_pairs: Another: everyone with everyone.
        apart: Pairs that are in neither, since they share no task that both have results of.
        ties: Largest groups of whom no two differ in `all_pairs`.
        settings: Agentic against direct over all agents; None if nobody has both.
    """

    suite: str
    seed: int
    complete: bool
    cards: tuple[Scorecard, ...]
    agentic_against_direct: tuple[Pair, ...]
    all_pairs: tuple[Pair, ...]
    apart: tuple[tuple[Entrant, Entrant], ...]
    ties: tuple[tuple[Entrant, ...], ...]
    settings: Annotated[SettingEffect | None, pydantic.Field(serialization_alias="arms")]


def summarise(
    suite: str,
    rows: Iterable[Row],
    roster: Roster,
    seed: int = 0,
    *,
    whole: bool = True,
    absent: Iterable[Absent] = (),
) -> Scores:
    """All scores of a suite.

    Args:
        suite: Its name.
        rows: Of any agents in any settings; runs that failed may be there beside their repetitions.
        roster: All tasks of the suite.
        seed: Of all draws.
        whole: Whether these are all tasks of the suite that it is a part of, if it is one.
        absent: Who was ordered and has no row; who has one after all isn't absent.

    Raises:
        ContraryRows: Rows of another suite or of other tasks, or two results of a run.
    """
    # Draws go by position, so that the order of rows must not matter.
    kept = sorted(settled(rows), key=lambda row: (*row.entrant, row.task, row.run))
    for row in kept:
        if row.suite != suite:
            raise ContraryRows(row, f"it is of suite {row.suite}, not of {suite}")
    entrants = by_entrant(kept)
    cards = [scorecard(some, roster, seed) for some in entrants.values()]
    never = {it.entrant: it for it in absent if it.entrant not in entrants}
    cards += [absent_card(it, roster, seed) for _, it in sorted(never.items())]
    cards.sort(key=lambda card: -card.macro.headline.worst)
    results: Results = {
        entrant: units for entrant, some in entrants.items() if (units := units_of(present(some)))
    }
    ranked = [card.entrant for card in cards if card.entrant in results]
    shared = [pair for pair in combinations(ranked, 2) if share_tasks(results, pair)]
    settings = [pair for pair in _both_settings(ranked) if share_tasks(results, pair)]
    pairs = family(results, shared, seed)
    return Scores(
        suite=suite,
        seed=seed,
        complete=whole and not any(card.gaps for card in cards),
        cards=tuple(cards),
        agentic_against_direct=tuple(family(results, settings, seed)),
        all_pairs=tuple(pairs),
        apart=tuple(pair for pair in combinations(ranked, 2) if pair not in shared),
        ties=tuple(ties(ranked, [(p.first, p.second) for p in pairs if not p.tie])),
        settings=_setting_effect(results, settings, seed),
    )


def write_scores(path: Path, scores: Scores) -> None:
    """Write scores as JSON.

    Raises:
        OutputFailed: It can't be written; nothing half-written is left.
    """
    text = pydantic.TypeAdapter(Scores).dump_json(scores, indent=1, by_alias=True).decode()
    write_text(path, text + "\n")


def _both_settings(entrants: Sequence[Entrant]) -> list[tuple[Entrant, Entrant]]:
    direct = {entrant.agent: entrant for entrant in entrants if entrant.setting == DIRECT}
    return [
        (it, direct[it.agent]) for it in entrants if it.setting == AGENTIC and it.agent in direct
    ]


def _setting_effect(
    results: Results, settings: Sequence[tuple[Entrant, Entrant]], seed: int
) -> SettingEffect | None:
    both: Both = {one.agent: (results[one], results[other]) for one, other in settings}
    return setting_effect(both, generator(seed, "arms")) if both else None
