"""What a suite may call itself beside a score: a packaged one, a part of one, or neither."""

from __future__ import annotations

from dataclasses import dataclass

from probe.tasks.suite import Suite
from probe.tasks.suite_file import content_hash, packaged_suite, packaged_suites
from probe.texts import plain


@dataclass(frozen=True)
class SuiteIdentity:
    """Which suite it is, in words.

    Attributes:
        title: Its name as scores bear it: that of a packaged suite is the whole one's alone, and
            what isn't printable ASCII is escaped.
        remark: What has to stand beside scores; empty of a whole packaged suite.
        whole: Whether no task is missing of the packaged one that it names, if it names one.
    """

    title: str
    remark: str = ""
    whole: bool = True


def identity_of(suite: Suite) -> SuiteIdentity:
    """Which suite it is; whether it is what its name says is for check_name() to refuse."""
    name = plain(suite.name)
    if suite.name not in packaged_suites():
        words = f"{name} isn't a suite of the package (SHA-256 of its content: "
        return SuiteIdentity(name, f"{words}{content_hash(suite)})")
    found, tasks = len(suite.tasks), len(packaged_suite(suite.name).tasks)
    if found == tasks:
        return SuiteIdentity(name)
    remark = f"{found} of the {tasks} tasks of {name}: not a score on {name}"
    return SuiteIdentity(f"{name} ({found} of {tasks} tasks)", remark, whole=False)
