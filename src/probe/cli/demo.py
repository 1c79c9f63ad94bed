"""`probe demo`: frozen tasks of seven types, solved by a scripted agent that really manipulates."""

from __future__ import annotations

from pathlib import Path

from probe.api.agents import make_agent
from probe.api.resources import everything
from probe.cli.report import write_run_report
from probe.cli.running import check_whole, run_order
from probe.cli.screen import say
from probe.engines.local import LocalEngine
from probe.episodes.conditions import Conditions, RendererKind
from probe.runs.plan import RunOrder
from probe.tasks.suite_file import packaged_suite


def demo(out: Path = Path("outputs/demo"), renderer: RendererKind = "own") -> None:
    """Let the scripted agent solve a task of each of seven types, and write a page of what it did.

    Args:
        out: Folder for the records, pictures and the page.
        renderer: What draws the pictures: as the tasks were frozen, or another; blender needs the
            extra of that name, and more time.
    """
    suite = packaged_suite("tour")
    order = RunOrder("scripted", conditions=Conditions(renderer=renderer))
    missing = run_order(suite, order, make_agent, everything(), out, LocalEngine())
    say(f"Open {write_run_report([out])} in a browser.")
    check_whole(missing, len(suite.tasks))
