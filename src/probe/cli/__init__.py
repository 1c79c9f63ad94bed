"""The command line: `probe demo | scene | assets | suite | run | merge | report | ...`."""

from __future__ import annotations

import contextlib
import errno
import os
import resource
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from typing import NoReturn

from probe import __version__
from probe.cli.overview import overview
from probe.cli.screen import say, sign, warn
from probe.errors import Misuse, ProbeError, UnknownName
from probe.texts import visible


def silence() -> None:
    """Let nothing more come out: what is left would be tried again when the interpreter ends."""
    with contextlib.suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)


@dataclass(frozen=True)
class _Command:
    """Where a command is, and what the list of commands says of it.

    Modules are imported when their command is called: each needs other libraries, all of them
    together take seconds.
    """

    module: str
    words: str
    nested: bool = False


COMMANDS: dict[str, _Command] = {
    "doctor": _Command("doctor", "See what is installed, what is missing, and how to get it."),
    "demo": _Command("demo", "Run the scripted agent on a task of each of seven question types."),
    "scene": _Command("scene", "Settle a cluttered table from a seed and photograph it."),
    "run": _Command("run", "Run an agent or a model on a suite."),
    "merge": _Command("merge", "Join folders of records that `probe run --shard` wrote."),
    "report": _Command("report", "Grade records and write a page of scores and replays."),
    "report sim-real": _Command(
        "sim_real", "Compare agents in simulation with the same agents on a robot."
    ),
    "film": _Command("film", "Film recorded episodes, with the arm that no agent sees."),
    "rescore": _Command("rescore", "Grade a run's records again and write rows and scores."),
    "audit": _Command("audit", "Check records, replay their episodes, sign a folder."),
    "robustness": _Command("robustness", "Compare runs of the same tasks under other conditions."),
    "published": _Command("published", "Recompute the averages of the paper's table."),
    "serve": _Command("serve", "Offer the tools on one task to other programs, over MCP."),
    "export": _Command("export", "Write a suite as a data set for other programs."),
    "collect": _Command("collect", "Collect a teacher's episodes on training tasks."),
    "select": _Command("select", "Choose the episodes that a model is to learn from."),
    "dataset": _Command("dataset", "Write chosen episodes as a data set for trainers."),
    "init-tiny": _Command("init_tiny", "Make a very small, untrained model to try the recipe on."),
    "unpack-model": _Command("unpack_model", "Make packed weights a folder that can be trained."),
    "train": _Command("train", "Train a model on a data set."),
    "serve-model": _Command(
        "serve_model", "Serve a trained model on this machine, for `probe run`."
    ),
    "ladder": _Command("ladder", "Show which step of using the tools a model fails at."),
    "held-out": _Command("held_out", "Compare runs; untrained question types stand apart."),
    "human": _Command("human", "Serve a page on which people answer as agents do."),
    "robot": _Command("robot", "Look at and move robots behind bridges, or a robot's twin.", True),
    "assets": _Command("assets", "List, check and add objects of the library.", True),
    "suite": _Command("suite", "Build, check and show frozen suites of tasks.", True),
    "tools": _Command("tools", "Measure how often the tools work on known targets.", True),
}


_MEMORY = (
    "Raise the limit (ulimit -v), leave other programs, or ask for less (--workers 1); else "
    "install PROBE again."
)


LEAST_ADDRESSES = 400 << 20
"""Bytes that every command needs. With fewer, libraries in C end the process in words of their own
or wait for ever, and no exception says so."""

_OUT_OF_REACH = {
    errno.ENAMETOOLONG: "Choose a shorter path",
    errno.EACCES: "Choose another path, or have its permissions changed",
    errno.ELOOP: "Check the path",
}
"""What to do about a path of which the system won't even say whether anything is there."""

_NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)
_ELSEWHERE = "Free some space, or send what is printed somewhere else."


def main() -> None:
    """Run the command line; expected failures become one line and exit status 1.

    So do a lack of memory, a path that can't be looked at, and output that can't be written.
    """
    try:
        try:
            _run(sys.argv[1:])
        finally:
            # What can't be printed is known when it is written out, not before.
            if sys.stdout is not None:  # pyright: ignore[reportUnnecessaryComparison]
                sys.stdout.flush()
    except BrokenPipeError:
        # Whoever read it has seen enough (`probe ... | head`).
        silence()
        sys.exit(1)
    except OSError as failure:
        _end(_words_of(failure))
    except Misuse as failure:
        warn(f"probe: {failure}")
        sys.exit(2)
    except ProbeError as failure:
        _end(str(failure))
    except (MemoryError, ImportError) as failure:
        # A library that can't be mapped into memory is said to be missing.
        reason = " ".join(str(failure).split()) or "there is none left"
        _end(f"Memory ran out, or the installation is broken: {reason}. {_MEMORY}")
    except KeyboardInterrupt:
        _end("interrupted")


def _words_of(failure: OSError) -> str:
    """What the system refused, if that is of the user's making.

    Raises:
        OSError: It isn't; that is an error of ours.
    """
    remedy = _OUT_OF_REACH.get(failure.errno or 0)
    if failure.filename is not None and remedy is not None:
        return f"{failure.filename}: {failure.strerror}. {remedy}."
    # Of standard output no name is told; files of ours are OutputFailed.
    if failure.filename is not None or failure.errno not in _NO_ROOM:
        raise failure
    silence()
    return f"Output can't be written: {failure.strerror}. {_ELSEWHERE}"


def _end(reason: str) -> NoReturn:
    """End in one line, in which no name from a file can steer a terminal."""
    sys.exit(f"probe: {visible(' '.join(reason.splitlines()))}")


def _check_addresses() -> None:
    """End where a limit leaves too few addresses for any command."""
    most, _ = resource.getrlimit(resource.RLIMIT_AS)
    if most != resource.RLIM_INFINITY and most < LEAST_ADDRESSES:
        needed = f"{most >> 20} MiB of memory are allowed, and {LEAST_ADDRESSES >> 20} is the least"
        _end(f"{needed} that anything works with. Raise the limit (ulimit -v).")


_LISTED = "`probe --help` lists them all."


def _run(arguments: list[str]) -> None:
    if " ".join(arguments[:2]) in COMMANDS:
        arguments = [" ".join(arguments[:2]), *arguments[2:]]
    wanted = arguments[0] if arguments else "--help"
    if wanted in ("-h", "--help"):
        say(*overview({name: command.words for name, command in COMMANDS.items()}))
    elif wanted == "--version":
        say(f"probe {__version__}")
    elif wanted in COMMANDS or wanted.startswith("--tyro-"):
        _check_addresses()
        with sign(f"probe {wanted} is starting ..."):
            app = _app(wanted)
        app(arguments)
    elif wanted.startswith("-"):
        raise Misuse(f"There is no option {wanted} here. `probe --help` lists the commands.")
    else:
        raise Misuse(str(UnknownName("command", wanted, list(COMMANDS), _LISTED)))


def _app(wanted: str) -> Callable[[list[str]], None]:
    """What runs a command; only its own module is imported, all of them to complete words."""
    from probe.cli.command_app import CommandApp, call

    app = CommandApp()
    for name, command in COMMANDS.items():
        if name == wanted or wanted.startswith("--tyro-"):
            module = import_module(f"probe.cli.{command.module}")
            app.command(
                module.app if command.nested else getattr(module, command.module), name=name
            )
        else:
            app.command(_named(command), name=name)
    return partial(call, app)


def _named(command: _Command) -> Callable[[], None]:
    """Stands in the list for a command that isn't called."""

    def stub() -> None: ...

    stub.__doc__ = command.words
    return stub
