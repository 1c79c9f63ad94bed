"""An episode on a real table: the same tools, and a record of pictures instead of poses."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from probe.episodes.arm_skills import ArmSkills
from probe.episodes.episode import Episode
from probe.episodes.film import Film
from probe.episodes.grading import answer_form, budget_of, question_of
from probe.episodes.perceptions import used_by
from probe.perception.choice import Perceiver
from probe.scene.scene import Scene
from probe.station.motion_camera import Keep
from probe.station.station import Station
from probe.tasks.task import Task
from probe.toolshed.toolshed import Toolshed
from probe.types import Array


class RealTable:
    """What can be told of a real table for the record: its set-up, the arm's joints, pictures.

    Args:
        task: Says what is asked and of which set-up; what lies on the table isn't taken from it.
        station: The robot.
        film: Keeps the pictures.
    """

    def __init__(self, task: Task, station: Station, film: Film) -> None:
        scene = task.scene
        self._bare = Scene(scene.seed, scene.table, (), scene.setup)
        self._station = station
        self._film = film

    def snapshot(self) -> Scene:
        """The set-up without things: nobody knows where they really are."""
        return self._bare

    def joints(self) -> Array:
        """Joint angles as measured, radians, shape (n,)."""
        return self._station.joints()

    def photograph(self) -> str:
        """Keep what the camera sees now; returns the picture's name."""
        return self._film.keep(self._station.observe(rgb=True))


def open_real_episode(
    task: Task,
    agent_name: str,
    station: Station,
    perceiver: Perceiver,
    folder: Path,
    run: int = 0,
    film: Callable[[Keep], None] | None = None,
) -> Episode:
    """A fresh episode on a robot's table as it stands now.

    Args:
        task: What is asked; an operator has laid the table like its scene.
        agent_name: For the record.
        station: The robot, its arm parked.
        perceiver: Makes what the tools see with; it gets no truth.
        folder: Of the run; pictures are kept in it.
        run: Number of the run, for the record.
        film: Is told where pictures of motions go; None if nobody wants any.

    Raises:
        RobotLost: The robot doesn't answer.
        OutputFailed: Pictures can't be written.
    """
    perception = perceiver({}, dict)
    tools = Toolshed(
        station,
        perception.detector,
        ArmSkills(),
        task.setup,
        pictures=True,
        finder=perception.finder,
        teller=perception.teller,
        form=answer_form(task),
        guessed=perception.guessed,
        budget=budget_of(task),
    )
    kept = Film(folder, task.id)
    if film is not None:
        film(kept.keep_motion)
    table = RealTable(task, station, kept)
    return Episode(
        task.id,
        question_of(task, tools.first_picture()),
        tools,
        table,
        agent_name=agent_name,
        run=run,
        viewpoint=task.viewpoint,
        perception=used_by(perceiver),
        photograph=table.photograph,
    )
