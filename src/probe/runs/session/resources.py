"""All that a session needs beside its log: agents, robot, operator."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass
from pathlib import Path

from probe.assets.library import Library
from probe.perception.choice import Perceiver
from probe.render.renderer import Renderer
from probe.runs.session.operator import Operator
from probe.runs.work import AgentOf
from probe.station.motion_camera import Keep
from probe.station.station import Station
from probe.tasks.suite import Suite
from probe.tasks.task import Task


@dataclass(frozen=True)
class Robot:
    """A robot at a table.

    Attributes:
        station: Looks at it.
        park: Sends the arm to where it hides nothing.
        acting: The same robot for an agent, as a person watches over it while the block lasts.
        film: Is told where pictures of motions go; None if nobody wants any.
    """

    station: Station
    park: Callable[[], None]
    acting: Callable[[], AbstractContextManager[Station]]
    film: Callable[[Keep], None] | None = None


@dataclass(frozen=True)
class SessionResources:
    """What a session works with.

    Attributes:
        suite: Its tasks alone.
        agents: What makes each agent, by its name in the records, in the plan's order.
        robot: Connects to the robot for a task, anew for each episode.
        perceiver: Makes what the tools see with.
        things: Have the tasks' objects.
        renderer: Draws how tables should lie.
        operator: Who lays them.
        out: Folder of the session.
    """

    suite: Suite
    agents: Mapping[str, AgentOf]
    robot: Callable[[Task], AbstractContextManager[Robot]]
    perceiver: Perceiver
    things: Library
    renderer: Renderer
    operator: Operator
    out: Path
