"""What agents without a model reach: `python benchmarks/baselines.py --help`.

Runs them on a suite, and the scripted one also on one that it didn't filter, and prints a table.
Goes on where an earlier run stopped. A suite's tasks were kept because the scripted agent
solved them once, so that its score there is what remains of that with fresh luck.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, get_args

import tyro

import probe

AgentName = Literal[
    "scripted", "random", "always-A", "always-B", "always-C", "always-D", "always-none",
    "middle-number", "question-only", "smallest", "largest",
]  # fmt: skip
NoiseName = Literal["none", "paper"]
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
    agents: tuple[AgentName, ...] = get_args(AgentName),
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
    types = sorted({task.question_type for task in probe.load_suite(suite).tasks})
    rows = [row(entry, scores_of(entry, out / entry.folder, workers), types) for entry in wanted]
    table = "\n".join([*head(types), *rows])
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


def scores_of(entry: Entry, folder: Path, workers: int) -> probe.Scores:
    """An agent's figures; it is run as far as it hasn't been."""
    suite = probe.load_suite(entry.suite)
    probe.run(suite, folder, agent=entry.agent, noise=entry.noise, workers=workers)
    return probe.rescore(folder)


def head(types: Sequence[str]) -> Iterator[str]:
    """The table's first lines."""
    titles = ["agent", "suite", "noise", "n", "macro (95 %)", *types, "Find, letter alone"]
    yield f"| {' | '.join(titles)} |"
    yield "|" + "---|" * len(titles)


def row(entry: Entry, scores: probe.Scores, types: Sequence[str]) -> str:
    """An entrant's line."""
    (card,) = scores.cards
    shares = {it.name: it.headline.value for it in (*card.question_types, *card.parts)}
    known = {name: per_cent(share) for name, share in shares.items()}
    alone = next((cell for name, cell in known.items() if "letter" in name), "")
    value, interval = card.macro.headline.value, card.macro.student
    macro = "incomplete"
    if value is not None and interval is not None:
        macro = f"{100 * value:.1f} ({100 * interval.low:.0f}-{100 * interval.high:.0f})"
    cells = [entry.agent, entry.suite, entry.noise, str(card.macro.tasks), macro]
    return f"| {' | '.join([*cells, *(known.get(name, '') for name in types), alone])} |"


def per_cent(share: float | None) -> str:
    """An accuracy."""
    return "incomplete" if share is None else f"{100 * share:.0f}"


if __name__ == "__main__":
    tyro.cli(main)
