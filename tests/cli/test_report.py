"""`probe report` on folders made by hand, whose pictures are there: nothing is drawn."""

import json
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from pages import Page
from probe.api.gathering import NoRuns, OtherSuite, gather, one_suite, short_names
from probe.assets.library import open_library
from probe.cli.held_out import held_out
from probe.cli.ladder import ladder as up_the_ladder
from probe.cli.report import report, write_run_report
from probe.cli.rescore import rescore
from probe.episodes.folder import RECORDS
from probe.episodes.grading import NoPoses
from probe.episodes.noise import NOISES
from probe.episodes.ordered import note_ordered
from probe.errors import BadData
from probe.report.page import LARGEST_SINGLE, PICTURES, TooManyEpisodes
from probe.report.scene_renderer import SceneRenderer
from probe.tasks.suite_file import write_suite
from run_folders import DEMO, episode, on_robot, write_pictures, write_run

TABLES = ("rows.csv", "rows.jsonl", "scores.json")
PLAIN = [task for task in DEMO.tasks if task.question_type != "find"]
"""Tasks that are graded without a look at the table."""


def data_of(page: Page, id: str = "index-data"):
    (script,) = page.all("script", id=id)
    return json.loads(script.text)


def test_a_run_becomes_a_folder_that_holds_all_it_needs(tmp_path):
    out = write_run(tmp_path / "run", [episode(task, right=True) for task in PLAIN])
    before = {path: path.stat().st_mtime_ns for path in (out / "pictures").iterdir()}
    page = Page(write_run_report([out]).read_text())
    assert {path: path.stat().st_mtime_ns for path in (out / "pictures").iterdir()} == before
    index = data_of(page)
    assert [each["verdict"] for each in index["episodes"]] == ["right"] * 4
    assert len(list((out / "episodes").glob("*.js"))) == 4
    for each in index["episodes"]:
        text = (out / "episodes" / f"{each['key']}.js").read_text()
        assert text.startswith(f'probeEpisode("{each["key"]}", ')
        detail = json.loads(text.removesuffix(");\n").split(", ", 1)[1])
        for address in [detail["start"], *(step["picture"] for step in detail["steps"])]:
            assert (out / address).is_file()
    assert all((out / task["picture"]).is_file() for task in index["tasks"])


def test_tables_beside_the_page_are_those_of_rescore(tmp_path):
    records = [episode(task, right=n % 2 == 0) for n, task in enumerate(PLAIN)]
    one, other = (write_run(tmp_path / name, records) for name in ("one", "other"))
    write_run_report([one])
    rescore(other)
    for name in TABLES:
        assert (one / name).read_bytes() == (other / name).read_bytes()


def test_what_was_never_run_and_what_failed_is_named(tmp_path):
    records = [episode(PLAIN[0]), episode(PLAIN[1], fault="RenderFailed: gone")]
    page = Page(write_run_report([write_run(tmp_path / "run", records)]).read_text())
    missing = page.section("missing")
    assert "anna (agentic) : 5 of 6 rows" in missing
    assert "RenderFailed: gone" in missing
    for task in DEMO.tasks[2:]:
        assert f"{task.id} run 0" in missing
    assert "incomplete" in page.section("scores")
    # One of six tasks right, in one of three types; five could be either.
    assert "worst 16.7 %, best 100.0 %" in page.section("scores")
    # A task that nobody was given has no card, but its line under "Missing".
    assert [each["verdict"] for each in data_of(page)["episodes"]] == ["right", "missing"]


def test_a_run_that_was_cut_off_between_runs_has_no_headline(tmp_path):
    less = replace(DEMO, tasks=PLAIN)
    out = write_run(tmp_path / "run", [episode(task) for task in PLAIN], less)
    note_ordered(out, "anna", "", 2)
    page = Page(write_run_report([out]).read_text())
    (card,) = json.loads((out / "scores.json").read_text())["cards"]
    top = card["macro"]["headline"]
    assert (top["value"], top["rows"], top["missing"]) == (None, 2 * len(PLAIN), len(PLAIN))
    assert f"4 never run {PLAIN[0].id} run 1, {PLAIN[1].id} run 1" in page.section("missing")


