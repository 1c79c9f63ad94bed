"""All that the command line shows: lines, tables and bars, in which no text can steer a terminal.

Names and questions come from files and models; what would be escape sequences or rich's markup in
them is shown as the signs that it consists of. Nothing else in this program prints.
"""

from __future__ import annotations

import sys
from collections.abc import Generator, Iterable, Iterator, Sized
from contextlib import contextmanager
from threading import Event, Thread
from typing import TextIO, TypeVar

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

__all__ = [
    "Column",
    "ScreenTable",
    "bar",
    "download_bar",
    "passing",
    "say",
    "say_above",
    "sign",
    "standard_error",
    "track",
    "warn",
]

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

    def show_paged(self, narrowest: int) -> None:
        """Print it; on a terminal with fewer lines, by way of the pager ($PAGER, less).

        Args:
            narrowest: As of `show`.
        """
        console = _console()
        if not console.is_terminal or self.row_count < console.height:
            self.show(narrowest)
            return
        with console.pager():
            console.print(self)


def say(*lines: object) -> None:
    """Print lines."""
    for each in lines:
        print(line(str(each)), flush=True)


def standard_error() -> TextIO:
    """Where what isn't a result goes."""
    return sys.stderr


def warn(*lines: object) -> None:
    """Print lines to standard error."""
    for each in lines:
        print(line(str(each)), file=sys.stderr, flush=True)


@contextmanager
def sign(words: str) -> Generator[None]:
    """Show a line on a terminal while something goes on that prints nothing; then take it away.

    It goes to standard error and counts the seconds; where that isn't a terminal, nothing shows.
    """
    if not sys.stderr.isatty():
        yield
        return
    _put(f"{line(words)}\r")
    over = Event()
    counting = Thread(target=_count, args=(line(words), over), daemon=True)
    counting.start()
    try:
        yield
    finally:
        over.set()
        counting.join()
        _put("\r\x1b[2K")


def _count(words: str, over: Event) -> None:
    """Show words and how many seconds it has been, every second."""
    seconds = 0
    while not over.wait(1.0):
        seconds += 1
        _put(f"{words} {seconds} s\r")


def _put(text: str) -> None:
    sys.stderr.write(text)
    sys.stderr.flush()


def say_above(progress: Progress, text: str) -> None:
    """Print a line above a bar."""
    progress.console.print(Text(line(text)), soft_wrap=True)


def bar(*, transient: bool = False) -> Progress:
    """A bar with words, counts, time spent and time left.

    Args:
        transient: Take it away at the end; where there is no terminal, show none.
    """
    return Progress(
        _Words(),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        _Left(),
        TimeRemainingColumn(),
        # The harness replaces rich's global console, which ends what is shown there.
        console=_console(),
        transient=transient,
        disable=transient and not _console().is_terminal,
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


def passing(items: Iterable[Item], words: str) -> Iterator[Item]:
    """Go through things with a bar that is gone when they are done."""
    with bar(transient=True) as progress:
        yield from progress.track(items, description=words)


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
