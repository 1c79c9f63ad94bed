"""Read a record, do its calls again, grade it anew: `python examples/replay.py --help`."""

from __future__ import annotations

from pathlib import Path

import tyro

from probe.api.resources import library
from probe.assets.tables import load_table
from probe.episodes.files import read_records
from probe.episodes.play import score, set_table
from probe.episodes.replay import differences, replay
from probe.render.renderer import Renderer
from probe.tasks.suite import check_objects
from probe.tasks.suite_file import read_suite


def main(folder: Path = Path("outputs/examples/agent")) -> None:
    """Replay the first record of a run.

    Args:
        folder: Holds suite.json and records.jsonl, as `examples/agent.py`, `probe run` and
            `probe demo` write them; procedural objects only.
    """
    suite, record = read_suite(folder / "suite.json"), read_records(folder / "records.jsonl")[0]
    task = next(task for task in suite.tasks if task.id == record.task)
    things = library("procedural")
    # A changed mesh would fall another way, so say so before wondering about differences.
    check_objects(suite, things)
    with Renderer() as renderer:
        table = load_table(task.scene.table, None)
        # Without pictures, as it was run; texts don't depend on it.
        tools, station = set_table(
            task, things, table, renderer, pictures=False, noise=record.noise, run=record.run
        )
        again = replay(record, tools, station)
        # Grading needs no physics: the record holds every pose after every call.
        before, after = score(task, record, renderer), score(task, again, renderer)
    found = differences(record, again)
    print(f"{record.agent} on {record.task}: {len(record.steps)} calls")
    print("Replayed byte for byte." if not found else "\n".join(found))
    print(f"Graded: {before.outcome}. The replay: {after.outcome}.")


if __name__ == "__main__":
    tyro.cli(main)
