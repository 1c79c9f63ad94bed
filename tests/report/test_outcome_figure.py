import pytest

from probe.report.outcome_figure import CLASSES, WIDTH, panels
from probe.scores.breakdown import Outcomes
from probe.scores.missing import Absent
from probe.scores.roster import roster_of
from probe.scores.row import Entrant
from probe.scores.scorecard import absent_card, scorecard
from probe.toolshed.version import TOOLS_VERSION
from score_rows import faulty, row


def test_bars_are_shares_of_a_types_episodes():
    rows = [
        row("size-0"),
        row("size-1"),
        row("size-2", False, manipulated=False, manipulations=0),
        faulty("size-3"),
        row("count-0", False),
    ]
    (panel,) = panels([scorecard(rows, roster_of(rows), seed=0)])
    count, size = panel.bars
    assert (size.question_type, size.episodes) == ("size", 4)
    assert [(s.name, s.count, s.x, s.width) for s in size.segments] == [
        ("used_right", 2, 0, pytest.approx(WIDTH / 2)),
        ("unused_wrong", 1, pytest.approx(WIDTH / 2), pytest.approx(WIDTH / 4)),
        ("missing", 1, pytest.approx(WIDTH * 3 / 4), pytest.approx(WIDTH / 4)),
    ]
    assert [s.words for s in count.segments] == ["manipulated, wrong"]


def test_who_has_no_episode_has_no_bars():
    absent = Absent(Entrant("dora", "agentic"), 1, TOOLS_VERSION)
    assert panels([absent_card(absent, roster_of([row("size-0")]), seed=0)]) == []


def test_every_class_of_episodes_has_its_colour():
    fields = set(Outcomes.__dataclass_fields__) - {"question_type"}
    assert {name for name, _ in CLASSES} == fields
