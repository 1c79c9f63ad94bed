import pytest

from probe.runs.plan import RunOrder
from probe.tasks.suite_file import demo_suite
from probe.types import Shard

TASKS = demo_suite().tasks


@pytest.mark.parametrize("count", [1, 2, 3, 7])
def test_shards_are_the_whole_without_overlap(count):
    parts = [RunOrder("a", 2, shard=Shard(n, count)).jobs(TASKS) for n in range(count)]
    found = [(job.task.id, job.run) for part in parts for job in part]
    assert sorted(found) == sorted((task.id, run) for task in TASKS for run in (0, 1))
    assert max(map(len, parts)) - min(map(len, parts)) <= 1


def test_what_is_done_moves_nothing_to_another_shard():
    order = RunOrder("a", shard=Shard(1, 2))
    jobs = order.jobs(TASKS)
    first = jobs[0].task.id
    assert order.jobs(TASKS, {(first, "a", "", 0), (TASKS[0].id, "a", "", 0)}) == jobs[1:]
    others = {(first, "b", "", 0), (first, "a", "", 1), (first, "a", "direct", 0)}
    assert order.jobs(TASKS, others) == jobs
