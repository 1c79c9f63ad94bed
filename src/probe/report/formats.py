"""Numbers in words: how a report prints them."""

from __future__ import annotations

from probe.report.episodes import name_of
from probe.scores.intervals import Interval
from probe.scores.row import Entrant
from probe.scores.scorecard import Figure
from probe.texts import plural

UNKNOWN = "\N{EN DASH}"
_THIN = "\N{NARROW NO-BREAK SPACE}"
_MINUS = "\N{MINUS SIGN}"


def percent(share: float | None, digits: int = 1) -> str:
    """A share of 0.5 as "50.0 %"."""
    return UNKNOWN if share is None else f"{_signed(100 * share, digits)}{_THIN}%"


def points(share: float | None) -> str:
    """A difference of shares of 0.05 as "+5.0"."""
    return UNKNOWN if share is None else _signed(100 * share, 1, plus=True)


def between(interval: Interval | None) -> str:
    """An interval of shares as "41 to 63 %"."""
    if interval is None:
        return UNKNOWN
    return f"{_signed(100 * interval.low, 0)} to {_signed(100 * interval.high, 0)}{_THIN}%"


def surest(figure: Figure) -> Interval | None:
    """The interval to show: Wilson's of a type whose tasks were run once, which holds for few."""
    return figure.wilson or figure.student


def between_points(interval: Interval) -> str:
    """An interval of differences as "-3 to +12"."""
    ends = (_signed(100 * end, 0, plus=True) for end in (interval.low, interval.high))
    return " to ".join(ends)


def chance(p: float) -> str:
    """A p value; very small ones are only bounded."""
    return "< 0.001" if p < 0.001 else f"{p:.3f}"


def number(value: float | None, beside: float | None = None) -> str:
    """A number, rounded as one of this size needs; thousands are grouped.

    Args:
        value: The number.
        beside: Another one, whose size is what counts: numbers of a row are rounded alike.
    """
    if value is None:
        return UNKNOWN
    size = abs(value if beside is None else beside)
    digits = 0 if size >= 100 else 1 if size >= 1 else 2
    return f"{value:,.{digits}f}".replace("-", _MINUS)


def measure(value: float) -> str:
    """A measure of a certificate to three significant digits, whatever its size."""
    return f"{value:.3g}".replace("-", _MINUS)


def resemblance(icc: float | None) -> str:
    """An intraclass correlation."""
    return "unknown" if icc is None else _signed(icc, 2)


def gap(detectable: float | None) -> str:
    """A detectable difference; over 100 points there is none."""
    if detectable is None:
        return "unknown"
    return "none, with so few tasks" if detectable > 1 else f"{100 * detectable:.0f} points"


def entrant(who: Entrant) -> str:
    """An entrant in one line."""
    return name_of(who)


def _signed(value: float, digits: int, *, plus: bool = False) -> str:
    text = f"{value:{'+' if plus else ''}.{digits}f}"
    if float(text) == 0:
        text = text.lstrip("+-")
    return text.replace("-", _MINUS)


FILTERS = {
    "surest": surest,
    "percent": percent,
    "points": points,
    "between": between,
    "between_points": between_points,
    "chance": chance,
    "number": number,
    "resemblance": resemblance,
    "gap": gap,
    "measure": measure,
    "entrant": entrant,
    "plural": plural,
}
