"""Features that tell nothing predict as well as a guess, neither better nor worse."""

import numpy as np
import pytest

from probe.shortcuts.classifiers import guesses, models

BLOCK = 40


def answers(rng: np.random.Generator) -> tuple[list[int], list[int]]:
    """Right options and blocks: half a block in which A is always right, then seven even ones."""
    even = [rng.permutation(BLOCK) % 2 for _ in range(7)]
    right = np.concatenate([np.zeros(BLOCK // 2, dtype=int), *even])
    blocks = np.concatenate([[7] * (BLOCK // 2), np.repeat(np.arange(7), BLOCK)])
    lot = rng.permutation(len(right))
    return right[lot].tolist(), blocks[lot].tolist()


@pytest.mark.parametrize("seed", range(3))
def test_letters_that_are_even_by_plan_are_guessed_right_in_half(seed):
    right, blocks = answers(np.random.default_rng(seed))
    told = [({"A": 1.0}, {"A": 0.0})] * len(right)
    said = guesses(models()["logistic"], told, right, blocks, seed)
    # What lacks tasks and one whole block are only learnt from.
    assert len(said) == 6 * BLOCK
    assert sum(right[task] == place for task, place in said.items()) == 3 * BLOCK


def test_tasks_of_a_block_are_predicted_together():
    right, blocks = answers(np.random.default_rng(0))
    rng = np.random.default_rng(1)
    told = [[{"x": float(x)} for x in rng.normal(size=2)] for _ in right]
    said = guesses(models()["neighbours"], told, right, blocks)
    foretold = {blocks[task] for task in said}
    assert 7 not in foretold and len(foretold) == 6
    assert all(task in said for task, block in enumerate(blocks) if block in foretold)


def test_what_tells_is_learnt():
    right, blocks = answers(np.random.default_rng(0))
    rng = np.random.default_rng(1)
    told = [[{"x": float(place == one) + rng.normal() / 4} for place in (0, 1)] for one in right]
    said = guesses(models()["logistic"], told, right, blocks)
    assert np.mean([right[task] == place for task, place in said.items()]) > 0.95
