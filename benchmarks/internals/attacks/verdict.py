"""What became of an attack, and the table of all of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal, TypeVar, get_args

from rich.console import Console
from rich.table import Table
from rich.text import Text

Verdict = Literal["refused", "harmless", "crashed", "read wrongly"]
"""Refused in one clear line; taken in stride (answered in words, or gone on with to the same
result); a traceback, a hang or a signal; taken for something that it isn't."""

VERDICTS: tuple[Verdict, ...] = get_args(Verdict)
BAD: tuple[Verdict, ...] = "crashed", "read wrongly"


@dataclass(frozen=True)
class Attack:
    """One attempt.

    Attributes:
        kind: What is attacked: a row of the table.
        name: What was tried.
        verdict: What became of it.
        detail: What was said, for people.
    """

    kind: str
    name: str
    verdict: Verdict
    detail: str = ""


Case = TypeVar("Case")


def some(cases: Sequence[Case], scale: float) -> list[Case]:
    """That share of some cases, evenly over all of them; at least one, at most each once."""
    count = min(len(cases), max(1, round(scale * len(cases))))
    return [cases[number * len(cases) // count] for number in range(count)]


def show(attacks: Iterable[Attack], console: Console) -> int:
    """Print a table by kind and every attack that got through; how many those are."""
    tried = list(attacks)
    table = Table("attacked", "tried", *VERDICTS)
    for kind in dict.fromkeys(attack.kind for attack in tried):
        counts = Counter(attack.verdict for attack in tried if attack.kind == kind)
        table.add_row(kind, str(counts.total()), *(str(counts[verdict]) for verdict in VERDICTS))
    console.print(table)
    through = [attack for attack in tried if attack.verdict in BAD]
    for attack in through:
        console.print(Text(f"{attack.kind}: {attack.name}: {attack.verdict}: {attack.detail}"))
    return len(through)
