"""What looking alone makes of Count: what is seen is all there is."""

from __future__ import annotations

from collections.abc import Sequence

from probe.generation.first_look import FirstLook
from probe.generation.observer import Observer, offered, visible_count
from probe.tasks.task import Letter
from probe.tasks.type_rules import Form


def _answer(form: Form, question: str, options: Sequence[str], look: FirstLook) -> Letter:
    return offered(str(visible_count(question, look)), options)


OBSERVER = Observer(_answer)
