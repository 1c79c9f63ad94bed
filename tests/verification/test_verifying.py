"""What work is called, so that results of another check aren't taken for its own."""

from __future__ import annotations

from dataclasses import replace

from probe.assets.library import Library
from probe.tasks.suite_file import demo_suite
from probe.verification.verifying import Rebuilder, SuiteVerifier

SUITE = demo_suite()


def nobody() -> Library:
    raise NotImplementedError


def test_a_check_of_other_depth_has_another_name():
    deep = SuiteVerifier(nobody, solve=True, played=frozenset({"a", "b"}))
    ways = [deep, replace(deep, solve=False), replace(deep, played=frozenset({"a"}))]
    names = {way.plan(SUITE, SUITE.tasks).name for way in ways}
    assert len(names) == 3
    again = SuiteVerifier(nobody, solve=True, played=frozenset({"b", "a"}))
    assert again.plan(SUITE, SUITE.tasks[:1]).name == deep.plan(SUITE, SUITE.tasks).name


def test_making_tasks_again_of_other_objects_or_tables_has_another_name():
    one = Rebuilder(nobody, "procedural", ("oak",), {})
    ways = [one, replace(one, pool="scans"), replace(one, tables=("oak", "slate"))]
    assert len({way.plan(SUITE, SUITE.tasks).name for way in ways}) == 3
