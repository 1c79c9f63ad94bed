# An unexpected None fails a test as well as a check of its type does.
# pyright: reportOptionalMemberAccess=false, reportOptionalOperand=false, reportArgumentType=false

import json

import pytest

from probe.scores.missing import Absent, Headline
from probe.scores.roster import roster_of
from probe.scores.row import Entrant
from probe.scores.summary import summarise, write_scores
from probe.scores.units import ContraryRows
from probe.toolshed.version import TOOLS_VERSION
from score_rows import faulty, row

TASKS = [f"{question_type}-{i}" for question_type in ("find", "size") for i in range(8)]


def entrant(agent: str, setting: str, right: int):
    """Each type's first tasks right, the rest wrong."""
    return [row(task, int(task[-1]) < right, agent=agent, setting=setting) for task in TASKS]


ROWS = [
    *entrant("anna", "agentic", 8),
    *entrant("anna", "direct", 1),
    *entrant("bob", "direct", 2),
    *entrant("carl", "agentic", 7),
]
ROSTER = roster_of(ROWS)


def test_everything_of_a_table():
    scores = summarise("s", ROWS, ROSTER, seed=3)
    assert (scores.suite, scores.seed, scores.complete) == ("s", 3, True)
    assert [card.entrant for card in scores.cards] == [
        ("anna", "agentic"),
        ("carl", "agentic"),
        ("bob", "direct"),
        ("anna", "direct"),
    ]
    (settings,) = scores.agentic_against_direct
    assert (settings.first, settings.second) == (("anna", "agentic"), ("anna", "direct"))
    assert settings.p == settings.adjusted == pytest.approx(2 / 2**14)
    assert (len(scores.all_pairs), scores.apart) == (6, ())
    same = next(
        p for p in scores.all_pairs if (p.first, p.second) == (settings.first, settings.second)
    )
    assert same.adjusted > same.p == settings.p
    assert scores.ties == (
        (("anna", "agentic"), ("carl", "agentic")),
        (("bob", "direct"), ("anna", "direct")),
    )
    assert (scores.settings.agents, scores.settings.tasks) == (1, 16)
    assert scores.settings.p == pytest.approx(2 / 2**14)


def test_the_test_of_arms_is_drawn_from_the_seed():
    many = [f"{question_type}-{i}" for question_type in ("find", "size") for i in range(20)]
    ones = [row(task, int(task[5:]) % 3 > 0, agent="anna") for task in many]
    others = [row(task, int(task[5:]) % 5 > 1, agent="anna", setting="direct") for task in many]
    roster = roster_of(ones)
    first, again, other = (
        summarise("s", [*ones, *others], roster, it).settings.p for it in (1, 1, 2)
    )
    assert first == again != other


def test_no_arms_to_compare():
    scores = summarise("s", [r for r in ROWS if r.agent != "anna"], ROSTER)
    assert scores.agentic_against_direct == ()
    assert scores.settings is None


def test_an_agent_that_lacks_a_task_or_everything_is_incomplete_and_last():
    lacking = [r for r in ROWS if (r.agent, r.task) != ("carl", "find-0")]
    failed = [faulty(task, agent="dora") for task in TASKS]
    scores = summarise("s", [*lacking, *failed], ROSTER)
    assert not scores.complete
    assert scores.cards[-1].entrant.agent == "dora"
    assert len(scores.all_pairs) == 6  # she can't be compared
    pair = next(p for p in scores.all_pairs if p.second.agent == "carl")
    assert (pair.tasks, pair.left_out) == (15, 1)


def test_who_was_ordered_and_never_came_is_missing_altogether():
    dora = Absent(Entrant("dora", "agentic"), 3, TOOLS_VERSION)
    scores = summarise("s", ROWS, ROSTER, absent=[dora, dora])
    assert not scores.complete
    card = scores.cards[-1]
    assert card.entrant == dora.entrant
    assert card.macro.headline == Headline(None, 0.0, 1.0, rows=48, missing=48)
    assert {(gap.run, gap.reason) for gap in card.gaps} == {(n, "never run") for n in range(3)}
    assert len(card.gaps) == 48 and card.effort.episodes == 0 and card.outcomes == ()
    assert [figure.headline.missing for figure in card.question_types] == [24, 24]
    # Nobody is compared with her, and the others have what they had.
    plain = summarise("s", ROWS, ROSTER)
    assert scores.cards[:-1] == plain.cards and scores.all_pairs == plain.all_pairs
    carl = Absent(Entrant("carl", "agentic"), 1, TOOLS_VERSION)
    assert summarise("s", ROWS, ROSTER, absent=[carl]) == plain


def test_those_who_share_no_task_so_far_are_named():
    early = [r for r in entrant("anna", "agentic", 8) if r.question_type == "find"]
    late = [r for r in entrant("anna", "direct", 1) if r.question_type == "size"]
    scores = summarise("s", [*early, *late, *entrant("bob", "direct", 2)], ROSTER)
    assert scores.apart == ((("anna", "agentic"), ("anna", "direct")),)
    assert len(scores.all_pairs) == 2
    assert (scores.agentic_against_direct, scores.settings) == ((), None)


def test_a_repetition_makes_it_whole():
    failed = faulty("find-0", agent="bob", setting="direct")
    assert summarise("s", [failed, *ROWS], ROSTER) == summarise("s", ROWS, ROSTER)


def test_rows_of_another_suite_are_refused():
    with pytest.raises(ContraryRows, match="isn't of this suite"):
        summarise("s", [*ROWS, row("find-99")], ROSTER)
    with pytest.raises(ContraryRows, match="it is of suite s, not of v1"):
        summarise("v1", ROWS, ROSTER)


def test_nobody():
    scores = summarise("s", [], ROSTER)
    assert (scores.cards, scores.all_pairs, scores.settings) == ((), (), None)


def test_the_document_is_plain_json(tmp_path):
    write_scores(tmp_path / "scores.json", summarise("s", ROWS, ROSTER))
    written = json.loads((tmp_path / "scores.json").read_text())
    assert written["cards"][0]["entrant"] == ["anna", "agentic"]
    assert written["cards"][0]["macro"]["headline"]["value"] == 1
    assert written["cards"][0]["icc"] is None
    assert written["arms"]["odds_ratio"] is None or written["arms"]["odds_ratio"] > 1
