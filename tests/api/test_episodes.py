"""Episodes by `import probe`: in a suite's headline setting, and what is refused."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, cast

import pytest

from probe.agents.reading import read_graph
from probe.api.episodes import open_episode, play, replay
from probe.assets.library import Library
from probe.episodes.noise import Noise
from probe.episodes.tool_errors import HEADLINE
from probe.episodes.turns import Agent
from probe.errors import BadData, UnknownName
from probe.perception.choice import segmented
from probe.perception.dials import Dials
from probe.render.renderer import Renderer
from probe.tasks.suite_file import demo_suite

TASK = demo_suite().tasks[0]


@pytest.mark.slow
def test_the_headline_setting_applies_to_episodes_stepped_by_hand(
    library: Library, renderer: Renderer
):
    with open_episode(TASK, library, headline=HEADLINE, renderer=renderer) as episode:
        listed = read_graph(episode.step("perceive_scene").text)
        record = episode.record
    assert (record.noise, record.conditions.dials) == (Noise(0.018, 0.0), HEADLINE.dials)
    # It tells kinds and colours, so that no option is to be read off.
    told = {seen.name for seen in listed.objects}
    assert told and not told & {option.text for option in TASK.options}
    _, differing = replay(TASK, record, library, renderer=renderer)
    assert differing == []


@pytest.mark.slow
def test_errors_of_the_hand_alone_leave_the_detector_ideal(library: Library, renderer: Renderer):
    hand = replace(HEADLINE, dials=Dials())
    with open_episode(TASK, library, headline=hand, renderer=renderer) as episode:
        episode.step("perceive_scene")
        assert episode.record.noise == Noise(0.018, 0.0)
        assert episode.record.conditions.dials == Dials()


def test_an_unknown_noise_is_refused_by_name(library: Library):
    with pytest.raises(UnknownName, match="no noise called 'own'. Known: none, paper"):
        open_episode(TASK, library, noise=cast(Any, "own"))


def test_a_headline_setting_and_a_noise_are_one_too_many(library: Library):
    with pytest.raises(BadData, match="headline: has a noise of its own"):
        play(TASK, cast(Agent, None), library, noise="paper", headline=HEADLINE)


@pytest.mark.slow
def test_the_detectors_errors_are_of_the_ideal_one_alone(library: Library, renderer: Renderer):
    with open_episode(
        TASK, library, headline=HEADLINE, perceiver=segmented, renderer=renderer
    ) as episode:
        assert episode.record.noise == Noise(0.018, 0.0)
        assert episode.record.conditions.dials == Dials()
