"""Episodes by `import probe`: in a suite's headline setting, and what is refused."""

from __future__ import annotations

from dataclasses import replace

import pytest

from probe.agents.reading import read_graph
from probe.api.episodes import open_episode, play, replay
from probe.assets.library import Library
from probe.episodes.noise import Noise
from probe.episodes.tool_errors import HEADLINE
from probe.errors import UnknownName
from probe.perception.dials import Dials
from probe.render.renderer import Renderer
from probe.tasks.suite_file import demo_suite

TASK = demo_suite().tasks[0]


@pytest.mark.slow
def test_the_headline_setting_of_a_suite_is_had_by_hand(library: Library, renderer: Renderer):
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


def test_a_noise_that_there_isnt_is_refused_by_name(library: Library):
    with pytest.raises(UnknownName, match="no noise called 'own'. Known: none, paper"):
        open_episode(TASK, library, noise="own")


def test_a_headline_setting_and_a_noise_are_one_too_many(library: Library):
    with pytest.raises(ValueError, match="give one of the two"):
        play(TASK, lambda question, history: None, library, noise="paper", headline=HEADLINE)
