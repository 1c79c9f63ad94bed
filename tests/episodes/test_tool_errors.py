"""A suite's headline setting: who runs under it, and how other settings are named."""

from __future__ import annotations

from dataclasses import replace

import pytest

from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.noise import NO_NOISE, NOISES, Noise
from probe.episodes.perceptions import PerceptionUsed
from probe.episodes.record import EpisodeRecord, TableState
from probe.episodes.tool_errors import hands_words, label_of, tool_errors
from probe.episodes.turns import Question
from probe.perception.dials import Dials
from probe.tasks.headline import HeadlineErrors
from run_folders import episode, on_robot
from task_examples import FIND, SCENE

EYE = Dials(over=0.1, under=0.05, missed=0.02)
HEADLINE = HeadlineErrors(0.018, 0.004, EYE)
HAND = Noise(0.018, 0.004)
AS_SAID = Conditions(dials=EYE)


@pytest.mark.parametrize(
    ("headline", "noise", "asked", "hand", "conditions"),
    [
        (None, "own", AS_FROZEN, NO_NOISE, AS_FROZEN),
        (None, "paper", AS_FROZEN, Noise(0.018), AS_FROZEN),
        (HEADLINE, "own", AS_FROZEN, HAND, AS_SAID),
        (HEADLINE, "none", AS_FROZEN, NO_NOISE, AS_FROZEN),
        (HEADLINE, "own", Conditions(dials=Dials(over=0.5)), HAND, Conditions(dials=Dials(0.5))),
        (HEADLINE, "own", Conditions(ideal="perception"), HAND, Conditions(ideal="perception")),
        (HEADLINE, "own", Conditions(table="other"), HAND, Conditions(table="other", dials=EYE)),
    ],
)
def test_tools_err_as_the_suite_says_unless_somebody_asks_for_something_else(
    headline, noise, asked, hand, conditions
):
    assert tool_errors(headline, noise, asked) == (hand, conditions)


def test_a_detector_that_isnt_the_ideal_one_errs_by_itself():
    assert tool_errors(HEADLINE, "own", AS_FROZEN, oracle=False) == (HAND, AS_FROZEN)


@pytest.mark.parametrize("setting", ["blind", "rule", "direct", "oracle-view"])
def test_who_calls_no_tool_suffers_no_errors(setting):
    assert tool_errors(HEADLINE, "own", AS_FROZEN, setting=setting) == (NO_NOISE, AS_FROZEN)
    assert label_of(record(NO_NOISE), HEADLINE, setting) == ""


@pytest.mark.parametrize(
    ("setting", "label"),
    [
        ("scripted", "ideal hand, ideal detector"),
        ("random", "ideal hand, ideal detector"),
        ("text-only", "ideal hand, ideal detector"),
        ("text-only, short graphs", "ideal hand, ideal detector"),
        # The model that points errs by itself.
        ("agentic, pointer self", "ideal hand"),
        ("agentic, pointer openai/eyes", "ideal hand"),
    ],
)
def test_who_calls_tools_does(setting, label):
    assert tool_errors(HEADLINE, "own", AS_FROZEN, setting=setting) == (HAND, AS_SAID)
    assert label_of(record(NO_NOISE), HEADLINE, setting) == label


def record(noise: Noise, conditions: Conditions = AS_FROZEN) -> EpisodeRecord:
    start = TableState(SCENE, (0.0,) * 6)
    asked = Question("?", ())
    return EpisodeRecord(
        FIND.id, "anna", 0, asked, start, (), None, "stopped", noise=noise, conditions=conditions
    )


def test_ideal_tools_cannot_be_taken_for_the_headline_setting():
    assert label_of(record(HAND, AS_SAID), HEADLINE, "agentic") == ""
    assert label_of(record(NO_NOISE), HEADLINE, "agentic") == "ideal hand, ideal detector"
    assert label_of(record(NO_NOISE, AS_SAID), HEADLINE, "agentic") == "ideal hand"
    assert label_of(record(HAND), HEADLINE, "agentic") == "ideal detector"
    more = Conditions(dials=EYE, table="other")
    assert label_of(record(HAND, more), HEADLINE, "agentic") == "table other"
    off = record(Noise(0.01), AS_SAID)
    assert label_of(off, HEADLINE, "agentic") == "hand off by 10 mm, pushing by 0 mm"


def test_another_detector_is_named_by_its_name():
    seen = replace(record(HAND), perception=PerceptionUsed("segmenter"))
    assert label_of(seen, HEADLINE, "agentic") == seen.perception.label != ""


def test_a_robots_hand_errs_by_itself(tmp_path):
    real = on_robot(record(NO_NOISE), tmp_path)
    assert real.frames and label_of(real, HEADLINE, "scripted") == "perception segmenter"


def test_hands_that_err_by_different_amounts_are_told_without_a_robots(tmp_path):
    ideal, erring = (episode(FIND, agent=name) for name in ("anna", "bert"))
    erring = replace(erring, noise=NOISES["paper"])
    assert "(ideal hand; hand off by 18 mm" in hands_words([ideal, erring], None)
    assert hands_words([on_robot(ideal, tmp_path), erring], None) == ""


@pytest.mark.parametrize("setting", ["direct", "blind", "oracle-view", "rule"])
def test_where_no_tool_is_called_none_errs(setting: str):
    assert label_of(record(NO_NOISE), HEADLINE, setting) == ""


def test_suites_that_say_nothing_name_settings_as_before():
    assert label_of(record(HAND), None, "agentic") == ""
    assert label_of(record(HAND, Conditions(table="other")), None, "agentic") == "table other"
