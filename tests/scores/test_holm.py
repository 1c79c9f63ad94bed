import gc
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from statsmodels.stats.multitest import multipletests

from probe.scores.holm import holm, ties


@pytest.fixture(scope="module")
def little_garbage():
    """Statsmodels collects garbage at every call, among all that other tests have left."""
    gc.freeze()
    yield
    gc.unfreeze()


@pytest.mark.usefixtures("little_garbage")
@given(st.lists(st.floats(0, 1), min_size=1, max_size=12))
def test_as_statsmodels_has_it(chances):
    expected = multipletests(chances, method="holm")
    assert holm(chances) == pytest.approx(np.asarray(expected[1]))


def test_by_hand():
    assert holm([0.04, 0.01, 0.03]) == pytest.approx([0.06, 0.03, 0.06])
    assert holm([0.5, 0.9]) == pytest.approx([1.0, 1.0])
    assert holm([0.2]) == [0.2]
    assert holm([]) == []


NAMES = "abcdef"


@pytest.mark.parametrize(
    ("rejected", "groups"),
    [
        ([], ["abcdef"]),
        (["af"], ["abcde", "bcdef"]),
        (["ac", "ad", "ae", "af"], ["ab", "bcdef"]),
        (["ab", "ac", "bc"], ["adef", "bdef", "cdef"]),
        (["".join(pair) for pair in combinations(NAMES, 2)], list(NAMES)),
    ],
)
def test_groups_by_hand(rejected, groups):
    assert ties(NAMES, [(a, b) for a, b in rejected]) == [tuple(group) for group in groups]


@given(st.sets(st.sampled_from(list(combinations(NAMES, 2)))))
def test_groups_are_all_largest_sets_without_a_rejected_pair(rejected):
    def apart(group):
        return any(pair in rejected for pair in combinations(sorted(group), 2))

    sets = [set(g) for size in range(1, 7) for g in combinations(NAMES, size)]
    clear = [it for it in sets if not apart(it)]
    largest = [it for it in clear if not any(it < other for other in clear)]
    found = [set(group) for group in ties(NAMES, sorted(rejected))]
    assert sorted(found, key=sorted) == sorted(largest, key=sorted)


def test_groups_are_in_the_order_of_the_names_not_of_the_alphabet():
    assert ties("cab", [("c", "b")]) == [("c", "a"), ("a", "b")]
    assert ties("cab", [("c", "a"), ("c", "b"), ("a", "b")]) == [("c",), ("a",), ("b",)]


def test_nobody_is_tied_with_nobody():
    assert ties((), []) == [()]
