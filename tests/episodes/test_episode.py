from episodes.conftest import CALLS, QUESTION
from probe.episodes.episode import FAILED, Episode
from probe.episodes.run import run_episode
from probe.episodes.turns import Call
from probe.errors import RenderFailed


def test_the_record_so_far_is_true_at_any_moment(fresh, play):
    station, tools = fresh()
    episode = Episode("t-1", QUESTION, tools, station, agent_name="fixed", run=2)
    for number, call in enumerate(CALLS):
        assert not episode.ended and episode.record.end == "stopped"
        assert len(episode.record.steps) == number and episode.record.answer is None
        assert episode.step(call).result.text == episode.record.steps[-1].text
    assert episode.ended and episode.record.untimed() == play().untimed()


def test_after_the_end_nothing_is_done_or_recorded(fresh):
    station, tools = fresh()
    episode = Episode("t-1", QUESTION, tools, station, agent_name="fixed")
    episode.step(CALLS[-1])
    record = episode.record
    turn = episode.step(Call.of("perceive_scene"))
    assert "has ended" in turn.result.text and turn.result.ended
    assert episode.record is record and tools.turns == 1


def test_a_failure_of_ours_is_recorded_and_not_told(fresh, monkeypatch):
    station, tools = fresh()
    episode = Episode("t-1", QUESTION, tools, station, agent_name="fixed")

    def fail(name: object, arguments: object) -> None:
        raise RenderFailed("secret_red_mug_77 can't be drawn")

    monkeypatch.setattr(tools, "call", fail)
    result = episode.step(CALLS[0]).result
    assert result.text == FAILED and result.ended
    assert episode.record.end == "fault" and "secret" in (episode.record.fault or "")
    assert "has ended" in episode.step(CALLS[0]).result.text


def test_an_agent_sees_its_calls_as_they_are_recorded(fresh):
    seen: list[Call] = []

    class Watching:
        def act(self, question, history):
            seen.extend(turn.call for turn in history)
            return None if history else Call("find_object", "half a \ud800 pair")

    station, tools = fresh()
    record = run_episode("t-1", QUESTION, Watching(), tools, station, agent_name="a")
    assert seen == [record.steps[0].call] and seen[0].arguments == "half a ? pair"