def test_an_agent_that_was_ordered_and_has_no_record_is_missing(tmp_path):
    less = replace(DEMO, tasks=PLAIN)
    out = write_run(tmp_path / "run", [episode(task) for task in PLAIN], less)
    note_ordered(out, "anna", "", 1)
    note_ordered(out, "always-A", "", 2)
    page = Page(write_run_report([out]).read_text())
    missing = page.section("missing")
    assert "always-A (blind) : 8 of 8 rows" in missing and "anna" not in missing
    assert "incomplete" in page.section("scores") and "always-A" not in page.section("outcomes")
    scores = json.loads((out / "scores.json").read_text())
    assert not scores["complete"]
    assert [card["entrant"] for card in scores["cards"]] == [
        ["anna", "agentic"],
        ["always-A", "blind"],
    ]
    # Tables of rows hold what was played.
    assert len((out / "rows.jsonl").read_text().splitlines()) == len(PLAIN)


def test_an_agent_that_is_missing_in_one_folder_is_told_from_the_other_folders(tmp_path):
    less = replace(DEMO, tasks=PLAIN)
    one = write_run(tmp_path / "one", [episode(task) for task in PLAIN], less)
    other = write_run(tmp_path / "other", [episode(t, agent="bert") for t in PLAIN], less)
    note_ordered(other, "anna", "", 1)
    write_run_report([one, other], tmp_path / "both")
    scores = json.loads((tmp_path / "both" / "scores.json").read_text())
    cards = {card["entrant"][0]: len(card["gaps"]) for card in scores["cards"]}
    assert cards == {"anna [one]": 0, "bert": 0, "anna [other]": 4}


def test_a_failure_that_was_run_again_is_shown_and_does_not_count(tmp_path):
    first, again = episode(PLAIN[0], fault="RenderFailed: gone"), episode(PLAIN[0])
    page = Page(write_run_report([write_run(tmp_path / "run", [first, again])]).read_text())
    shown = [(each["verdict"], each["counts"]) for each in data_of(page)["episodes"]]
    assert shown == [("missing", False), ("right", True)]
    assert len({each["key"] for each in data_of(page)["episodes"]}) == 2
    assert "run again" in page.section("missing")


def test_runs_of_one_suite_are_compared(tmp_path):
    one = write_run(tmp_path / "one", [episode(task) for task in PLAIN])
    other = write_run(tmp_path / "other", [episode(t, right=False, agent="bert") for t in PLAIN])
    out = tmp_path / "both"
    page = Page(write_run_report([one, other], out).read_text())
    assert data_of(page)["entrants"] == ["anna (agentic)", "bert (agentic)"]
    assert "+100.0" in page.section("differences")
    # Pictures are taken over from the runs; nothing could be drawn here.
    assert {path.name for path in (out / "pictures").iterdir()} == {
        path.name for run in (one, other) for path in (run / "pictures").iterdir()
    }


def test_another_renderers_pictures_stand_beside_the_others(tmp_path):
    records = [episode(task) for task in PLAIN]
    out = write_run(tmp_path / "run", records)
    before = set((out / PICTURES).iterdir())
    write_pictures(out, records, DEMO, "blender")
    report((out,), renderer="blender")
    page = (out / "index.html").read_text()
    shown = {out / task["picture"] for task in data_of(Page(page))["tasks"]}
    assert shown.isdisjoint(before) and all(path.is_file() for path in shown)
    assert "Blender drew the pictures" in page
    report((out,))
    assert "Blender drew the pictures" not in (out / "index.html").read_text()


def test_an_agent_of_two_folders_is_told_apart_by_their_names(tmp_path):
    folders = [write_run(tmp_path / n, [episode(t) for t in PLAIN]) for n in ("v1", "v2")]
    page = Page(write_run_report(folders, tmp_path / "both").read_text())
    assert data_of(page)["entrants"] == ["anna [v1] (agentic)", "anna [v2] (agentic)"]
    assert len(data_of(page)["episodes"]) == 8


def test_folders_are_called_by_as_much_of_their_path_as_it_takes(tmp_path):
    assert short_names([tmp_path / "x" / "run", tmp_path / "y" / "run"]) == ["x/run", "y/run"]
    assert short_names([tmp_path / "x", tmp_path / "y"]) == ["x", "y"]


