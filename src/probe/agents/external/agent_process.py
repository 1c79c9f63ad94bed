"""In an agent's own process: gives up rights, loads a file, and answers as its agent does.

Nothing here may import what knows a task: whatever this process holds, the agent can get at.
"""

from __future__ import annotations

import contextlib
import importlib.util
import inspect
import os
import resource
import socket
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import NoReturn, cast

from probe.agents.external import landlock
from probe.agents.external.protocol import (
    LONGEST,
    AgentReady,
    AgentReply,
    AgentTurn,
    Confinement,
    Opening,
    WireCall,
)
from probe.agents.external.wire import Wire, WireCut
from probe.episodes.turns import Agent, Call, Question, Turn

_LARGEST_FILE = 2**30
_WORDS = 500
"""Characters of an error that are told; the whole of it is printed."""

_DEVICES = ("/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom")


class UnusableAgentFile(Exception):
    """A file makes no agent; the message is the reason."""


def main(handle: int, *, apart: bool) -> NoReturn:
    """Confine this process, make the agent, and answer until nobody asks.

    Args:
        handle: Of a socket to who asks.
        apart: Whether this process has namespaces of its own.
    """
    wire = Wire(socket.socket(fileno=handle))
    with contextlib.suppress(WireCut):
        opening = Opening.model_validate_json(wire.receive())
        wire.send(confine(opening, apart=apart).line)
        try:
            agent, name = made(opening)
            ready = AgentReady(name=name, pictures=bool(getattr(agent, "pictures", False)))
        except BaseException as error:
            wire.send(AgentReady(failed=_told(error)).line)
        else:
            wire.send(ready.line)
            answer(wire, agent)
    sys.stdout.flush()
    os._exit(0)


def confine(opening: Opening, *, apart: bool) -> Confinement:
    """Give up what the agent isn't to have.

    Args:
        opening: What it is allowed.
        apart: Whether this process has namespaces of its own.
    """
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (_LARGEST_FILE, _LARGEST_FILE))
    resource.setrlimit(resource.RLIMIT_AS, (opening.memory, opening.memory))
    alone = apart and not opening.network
    if not landlock.version():
        return Confinement(files=False, network=alone, processes=apart)
    allowed = dict.fromkeys(opening.listable, landlock.LIST)
    allowed |= dict.fromkeys((*opening.readable, "/proc/self"), landlock.READ)
    allowed |= dict.fromkeys((*_DEVICES, os.getcwd()), landlock.WRITE)
    kept = landlock.restrict(allowed, network=opening.network)
    return Confinement(files=True, network=alone or kept.tcp, processes=apart or kept.signals)


def made(opening: Opening) -> tuple[Agent, str]:
    """The agent of a file, and the name of what made it.

    Raises:
        Unusable: There is none in it.
    """
    sys.path += opening.modules
    path = Path(opening.file)
    spec = importlib.util.spec_from_file_location(path.stem, path)
    if spec is None or spec.loader is None:
        raise UnusableAgentFile(f"{path.name} is no Python file")
    module = importlib.util.module_from_spec(spec)
    sys.modules[path.stem] = module
    spec.loader.exec_module(module)
    maker = _maker(module, opening.name)
    seeded = "seed" in inspect.signature(maker).parameters
    agent = maker(seed=opening.seed) if seeded else maker()
    if not callable(getattr(agent, "act", None)):
        raise UnusableAgentFile(
            f"{maker.__name__} makes something that has no act(question, history)"
        )
    return cast(Agent, agent), maker.__name__


def answer(wire: Wire, agent: Agent) -> None:
    """Answer each Step with what the agent does.

    Raises:
        WireCut: Nobody asks any more.
    """
    question, history = Question("", ()), list[Turn]()
    while True:
        step = AgentTurn.model_validate_json(wire.receive())
        question = step.question.question() if step.question else question
        history += [told.turn() for told in step.turns]
        wire.send(_reply(agent, question, tuple(history)).line)


def _maker(module: ModuleType, name: str | None) -> Callable[..., object]:
    if name is not None:
        maker = getattr(module, name, None)
        if not callable(maker):
            raise UnusableAgentFile(f"there is no class or function called {name} in it")
        return maker
    makers = [
        found
        for found in vars(module).values()
        if inspect.isclass(found)
        and found.__module__ == module.__name__
        and callable(getattr(found, "act", None))
    ]
    if len(makers) != 1:
        names = ", ".join(found.__name__ for found in makers) or "none"
        raise UnusableAgentFile(
            f"it needs one class with act(), or its name after a colon; found: {names}"
        )
    return makers[0]


def _reply(agent: Agent, question: Question, history: tuple[Turn, ...]) -> AgentReply:
    try:
        call = cast(object, agent.act(question, history))
        if call is None:
            return AgentReply()
        if not isinstance(call, Call):
            return AgentReply(failed=f"act() gave a {type(call).__name__}, neither a Call nor None")
        parts = (_text(call.name), _text(call.arguments), _text(call.words))
        return AgentReply(call=WireCall(name=parts[0], arguments=parts[1], words=parts[2]))
    except BaseException as error:
        # Its exits, too: they are the agent's, and are told.
        return AgentReply(failed=f"act() raised {_told(error)}")


def _text(part: object) -> str:
    """Text that UTF-8 can hold; halves of surrogate pairs are replaced."""
    if not isinstance(part, str):
        raise TypeError(f"a Call holds a {type(part).__name__} where text is wanted")
    if len(part) > LONGEST:
        raise ValueError(f"a Call holds more than {LONGEST} characters")
    return part.encode("utf-8", "replace").decode()


def _told(error: BaseException) -> str:
    if isinstance(error, UnusableAgentFile):
        return str(error)[:_WORDS]
    with contextlib.suppress(Exception):
        traceback.print_exception(error)
    return f"{type(error).__name__}: {_text(str(error)[:_WORDS])}".removesuffix(": ")
