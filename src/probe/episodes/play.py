"""Puts an agent at a task's table in simulation and keeps the record."""

from __future__ import annotations

from dataclasses import replace

from probe.assets.library import Library
from probe.episodes.arm_skills import ArmSkills
from probe.episodes.circumstances import PLAIN_TRY, Circumstances
from probe.episodes.conditions import NO_DIALS
from probe.episodes.episode import Episode
from probe.episodes.grading import answer_form, grade_episode, question_of
from probe.episodes.record import EpisodeRecord
from probe.episodes.replay import check_tools, replay
from probe.episodes.run import run_episode
from probe.episodes.turns import Agent
from probe.perception.choice import Perceiver, dialled, ideal
from probe.render.lighting import light_of
from probe.render.photograph import labels_of, load_scene
from probe.render.renderer import Renderer
from probe.station.simulated import SimulatedStation
from probe.tasks.grading import Score
from probe.tasks.task import Task
from probe.toolshed.toolshed import Toolshed
from probe.types import Pose
from probe.world.world import World


def set_table(
    task: Task,
    library: Library,
    renderer: Renderer,
    circumstances: Circumstances = PLAIN_TRY,
    *,
    pictures: bool,
    perceiver: Perceiver = ideal,
) -> tuple[Toolshed, SimulatedStation]:
    """A task's table, fresh, with the tools over it and the station that the record watches.

    Args:
        task: Says what is on the table, and what stands around it.
        library: Has the task's objects.
        renderer: Draws what the station sees; what was loaded in it is replaced.
        circumstances: Of the episode.
        pictures: Whether the tools show any.
        perceiver: Makes what the tools see with.
    """
    load_scene(renderer, task.scene, library, library.table(task.scene.table))
    viewpoint = circumstances.viewpoint or task.viewpoint
    light = light_of(viewpoint.lighting, library.assets)
    station = SimulatedStation(World(task.scene, library), renderer, viewpoint.camera, light)
    words = {item.instance: library[item.object_id] for item in task.scene.objects}

    def poses() -> dict[int, Pose]:
        return {placed.instance: placed.pose for placed in station.snapshot().objects}

    perception = _perceiver(perceiver, circumstances, task, library)(words, poses)
    ideal_grasp = circumstances.conditions.ideal == "grasp"
    skills = ArmSkills(
        circumstances.noise,
        task.seed,
        circumstances.run,
        removal=station if ideal_grasp else None,
    )
    tools = Toolshed(
        station,
        perception.detector,
        skills,
        task.setup,
        pictures=pictures,
        finder=perception.finder,
        teller=perception.teller,
        form=answer_form(task),
    )
    return tools, station


def play(
    task: Task,
    agent: Agent,
    agent_name: str,
    library: Library,
    renderer: Renderer,
    circumstances: Circumstances = PLAIN_TRY,
    *,
    pictures: bool = False,
) -> EpisodeRecord:
    """Let an agent work on a task.

    Args:
        task: What is asked, and of which table.
        agent: Fresh for this episode.
        agent_name: For the record.
        library: Has the task's objects.
        renderer: Draws what the station sees; what was loaded in it is replaced.
        circumstances: Of the episode.
        pictures: Whether the agent looks at any; what the tools say doesn't depend on it.
    """
    tools, station = set_table(task, library, renderer, circumstances, pictures=pictures)
    asked, run = question_of(task, tools.first_picture() if pictures else None), circumstances.run
    record = run_episode(task.id, asked, agent, tools, station, agent_name=agent_name, run=run)
    return replace(record, viewpoint=task.viewpoint).under(circumstances)


def _perceiver(
    chosen: Perceiver, circumstances: Circumstances, task: Task, library: Library
) -> Perceiver:
    """What the tools see with once dials and ideals have had their say."""
    conditions = circumstances.conditions
    if conditions.ideal == "perception":
        return ideal
    if conditions.dials == NO_DIALS:
        return chosen
    return dialled(conditions.dials, task.seed, circumstances.run, library.specs)


def open_episode(
    task: Task,
    agent_name: str,
    library: Library,
    renderer: Renderer,
    circumstances: Circumstances = PLAIN_TRY,
    perceiver: Perceiver = ideal,
) -> Episode:
    """A fresh episode with pictures, for somebody who acts from outside; see play().

    Its record tells of the noise alone, not of conditions and viewpoint: whoever keeps it adds
    them.
    """
    tools, station = set_table(
        task, library, renderer, circumstances, pictures=True, perceiver=perceiver
    )
    return Episode(
        task.id,
        question_of(task, tools.first_picture()),
        tools,
        station,
        agent_name=agent_name,
        run=circumstances.run,
        noise=circumstances.noise,
        viewpoint=task.viewpoint,
    )


def replay_afresh(
    task: Task, record: EpisodeRecord, library: Library, renderer: Renderer
) -> EpisodeRecord:
    """Set a record's table as it stood at the start and do its calls again, without pictures.

    Args:
        task: What the record is about.
        record: Of an agent without a model that points.
        library: Has the task's objects.
        renderer: Draws what the station sees; what was loaded in it is replaced.

    Raises:
        OtherTools: Tools of another version made it.
    """
    check_tools(record)
    tools, station = set_table(task, library, renderer, record.circumstances, pictures=False)
    return replay(record, tools, station)


def score(task: Task, record: EpisodeRecord, renderer: Renderer) -> Score:
    """Grade a record without physics; the renderer must have the task's objects loaded."""
    labels = labels_of(renderer, record.scenes[-1], record.viewpoint.camera)
    return grade_episode(task, record, labels)
