"""`probe report sim-real`: agents in simulation beside the same agents on a robot."""

from __future__ import annotations

from pathlib import Path

from probe.api.sim_real import OUT, PAGE, write_sim_real
from probe.cli.metavars import RunFolder
from probe.cli.screen import ScreenTable, say, track
from probe.report.sim_real_words import span, telling


def sim_real(
    sim: RunFolder,
    real: RunFolder,
    out: Path = OUT,
) -> None:
    """Compare agents in simulation with the same agents on a robot, task by task.

    Args:
        sim: Folder that `probe run` wrote.
        real: Folder that `probe robot run` or `probe robot session` wrote.
        out: Folder for the page and its figures.
    """
    found = write_sim_real(sim, real, out, track=track)
    table = ScreenTable("agent", "tasks", "simulation", "95 %", "robot", "95 %", "points")
    for it in found.agents:
        sides = [
            words
            for side in (it.sim, it.real)
            for words in (
                f"{side.success:.1%}",
                f"{side.interval.low:.0%} to {side.interval.high:.0%}",
            )
        ]
        points = f"{100 * it.difference.difference:+.1f}"
        table.add(it.entrant.agent, str(len(found.tasks)), *sides, points)
    table.show()
    for name, it in (("Pearson's r", found.pearson), ("Spearman's rho", found.spearman)):
        if it.value is not None:
            say(f"{name} = {it.value:.3f} (over tasks {span(it.over_tasks)}; p = {it.p:.3f})")
    say(*telling(found))
    left = f"{len(found.tasks_left_out)} tasks and {len(found.agents_left_out)} agents"
    say(f"{left} are left out; the page says why. Open {out / PAGE} in a browser.")
