"""`probe suite certify` over records made by hand."""

import pytest

from probe.cli.suite_certify import certify
from probe.episodes.files import write_records
from probe.episodes.folder import RECORDS, claim_setting, start_folder
from probe.episodes.remarks import Remark, add_remark
from probe.errors import BadData
from probe.tasks.suite import selection
from probe.tasks.suite_file import read_suite
from run_folders import DEMO, episode

SUITE = selection(DEMO, tuple(task for task in DEMO.tasks if task.question_type != "find"), "some")
GOOD, BAD, DOUBTED, NEW = SUITE.tasks


@pytest.fixture
def folder(tmp_path):
    """Two people: one task both got right, one neither did, one that one calls ambiguous."""
    out = tmp_path / "people"
    start_folder(out, SUITE)
    claim_setting(out, "human")
    records = [
        episode(GOOD, agent="ada", fault="a dead renderer"),
        episode(GOOD, agent="ada"),
        episode(GOOD, agent="ada", run=1, right=False),
        episode(GOOD, agent="bea"),
        episode(BAD, agent="ada", right=False),
        episode(BAD, agent="bea", right=False),
        episode(DOUBTED, agent="ada"),
        episode(NEW, agent="ada", fault="a dead renderer"),
    ]
    write_records(out / RECORDS, records)
    add_remark(out, Remark(DOUBTED.id, "bea", True, "which [b]mug[/b]?"))
    add_remark(out, Remark(GOOD.id, "bea", True, "no"))
    add_remark(out, Remark(GOOD.id, "bea", False))
    return out


def test_what_people_reject_is_left_out(folder, tmp_path, capsys):
    certify((folder,), tmp_path / "new.json")
    suite = read_suite(tmp_path / "new.json")
    assert suite.name == "some-human" and suite.tasks == (GOOD, NEW)
    shown = {item.object_id for task in suite.tasks for item in task.scene.objects}
    assert set(suite.objects) == shown
    said = capsys.readouterr().out
    assert "2 of 4 tasks are in" in said and "bea: which [b]mug[/b]?" in said
    lines = {line.split("│")[1].strip(): line for line in said.splitlines() if line.count("│") > 5}
    assert "2" in lines[GOOD.id] and "kept" in lines[GOOD.id]
    assert "failed" in lines[BAD.id] and "not tried" in lines[NEW.id]
    assert [cell.strip() for cell in lines["all"].split("│")[2:4]] == ["5", "3"]


def test_a_folder_of_agents_is_refused(folder, tmp_path):
    (folder / "arm").unlink()
    with pytest.raises(BadData, match="aren't people's"):
        certify((folder,), tmp_path / "new.json")
    assert not (tmp_path / "new.json").exists()


@pytest.mark.parametrize("limits", [{"least": 1.5}, {"doubters": 0}])
def test_limits_that_mean_nothing_are_refused(folder, tmp_path, limits):
    with pytest.raises(BadData, match="--"):
        certify((folder,), tmp_path / "new.json", **limits)
