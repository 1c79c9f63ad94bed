import json

from probe.episodes.turns import Call
from probe.errors import ArmInView
from probe.toolshed.result import Answer
from probe.toolshed.toolshed import TURNS
from tabletops import PaintedStation


class Broken(PaintedStation):
    """Its arm stays in view after the first look and its colours."""

    looks = 0

    def observe(self, *, rgb):
        self.looks += 1
        if self.looks > 2:
            raise ArmInView
        return super().observe(rgb=rgb)


def test_records_every_call_and_the_table_after_it(play):
    record = play()
    assert [step.status for step in record.steps] == [
        "done",
        "done",
        "done",
        "malformed",
        "malformed",
        "done",
        "done",
    ]
    counts = [len(scene.objects) for scene in record.scenes]
    assert counts == [2, 2, 2, 1, 1, 1, 1, 1]
    assert record.steps[0].call.words == "Let me look."
    assert record.answer == Answer("B", (640, 490))
    assert record.end == "answered" and record.manipulations == 1
    assert len(record.steps[0].after.joints) == 6
    assert len(record.seconds.agent) == len(record.seconds.tools) == 7


def test_an_agent_may_stop(play):
    record = play(Call.of("perceive_scene"))
    assert record.end == "stopped" and record.answer is None


def test_turns_run_out(play):
    record = play(*[Call.of("perceive_scene")] * 50)
    assert record.end == "out_of_turns" and len(record.steps) == TURNS


def test_a_failure_of_ours_is_no_answer(play):
    record = play(kind=Broken)
    assert record.end == "fault" and "Park it" in (record.fault or "")
    assert len(record.steps) == 2 and record.answer is None


def test_what_is_recorded_is_what_was_called(play):
    record = play()
    assert record.steps[4].call.arguments == "half a ? pair"
    assert json.loads(record.steps[1].call.arguments) == {"description": "red mug"}
