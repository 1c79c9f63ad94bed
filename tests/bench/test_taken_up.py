"""A folder belongs to one process at a time, and to one suite under one set of conditions."""

from __future__ import annotations

from dataclasses import replace

import pytest

from bench.painted import demo, plan
from probe.bench.model_runner import ModelRunner
from probe.bench.plan import missing_of, taken_up
from probe.bench.tasks import agentic, direct
from probe.episodes.files import write_records
from probe.episodes.folder import RECORDS, claim_setting, reserved, start_folder
from probe.episodes.ordered import read_ordered
from probe.episodes.participation import ModelReply, Participation
from probe.errors import BadData
from probe.tasks.suite_file import demo_suite
from run_folders import episode

SUITE = demo(2)
HALF = b'{"task": "half a li'


def order_of(asked):
    return replace(asked, called="m").order("m", "")


def test_a_folder_that_another_run_is_at_is_left_as_it_is(tmp_path):
    asked = plan(tmp_path, "agentic", SUITE)
    start_folder(tmp_path, SUITE)
    (tmp_path / RECORDS).write_bytes(HALF)
    with (
        reserved(tmp_path),
        pytest.raises(BadData, match="another run"),
        taken_up(asked, order_of(asked)),
    ):
        pass
    assert (tmp_path / RECORDS).read_bytes() == HALF
    with taken_up(asked, order_of(asked)):
        assert (tmp_path / RECORDS).read_bytes() == b""


def test_a_seating_keeps_others_out_until_it_is_closed(tmp_path):
    asked = plan(tmp_path, "agentic", SUITE, epochs=3)
    first, second = ModelRunner(asked), ModelRunner(asked)
    assert first.take_up(order_of(asked)) == 6
    with pytest.raises(BadData, match="another run"):
        second.take_up(order_of(asked))
    first.close()
    assert second.take_up(order_of(asked)) == 6
    second.close()


def test_models_do_not_answer_where_people_do(tmp_path):
    asked = plan(tmp_path, "agentic", SUITE)
    start_folder(tmp_path, SUITE)
    claim_setting(tmp_path, "human")
    with (
        pytest.raises(BadData, match="is kept for records of the setting human"),
        taken_up(asked, order_of(asked)),
    ):
        pass
    assert read_ordered(tmp_path) == {}


def test_what_is_missing_is_counted_in_the_records(tmp_path):
    asked = plan(tmp_path, "agentic", SUITE, epochs=2)
    assert missing_of(asked, order_of(asked)) == 4
    start_folder(tmp_path, SUITE)
    one, two = SUITE.tasks
    told = [episode(one, agent="m"), episode(one, agent="else"), episode(two, agent="m")]
    lost = replace(told[2], run=1, end="fault", fault="no reply")
    write_records(
        tmp_path / RECORDS,
        [replace(it, participation=Participation("agentic")) for it in (*told, lost)],
    )
    assert missing_of(asked, order_of(asked)) == 2


def test_one_that_points_writes_places_down_in_one_way(tmp_path):
    asked = replace(plan(tmp_path, "agentic", SUITE), called="m", pointer="self")
    gemini = replace(asked, convention="yx1000")
    order = asked.order("m", "self")
    with taken_up(gemini, order):
        pass
    with pytest.raises(BadData, match="pointing=yx1000.*not pixels"), taken_up(asked, order):
        pass
    with taken_up(gemini, order):
        pass
    # It matters to nobody else: not where another one points, nor where nobody does.
    with taken_up(asked, asked.order("m", "eyes")):
        pass
    nobody = replace(asked, pointer="oracle")
    with taken_up(nobody, order_of(nobody)):
        pass


def test_where_nobody_noted_how_places_are_written_a_run_goes_on(tmp_path):
    asked = replace(plan(tmp_path, "agentic", SUITE), called="m", pointer="self")
    order = asked.order("m", "self")
    start_folder(tmp_path, SUITE)
    record = episode(SUITE.tasks[0], agent="m")
    seat = Participation(order.setting, replies=(ModelReply(len(record.steps)),))
    write_records(tmp_path / RECORDS, [replace(record, participation=seat)])
    with taken_up(replace(asked, convention="yx1000"), order) as (done, _):
        assert set(done) == {(SUITE.tasks[0].id, 0)}


def test_inspect_is_told_of_an_unfit_folder_before_any_sample(tmp_path):
    start_folder(tmp_path / "other", SUITE)
    with pytest.raises(BadData, match="another suite"):
        direct(suite="demo", out=str(tmp_path / "other"))
    whole = demo_suite()
    start_folder(tmp_path / "quiet", whole)
    write_records(tmp_path / "quiet" / RECORDS, [episode(whole.tasks[0], agent="m")])
    with pytest.raises(BadData, match="another noise"):
        agentic(suite="demo", out=str(tmp_path / "quiet"), noise="paper")
