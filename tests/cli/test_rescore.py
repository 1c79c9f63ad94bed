"""`probe rescore` on records that are made by hand; nothing is drawn."""

import json
from dataclasses import replace
from importlib import import_module

import pytest

from probe.api.rows import ROWS_CSV, ROWS_JSON, SCORES
from probe.cli.rescore import _lines, _table, rescore
from probe.episodes.files import write_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.grading import question_of
from probe.episodes.ordered import note_ordered
from probe.episodes.record import EpisodeRecord, TableState
from probe.errors import BadData
from probe.scores.roster import roster_of
from probe.scores.row_files import read_csv, read_json_lines
from probe.scores.summary import summarise
from probe.tasks.grading import Score
from probe.tasks.suite_file import demo_suite, write_suite
from probe.toolshed.result import Answer
from score_rows import row

DEMO = demo_suite()


def episode(task, letter: str, **changes) -> EpisodeRecord:
    start = TableState(task.scene, (0.0,) * 6)
    record = EpisodeRecord(
        task.id, "anna", 0, question_of(task), start, (), Answer(letter), "answered"
    )
    return replace(record, **changes)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A run folder of three records; grading by letters alone stands in for drawing."""
    records = [
        episode(DEMO.tasks[0], DEMO.tasks[0].answer),
        episode(DEMO.tasks[1], "A", answer=None, end="fault", fault="RenderFailed: gone"),
        episode(DEMO.tasks[2], DEMO.tasks[2].answer, agent="scripted"),
    ]
    write_suite(tmp_path / SUITE, DEMO)
    write_records(tmp_path / RECORDS, records)

    tasks = {task.id: task for task in DEMO.tasks}

    def grade(record):
        said = record.answer.choice if record.answer else None
        right = said == tasks[record.task].answer
        words = "right" if right else "wrong" if said else "unanswered"
        return tasks[record.task], record, Score(right, right, words)

    def graded(out, track):
        return list(map(grade, records))

    monkeypatch.setattr(import_module("probe.api.reports"), "graded", graded)
    return tmp_path


def test_rows_and_scores_are_written_beside_the_records(folder, capsys):
    rescore(folder)
    rows = read_csv(folder / ROWS_CSV)
    assert read_json_lines(folder / ROWS_JSON) == rows
    assert [(row.agent, row.setting, row.correct, row.missing) for row in rows] == [
        ("anna", "agentic", True, False),
        ("anna", "agentic", False, True),
        ("scripted", "scripted", True, False),
    ]
    scores = json.loads((folder / SCORES).read_text())
    assert (scores["suite"], scores["complete"]) == ("demo", False)
    assert [card["macro"]["headline"]["value"] for card in scores["cards"]] == [None, None]
    shown = capsys.readouterr().out
    assert "incomplete" in shown
    assert "anna (agentic): n = 6 tasks; ICC of runs unknown" in shown
    assert "5 rows missing" in shown


def test_who_was_ordered_and_has_no_record_is_missing(folder, capsys):
    note_ordered(folder, "anna", "", 1)
    note_ordered(folder, "random", "", 2)
    note_ordered(folder, "model", "direct", 1)
    rescore(folder)
    told = " ".join(capsys.readouterr().out.split())
    assert "random: n = 6 tasks" in told and "12 rows missing" in told
    assert "model (direct): n = 6 tasks" in told
    scores = json.loads((folder / SCORES).read_text())
    gaps = {tuple(card["entrant"]): len(card["gaps"]) for card in scores["cards"]}
    assert gaps[("random", "random")] == 12 and gaps[("model", "direct")] == 6
    assert {row.agent for row in read_csv(folder / ROWS_CSV)} == {"anna", "scripted"}


def test_a_difference_that_cannot_be_is_not_promised():
    half = [row(f"find-{i}", i, agent="anna") for i in range(2)]
    (line,) = _lines(summarise("s", half, roster_of(half)))
    assert "detectable difference from an unrelated agent none, with so few tasks" in line


def test_an_arm_may_be_named(folder):
    rescore(folder, setting="oracle-view")
    assert {row.setting for row in read_csv(folder / ROWS_CSV)} == {"oracle-view"}


def test_a_folder_without_a_suite_is_refused(tmp_path):
    with pytest.raises(BadData, match="suite.json"):
        rescore(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_both_floors_are_shown(folder, capsys):
    rescore(folder)
    told = " ".join(capsys.readouterr().out.split())
    assert "chance ┃ naive ┃ beyond" in told
    # Find, Count and Beneath, two of each: a fifth, and a third for Count.
    assert "│ 20% │ 24% │" in told and "│ 20% │ 33% │" in told
    assert "Chance is a blind guess; naive is a guess after a look" in told


def test_a_setting_named_after_its_agent_is_told_once(folder, capsys):
    rescore(folder)
    said = capsys.readouterr().out
    assert "scripted: n = " in said and "scripted (scripted)" not in said


def test_restraint_and_what_is_necessary_stand_in_the_table_of_suites_that_state_it(capsys):
    rows = [
        row("beneath-1", True, necessary=1, manipulations=3),
        row("beneath-2", True, necessary=2, manipulations=3),
    ]
    scores = summarise("s", rows, roster_of(rows))
    (card,) = scores.cards
    _table(card).show()
    told = " ".join(capsys.readouterr().out.split())
    # Both are right; the first took two more than necessary, the second one.
    (line,) = _lines(scores)
    assert "1.5 needless manipulations an episode" in line
    assert "│ restrained │ 2 │ 2 │ 50.0%" in told
    assert "│ 1 necessary │ 1 │ 1 │ 100.0%" in told and "│ 2 necessary" in told
    bare = [row("beneath-1", True)]
    (card,) = summarise("s", bare, roster_of(bare)).cards
    _table(card).show()
    assert "necessary" not in capsys.readouterr().out
