"""`probe film`: an episode as a film, with the arm that no agent sees, or as a recording."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Annotated, Literal

import tyro

from probe.api.films import clipped, filmed, recorded
from probe.cli.option_conflicts import refuse_stray
from probe.cli.screen import say, track
from probe.scene.setup import RendererName


def film(
    records: Annotated[Path, tyro.conf.Positional],
    task: str | None = None,
    run: int | None = None,
    agent: str | None = None,
    out: Path | None = None,
    format: Literal["mp4", "webm", "gif", "rrd"] | None = None,
    speed: float | None = None,
    renderer: RendererName | None = None,
    clips: bool = False,
) -> None:
    """Film recorded episodes: simulated ones are done again, of a robot's the pictures are shown.

    What comes out otherwise than recorded isn't filmed. A film that is there already is kept; the
    same command goes on with those that are missing.

    Args:
        records: Folder that `probe run`, `probe robot run` or `probe robot session` wrote to.
        task: Id of a task; by default all.
        run: Number of a run of it; by default all.
        agent: Name of an agent, as in the records; by default all.
        out: Folder for the films; by default "films" in that of the records.
        format: Of the files: by default mp4; rrd is a recording for Rerun's viewer.
        speed: How fast the arm moves, in multiples of real time, by default 1; in simulation,
            fingers that close on something are shown at half of that.
        renderer: What draws robot, table and room, by default filament; blender needs the extra of
            that name, and much more time. What the agent saw is drawn as when it saw it.
        clips: Make no films but a short loop of each manipulation, which `probe report` shows.
    """
    if clips:
        given = {"--out": out, "--format": format, "--speed": speed}
        refuse_stray("film", "with --clips", given)
        _clips(records, task, run, agent, renderer or "filament")
        return
    if format == "rrd":
        refuse_stray("film", "with --format rrd", {"--speed": speed, "--renderer": renderer})
        _recordings(records, out, task, run, agent)
        return
    say("What was simulated is done again and compared first; the bar then counts pictures.")
    for facts in filmed(
        records,
        out,
        task=task,
        run=run,
        agent=agent,
        form=format or "mp4",
        renderer=renderer or "filament",
        speed=1.0 if speed is None else speed,
        watch=_watch,
    ):
        if facts.drawn:
            rate = 60 * facts.seconds / facts.cpu_seconds
            took = f"{facts.drawn} pictures, {rate:.1f} s of film a CPU minute"
            say(f"{facts.path}: {facts.seconds:.0f} s; {took}.")
        else:
            say(f"{facts.path} is there already.")


def _clips(
    records: Path, task: str | None, run: int | None, agent: str | None, renderer: RendererName
) -> None:
    took = "about 20 s" if renderer == "filament" else "some minutes"
    say(f"Each episode is done again and compared first; all that takes {took} a manipulation.")
    for record, made in clipped(records, task=task, run=run, agent=agent, renderer=renderer):
        found = f"{made} clips made" if made else "its clips are there already"
        say(f"{record.task}, {record.agent}, run {record.run}: {found}.")
    say(f"`probe report {records}` shows them.")


def _recordings(
    records: Path, out: Path | None, task: str | None, run: int | None, agent: str | None
) -> None:
    say("Each episode is done again and compared first; that takes about 20 s a manipulation.")
    for path, made in recorded(records, out, task=task, run=run, agent=agent):
        size = f"{path.stat().st_size / 1e6:.0f} MB" if made else "it is there already"
        say(f"{path}: {size}. `rerun {path}` shows it.")


def _watch(numbers: Iterable[int], count: int) -> Iterable[int]:
    return track(numbers, "Filming", count)
