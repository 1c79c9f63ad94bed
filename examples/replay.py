"""Read a record, do its calls again, grade it again: `python examples/replay.py --help`."""

from __future__ import annotations

from pathlib import Path

import tyro

import probe


def main(folder: Path = Path("outputs/demo")) -> None:
    """Replay the first record of a run.

    Args:
        folder: Holds suite.json and records.jsonl, as `probe run` and `probe demo` write them.
    """
    record = probe.read_records(folder)[0]
    task = probe.load_suite(folder / "suite.json")[record.task]
    library = probe.open_library("all")
    with probe.Renderer() as renderer:
        again, differences = probe.replay(task, record, library, renderer=renderer)
        # Grading needs no physics: the record holds every pose after every call.
        before = probe.score(task, record, library, renderer=renderer)
        after = probe.score(task, again, library, renderer=renderer)
    print(f"{record.agent} on {record.task}: {len(record.steps)} calls")
    print("\n".join(differences) or "The replay is the same, byte for byte.")
    print(f"Graded: {before.outcome}. The replay: {after.outcome}.")


if __name__ == "__main__":
    tyro.cli(main)
