import numpy as np

from probe.agents.random import Random
from tabletops import Block, spec

SPECS = {1: spec("blue bowl", "blue"), 2: spec("red die", "red")}
BLOCKS = [Block(1, (300, 300, 499, 499)), Block(2, (600, 700, 700, 800))]


def test_calls_are_valid_and_it_always_answers(play):
    letters, tools = set(), set()
    for seed in range(12):
        record = play(Random(np.random.default_rng(seed)), ["x", "y", "z"], SPECS, BLOCKS)
        assert record.end == "answered" and record.answer
        assert all(s.status != "malformed" or "out of date" in s.text for s in record.steps)
        letters.add(record.answer.choice)
        tools |= {step.call.name for step in record.steps}
    assert letters == {"A", "B", "C"}
    assert len(tools) == 5


def test_the_same_generator_gives_the_same_episode(play):
    def once():
        return play(Random(np.random.default_rng(3)), ["x", "y"], SPECS, BLOCKS).untimed()

    assert once() == once()
