"""`probe doctor`: what is here, what is missing, what needs it, and the command that gets it."""

from __future__ import annotations

import json as json_format
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import Annotated

import tyro

from probe import __version__
from probe.cli.health.around import around_findings
from probe.cli.health.core import core_findings
from probe.cli.health.packages import extra_findings
from probe.cli.health.requirement import Requirement
from probe.cli.screen import say
from probe.errors import ProbeError


class Unfit(ProbeError):
    """Something is missing that everything needs."""

    def __init__(self, names: Sequence[str]) -> None:
        super().__init__(f"Nothing works without: {', '.join(names)}. The list says how to get it.")


def doctor(
    endpoint: Annotated[str | None, tyro.conf.arg(metavar="URL")] = None, json: bool = False
) -> None:
    """Say what this machine has and lacks, what needs it, and the command that gets it.

    The exit status is 1 only if something is missing that everything needs.

    Args:
        endpoint: Address of a model's server to try, such as http://localhost:8000/v1; by default
            what VLLM_BASE_URL names.
        json: Print it as JSON.
    """
    around = list(around_findings(endpoint))
    findings = [*core_findings(), *around, *extra_findings()]
    lacking = [it.name for it in findings if it.core and not it.ok]
    if json:
        found = {"version": __version__, "ok": not lacking}
        say(json_format.dumps(found | {"findings": [asdict(it) for it in findings]}))
    else:
        say(f"probe {__version__}", *_lines(findings))
    if lacking:
        raise Unfit(lacking)


def _lines(findings: Sequence[Requirement]) -> Iterator[str]:
    """First what everything needs, then what is here for some uses, then what isn't."""
    parts = {
        "Needed by everything:": [it for it in findings if it.core],
        "Here as well:": [it for it in findings if it.ok and not it.core],
        "Missing, and needed only for what stands beside it:": [
            it for it in findings if not (it.ok or it.core)
        ],
    }
    for heading, part in parts.items():
        if part:
            yield ""
            yield heading
        width = max((len(it.name) for it in part), default=0)
        for it in part:
            if it.ok:
                yield f"  ok       {it.name:{width}}  {it.found}"
            else:
                yield f"  missing  {it.name:{width}}  {it.found}; for {it.use}"
                yield f"           {'':{width}}  {it.remedy}"
