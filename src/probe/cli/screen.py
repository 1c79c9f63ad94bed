"""All that the command line shows: lines, tables and bars, in which no text can steer a terminal.

Names and questions come from files and models; what would be escape sequences or rich's markup in
them is shown as the signs that it consists of. Nothing else in this program prints.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sized
from typing import TypeVar

from rich import table as rich_table
from rich.console import Console
from rich.progress import (
    BarColumn,
    DownloadColumn,
    MofNCompleteColumn,
    Progress,
    ProgressColumn,
    Task,
    TimeElapsedColumn,
    TimeRemainingColumn,
)
from rich.table import Column
from rich.text import Text

from probe.texts import line, visible

__all__ = ["Column", "ScreenTable", "bar", "download_bar", "say", "say_above", "track", "warn"]

Item = TypeVar("Item")
_HOUR = 3600.0


class ScreenTable(rich_table.Table):
    """A table whose cells and title are shown as they are."""

    def __init__(
        self,
        *columns: Column | str,
        title: str | None = None,
        left: bool = False,
        head: bool = True,
    ) -> None:
        super().__init__(
            *columns,
            title=None if title is None else Text(line(title)),
            title_justify="left" if left else "center",
            show_header=head,
        )

    def add(self, *cells: str) -> None:
        """Add a row; a cell may have several lines."""
        self.add_row(*(Text(visible(cell)) for cell in cells))

    def show(self, narrowest: int = 0) -> None:
        """Print it.

        Args:
            narrowest: How many signs wide it may be where no terminal limits that.
        """
        console = _console()
        if narrowest and not console.is_terminal:
            console.width = narrowest
        console.print(self)


def say(*lines: object) -> None:
    """Print lines."""
    for each in lines:
        print(line(str(each)), flush=True)


def warn(*lines: object) -> None:
    """Print lines to standard error."""
    for each in lines:
        print(line(str(each)), file=sys.stderr, flush=True)


def say_above(progress: Progress, text: str) -> None:
    """Print a line above a bar."""
    progress.console.print(Text(line(text)), soft_wrap=True)


def bar() -> Progress:
    """A bar with words, counts, time spent and time left."""
    return Progress(
        _Words(),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        _Left(),
        TimeRemainingColumn(),
        # The harness replaces rich's global console, which ends what is shown there.
        console=_console(),
        # Episodes and tasks take minutes; a rate over half a minute would know of none.
        speed_estimate_period=_HOUR,
    )


def download_bar() -> Progress:
    """A bar with words and bytes."""
    return Progress(_Words(), DownloadColumn(), TimeRemainingColumn(), console=_console())


def track(
    items: Iterable[Item], words: str, total: float | None = None, *, hidden: bool = False
) -> Iterator[Item]:
    """Go through things with a bar.

    Args:
        items: The things.
        words: What is done.
        total: How many there are, if they don't know it themselves.
        hidden: Show no bar.
    """
    if hidden:
        yield from items
        return
    if total is None and isinstance(items, Sized):
        total = len(items)
    with bar() as progress:
        yield from progress.track(items, total=total, description=words)


class _Words(ProgressColumn):
    """The description of a bar, as it is."""

    def render(self, task: Task) -> Text:
        return Text(line(task.description))


class _Left(ProgressColumn):
    """A word before the time that is left."""

    def render(self, task: Task) -> Text:
        return Text("left")


def _console() -> Console:
    return Console(markup=False, highlight=False)
