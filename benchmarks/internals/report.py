"""How long a report takes to write and to open in Chromium.

`python benchmarks/internals/report.py`. Measures internals, not the public API.

Copies the demo's records until there are enough episodes, each at a task of its own with pictures
of its own, so that nothing is shared, and with a clip of each manipulation that is shaped like a
film. The demo is run first if it hasn't been.
"""

from __future__ import annotations

import io
import statistics
import sys
import tempfile
import time
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import tyro
from PIL import Image

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))

from browser import Browser, chromium  # noqa: E402
from probe.api.agents import make_agent  # noqa: E402
from probe.api.resources import everything  # noqa: E402
from probe.cli.report import write_run_report  # noqa: E402
from probe.cli.running import run_order  # noqa: E402
from probe.engines.local import LocalEngine  # noqa: E402
from probe.episodes.files import read_records, write_records  # noqa: E402
from probe.episodes.folder import RECORDS, SUITE  # noqa: E402
from probe.episodes.record import EpisodeRecord, TableState  # noqa: E402
from probe.files import write_bytes  # noqa: E402
from probe.report.clips import CLIPS, MOVING, clip_stem  # noqa: E402
from probe.report.page import PICTURES  # noqa: E402
from probe.report.stills import file_of, stills_of  # noqa: E402
from probe.runs.plan import RunOrder  # noqa: E402
from probe.tasks.suite import Suite  # noqa: E402
from probe.tasks.suite_file import packaged_suite, read_suite, write_suite  # noqa: E402
from probe.tasks.task import Task  # noqa: E402


def main(run: Path = Path("outputs/demo"), episodes: int = 150, repeats: int = 5) -> None:
    """Print times.

    Args:
        run: Folder of a run and its report.
        episodes: Of the report that is opened.
        repeats: Fresh browsers to open it in.
    """
    if chromium() is None:
        print("No Chromium here; scripts/ensure-browser installs it.")
        return
    if not (run / RECORDS).exists():
        run_order(
            packaged_suite("tour"),
            RunOrder("scripted"),
            make_agent,
            everything(),
            run,
            LocalEngine(),
        )
    write_run_report([run])
    with tempfile.TemporaryDirectory() as folder:
        copied = copies(run, Path(folder) / "copies", episodes)
        begun = time.perf_counter()
        page = write_run_report([copied])
        written = time.perf_counter() - begun
        clips = list((copied / CLIPS).iterdir())
        size, filmed = size_of(copied.rglob("*")), size_of(clips)
        print(f"{episodes} episodes, {size - filmed:.0f} MB; pictures were there")
        print(f"  beside them {len(clips)} clips, {filmed:.0f} MB")
        print(f"  graded, scored and written in {written:.1f} s")
        opening, replaying = zip(*(opened(page) for _ in range(repeats)), strict=True)
    for name, taken in (("page opened", opening), ("first replay shown", replaying)):
        print(f"  {name:18} {statistics.median(taken):.2f} s (most {max(taken):.2f}, n {repeats})")


def size_of(paths: Iterable[Path]) -> float:
    """Megabytes of files."""
    return sum(path.stat().st_size for path in paths if path.is_file()) / 1e6


def film(before: Path, after: Path) -> bytes:
    """A clip of 40 frames that looks like one: one picture turns into another."""
    first, last = (Image.open(path).convert("RGB").resize((480, 480)) for path in (before, after))
    frames = [Image.blend(first, last, number / 39) for number in range(40)]
    buffer = io.BytesIO()
    frames[0].save(
        buffer, "WEBP", save_all=True, append_images=frames[1:], duration=80, loop=0, quality=30,
        method=2,
    )  # fmt: skip
    return buffer.getvalue()


def add_clips(record: EpisodeRecord, out: Path, clip: bytes) -> None:
    """Write a clip of each manipulation; what it shows doesn't matter here."""
    for number, step in enumerate(record.steps, start=1):
        if step.call.name in MOVING:
            write_bytes(out / CLIPS / f"{clip_stem(record, number)}.webp", clip)


def copies(run: Path, out: Path, count: int) -> Path:
    """A run folder of this many episodes. Find is left out: grading it takes drawing."""
    suite = read_suite(run / SUITE)
    tasks = {task.id: task for task in suite.tasks}
    records = [it for it in read_records(run / RECORDS) if tasks[it.task].question_type != "find"]
    made: list[tuple[Task, EpisodeRecord]] = []
    clip = film(*sorted((run / PICTURES).glob("*.webp"))[:2])
    for number in range(count):
        record = records[number % len(records)]
        task, again = copy(tasks[record.task], record, number)
        for old, new in zip(
            stills_of(tasks[record.task], record, run),
            stills_of(task, again, out),
            strict=True,
        ):
            picture = (run / PICTURES / file_of(old, suite.objects)).read_bytes()
            write_bytes(out / PICTURES / file_of(new, suite.objects), picture)
        add_clips(again, out, clip)
        made.append((task, again))
    write_suite(out / SUITE, Suite("copies", tuple(task for task, _ in made), suite.objects))
    write_records(out / RECORDS, [record for _, record in made])
    return out


def copy(task: Task, record: EpisodeRecord, number: int) -> tuple[Task, EpisodeRecord]:
    """The same with another name and another seed, so that its pictures are others."""

    def reseeded(table: TableState) -> TableState:
        return replace(table, scene=replace(table.scene, seed=number))

    name = f"{task.question_type}-{number:08x}"
    steps = tuple(replace(step, after=reseeded(step.after)) for step in record.steps)
    again = replace(
        record, task=name, agent="copy", run=0, start=reseeded(record.start), steps=steps
    )
    return replace(task, id=name, scene=again.start.scene), again


def opened(page: Path) -> tuple[float, float]:
    """Seconds until a fresh browser has the page, and until an episode's picture is there."""
    with Browser() as browser:
        seconds = browser.open(page.as_uri())
        browser.wait("document.querySelectorAll('.card').length > 0")
        begun = time.perf_counter()
        browser.run("document.querySelector('.card button.run').click()")
        browser.wait("(document.querySelector('#stage img') ?? {}).naturalWidth > 0")
        return seconds, time.perf_counter() - begun


if __name__ == "__main__":
    tyro.cli(main)
