from dataclasses import replace

from probe.episodes.files import line_of, read_records, write_records
from probe.episodes.replay import differences, replay


def test_a_replay_is_the_same_to_the_byte(tmp_path, play, fresh):
    record = play()
    write_records(tmp_path / "r.jsonl", [record])
    (stored,) = read_records(tmp_path / "r.jsonl")
    station, tools = fresh()
    again = replay(stored, tools, station)
    assert line_of(again, timed=False) == line_of(record, timed=False)
    assert differences(record, again) == []


def test_differences_are_named(play, fresh):
    record = play()
    station, tools = fresh()
    station.blocks = station.blocks[::-1]
    again = replay(record, tools, station)
    assert differences(record, again)[0] == "start"
    step = replace(record.steps[1], text="something else")
    other = replace(record, steps=(record.steps[0], step, *record.steps[2:]))
    assert differences(record, other) == ["step 2: text"]
    assert differences(record, replace(record, steps=())) == ["number of steps: 7 and 0"]
