from __future__ import annotations

from collections import Counter

import pytest

from probe.errors import BadData
from probe.tasks.task import QUESTION_TYPES
from probe.train.collect.aim import PAPER_COUNTS, Aim, in_proportion, uncollected
from probe.train.collect.batches import CollectedBatches
from probe.types import Shard

FIRST = 2_000_000


def test_the_papers_counts():
    assert sum(PAPER_COUNTS.values()) == 2947
    assert in_proportion(PAPER_COUNTS, 2947) == dict(PAPER_COUNTS)


def test_what_is_not_collected_by_default():
    assert uncollected(["find", "beneath", "nested"]) == ("beneath", "nested")
    trained = {"count", "find", "compare", "size", "reduce"}
    assert {*uncollected(QUESTION_TYPES)} == {*QUESTION_TYPES} - trained


def test_fewer_in_the_papers_proportions():
    # 120 / 2947 of 521, 800, 785, 610, 231: 21.21, 32.57, 31.96, 24.84, 9.41.
    assert in_proportion(PAPER_COUNTS, 120) == {
        "count": 21, "find": 33, "compare": 32, "size": 25, "reduce": 9, "beneath": 0
    }  # fmt: skip
    with pytest.raises(BadData, match="asks for nothing"):
        in_proportion({"find": 0}, 5)


@pytest.mark.parametrize("count", [0, 1, 7, 100])
def test_shards_share_counts_and_places(count):
    aims = [Aim({"find": count}, FIRST, Shard(n, 3), batch=1000) for n in range(3)]
    assert sum(aim.total for aim in aims) == count
    places = [place.episode for aim in aims for place in aim.next_places(CollectedBatches())]
    assert len(set(places)) == len(places) and all(place >= FIRST for place in places)


def test_a_batch_follows_what_is_lacking_and_the_rate():
    aim = Aim({"find": 10, "count": 10}, FIRST, batch=100)
    so_far = CollectedBatches(
        Counter(find=8, count=8), Counter(find=2, count=8), last={"find": FIRST + 7, "count": FIRST}
    )
    question_types = Counter(place.question_type for place in aim.next_places(so_far))
    # 8 are lacking at a rate of 3 in 10, 2 at 9 in 10; a tenth more.
    assert question_types == {"find": 30, "count": 3}
    assert min(p.episode for p in aim.next_places(so_far) if p.question_type == "find") == FIRST + 8


def test_a_batch_is_no_larger_than_allowed_and_lacks_no_type():
    aim = Aim({"find": 1000, "count": 10}, FIRST, batch=10)
    places = aim.next_places(CollectedBatches())
    assert Counter(place.question_type for place in places) == {"find": 9, "count": 1}
    late = CollectedBatches(Counter(find=1000), Counter(find=1000), last={"find": FIRST + 999})
    assert {place.question_type for place in aim.next_places(late)} == {"count"}


def test_if_there_is_room_for_a_few_no_type_gets_two():
    few = Aim({"find": 500, "count": 400, "size": 5}, FIRST, most_cost=10.0)
    first = few.next_places(CollectedBatches())
    assert sorted(place.question_type for place in first) == ["count", "find", "size"]
    fewer = Aim({"find": 500, "count": 400, "size": 5}, FIRST, most_episodes=2)
    assert [it.question_type for it in fewer.next_places(CollectedBatches())] == ["find"]
    two = Aim({"find": 500, "count": 400, "size": 5}, FIRST, batch=2)
    assert [it.question_type for it in two.next_places(CollectedBatches())] == ["find", "count"]


def test_budgets():
    aim = Aim({"find": 10}, FIRST, most_episodes=20)
    assert aim.spent(CollectedBatches(episodes=18)) is None
    assert len(aim.next_places(CollectedBatches(Counter(find=8), episodes=18))) == 1
    assert aim.spent(CollectedBatches(episodes=19)) == "episodes"
    money = Aim({"find": 100}, FIRST, most_cost=10.0)
    assert len(money.next_places(CollectedBatches())) == 1
    half = CollectedBatches(Counter(find=10), episodes=10, cost=8.0, last={"find": FIRST})
    assert len(money.next_places(half)) == 2
    assert money.spent(CollectedBatches(Counter(find=10), episodes=10, cost=9.5)) == "cost"


def test_what_has_no_price_counts_as_much_as_the_rest():
    aim = Aim({"find": 100}, FIRST, most_cost=10.0)
    some = CollectedBatches(
        Counter(find=10), episodes=10, unpriced=5, cost=4.0, last={"find": FIRST}
    )
    # 8 dollars for ten tasks: 0.8 each.
    assert len(aim.next_places(some)) == 2
    nobody_knows = CollectedBatches(Counter(find=10), episodes=10, unpriced=10)
    assert aim.spent(nobody_knows) == "cost"


def test_successes_beyond_a_count_do_not_count():
    aim = Aim({"find": 2, "size": 3}, FIRST)
    assert aim.reached(CollectedBatches(successes=Counter(find=9, size=1))) == 3
