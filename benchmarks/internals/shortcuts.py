"""How often the no-shortcut test cries wolf on imaginary tasks, and which leaks it finds.

Measures internals, not the public API.
"""

from __future__ import annotations

import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import tyro

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))

from imaginary_tasks import (  # noqa: E402
    LORE,
    ImaginaryTask,
    Leak,
    Make,
    compare,
    count,
    examples,
    find,
    size,
)
from probe.shortcuts.findings import LEVEL, Finding  # noqa: E402
from probe.shortcuts.investigation import investigate  # noqa: E402
from probe.shortcuts.table import leaks  # noqa: E402

_MAKERS: dict[str, Make] = {"find": find, "count": count, "size": size, "compare": compare}


@dataclass(frozen=True)
class Args:
    """What to try.

    Attributes:
        tasks: Of each type.
        sims: Imaginary sets of tasks.
    """

    tasks: int = 300
    sims: int = 1


def main(args: Args) -> None:
    """Print both."""
    _false_alarms(args)
    for share in (0.1, 0.2, 0.3):
        _found(args, "smallest is right, of five options", find, _smallest(share), share)
        _found(args, "larger area is right, of two", size, _larger(share), share)


def _false_alarms(args: Args) -> None:
    """Tests of sets without any leak: each type alone, and by kind of finder."""
    alarms, low, tests = 0, Counter[str](), Counter[str]()
    for seed in range(args.sims):
        for make in _MAKERS.values():
            found = investigate(examples(make, args.tasks, seed=1000 + seed), LORE)
            alarms += bool(leaks(found))
            for finding in found:
                tests[_finder(finding)] += 1
                low[_finder(finding)] += finding.p < LEVEL
    sets = args.sims * len(_MAKERS)
    print(f"sets of {args.tasks} tasks without a leak: {alarms} of {sets} were called leaky")
    for finder, n in sorted(tests.items()):
        print(
            f"  {finder}: p under {LEVEL:.0%} in {low[finder]} of {n} tests ({low[finder] / n:.1%})"
        )


def _found(args: Args, words: str, make: Make, leak: Leak, share: float) -> None:
    """How often a leak in a share of the tasks is found."""
    hits = 0
    for seed in range(args.sims):
        hits += bool(leaks(investigate(examples(make, args.tasks, leak, 2000 + seed), LORE)))
    print(f"{words}, made so in {share:.0%} of the tasks: found in {hits} of {args.sims} sets")


def _finder(finding: Finding) -> str:
    return finding.hits.by.split(" on ")[0] if " on " in finding.hits.by else "rules"


def _smallest(share: float) -> Leak:
    def leak(draw: ImaginaryTask) -> None:
        if draw.rng.random() < share and draw.right < len(draw.options) - 1:
            named = draw.options[:-1]
            draw.right = named.index(min(named, key=lambda n: max(LORE.by_name[n].size)))

    return leak


def _larger(share: float) -> Leak:
    def leak(draw: ImaginaryTask) -> None:
        a, b = (draw.things[place].area_px for place in draw.marked)
        if draw.rng.random() < share:
            draw.right = int((a > b) == (draw.form == "smaller"))

    return leak


if __name__ == "__main__":
    main(tyro.cli(Args))
