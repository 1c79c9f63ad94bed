"""Puts an agent at a task's table in simulation and keeps the record."""

from __future__ import annotations

from dataclasses import replace

from probe.assets.library import Library
from probe.episodes.arm_skills import ArmSkills
from probe.episodes.circumstances import PLAIN_TRY, Circumstances
from probe.episodes.conditions import NO_DIALS
from probe.episodes.episode import Episode
from probe.episodes.grading import answer_form, budget_of, grade_episode, question_of
from probe.episodes.perceptions import check_perception
from probe.episodes.record import EpisodeRecord
from probe.episodes.replay import check_tools, replay
from probe.episodes.run import run_episode
from probe.episodes.turns import Agent
from probe.perception.choice import Perceiver, dialled, ideal, segmented
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
    world: World | None = None,
) -> tuple[Toolshed, SimulatedStation]:
    """A task's table, fresh, with the tools over it and the station that the record watches.

    Args:
        task: Says what is on the table, and what stands around it.
        library: Has the task's objects.
        renderer: Draws what the station sees; what was loaded in it is replaced.
        circumstances: Of the episode.
        pictures: Whether the tools show any.
        perceiver: Makes what the tools see with; the circumstances must say the same.
        world: The task's table brought to life, untouched, by whoever looks on; by default a new
            one.

    Raises:
        PerceptionDiffers: They don't.
        ValueError: The renderer isn't what the circumstances say draws.
    """
    load_scene(renderer, task.scene, library)
    viewpoint = circumstances.viewpoint or task.viewpoint
    if renderer.name != viewpoint.renderer:
        raise ValueError(f"{viewpoint.renderer} is to draw, and this renderer is {renderer.name}'s")
    light = light_of(viewpoint.lighting, library.assets)
    alive = world or World(task.scene, library)
    station = SimulatedStation(alive, renderer, viewpoint.camera, light)
    words = {item.instance: library[item.object_id] for item in task.scene.objects}

    def poses() -> dict[int, Pose]:
        return {placed.instance: placed.pose for placed in station.snapshot().objects}

    check_perception(circumstances.perception, perceiver)
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
        guessed=perception.guessed,
        budget=budget_of(task),
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
    perceiver: Perceiver = ideal,
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
        perceiver: As in set_table().
    """
    tools, station = set_table(
        task, library, renderer, circumstances, pictures=pictures, perceiver=perceiver
    )
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
    # Those of the package: what else is on a machine must not change what is told.
    rumours = [spec for spec in library.specs if spec.origin == "procedural"]
    return dialled(conditions.dials, task.seed, circumstances.run, rumours)


def open_episode(
    task: Task,
    agent_name: str,
    library: Library,
    renderer: Renderer,
    circumstances: Circumstances = PLAIN_TRY,
    perceiver: Perceiver = ideal,
    *,
    pictures: bool = True,
) -> Episode:
    """A fresh episode for somebody who acts from outside, by default with pictures; see play()."""
    tools, station = set_table(
        task, library, renderer, circumstances, pictures=pictures, perceiver=perceiver
    )
    return Episode(
        task.id,
        question_of(task, tools.first_picture()),
        tools,
        station,
        agent_name=agent_name,
        run=circumstances.run,
        noise=circumstances.noise,
        conditions=circumstances.conditions,
        viewpoint=circumstances.viewpoint or task.viewpoint,
        perception=circumstances.perception,
    )


def replay_afresh(
    task: Task,
    record: EpisodeRecord,
    library: Library,
    renderer: Renderer,
    perceiver: Perceiver = ideal,
) -> EpisodeRecord:
    """Set a record's table as it stood at the start and do its calls again, without pictures.

    Args:
        task: What the record is about.
        record: Of an agent without a model that points.
        library: Has the task's objects.
        renderer: Draws what the station sees; what was loaded in it is replaced.
        perceiver: What the tools saw with, where that was an enrolment.

    Raises:
        OtherTools: Tools of another version made it.
        PerceptionDiffers: Names came from another enrolment, or from one that wasn't given.
    """
    check_tools(record)
    tools, station = set_table(
        task,
        library,
        renderer,
        record.circumstances,
        pictures=False,
        perceiver=perceiver_of(record, perceiver),
    )
    return replay(record, tools, station)


def perceiver_of(record: EpisodeRecord, enrolled: Perceiver = ideal) -> Perceiver:
    """What a record's tools saw with; what was enrolled isn't in it and has to be given."""
    return segmented if record.perception.kind == "segmenter" else enrolled


def score(task: Task, record: EpisodeRecord, renderer: Renderer) -> Score:
    """Grade a record without physics; the renderer must have the task's objects loaded."""
    labels = labels_of(renderer, record.scenes[-1], record.viewpoint.camera)
    return grade_episode(task, record, labels)
