"""The page of what is asked says what its tasks say, and each has its picture."""

from __future__ import annotations

import re
from pathlib import Path

import type_page

from probe.tasks.task import QUESTION_TYPES

ROOT = Path(__file__).parents[1]


def test_the_page_is_made_from_its_tasks():
    text = type_page.PAGE.read_text("utf-8")
    assert type_page.page() == text, "run scripts/type_page.py"
    for task, _ in type_page.tasks():
        assert f"> {task.question}\n" in text
        for option in task.options:
            assert f"{option.letter}: {option.text}" in text


def test_every_type_has_a_task_and_a_small_picture():
    assert sorted(type_page.WHAT) == sorted(QUESTION_TYPES)
    shown = re.findall(r"\]\(\.\./(pictures/type_[\w-]+\.jpg)\)", type_page.PAGE.read_text("utf-8"))
    ids = {task.id for task, _ in type_page.tasks()}
    assert {Path(it).stem.removeprefix("type_") for it in shown} == ids
    assert {it.name for it in (ROOT / "docs/pictures").glob("type_*")} == {
        Path(it).name for it in shown
    }, "run scripts/type_page.py --draw-all, and delete the old pictures"
    for picture in shown:
        assert (ROOT / "docs" / picture).stat().st_size < 100_000