def test_other_suites_are_refused(tmp_path):
    less = replace(DEMO, tasks=DEMO.tasks[:4])
    one = write_run(tmp_path / "one", [episode(PLAIN[0])])
    other = write_run(tmp_path / "other", [episode(PLAIN[0])], less)
    with pytest.raises(OtherSuite, match="2 tasks of demo are in only one of them. If both are"):
        write_run_report([one, other], tmp_path / "both")
    assert not (tmp_path / "both").exists()
    named = write_run(tmp_path / "named", [], replace(DEMO, name="v1"))
    with pytest.raises(OtherSuite, match="one is called demo, the other v1"):
        one_suite([one, named])
    task = replace(DEMO.tasks[0], question="What else?")
    changed = write_run(tmp_path / "changed", [], replace(DEMO, tasks=(task, *DEMO.tasks[1:])))
    with pytest.raises(OtherSuite, match=f"{task.id} differ"):
        one_suite([one, changed])


def test_no_folder_and_no_record_and_the_same_folder_twice_are_refused(tmp_path):
    with pytest.raises(NoRuns, match="No folder"):
        one_suite([])
    run = write_run(tmp_path / "run", [])
    with pytest.raises(NoRuns, match="named twice"):
        one_suite([run, tmp_path / "run" / ".." / "run"])
    with pytest.raises(NoRuns, match="no record in"):
        write_run_report([run])
    (run / RECORDS).unlink()
    with pytest.raises(BadData, match=RECORDS):
        write_run_report([run])


def test_a_single_file_needs_no_other(tmp_path):
    out = write_run(tmp_path / "run", [episode(task) for task in PLAIN])
    path = write_run_report([out], single=True)
    page = Page(path.read_text())
    assert path.name == "report.html"
    assert not (out / "episodes").exists()
    details = data_of(page, "detail-data")
    assert set(details) == {each["key"] for each in data_of(page)["episodes"]}
    pictures = [detail["start"] for detail in details.values()]
    assert all(picture.startswith("data:image/webp;base64,") for picture in pictures)
    outside = [it for it in page.addresses() if not it.startswith(("data:", "#", *TABLES))]
    assert outside == []


def test_a_single_file_of_many_episodes_is_refused_before_anything_is_drawn(tmp_path):
    many = [episode(PLAIN[0], run=run) for run in range(LARGEST_SINGLE + 1)]
    out = write_run(tmp_path / "run", many, pictures=False)
    with pytest.raises(TooManyEpisodes, match="at most 20 episodes, and these are 21"):
        write_run_report([out], single=True)
    assert sorted(path.name for path in out.iterdir()) == ["records.jsonl", "suite.json"]


def test_the_log_of_the_building_becomes_a_table(tmp_path):
    log = tmp_path / "log.txt"
    log.write_text("count\t0\tcover\t-\tnothing\t2.0\ncount\t1\tkept\tTrue\t\t18.0\n")
    out = write_run(tmp_path / "run", [episode(PLAIN[0])])
    page = Page(write_run_report([out], build_log=log).read_text())
    assert "count 2 1 50 % 20 1 of 1 cover 1" in page.section("suite")


def test_names_with_brackets_are_printed_as_they_are(tmp_path, capsys):
    write_run_report([write_run(tmp_path / "run", [episode(PLAIN[0], agent="[/b] anna [x]")])])
    assert "[/b] anna [x] (agentic): incomplete" in capsys.readouterr().out


@pytest.mark.slow
def test_a_report_that_was_stopped_draws_what_is_lacking_and_nothing_else(tmp_path, cache):
    run = write_run(tmp_path / "run", [episode(PLAIN[0]), episode(PLAIN[1])])
    lacking, *others = sorted((run / PICTURES).iterdir())
    before = {path: path.read_bytes() for path in others}
    plain = lacking.read_bytes()
    lacking.unlink()
    with SceneRenderer(DEMO, lambda: open_library("procedural", None, cache)) as room:
        played = gather([run], DEMO, room, run).played
    assert {path: path.read_bytes() for path in others} == before
    assert lacking.read_bytes() != plain
    assert all((run / name).is_file() for each in played for name in each.pictures)


def test_a_suite_that_was_replaced_is_noticed(tmp_path):
    out = write_run(tmp_path / "run", [episode(PLAIN[0])])
    write_suite(out / "suite.json", replace(DEMO, tasks=DEMO.tasks[1:]))
    with pytest.raises(BadData, match="is not in suite.json"):
        write_run_report([out])


