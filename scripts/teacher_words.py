"""Write the words of today's phrases into the scripted teacher's episodes with tools.

Phrases change more often than what the teacher does. An episode whose calls would be others today
is an error: collect it again. For runs/data/teacher.tar.xz, which a test compares with the phrases:

    tar xf runs/data/teacher.tar.xz && .venv/bin/python scripts/teacher_words.py collected
    tar --sort=name --owner=root --group=root --mtime=DATE -cJf runs/data/teacher.tar.xz collected
"""

from __future__ import annotations

from pathlib import Path

import tyro

from probe.episodes.files import read_records, write_records
from probe.episodes.folder import RECORDS, SUITE
from probe.tasks.suite_file import read_suite
from probe.train.collect.batches import Batch, batches
from probe.train.dataset.augment.rephrasing import rephrased


def say_again(batch: Batch) -> bool:
    """Whether a batch's episodes had other words; they have today's now."""
    tasks = {task.id: task for task in read_suite(batch.folder / SUITE).tasks}
    path = batch.setting("agentic") / RECORDS
    if not path.exists():
        return False
    before = read_records(path)
    now = [rephrased(tasks[record.task], record) for record in before]
    if now == before:
        return False
    write_records(path, now)
    return True


def main(collection: tyro.conf.Positional[Path]) -> None:
    """Go through all batches of a collection.

    Args:
        collection: A folder that `probe collect` wrote.
    """
    changed = [batch.folder.name for batch in batches(collection) if say_again(batch)]
    print(f"Other words in {len(changed)} batches: {', '.join(changed) or 'none'}")


if __name__ == "__main__":
    tyro.cli(main)
