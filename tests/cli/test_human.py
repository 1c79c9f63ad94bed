"""`probe human` short of its page: how it takes up a folder, and what draws its tables."""

from __future__ import annotations

from dataclasses import replace
from importlib.util import find_spec

import numpy as np
import pytest

from probe.assets.library import open_library
from probe.cli.human import SETTING, HumanResources, taken_up
from probe.episodes.conditions import Conditions
from probe.episodes.files import append_record, read_records
from probe.episodes.folder import RECORDS, claim_setting, setting_of_folder
from probe.episodes.noise import NO_NOISE, NOISES
from probe.episodes.perceptions import PerceptionUsed
from probe.episodes.remarks import REMARKS, Remark, add_remark, read_remarks
from probe.errors import BadData
from probe.interfaces.human.session_store import UNFINISHED
from probe.runs.plan import RunOrder
from probe.scene.setup import RendererName
from run_folders import DEMO, episode

RENDERERS: tuple[RendererName, ...] = ("filament", "blender")
PEOPLE = RunOrder("")
RECORD = replace(episode(DEMO.tasks[0], agent="Ada"), noise=NO_NOISE)
REMARK = Remark(DEMO.tasks[0].id, "Ada", ambiguous=True)
HALF = b'{"task": "cou'


@pytest.fixture
def killed(tmp_path):
    """A folder whose server was killed while it wrote a record and a remark."""
    with taken_up(tmp_path, DEMO, PEOPLE):
        append_record(tmp_path / RECORDS, RECORD)
        add_remark(tmp_path, REMARK)
    for name in (RECORDS, REMARKS):
        with (tmp_path / name).open("ab") as file:
            file.write(HALF)
    return tmp_path


def test_what_was_cut_off_is_set_aside(killed, capsys):
    with taken_up(killed, DEMO, PEOPLE):
        assert read_records(killed / RECORDS) == [RECORD]
        assert read_remarks(killed) == [REMARK]
    assert setting_of_folder(killed) == "human"
    said = capsys.readouterr().out
    for name in (RECORDS, REMARKS):
        assert (killed / f"{name}.cut").read_bytes() == HALF + b"\n"
        assert f"moved to {killed / name}.cut" in said


def test_another_server_at_work_is_left_alone(killed):
    with taken_up(killed, DEMO, PEOPLE):
        with (killed / RECORDS).open("ab") as file:
            file.write(HALF)
        with (
            pytest.raises(BadData, match="another run is at work"),
            taken_up(killed, DEMO, PEOPLE),
        ):
            pass
        assert (killed / RECORDS).read_bytes().endswith(HALF)


def test_a_folder_has_one_suite_one_way_to_play_and_people_alone(tmp_path):
    with taken_up(tmp_path, DEMO, PEOPLE):
        append_record(tmp_path / RECORDS, RECORD)
    for suite, order, words in (
        (replace(DEMO, name="other"), PEOPLE, "another suite"),
        (DEMO, replace(PEOPLE, noise=NOISES["paper"]), "another noise"),
        (DEMO, replace(PEOPLE, perception=PerceptionUsed("segmenter")), "with perception oracle"),
        (DEMO, replace(PEOPLE, conditions=Conditions(renderer="blender")), "other conditions"),
    ):
        with pytest.raises(BadData, match=words), taken_up(tmp_path, suite, order):
            pass
    append_record(tmp_path / "agents" / RECORDS, RECORD)
    with (
        pytest.raises(BadData, match="others have records"),
        taken_up(tmp_path / "agents", DEMO, PEOPLE),
    ):
        pass


def test_people_do_not_go_on_with_other_tools(tmp_path):
    other = replace(RECORD, tools=1)
    claim_setting(tmp_path / "done", SETTING)
    append_record(tmp_path / "done" / RECORDS, other)
    append_record(tmp_path / "midway" / UNFINISHED / "0.jsonl", other)
    for name in ("done", "midway"):
        with (
            pytest.raises(BadData, match="version 1 of the tools"),
            taken_up(tmp_path / name, DEMO, PEOPLE),
        ):
            pass


@pytest.mark.slow
@pytest.mark.skipif(find_spec("bpy") is None, reason="Blender's package isn't installed")
def test_people_see_what_the_chosen_renderer_draws(cache):
    things, pictures = open_library("procedural", None, cache), list[np.ndarray]()
    for name in RENDERERS:
        conditions = Conditions(renderer=name)
        resources = HumanResources(things, RunOrder("", conditions=conditions))
        with resources.furnish() as place:
            record = place.set_table(DEMO.tasks[0], "Ada", 0).record
        assert (record.conditions, record.viewpoint.renderer) == (conditions, name)
        assert record.question.picture is not None
        pictures.append(record.question.picture.astype(int))
    assert 1 < np.abs(pictures[1] - pictures[0]).mean() < 25
