"""`probe suite shortcuts | learn`: whether tasks can be answered without acting, or looking."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from probe.api.resources import cache_folder, everything
from probe.cli.metavars import SuiteNames
from probe.cli.screen import say, track
from probe.errors import BadData
from probe.files import write_text
from probe.generation.necessary import is_answerable_at_sight
from probe.shortcuts.investigation import investigate
from probe.shortcuts.learning import learn as learn_weights
from probe.shortcuts.looks import examples_of
from probe.shortcuts.sample import CatalogueFacts
from probe.shortcuts.table import leaks, markdown
from probe.tasks.suite import Suite
from probe.tasks.suite_file import find_suite


def shortcuts(
    suites: SuiteNames,
    out: Path = Path("outputs/shortcuts.md"),
    rules_only: bool = False,
) -> None:
    """Try simple classifiers and fixed rules on generated tasks, and write a table of them.

    They see the question, the options, the catalogue and the first picture. First looks are kept
    in the cache, so that a second run is quick.

    Args:
        suites: Names, or files that `probe suite build` wrote; a task in several counts once.
        out: File for the table, Markdown.
        rules_only: Train nothing; for a suite too small to learn from.
    """
    things, read = everything(), _read(suites)
    if not rules_only:
        _check_public(read)
    tasks = [task for suite in read for task in suite.tasks]
    total = len({task.id for task in tasks if not is_answerable_at_sight(task)})
    looking = examples_of(read, things, cache_folder())
    examples = list(track(looking, "Looking", total=total))
    findings = investigate(examples, CatalogueFacts(things.specs), learning=not rules_only)
    write_text(out, markdown(findings))
    for finding in leaks(findings):
        hits = finding.hits
        say(f"Leak: {hits.question_type}, {hits.by}: {hits.accuracy:.1%} of {hits.n}")
    say(f"{len(leaks(findings))} leaks in {len(findings)} tests; the table is {out}.")


def learn(
    suites: SuiteNames,
    out: Path = Path("outputs/question_only.json"),
) -> None:
    """Train the question-only classifier on training tasks.

    Args:
        suites: Files that `probe suite build` wrote.
        out: File for what it learnt; the package's own is src/probe/agents/data/question_only.json.
    """
    learnt = learn_weights([task for suite in _read(suites) for task in suite.tasks])
    write_text(out, learnt.model_dump_json(indent=0) + "\n")
    counts = ", ".join(
        f"{question_type} {what.tasks}" for question_type, what in learnt.root.items()
    )
    say(f"What was learnt is in {out}; tasks: {counts}.")


def _check_public(suites: Sequence[Suite]) -> None:
    """Classifiers learn block by block of the plan, which nobody knows of a private suite."""
    for suite in suites:
        if suite.commitment is not None:
            remedy = "Say --rules-only, or build tasks for this with --public"
            raise BadData(f"suite {suite.name}", "is private: its plan isn't known", remedy)


def _read(names: Sequence[str]) -> list[Suite]:
    if not names:
        raise BadData("probe suite", "was given no suite", "Name some that `suite build` wrote")
    return [find_suite(name) for name in names]
