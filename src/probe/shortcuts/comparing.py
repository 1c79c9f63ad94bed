"""Numbers about options as features that say how each differs from the others."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from probe.agents.text_features import Features
from probe.tasks.task import NONE_OF_THE_ABOVE
from probe.tasks.type_rules import Form


def relative(name: str, values: Sequence[float | None]) -> tuple[Features, ...]:
    """One number of each option against those of the others; None where it has none.

    Options without it get what the others have in common, as "none of the above" might go by it.
    """
    told = [value for value in values if value is not None]
    if not told:
        return tuple({} for _ in values)
    low, high = min(told), max(told)
    found: list[Features] = []
    for value in values:
        if value is None:
            found.append({f"none {name} spread": high - low, f"none {name}": sum(told) / len(told)})
            continue
        below = sum(other < value for other in told) / len(told)
        found.append(
            {
                name: value,
                f"{name} rank": below,
                f"{name} least": float(value == low),
                f"{name} most": float(value == high),
                f"{name} off": value - sum(told) / len(told),
                f"{name} extremity": abs(value - sum(told) / len(told)),
            }
        )
    return tuple(found)


def opposed(form: Form, a: Mapping[str, float], b: Mapping[str, float]) -> tuple[Features, ...]:
    """Numbers of two options, each less the other's; by what is asked, too.

    Besides, what both have on average: it tells of neither, but may tell which way to go.
    """
    both = {f"both {name}": (a[name] + b[name]) / 2 for name in a}
    less = {name: a[name] - b[name] for name in a}
    forms = less | {f"{form} {name}": value for name, value in less.items()}
    return forms | both, {name: -value for name, value in forms.items()} | both


def joined(*parts: Sequence[Features]) -> tuple[Features, ...]:
    """Features of the same options put together."""
    count = max(len(part) for part in parts)
    return tuple({k: v for part in parts for k, v in part[place].items()} for place in range(count))


def with_context(options: Sequence[str], context: Features) -> tuple[Features, ...]:
    """Numbers of the whole task; "none of the above" may go by them alone."""
    alone = {"none": 1.0} | {f"none {name}": value for name, value in context.items()}
    return tuple({**context, **(alone if is_none(text) else {})} for text in options)


def is_none(option: str) -> bool:
    """Whether an option is "none of the above"."""
    return option == NONE_OF_THE_ABOVE


def number(option: str) -> int | None:
    """The number that an option is; None if it is none."""
    return int(option) if option.isdigit() else None


def log(value: float) -> float:
    """Natural logarithm; sizes and areas are compared by ratio."""
    return math.log(max(value, 1e-9))
