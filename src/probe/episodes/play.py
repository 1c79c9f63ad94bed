"""Puts an agent at a task's table in simulation and keeps the record."""

from __future__ import annotations

from dataclasses import replace

from probe import manipulation
from probe.assets.library import Library
from probe.assets.tables import TableMaterial
from probe.episodes.conditions import AS_FROZEN, NO_DIALS, Conditions
from probe.episodes.episode import Episode
from probe.episodes.grading import grade_episode, question_of
from probe.episodes.ideal_grasp import IdealGrasp
from probe.episodes.noise import NO_NOISE, Noise, NoisySkills
from probe.episodes.record import EpisodeRecord
from probe.episodes.replay import replay
from probe.episodes.run import run_episode
from probe.episodes.turns import Agent
from probe.perception.choice import Perceiver, dialled, ideal
from probe.render.lighting import light_of
from probe.render.photograph import labels_of, load_scene
from probe.render.renderer import Renderer
from probe.scene.viewpoint import Viewpoint
from probe.station.simulated import SimulatedStation
from probe.tasks.grading import Score
from probe.tasks.task import Task
from probe.toolshed.skills import Skills
from probe.toolshed.toolshed import Toolshed
from probe.types import Pose
from probe.world.world import World


def set_table(
    task: Task,
    library: Library,
    table: TableMaterial,
    renderer: Renderer,
    *,
    pictures: bool,
    perceiver: Perceiver = ideal,
    noise: Noise = NO_NOISE,
    conditions: Conditions = AS_FROZEN,
    sight: Viewpoint | None = None,
    run: int = 0,
) -> tuple[Toolshed, SimulatedStation]:
    """A task's table, fresh, with the tools over it and the station that the record watches.

    Args:
        task: Says what is on the table.
        library: Has the task's objects.
        table: What the table is made of.
        renderer: Draws what the station sees; what was loaded in it is replaced.
        pictures: Whether the tools show any.
        perceiver: Makes what the tools see with.
        noise: How far the hand errs.
        conditions: Its dials and its ideal hold; what it says of the table must be so already.
        sight: From where and in which light the table is seen; by default as the task was made.
        run: Of the episode's runs; each has its own luck.
    """
    load_scene(renderer, task.scene, library, table)
    sight = sight or task.viewpoint
    light = light_of(sight.lighting, library.assets)
    station = SimulatedStation(World(task.scene, library), renderer, sight.camera, light)
    words = {item.instance: library[item.object_id] for item in task.scene.objects}

    def poses() -> dict[int, Pose]:
        return {placed.instance: placed.pose for placed in station.snapshot().objects}

    perception = _perceiver(perceiver, conditions, task, library, run)(words, poses)
    skills: Skills = NoisySkills(manipulation, noise, task.seed, run)
    if conditions.ideal == "grasp":
        skills = IdealGrasp(skills, station)
    tools = Toolshed(
        station,
        perception.detector,
        skills,
        task.scene.setup,
        pictures=pictures,
        finder=perception.finder,
        teller=perception.teller,
    )
    return tools, station


def play(
    task: Task,
    agent: Agent,
    agent_name: str,
    library: Library,
    table: TableMaterial,
    renderer: Renderer,
    run: int = 0,
    noise: Noise = NO_NOISE,
    conditions: Conditions = AS_FROZEN,
    sight: Viewpoint | None = None,
    *,
    pictures: bool = False,
) -> EpisodeRecord:
    """Let an agent work on a task.

    Args:
        task: What is asked, and of which table.
        agent: Fresh for this episode.
        agent_name: For the record.
        library: Has the task's objects.
        table: What the table is made of.
        renderer: Draws what the station sees; what was loaded in it is replaced.
        run: Number of the run, for the record; each has its own luck.
        noise: How far the hand errs.
        conditions: As for set_table.
        sight: As for set_table.
        pictures: Whether the agent looks at any; what the tools say doesn't depend on it.
    """
    sight = sight or task.viewpoint
    tools, station = set_table(
        task,
        library,
        table,
        renderer,
        pictures=pictures,
        noise=noise,
        conditions=conditions,
        sight=sight,
        run=run,
    )
    asked = question_of(task, tools.first_picture() if pictures else None)
    record = run_episode(task.id, asked, agent, tools, station, agent_name=agent_name, run=run)
    return replace(record, noise=noise, conditions=conditions, sight=sight)


def _perceiver(
    chosen: Perceiver, conditions: Conditions, task: Task, library: Library, run: int
) -> Perceiver:
    """What the tools see with once dials and ideals have had their say."""
    if conditions.ideal == "perception":
        return ideal
    if conditions.dials == NO_DIALS:
        return chosen
    return dialled(conditions.dials, task.seed, run, library.specs)


def open_episode(
    task: Task,
    agent_name: str,
    library: Library,
    table: TableMaterial,
    renderer: Renderer,
    run: int = 0,
    noise: Noise = NO_NOISE,
    conditions: Conditions = AS_FROZEN,
    sight: Viewpoint | None = None,
    perceiver: Perceiver = ideal,
) -> Episode:
    """A fresh episode with pictures, for somebody who acts from outside; see play().

    Its record doesn't tell of conditions and sight: whoever keeps it adds them.
    """
    tools, station = set_table(
        task,
        library,
        table,
        renderer,
        pictures=True,
        perceiver=perceiver,
        noise=noise,
        conditions=conditions,
        sight=sight,
        run=run,
    )
    question = question_of(task, tools.first_picture())
    return Episode(task.id, question, tools, station, agent_name=agent_name, run=run, noise=noise)


def replay_afresh(
    task: Task, record: EpisodeRecord, library: Library, renderer: Renderer
) -> EpisodeRecord:
    """Set a record's table as it stood at the start and do its calls again, without pictures.

    Args:
        task: What the record is about.
        record: Of an agent without a model that points.
        library: Has the task's objects.
        renderer: Draws what the station sees; what was loaded in it is replaced.
    """
    tools, station = set_table(
        task,
        library,
        library.table(task.scene.table),
        renderer,
        pictures=False,
        noise=record.noise,
        conditions=record.conditions,
        sight=record.sight,
        run=record.run,
    )
    return replay(record, tools, station)


def score(task: Task, record: EpisodeRecord, renderer: Renderer) -> Score:
    """Grade a record without physics; the renderer must have the task's objects loaded."""
    labels = labels_of(renderer, record.scenes[-1], record.sight.camera)
    return grade_episode(task, record, labels)