def test_results_of_other_tools_stand_beside_in_words(tmp_path, capsys):
    late = [episode(task) for task in PLAIN]
    early = [replace(it, tools=1) for it in late]
    folders = [write_run(tmp_path / "early", early), write_run(tmp_path / "late", late)]
    page = Page(write_run_report(folders, tmp_path / "both").read_text())
    words = "different versions of the tools (1 and"
    for section in ("scores", "differences"):
        assert words in page.section(section)
    assert "tools 1" in page.section("scores")
    assert words in " ".join(capsys.readouterr().out.split())
    alone = Page(write_run_report(folders[:1]).read_text())
    assert "versions of the tools" not in alone.section("scores")


def test_hands_that_err_by_different_amounts_stand_beside_in_words(tmp_path, capsys):
    ideal = [episode(task) for task in PLAIN]
    erring = [replace(episode(task, agent="bert"), noise=NOISES["paper"]) for task in PLAIN]
    runs = [write_run(tmp_path / name, of) for name, of in (("one", ideal), ("other", erring))]
    page = Page(write_run_report(runs, tmp_path / "both").read_text())
    words = "errs by different amounts (ideal hand; hand off by 18 mm, pushing by 0 mm)."
    assert words in page.section("scores") and words in capsys.readouterr().out
    held_out(tuple(runs), out=tmp_path / "table.md")
    assert words in (tmp_path / "table.md").read_text()
    page = Page(write_run_report([runs[0]]).read_text())
    assert "errs by" not in page.section("scores")


def test_who_never_looks_stands_once_among_the_held_out_and_not_on_the_ladder(tmp_path):
    """Built-in agents' records don't tell that they never look, and one of them is a floor."""
    letters = [episode(task, agent=name) for task in PLAIN for name in ("question-only", "anna")]
    run = write_run(tmp_path / "run", letters, replace(DEMO, tasks=tuple(PLAIN)))
    held_out((run,), out=tmp_path / "table.md")
    lines = (tmp_path / "table.md").read_text().splitlines()
    assert len([line for line in lines if line.startswith("| question-only")]) == 1
    up_the_ladder((run,), out=tmp_path / "ladder.md")
    steps = (tmp_path / "ladder.md").read_text()
    assert "anna" in steps and "question-only" not in steps


def test_a_robots_records_are_scored_and_shown_by_its_own_pictures(tmp_path):
    """Nothing is drawn: there are no poses to draw from."""
    out = tmp_path / "run"
    records = [on_robot(episode(task, run=run), out) for task in PLAIN for run in range(2)]
    write_run(out, records, replace(DEMO, tasks=tuple(PLAIN)), pictures=False)
    rescore(out)
    page = Page(write_run_report([out]).read_text())
    index = data_of(page)
    assert [each["verdict"] for each in index["episodes"]] == ["right"] * 8
    greys = []
    text = (out / "episodes" / f"{index['episodes'][0]['key']}.js").read_text()
    detail = json.loads(text.removesuffix(");\n").split(", ", 1)[1])
    for address in [detail["start"], *(step["picture"] for step in detail["steps"])]:
        with Image.open(out / address) as picture:
            greys.append(np.asarray(picture)[512, 512, 0])
    assert greys == pytest.approx([0, 40, 80, 120, 160], abs=2)


def test_a_point_on_a_robots_table_cant_be_graded(tmp_path):
    (find,) = [task for task in DEMO.tasks if task.question_type == "find" and task.answer == "D"]
    record = on_robot(episode(find), tmp_path)
    write_run(tmp_path, [record], pictures=False)
    with pytest.raises(NoPoses, match="pictures instead of poses"):
        rescore(tmp_path)


def test_a_page_is_shown_in_a_browser_if_one_is_here(tmp_path, monkeypatch, capsys):
    out = write_run(tmp_path / "run", [episode(task, right=True) for task in PLAIN])
    shown = []
    for here in (True, False):
        monkeypatch.setattr("webbrowser.open", lambda url, here=here: shown.append(url) or here)
        report((out,), open=True)
        assert shown.pop() == (out / "index.html").resolve().as_uri()
        assert ("in a browser" in capsys.readouterr().out) is not here
    report((out,))
    assert shown == [] and "Open " in capsys.readouterr().out
