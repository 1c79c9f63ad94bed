import pytest

from probe.report.steps_figure import HEIGHT, WIDTH, curves, height
from probe.scores.roster import roster_of
from probe.scores.scorecard import scorecard
from score_rows import faulty, row


def test_points_lie_where_their_counts_and_shares_are():
    rows = [
        row("find-1", necessary=0),
        row("find-2", correct=False, necessary=1),
        row("count-1", necessary=1),
        row("count-2", necessary=4),
    ]
    (curve,) = curves([scorecard(rows, roster_of(rows), seed=0)])
    assert [(it.necessary, it.tasks, it.share) for it in curve.points] == [
        (0, 1, 1.0),
        (1, 2, 0.5),
        (4, 1, 1.0),
    ]
    assert [it.x for it in curve.points] == [0, pytest.approx(WIDTH / 4), WIDTH]
    assert [it.y for it in curve.points] == [0, HEIGHT / 2, 0]
    assert curve.line == f"0.0,0.0 {WIDTH / 4},{HEIGHT / 2} {WIDTH},0.0"


def test_intervals_enclose_their_points_and_are_wider_with_fewer_tasks():
    few = [row(f"find-{n}", n % 2 == 0, necessary=1) for n in range(4)]
    many = [row(f"find-{n}", n % 2 == 0, necessary=1) for n in range(40)]
    spans = []
    for rows in (few, many):
        ((point,),) = (it.points for it in curves([scorecard(rows, roster_of(rows), seed=0)]))
        assert 0 <= point.top < point.y < point.bottom <= HEIGHT
        spans.append(point.bottom - point.top)
    assert spans[0] > spans[1]


def test_steps_with_missing_episodes_are_left_out():
    rows = [row("find-1", necessary=0), faulty("find-2", necessary=1)]
    (curve,) = curves([scorecard(rows, roster_of(rows), seed=0)])
    assert [it.necessary for it in curve.points] == [0]


def test_no_curve_where_tasks_do_not_state_what_is_necessary():
    rows = [row("find-1"), row("find-2")]
    assert curves([scorecard(rows, roster_of(rows), seed=0)]) == []


def test_heights_count_from_the_top():
    assert (height(1), height(0.5), height(0)) == (0, HEIGHT / 2, HEIGHT)
