"""What agents without a model reach: `python benchmarks/baselines.py --help`.

Runs them on a suite, and the scripted one also on one that it didn't filter, and prints a table.
Goes on where an earlier run stopped. A suite's tasks were kept because the scripted agent
solved them once, so that its score there is what remains of that with fresh luck.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import tyro

from probe.api.agents import AgentName, make_agent
from probe.api.grading import graded
from probe.api.resources import everything
from probe.api.rows import rows_of, write_beside
from probe.cli.running import run_order
from probe.episodes.noise import NOISES, NoiseName
from probe.runs.plan import RunOrder
from probe.scores.marking import roster_of_tasks
from probe.scores.scorecard import Figure, Scorecard
from probe.scores.summary import summarise
from probe.tasks.suite import Suite
from probe.tasks.suite_file import find_suite
from probe.tasks.task import QUESTION_TYPES

RULES: tuple[AgentName, ...] = (
    "random",
    "always-A",
    "always-B",
    "always-C",
    "always-D",
    "always-none",
    "middle-number",
    "question-only",
    "smallest",
    "largest",
)
BEGIN, END = "<!-- benchmarks/baselines.py -->", "<!-- end of table -->"


@dataclass(frozen=True)
class Entry:
    """A row of the table: who, on what, how its hand errs."""

    suite: str
    agent: AgentName
    noise: NoiseName

    @property
    def folder(self) -> str:
        """Where its records are."""
        return f"{self.suite}-{self.agent}-{self.noise}"


def main(
    out: Path = Path("outputs/baselines"),
    suite: str = "v1",
    unfiltered: str | None = "v1-unfiltered",
    agents: tuple[AgentName, ...] = ("scripted", *RULES),
    workers: int = 2,
    into: tuple[Path, ...] = (),
) -> None:
    """Run agents without a model and print a table of what they reach.

    Args:
        out: Folder for the runs.
        suite: For all of them.
        unfiltered: Another for the scripted agent.
        agents: Which.
        workers: Processes.
        into: Pages whose table, between their marks, is replaced by this one.
    """
    wanted = list[Entry]()
    for agent in agents:
        noises: tuple[NoiseName, ...] = ("paper", "none") if agent == "scripted" else ("none",)
        suites = (suite, unfiltered) if agent == "scripted" else (suite,)
        wanted += [Entry(name, agent, noise) for name in suites if name for noise in noises]
    rows = [
        row(entry, card_of(find_suite(entry.suite), entry, out / entry.folder, workers))
        for entry in wanted
    ]
    table = "\n".join([*head(), *rows])
    print(table)
    for page in into:
        replace_table(page, table)


def replace_table(page: Path, table: str) -> None:
    """Put a table between the marks of a page."""
    before, begin, rest = page.read_text().partition(BEGIN)
    _, end, after = rest.partition(END)
    if not end:
        raise SystemExit(f"{page} has no place for the table: {BEGIN} ... {END}")
    page.write_text(f"{before}{begin}\n{table}\n{end}{after}")


def card_of(suite: Suite, entry: Entry, folder: Path, workers: int) -> Scorecard:
    """An agent's figures; it is run as far as it hasn't been."""
    order = RunOrder(entry.agent, noise=NOISES[entry.noise])
    run_order(suite, order, make_agent, everything(), folder, workers)
    rows = rows_of(folder, suite.name, graded(folder))
    scores = summarise(suite.name, rows, roster_of_tasks(suite.tasks))
    write_beside(folder, rows, scores)
    (card,) = scores.cards
    return card


def head() -> Iterator[str]:
    """The table's first lines."""
    titles = ["agent", "suite", "noise", "n", "macro (95 %)", *QUESTION_TYPES, "Find, letter alone"]
    yield f"| {' | '.join(titles)} |"
    yield "|" + "---|" * len(titles)


def row(entry: Entry, card: Scorecard) -> str:
    """An entrant's line."""
    question_types = {figure.name: figure for figure in (*card.question_types, *card.parts)}
    shown = [share(question_types.get(question_type)) for question_type in QUESTION_TYPES]
    alone = share(next((f for name, f in question_types.items() if "letter" in name), None))
    cells = [entry.agent, entry.suite, entry.noise, str(card.macro.tasks), macro(card.macro)]
    return f"| {' | '.join([*cells, *shown, alone])} |"


def share(figure: Figure | None) -> str:
    """An accuracy in per cent."""
    if figure is None:
        return ""
    value = figure.headline.value
    return "incomplete" if value is None else f"{100 * value:.0f}"


def macro(figure: Figure) -> str:
    """The headline with its interval."""
    value, interval = figure.headline.value, figure.student
    if value is None or interval is None:
        return "incomplete"
    return f"{100 * value:.1f} ({100 * interval.low:.0f}-{100 * interval.high:.0f})"


if __name__ == "__main__":
    tyro.cli(main)
