"""People at a robot whom tests make up: they answer by what they are asked."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from probe.tasks.task import Task


class ScriptedOperator:
    """Lays every table rightly and writes a reason; notes all that was said.

    Args:
        tasks: Whose tables they lay.
        on: What to do when asked something with such words; its reply, if any, is given.
    """

    def __init__(
        self, tasks: Iterable[Task], on: Mapping[str, Callable[[], str | None]] | None = None
    ) -> None:
        self.heard: list[str] = []
        self._answers = {task.question: task.answer for task in tasks}
        self._on = on or {}
        self._letter = ""

    def tell(self, *lines: str) -> None:
        self.heard += lines
        self._letter = self._answers.get(lines[0], self._letter)

    def ask(self, words: str) -> str:
        self.heard.append(words)
        for part, act in self._on.items():
            if part in words and (said := act()) is not None:
                return said
        if "Which letter" in words:
            return self._letter.lower()
        if "lies so" in words:
            return "OK"
        return "" if "Enter" in words else "The agent said so at once."
