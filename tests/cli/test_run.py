"""`probe run` short of an episode: folders that it leaves as they are."""

from dataclasses import replace
from pathlib import Path

import pytest

from probe.api.agents import make_agent
from probe.assets.library import Library
from probe.cli.running import run_order
from probe.engines.local import LocalEngine
from probe.episodes.conditions import Conditions
from probe.episodes.files import append_record
from probe.episodes.folder import RECORDS, SUITE, claim_setting, start_folder
from probe.episodes.noise import NOISES
from probe.episodes.ordered import read_ordered
from probe.episodes.perceptions import PerceptionUsed
from probe.episodes.record import EpisodeRecord, TableState
from probe.episodes.turns import Question
from probe.errors import BadData, OutputFailed
from probe.runs.plan import RunOrder
from probe.runs.run import begun, check_folder
from probe.scene.scene import Scene
from probe.tasks.suite import selection
from probe.tasks.suite_file import demo_suite, write_suite

EMPTY = TableState(Scene(0, "oak", ()), (0.0,) * 6)
RECORD = EpisodeRecord("t-1", "random", 0, Question("What?", ()), EMPTY, (), None, "stopped", None)
DEMO = demo_suite()


def begin(out, order=RunOrder("random")):  # noqa: B008 - a value
    with begun(out, DEMO, order) as beginning:
        return beginning


def test_a_folder_of_another_suite_is_refused(tmp_path):
    path = tmp_path / "out" / SUITE
    write_suite(path, replace(DEMO, name="other"))
    before = path.read_bytes()
    with pytest.raises(BadData, match="another suite. Choose another folder"):
        begin(tmp_path / "out")
    assert path.read_bytes() == before


def test_agents_do_not_answer_where_people_do(tmp_path):
    start_folder(tmp_path, DEMO)
    claim_setting(tmp_path, "human")
    before = sorted(tmp_path.iterdir())
    words = "is kept for records of the setting human. Choose another folder"
    with pytest.raises(BadData, match=words):
        begin(tmp_path)
    assert sorted(tmp_path.iterdir()) == before


def test_another_part_of_the_same_suite_is_named_as_such(tmp_path):
    write_suite(tmp_path / SUITE, selection(DEMO, DEMO.tasks[:2], "demo"))
    with pytest.raises(BadData, match="another suite: 2 tasks of demo, not 6. Choose another"):
        begin(tmp_path)


def test_a_wrong_folder_is_refused_before_any_object_is_looked_at(tmp_path):
    write_suite(tmp_path / SUITE, replace(DEMO, name="other"))
    none = Library((), None, tmp_path / "cache")
    with pytest.raises(BadData, match="another suite"):
        run_order(DEMO, RunOrder("random"), make_agent, none, tmp_path, LocalEngine())


def test_a_folder_that_cannot_be_made_is_refused_in_the_same_way(tmp_path):
    none = Library((), None, tmp_path / "cache")
    with pytest.raises(OutputFailed, match="/proc/run: .* No folder can be made there"):
        run_order(DEMO, RunOrder("random"), make_agent, none, Path("/proc/run"), LocalEngine())


def test_a_folder_that_will_do_is_left_as_it_was(tmp_path):
    check_folder(tmp_path / "deep" / "out", DEMO, RunOrder("random"))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("order", "words"),
    [
        (RunOrder("random", noise=NOISES["paper"]), "another noise"),
        (RunOrder("random", conditions=Conditions(ideal="grasp")), r"other conditions \(none\)"),
        (RunOrder("random", perception=PerceptionUsed("segmenter")), "perception oracle"),
    ],
)
def test_other_settings_are_refused_before_anything_is_written(tmp_path, order, words):
    append_record(tmp_path / "out" / RECORDS, RECORD)
    with pytest.raises(BadData, match=f"{words}. Choose another folder"):
        begin(tmp_path / "out", order)
    assert [path.name for path in (tmp_path / "out").iterdir()] == [RECORDS]


def test_a_folder_says_how_many_runs_were_ordered(tmp_path):
    begin(tmp_path, RunOrder("random", runs=3))
    begin(tmp_path, RunOrder("scripted"))
    begin(tmp_path, RunOrder("random", runs=2))
    assert read_ordered(tmp_path) == {("random", ""): 3, ("scripted", ""): 1}


def test_what_is_there_is_not_run_again_but_faults_are(tmp_path):
    first, second = DEMO.tasks[:2]
    append_record(tmp_path / RECORDS, replace(RECORD, task=first.id))
    append_record(tmp_path / RECORDS, replace(RECORD, task=second.id, end="fault", fault="gone"))
    beginning = begin(tmp_path)
    assert [job.task for job in beginning.jobs] == list(DEMO.tasks[1:])
    assert (beginning.done, beginning.cut) == (1, None)


def test_half_a_record_is_set_aside_and_run_again(tmp_path):
    path = tmp_path / RECORDS
    append_record(path, replace(RECORD, task=DEMO.tasks[0].id))
    whole = path.read_bytes()
    path.write_bytes(whole + b'{"version": 2, "ta')
    beginning = begin(tmp_path)
    assert len(beginning.jobs) == len(DEMO.tasks) - 1
    assert path.read_bytes() == whole
    assert beginning.cut is not None
    assert beginning.cut.read_bytes() == b'{"version": 2, "ta\n'


def test_two_runs_do_not_share_a_folder(tmp_path):
    there = pytest.raises(BadData, match="another run is at work there")
    with begun(tmp_path, DEMO, RunOrder("random")), there:
        begin(tmp_path)
    assert len(begin(tmp_path).jobs) == len(DEMO.tasks)


def test_records_of_other_tools_are_not_added_to(tmp_path):
    append_record(tmp_path / "out" / RECORDS, replace(RECORD, tools=1))
    with pytest.raises(BadData, match="version 1 of the tools.*go on with probe-vqa 0.1"):
        begin(tmp_path / "out")
    assert [path.name for path in (tmp_path / "out").iterdir()] == [RECORDS]
