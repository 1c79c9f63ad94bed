import pytest

from probe.report.formats import (
    between,
    between_points,
    chance,
    gap,
    measure,
    number,
    percent,
    plural,
    points,
    resemblance,
)
from probe.scores.intervals import Interval


@pytest.mark.parametrize(
    ("shown", "wanted"),
    [
        (percent(0.5), "50.0 %"),
        (percent(None), "–"),
        (percent(-0.0416), "−4.2 %"),
        (percent(-0.0001), "0.0 %"),
        (percent(2 / 3, 0), "67 %"),
        (points(0.05), "+5.0"),
        (points(-0.05), "−5.0"),
        (points(0.0), "0.0"),
        (between(Interval(0.411, 0.629)), "41 to 63 %"),
        (between(None), "–"),
        (between_points(Interval(-0.03, 0.12)), "−3 to +12"),
        (chance(0.0004), "< 0.001"),
        (chance(0.03125), "0.031"),
        (number(None), "–"),
        (number(12345.6), "12,346"),
        (number(12.34), "12.3"),
        (number(1.234), "1.2"),
        (number(0.0512), "0.05"),
        (number(0, beside=120), "0"),
        (number(3, beside=2.5), "3.0"),
        (measure(4.1635e-05), "4.16e−05"),
        (measure(1.0), "1"),
        (resemblance(-0.286), "−0.29"),
        (resemblance(None), "unknown"),
        (gap(None), "unknown"),
        (gap(0.094), "9 points"),
        (gap(1.2), "none, with so few tasks"),
        (plural(1, "task"), "1 task"),
        (plural(1500, "task"), "1,500 tasks"),
    ],
)
def test_numbers_read_as_people_write_them(shown, wanted):
    assert shown.replace("\N{NARROW NO-BREAK SPACE}", " ") == wanted
