from dataclasses import replace

import pytest

from episodes.conftest import CALLS, QUESTION
from probe.episodes.episode import Episode
from probe.episodes.files import line_of, read_records, write_records
from probe.episodes.replay import NotAsBefore, OtherTools, differences, replay, resume
from probe.toolshed.version import TOOLS_VERSION


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


def test_an_episode_is_gone_on_with(play, fresh):
    whole = play()
    left = replace(play(*CALLS[:3]), agent="fixed")
    station, tools = fresh()
    episode = Episode("t-1", QUESTION, tools, station, agent_name="fixed", run=2)
    turns = resume(left, episode)
    assert [turn.result.text for turn in turns] == [step.text for step in left.steps]
    assert episode.record.seconds == left.seconds
    for call in CALLS[3:]:
        episode.step(call)
    assert line_of(episode.record, timed=False) == line_of(whole, timed=False)
    assert len(episode.record.seconds.agent) == len(CALLS)


def test_another_table_is_not_gone_on_with(play, fresh):
    left = play(*CALLS[:3])
    station, tools = fresh()
    station.blocks = station.blocks[:1]
    episode = Episode("t-1", QUESTION, tools, station, agent_name="fixed", run=2)
    with pytest.raises(NotAsBefore, match="start"):
        resume(left, episode)


@pytest.mark.parametrize(("version", "release"), [(1, "probe-vqa 0.1"), (TOOLS_VERSION + 1, "")])
def test_a_record_of_other_tools_is_not_repeated(play, fresh, version, release):
    record = replace(play(*CALLS[:3]), tools=version)
    station, tools = fresh()
    words = f"version {version} of the tools.*has version {TOOLS_VERSION}.*Install .*{release}"
    with pytest.raises(OtherTools, match=words):
        replay(record, tools, station)
    episode = Episode("t-1", QUESTION, tools, station, agent_name="fixed", run=2)
    with pytest.raises(OtherTools, match=words):
        resume(record, episode)
    assert tools.turns == 0
