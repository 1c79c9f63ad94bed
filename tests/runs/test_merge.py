from dataclasses import replace

import pytest

from probe.episodes.conditions import Conditions
from probe.episodes.conventions import CONVENTIONS, claim_convention, read_conventions
from probe.episodes.files import read_records, write_records
from probe.episodes.folder import RECORDS, SETTING, SUITE, setting_of_folder
from probe.episodes.grading import question_of
from probe.episodes.noise import NOISES
from probe.episodes.ordered import note_ordered, read_ordered
from probe.episodes.participation import Participation
from probe.episodes.record import EpisodeRecord, TableState
from probe.episodes.remarks import Remark, add_remark, read_remarks
from probe.errors import BadData
from probe.runs.merge import merge_folders
from probe.tasks.suite_file import demo_suite, read_suite, write_suite
from run_folders import episode, on_robot, write_run

DEMO = demo_suite()


def record(task: int, **changes) -> EpisodeRecord:
    asked = DEMO.tasks[task]
    table = TableState(asked.scene, (0.0,) * 6)
    made = EpisodeRecord(asked.id, "a", 0, question_of(asked), table, (), None, "stopped")
    return replace(made, **changes)


@pytest.fixture
def folders(tmp_path):
    """A function that makes a folder of each list of records."""

    def make(*parts, suites=(DEMO, DEMO)):
        paths = [tmp_path / str(number) for number in range(len(parts))]
        for path, records, suite in zip(paths, parts, suites, strict=True):
            write_suite(path / SUITE, suite)
            write_records(path / RECORDS, records)
        return paths

    return make


def test_records_come_in_the_order_of_tasks(folders, tmp_path):
    fault = record(0, end="fault", fault="gone")
    parts = folders([record(2), fault, record(0, run=1)], [record(3), record(1)])
    assert merge_folders(parts, tmp_path / "out") == 5
    kept = read_records(tmp_path / "out" / RECORDS)
    assert kept == [fault, record(0, run=1), record(1), record(2), record(3)]
    assert read_suite(tmp_path / "out" / SUITE) == DEMO


def test_a_fault_gives_way_to_its_repetition(folders, tmp_path):
    parts = folders([record(0, end="fault", fault="gone"), record(0)], [record(1)])
    assert merge_folders(parts, tmp_path / "out") == 2
    assert read_records(tmp_path / "out" / RECORDS) == [record(0), record(1)]


@pytest.mark.parametrize(
    ("other", "words"),
    [
        (record(0), "a, run 0 is in .*/0 too"),
        (record(1, noise=NOISES["paper"]), "run under other conditions"),
        (record(1, conditions=Conditions(lighting="hdri")), "run under other conditions"),
        (record(1, tools=1), "run with version 1 of the tools, others with [2-9]"),
    ],
)
def test_what_does_not_go_together_is_refused(folders, tmp_path, other, words):
    with pytest.raises(BadData, match=words):
        merge_folders(folders([record(0)], [other]), tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_places_that_are_counted_in_two_ways_are_refused(folders, tmp_path):
    pixels, thousandths = (Participation("agentic", points) for points in ("pixels", "0-1000"))
    parts = folders([record(0, participation=pixels)], [record(1, participation=thousandths)])
    with pytest.raises(BadData, match="run with other --points"):
        merge_folders(parts, tmp_path / "out")
    # Another agent counts as it likes.
    another = record(1, agent="b", participation=thousandths)
    parts = folders([record(0, participation=pixels)], [another])
    assert merge_folders(parts, tmp_path / "out") == 2


def test_a_robots_pictures_are_not_left_behind(tmp_path):
    tasks = [task for task in DEMO.tasks if task.question_type == "count"]
    parts = [tmp_path / name for name in ("one", "other")]
    for part, task in zip(parts, tasks, strict=True):
        write_run(part, [on_robot(episode(task), part)], DEMO, pictures=False)
    with pytest.raises(BadData, match="has pictures of a robot's table"):
        merge_folders(parts, tmp_path / "out")


def test_the_number_of_ordered_runs_is_kept(folders, tmp_path):
    parts = folders([record(0)], [record(1)])
    merge_folders(parts, tmp_path / "unknown")
    assert read_ordered(tmp_path / "unknown") == {}
    for part in parts:
        note_ordered(part, "a", "", 3)
    note_ordered(parts[1], "a", "direct", 1)
    merge_folders(parts, tmp_path / "out")
    assert read_ordered(tmp_path / "out") == {("a", ""): 3, ("a", "direct"): 1}


def test_different_numbers_of_ordered_runs_are_refused(folders, tmp_path):
    parts = folders([record(0)], [record(1)])
    note_ordered(parts[0], "a", "", 3)
    note_ordered(parts[1], "a", "", 1)
    with pytest.raises(BadData, match=r"/1: was to have 1 runs of each task by a, .* 3"):
        merge_folders(parts, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_how_places_are_written_down_is_kept(folders, tmp_path):
    parts = folders([record(0)], [record(1)])
    merge_folders(parts, tmp_path / "unknown")
    assert not (tmp_path / "unknown" / CONVENTIONS).exists()
    claim_convention(parts[0], "a", "agentic, pointer self", "yx1000")
    merge_folders(parts, tmp_path / "out")
    assert read_conventions(tmp_path / "out") == {("a", "agentic, pointer self"): "yx1000"}
    claim_convention(parts[1], "a", "agentic, pointer self", "pixels")
    with pytest.raises(BadData, match=r"/1: was run with pointing=pixels for a, .* yx1000"):
        merge_folders(parts, tmp_path / "other")
    assert not (tmp_path / "other").exists()


def test_people_stay_people_and_what_they_said_comes_along(folders, tmp_path):
    parts = folders([record(0)], [record(1, agent="b")])
    said = [Remark(DEMO.tasks[n].id, "a", ambiguous=True, note=f"note {n}") for n in range(2)]
    for part, remark in zip(parts, said, strict=True):
        (part / SETTING).write_text("human\n")
        add_remark(part, remark)
    assert merge_folders(parts, tmp_path / "out") == 2
    assert setting_of_folder(tmp_path / "out") == "human"
    assert read_remarks(tmp_path / "out") == said


def test_people_and_agents_are_not_mixed(folders, tmp_path):
    parts = folders([record(0)], [record(1)])
    (parts[1] / SETTING).write_text("human\n")
    with pytest.raises(BadData, match="1: is of the setting human, .*0 of agents"):
        merge_folders(parts, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_other_suites_are_refused(folders, tmp_path):
    parts = folders([record(0)], [record(1)], suites=(DEMO, replace(DEMO, name="other")))
    with pytest.raises(BadData, match="is another suite"):
        merge_folders(parts, tmp_path / "out")


def test_only_a_new_folder_will_do(folders):
    parts = folders([record(0)], [record(1)])
    with pytest.raises(BadData, match="holds a run"):
        merge_folders(parts, parts[0])


def test_runs_of_the_first_tools_are_merged_as_ever(folders, tmp_path):
    parts = folders([record(0, tools=1)], [record(1, tools=1)])
    assert merge_folders(parts, tmp_path / "out") == 2
    assert [it.tools for it in read_records(tmp_path / "out" / RECORDS)] == [1, 1]
