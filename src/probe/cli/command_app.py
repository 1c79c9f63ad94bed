"""Commands whose arguments are read first and which run afterwards; mistakes are told in a line."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from contextlib import redirect_stderr
from functools import partial, wraps
from typing import Any

import tyro

from probe.cli.usage import in_a_line
from probe.errors import Misuse


class CommandApp(tyro.extras.SubcommandApp):
    """Like tyro's, but no command runs while arguments are read."""

    def command(self, func: Any = None, **options: Any) -> Any:
        """As tyro's; a decorator, or called with a function or another app."""
        if func is None:
            return partial(self.command, **options)
        kept = func if isinstance(func, tyro.extras.SubcommandApp) else _postponed(func)
        super().command(kept, **options)
        return func


def call(app: CommandApp, arguments: Sequence[str]) -> None:
    """Read arguments and run the command that they name.

    Raises:
        Misuse: They don't fit the command.
        SystemExit: Only help was asked for.
    """
    said = io.StringIO()
    try:
        # What tyro has to say of mistakes takes ten lines in a box.
        with redirect_stderr(said):
            chosen: Callable[[], None] = app.cli(
                prog="probe",
                args=arguments,
                description="A benchmark of questions about a cluttered table.",
            )
    except SystemExit as ending:
        if ending.code in (0, None):
            raise
        raise Misuse(in_a_line(said.getvalue(), arguments)) from None
    chosen()


def _postponed(function: Callable[..., None]) -> Callable[..., Callable[[], None]]:
    """A function of the same arguments that returns the call, to be made later."""

    @wraps(function)
    def later(*given: Any, **named: Any) -> Callable[[], None]:
        return lambda: function(*given, **named)

    return later
