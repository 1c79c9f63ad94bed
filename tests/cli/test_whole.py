"""What is missing at the end is counted, and a failure for whoever started the command."""

import pytest

from deadly_work import aborts
from probe.api.resources import everything
from probe.cli.running import check_whole, run_order
from probe.engines.local import LocalEngine
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.errors import Unfinished
from probe.runs.plan import RunOrder
from probe.tasks.suite import selection
from probe.tasks.suite_file import demo_suite

DEMO = demo_suite()


def test_a_whole_run_ends_well_and_another_one_says_how_to_go_on():
    check_whole(0, 6)
    with pytest.raises(Unfinished, match=r"^2 of 6 episodes are missing. The same command tries"):
        check_whole(2, 6)


@pytest.mark.slow
def test_episodes_over_which_workers_abort_are_missing(tmp_path):
    suite = selection(DEMO, DEMO.tasks[:1], "one")
    assert run_order(suite, RunOrder("mad"), aborts, everything(), tmp_path, LocalEngine()) == 1
    (record,) = read_records(tmp_path / RECORDS)
    assert record.end == "fault" and "SIGABRT" in (record.fault or "")
