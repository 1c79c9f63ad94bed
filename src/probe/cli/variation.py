"""A suite under other conditions, prepared once for each folder; says what is amiss."""

from __future__ import annotations

from pathlib import Path

from probe.assets.library import Library
from probe.cli.screen import say, track
from probe.episodes.conditions import Conditions
from probe.render.renderer import Renderer
from probe.runs.variation import Variation, earlier, keep_varied, read_variation
from probe.runs.vary import vary
from probe.tasks.suite import Suite


def varied(base: Suite, conditions: Conditions, things: Library, out: Path) -> Suite:
    """The suite under other conditions, as the folder has it or made now; says what is amiss."""
    suite = earlier(out, base, conditions)
    if suite is None:
        with Renderer() as renderer:
            made = vary(base.tasks, conditions, things, renderer)
            total = len(base.tasks)
            found = list(track(made, f"Preparing tables ({conditions.label})", total=total))
        suite = keep_varied(out, base, conditions, found)
    notes = (read_variation(out) or Variation(base="", conditions="", notes={})).notes
    for task, note in notes.items():
        say(f"{task}: {note}")
    say(f"{len(notes)} of {len(base.tasks)} tasks are no longer what was certified; all are run.")
    return suite
