from __future__ import annotations

from collections import Counter
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import chisquare

from probe.tasks.options import count_candidates, drop_one
from probe.tasks.task import LETTERS, RulesVersion

FIVE = ("ant", "bee", "cat", "dog", "eel")
P_LIMIT = 0.001
OLDER = ["0 1 2 4 5", "0 1 2 3 4", "0 1 2 3 4", "0 1 3 4 5"]
RANKS = {"smallest": 0, "second": 1, "third": 2, "largest": 3}


def drawn(seed: int):
    """Options as episodes draw them: true one and letter uniform."""
    rng = np.random.default_rng(seed)
    truth, letter = int(rng.integers(5)), LETTERS[rng.integers(5)]
    return truth, letter, drop_one(FIVE, truth, letter, rng)


@given(st.integers(0, 4), st.sampled_from(LETTERS), st.integers(0, 10**6))
def test_the_true_one_is_under_its_letter_or_left_out(truth, letter, seed):
    options = drop_one(FIVE, truth, letter, np.random.default_rng(seed))
    assert [option.letter for option in options] == list("ABCDE")
    assert options[4].text == "None of the above"
    named = [option.text for option in options[:4]]
    assert len(set(named)) == 4 and set(named) < set(FIVE)
    if letter == "E":
        assert FIVE[truth] not in named
    else:
        assert named["ABCD".index(letter)] == FIVE[truth]


def test_e_is_right_in_a_fifth_and_no_letter_is_favoured():
    letters = Counter(
        next((o.letter for o in options if o.text == FIVE[truth]), "E")
        for truth, _, options in map(drawn, range(2000))
    )
    assert chisquare([letters[letter] for letter in LETTERS]).pvalue > P_LIMIT


def test_every_candidate_is_left_out_and_shown_at_each_place_alike():
    left_out: Counter[str] = Counter()
    shown: Counter[tuple[str, str]] = Counter()
    for _, _, options in map(drawn, range(2000)):
        left_out.update(set(FIVE) - {option.text for option in options})
        shown.update((option.letter, option.text) for option in options[:4])
    assert chisquare([left_out[text] for text in FIVE]).pvalue > P_LIMIT
    places = [shown[letter, text] for letter in "ABCD" for text in FIVE]
    assert chisquare(places).pvalue > P_LIMIT


def test_which_wrong_one_is_left_out_does_not_depend_on_its_rank():
    rng = np.random.default_rng(1)
    gone: Counter[str] = Counter()
    for _ in range(2000):
        gone.update(set(FIVE) - {option.text for option in drop_one(FIVE, 2, "B", rng)})
    assert gone["cat"] == 0
    assert chisquare([gone[text] for text in ("ant", "bee", "dog", "eel")]).pvalue > P_LIMIT


@pytest.mark.parametrize("candidates", [FIVE[:4], ("ant", "ant", "cat", "dog", "eel")])
def test_five_different_candidates_are_needed(candidates):
    with pytest.raises(ValueError, match="Five different"):
        drop_one(candidates, 0, "A", np.random.default_rng(0))


@given(st.integers(0, 3), st.integers(0, 10**6))
def test_counts_offer_what_is_visible_and_up_to_two_more(visible, seed):
    numbers = counted(visible, seed, rules=2)
    assert {visible, visible + 1, visible + 2} < set(numbers)
    assert numbers == sorted(set(numbers)) and len(numbers) == 5
    assert numbers[0] >= 0 and numbers[-1] <= 5


@given(st.integers(0, 4), st.integers(0, 10**6))
def test_counts_to_six_have_both_other_numbers_on_one_side(visible, seed):
    numbers = counted(visible, seed, rules=3)
    near = [visible, visible + 1, visible + 2]
    assert near in (numbers[:3], numbers[2:])
    assert numbers == sorted(set(numbers)) and len(numbers) == 5
    assert numbers[0] >= 0 and numbers[-1] <= 6


def test_what_counts_offered_by_older_rules_is_still_drawn_alike():
    # What the generator of v1 drew, written down when these rules were the only ones.
    found = [" ".join(count_candidates(v, np.random.default_rng(v), 2)) for v in range(4)]
    assert found == OLDER


def counted(visible: int, seed: int, rules: RulesVersion) -> list[int]:
    return [int(text) for text in count_candidates(visible, np.random.default_rng(seed), rules)]


def test_the_rank_of_a_count_among_the_numbers_offered_is_nearly_even():
    """No rule that goes by ranks is right much oftener than one in five."""
    rng, right = np.random.default_rng(5), Counter[str]()
    plans = list(product(range(5), range(3), LETTERS)) * 60
    for visible, hidden, letter in plans:
        candidates = count_candidates(visible, rng, 3)
        true = str(visible + hidden)
        *options, _ = drop_one(candidates, candidates.index(true), letter, rng)
        places = [option.text for option in sorted(options, key=lambda it: int(it.text))]
        right.update(name for name, place in RANKS.items() if places[place] == true)
    shares = {name: right[name] / len(plans) for name in RANKS}
    # 1/6, 1/6, 1/3, 1/6 and 1/6 of five; one of those that aren't true is left out, then a fifth.
    expected = {"smallest": 1 / 6, "second": 7 / 30, "third": 7 / 30, "largest": 1 / 6}
    assert shares == pytest.approx(expected, abs=0.02)
