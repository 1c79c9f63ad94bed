"""Results of imaginary agents whose chances are known: to check statistics and to plan suites."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from scipy import special

from probe.scores.units import Unit
from probe.types import Array


def draw_chances(
    rng: np.random.Generator, means: Sequence[float], icc: float, alike: Array, tasks: int
) -> Array:
    """Each entrant's chance at each of some tasks of one type, shape (entrants, tasks).

    Chances are beta distributed, so that runs have the correlation `icc` (Griffiths, Biometrics
    29(4), 1973); entrants are joined by a Gaussian copula.

    Args:
        rng: For the draws.
        means: Mean chance of each entrant, above 0 and below 1.
        icc: Correlation of an entrant's runs at a task, above 0 and below 1.
        alike: Correlation of the normal scores behind the entrants' chances, positive
            semi-definite, shape (entrants, entrants).
        tasks: How many.
    """
    values, vectors = np.linalg.eigh(alike)
    root = vectors * np.sqrt(np.maximum(values, 0))
    ranks = special.ndtr(root @ rng.standard_normal((len(means), tasks)))
    middle, weight = np.asarray(means)[:, None], 1 / icc - 1
    return special.betaincinv(middle * weight, (1 - middle) * weight, ranks)


def draw_units(
    rng: np.random.Generator,
    sizes: Mapping[str, int],
    means: Mapping[str, Sequence[float]],
    icc: float,
    alike: Array,
    runs: int,
) -> list[list[Unit]]:
    """Units of each entrant on a suite of new tasks; see draw_chances.

    Args:
        rng: For the draws.
        sizes: Number of tasks by question type.
        means: By type, mean chance of each entrant.
        icc: Correlation of an entrant's runs at a task.
        alike: Between entrants, shape (entrants, entrants).
        runs: Of each task.
    """
    entrants: list[list[Unit]] = [[] for _ in alike]
    for question_type, tasks in sizes.items():
        chances = draw_chances(rng, means[question_type], icc, alike, tasks)
        won = (rng.random((runs, *chances.shape)) < chances).transpose(1, 2, 0).astype(float)
        for entrant, mine in zip(entrants, won.tolist(), strict=True):
            entrant.extend(
                Unit(f"{question_type}-{i}", question_type, tuple(it)) for i, it in enumerate(mine)
            )
    return entrants


def two_settings(agents: int, *, task: float, agent: float, setting: float) -> Array:
    """How alike entrants are that are agents in two settings, shape (2 agents, 2 agents).

    The first half is the one setting, the second the other, in the same order of agents. What
    makes a task easy is parted into shares, of which the rest is each entrant's own.

    Args:
        agents: How many.
        task: Share that is the same for everybody.
        agent: Share that an agent has in both settings.
        setting: Share that all agents of a setting have.
    """
    same_agent = np.tile(np.eye(agents), (2, 2))
    same_setting = np.kron(np.eye(2), np.ones((agents, agents)))
    own = 1 - task - agent - setting
    return task + agent * same_agent + setting * same_setting + own * np.eye(2 * agents)
