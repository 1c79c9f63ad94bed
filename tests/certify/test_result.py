from __future__ import annotations

from probe.certify.result import Candidate, Rejection, Yield
from task_examples import FIND


def test_yield_counts_what_was_kept_and_what_failed_where():
    hidden, settle = Rejection("hidden", "9 %"), Rejection("settle", "it rolls")
    tally = Yield.of([settle, hidden, Candidate(FIND), hidden])
    assert (tally.kept, tally.attempts, tally.share) == (1, 4, 0.25)
    assert list(tally.rejected.items()) == [("hidden", 2), ("settle", 1)]
    assert Yield.of([]).share == 0
