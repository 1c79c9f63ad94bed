import json

import pytest

from probe.episodes.files import append_record, line_of, read_records, write_records
from probe.episodes.turns import Call
from probe.errors import BadData


def test_records_survive_the_disk(tmp_path, play):
    path = tmp_path / "runs" / "records.jsonl"
    records = [play(), play(Call.of("perceive_scene"))]
    for record in records:
        append_record(path, record)
    assert read_records(path) == records
    again = tmp_path / "again.jsonl"
    write_records(again, read_records(path))
    assert again.read_bytes() == path.read_bytes()
    assert [f.name for f in path.parent.iterdir()] == ["records.jsonl"]


def test_an_unchanged_table_is_written_once(play):
    steps = json.loads(line_of(play()))["steps"]
    assert [step["after"] is None for step in steps] == [True, True, False, *[True] * 4]


def test_timing_lies_apart(play):
    one, other = play(), play()
    assert line_of(one, timed=False) == line_of(other, timed=False)
    assert one.untimed() == other.untimed()


def test_a_line_that_is_cut_off_is_named(tmp_path, play):
    path = tmp_path / "records.jsonl"
    whole = line_of(play())
    path.write_bytes(whole + whole[:-40])
    with pytest.raises(BadData, match=r"records.jsonl, line 2: .*Delete this line"):
        read_records(path)
    with pytest.raises(BadData, match=r"records.jsonl, line 2: is cut off"):
        append_record(path, play())
    assert path.read_bytes() == whole + whole[:-40]


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"version": 1}, "version"),
        ({"end": "bored"}, "end"),
        ({"start": {"scene": None, "joints": []}}, "start.scene"),
        ({"more": 1}, "more"),
    ],
)
def test_lines_that_are_no_records_are_refused(tmp_path, play, change, reason):
    path = tmp_path / "records.jsonl"
    path.write_text(json.dumps(json.loads(line_of(play())) | change) + "\n")
    with pytest.raises(BadData, match=f"line 1: {reason}"):
        read_records(path)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(BadData, match="nowhere.jsonl"):
        read_records(tmp_path / "nowhere.jsonl")
