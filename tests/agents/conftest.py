"""Runs an agent on a painted table."""

from __future__ import annotations

import pytest

from probe.episodes.conditions import NO_DIALS
from probe.episodes.run import run_episode
from probe.episodes.turns import Question
from probe.perception.dials import NoisyDetector
from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.toolshed import Toolshed
from probe.types import Pose
from tabletops import Obedient, PaintedStation


@pytest.fixture
def play():
    """A function: agent, options, specs and blocks to an episode's record."""

    def run(agent, options, specs, blocks, skills=None, text="?", manipulations=10, dials=NO_DIALS):
        station = PaintedStation(blocks)
        skills = skills or Obedient()
        detector = NoisyDetector(Oracle(specs), dials, lambda: dict.fromkeys(specs, Pose()), 1)
        tools = Toolshed(station, detector, skills, UR5_TABLE, pictures=False, budget=manipulations)
        letters = tuple(zip("ABCDE", options, strict=False))
        question = Question(text, letters, manipulations=manipulations)
        return run_episode("t", question, agent, tools, station, agent_name="a")

    return run
