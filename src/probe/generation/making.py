"""Makes the tasks of many places, by any engine: each place is a unit of work."""

from __future__ import annotations

import hashlib
import json
import tempfile
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from pathlib import Path

from probe.assets.library import Library
from probe.engines.plan import Engine, LostUnit, WorkPlan
from probe.errors import OutputFailed, ProbeError, Unsatisfiable
from probe.generation.build import Audit, BuildResources, fill
from probe.generation.build_folder import BuildFolder, TaskSlot
from probe.generation.salt import Salt
from probe.render.renderer import Renderer
from probe.scene.setup import UR5_TABLE, Setup
from probe.tasks.task import NEWEST_RULES, RulesVersion


@dataclass(frozen=True)
class TaskMaker:
    """What makes tasks; see probe.processes.serving.Opening.

    Attributes:
        parts: Where tasks and logs go, for workers that see it; None for those that don't: they
            send what they made.
        library: Opens the objects.
        tables: Ids of table materials.
        audit: Measures tasks once more; None leaves out that check and those after it, see
            BuildResources.
        salt: Of a private suite.
        setup: The table that tasks are for.
        rules: The version of the rules that they are made by.
    """

    parts: BuildFolder | None
    library: Callable[[], Library]
    tables: Sequence[str]
    audit: Audit | None = None
    salt: Salt | None = None
    setup: Setup = UR5_TABLE
    rules: RulesVersion = NEWEST_RULES

    @contextmanager
    def __call__(self) -> Generator[Callable[[_Begun], bytes]]:
        """Open the library and start a renderer; gives what makes a task."""
        things = self.library()
        with Renderer(things.light_cache, self.setup.renderer) as renderer:
            yield partial(
                self._made,
                BuildResources(
                    things,
                    self.tables,
                    renderer,
                    self.audit,
                    self.salt,
                    self.setup,
                    self.rules,
                ),
            )

    @property
    def name(self) -> str:
        """A digest of how tasks are made."""
        commitment = self.salt.commitment if self.salt else None
        checks = "measured again, movable, solved" if self.audit else "none"
        how = repr((tuple(self.tables), checks, commitment, self.setup, self.rules))
        return f"tasks-{hashlib.sha256(how.encode()).hexdigest()[:32]}"

    def _made(self, resources: BuildResources, begun: _Begun) -> bytes:
        if self.parts is not None:
            return json.dumps(asdict(_filled(self.parts, resources, begun.place))).encode()
        with tempfile.TemporaryDirectory(prefix="probe-") as scratch:
            parts = BuildFolder(Path(scratch))
            parts.unpack(begun.files)
            filled = _filled(parts, resources, begun.place)
            return json.dumps(asdict(replace(filled, files=parts.packed(begun.place)))).encode()


@dataclass(frozen=True)
class _Begun:
    """A place, and what is there of it: its files by name, where workers don't see them."""

    place: TaskSlot
    files: dict[str, str]


@dataclass(frozen=True)
class _Filled:
    """What came of a place.

    Attributes:
        problem: Why there is no task; None if there is one.
        fatal: Whether that ends all work: a file can't be read, or written.
        files: What is there of it now, by name.
    """

    problem: str | None = None
    fatal: bool = False
    files: dict[str, str] = field(default_factory=dict[str, str])


def make_tasks(
    maker: TaskMaker, parts: BuildFolder, places: Sequence[TaskSlot], engine: Engine
) -> Generator[tuple[TaskSlot, str | None]]:
    """Make the tasks that aren't there yet; yields each place with what went wrong, if it did.

    Args:
        maker: Makes them.
        parts: Where they go.
        places: All of them.
        engine: Where the work is done.

    Raises:
        ProbeError: A part of the folder can't be read, or the folder can't be written.
        WorkerUnfit: A worker couldn't be set up.
        WorkerDied: Workers die before they begin.
    """
    waiting = list[_Begun]()
    for place in places:
        if parts.task_path(place).exists():
            yield place, None
        else:
            waiting.append(_Begun(place, parts.packed(place) if maker.parts is None else {}))
    plan = WorkPlan(maker.name, maker, waiting, lambda it: "-".join(map(str, it.place)))
    results = engine.carry_out(plan)
    try:
        for begun, result in results:
            if isinstance(result, LostUnit):
                yield begun.place, result.reason
                continue
            filled = _Filled(**json.loads(result))
            parts.unpack(filled.files)
            if filled.fatal:
                raise ProbeError(filled.problem)
            yield begun.place, filled.problem
    finally:
        results.close()


def _filled(parts: BuildFolder, resources: BuildResources, place: TaskSlot) -> _Filled:
    """Fill a place."""
    try:
        for _ in fill(place, parts, resources):
            pass
    except Unsatisfiable as error:
        return _Filled(str(error))
    except OutputFailed:
        raise  # this machine's disk is full: another one may do it
    except ProbeError as error:
        return _Filled(str(error), fatal=True)
    return _Filled()
