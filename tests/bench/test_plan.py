"""What a folder is told before a model is asked anything."""

from __future__ import annotations

from bench.painted import demo, plan
from probe.bench.plan import take_up
from probe.episodes.ordered import read_ordered


def test_a_folder_says_how_many_runs_were_ordered(tmp_path):
    some = plan(tmp_path, "direct", demo(2), epochs=3)
    take_up(some, some.order("mine", ""))
    assert read_ordered(tmp_path) == {("mine", "direct"): 3}
