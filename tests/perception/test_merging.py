import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from probe.perception.merging import Merging, merged
from probe.perception.patches import Patches, _borders, _inside, patches
from probe.perception.relief import Relief, relief
from tabletops import Block, paint


def counted(numbers: np.ndarray, scene: Relief) -> Patches:
    return Patches(numbers, _inside(numbers, scene), *_borders(numbers, scene))


def noise(seed: int, numbers: np.ndarray) -> Relief:
    rng = np.random.default_rng(seed)
    maps = rng.uniform(0, 4, (4, *numbers.shape))
    return Relief(1, numbers > 0, rng.uniform(0, 60, (*numbers.shape, 3)), *maps)


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 10**6))
def test_counts_of_joined_patches_are_those_of_their_union(seed):
    rng = np.random.default_rng(seed)
    numbers = np.kron(rng.permutation(36).reshape(6, 6), np.ones((4, 4), int))
    scene = noise(seed, numbers)
    merging = Merging(counted(numbers, scene), lambda borders, first, second: borders[:, 1] % 1)
    for _ in range(12):
        pair = merging.likeliest(0.0)
        assert pair is not None
        numbers = np.where(np.isin(numbers, pair), merging.join(*pair), numbers)
    again = counted(numbers, scene)
    for number, counts in merging.inside.items():
        assert np.allclose(counts, again.inside[number])
    pairs = {(a, b) for a, others in merging.borders.items() for b in others if a < b}
    assert pairs == {tuple(pair) for pair in again.pairs.tolist()}
    for (a, b), counts in zip(again.pairs.tolist(), again.borders, strict=True):
        assert np.allclose(merging.borders[a][b], counts)


def test_never_and_always():
    frame = paint([Block(1, (100, 100, 299, 299)), Block(2, (300, 100, 400, 299), height=0.1)])
    start = patches(relief(frame))
    none = merged(start, lambda borders, first, second: np.zeros(len(borders)), 0.5)
    assert np.array_equal(none, start.numbers)
    every = merged(start, lambda borders, first, second: np.ones(len(borders)), 0.5)
    assert len(np.unique(every[every > 0])) == 1
    assert np.array_equal(every > 0, start.numbers > 0)


def test_an_empty_table_has_no_patches():
    start = patches(relief(paint([])))
    assert not merged(start, lambda borders, first, second: np.ones(len(borders)), 0.5).any()
