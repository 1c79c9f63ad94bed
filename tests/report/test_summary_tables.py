from probe.report.summary_tables import effort_table, missing_table, type_table, unknown_measures
from probe.scores.roster import roster_of
from probe.scores.scorecard import Scorecard, scorecard
from score_rows import faulty, row


def card(*rows, roster=None) -> Scorecard:
    return scorecard(list(rows), roster or roster_of(rows), seed=0)


def test_types_come_before_their_parts_with_their_sizes():
    rows = [
        row("find-0", stratum="hidden"),
        row("find-1", stratum="partly"),
        row("size-0", options=2),
    ]
    table = type_table([card(*rows)])
    assert table.columns == (
        ("find", 2),
        ("size", 1),
        ("find, letter alone", 2),
        ("find, hidden", 1),
        ("find, partly", 1),
    )
    ((_, figures),) = table.rows
    assert [figure.name for figure in figures] == [name for name, _ in table.columns]


def test_measures_that_nobody_records_are_named_instead():
    cards = [card(row("size-0", cost=0.5)), card(row("size-0", agent="bert"))]
    tables = {table.name: table for table in effort_table(cards)}
    assert [spread and spread.mean for _, spread in tables["cost, US dollars"].rows] == [0.5, None]
    assert [spread and spread.mean for _, spread in tables["turns"].rows] == [4, 4]
    assert unknown_measures(cards) == [
        "seconds, agent",
        "seconds, tools",
        "tokens in",
        "tokens out",
    ]


def test_what_is_missing_is_parted_by_reason():
    rows = [row("size-0"), faulty("size-1")]
    everything = roster_of([*rows, row("size-2"), row("count-0")])
    (missing,) = missing_table([card(*rows, roster=everything), card(row("size-3", agent="bert"))])
    assert (missing.entrant.agent, missing.rows) == ("anna", 4)
    assert [gap.task for gap in missing.failed] == ["size-1"]
    assert [gap.task for gap in missing.never] == ["size-2", "count-0"]
    assert missing.question_types == (("count", 1), ("size", 2))
