"""One episode: stepped by hand, or played by an agent; and what it is worth."""

from __future__ import annotations

from contextlib import ExitStack
from types import TracebackType

from probe.api.scenes import running
from probe.assets.library import Library
from probe.episodes.circumstances import Circumstances
from probe.episodes.conditions import AS_FROZEN
from probe.episodes.episode import Episode
from probe.episodes.noise import NO_NOISE, Noise, NoiseName, noise_of
from probe.episodes.perceptions import used_by
from probe.episodes.play import open_episode as _open_episode
from probe.episodes.play import play as _play
from probe.episodes.play import replay_afresh
from probe.episodes.play import score as _score
from probe.episodes.record import EpisodeRecord
from probe.episodes.replay import differences
from probe.episodes.tool_errors import tool_errors
from probe.episodes.turns import Agent, Call, Question
from probe.errors import BadData
from probe.perception.choice import Perceiver, ideal
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.tasks.grading import Score
from probe.tasks.headline import HeadlineErrors
from probe.tasks.task import Task
from probe.toolshed.result import ToolResult


class OpenEpisode:
    """A task's table with the five tools over it. Use it as a context manager, or call close().

    Attributes:
        task: What it is about; its answer is for you, no tool sees it.
    """

    def __init__(
        self, task: Task, episode: Episode, library: Library, renderer: Renderer, started: ExitStack
    ) -> None:
        self.task = task
        self._episode = episode
        self._library = library
        self._renderer = renderer
        self._started = started

    @property
    def question(self) -> Question:
        """What an agent is given: the text, the options, and the first picture, (h, w, 3) uint8."""
        return self._episode.record.question

    @property
    def record(self) -> EpisodeRecord:
        """All that has happened so far."""
        return self._episode.record

    @property
    def ended(self) -> bool:
        """Whether an answer was given or the turns are used up; further calls are refused."""
        return self._episode.ended

    def step(self, tool: str, **arguments: object) -> ToolResult:
        """Call a tool.

        Args:
            tool: "perceive_scene", "find_object", "grasp_and_remove", "push", "answer_question".
            **arguments: The tool's own, by name. What doesn't fit costs a turn and no more.

        Returns:
            The text that the agent reads, and the new picture where there is one.
        """
        return self._episode.step(Call.of(tool, arguments)).result

    def score(self) -> Score:
        """What the answer so far is worth."""
        return score(self.task, self.record, self._library, renderer=self._renderer)

    def close(self) -> None:
        """End the renderer, if it was started for this episode."""
        self._started.close()

    def __enter__(self) -> OpenEpisode:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()


def open_episode(
    task: Task,
    library: Library,
    *,
    noise: Noise | NoiseName = "none",
    headline: HeadlineErrors | None = None,
    run: int = 0,
    perceiver: Perceiver = ideal,
    renderer: Renderer | None = None,
) -> OpenEpisode:
    """Set a task's table and open the tools over it.

    Args:
        task: Of a suite; see load_suite().
        library: Has the task's objects; `open_library("all")` has those of every packaged suite.
        noise: How far the hand misses where it is sent: "none", "paper", or a Noise.
        headline: Errors of hand and detector in place of noise: `suite.headline`, for the setting
            in which a suite's scores are taken. The detector's are of the ideal one alone. By
            default, and with None, which suites like v1 state, neither errs.
        run: Number of the run; each run of a task has its own noise.
        perceiver: What the tools see with; by default the ideal detector. See pointing().
        renderer: One that is running already, for this episode alone; by default one is started.

    Raises:
        NoGraphicsDriver: The machine has no Vulkan driver.
        UnknownName: The library lacks an object of the task, or there is no such noise.
        BadData: Both a noise and a headline setting are given.
    """
    circumstances = _circumstances(noise, headline, perceiver, run)
    with ExitStack() as started:
        drawing = started.enter_context(running(renderer, task.setup.renderer))
        episode = _open_episode(task, "by hand", library, drawing, circumstances, perceiver)
        return OpenEpisode(task, episode, library, drawing, started.pop_all())


def play(
    task: Task,
    agent: Agent,
    library: Library,
    *,
    name: str | None = None,
    noise: Noise | NoiseName = "none",
    headline: HeadlineErrors | None = None,
    run: int = 0,
    pictures: bool = True,
    perceiver: Perceiver = ideal,
    renderer: Renderer | None = None,
) -> EpisodeRecord:
    """Run an agent on a task until it answers, stops, or has used its turns.

    The agent runs in this process and could look for the answer there, so use this for your own
    agents. `probe run --agent FILE.py` runs other people's agents in a sandbox.

    Args:
        task: Of a suite.
        agent: Fresh for this episode: `act(question, history)` returns the next Call, or None.
        library: Has the task's objects.
        name: What the record calls the agent; by default its class's name.
        noise: As in open_episode().
        headline: As in open_episode().
        run: As in open_episode().
        pictures: Whether the agent looks at any. Without, it is faster; the texts are the same.
        perceiver: As in open_episode().
        renderer: One that is running already; by default one is started, and ended afterwards.

    Raises:
        NoGraphicsDriver: The machine has no Vulkan driver.
        UnknownName: The library lacks an object of the task, or there is no such noise.
        BadData: Both a noise and a headline setting are given.
    """
    called = name or type(agent).__name__
    circumstances = _circumstances(noise, headline, perceiver, run)
    with running(renderer, task.setup.renderer) as drawing:
        return _play(
            task,
            agent,
            called,
            library,
            drawing,
            circumstances,
            pictures=pictures,
            perceiver=perceiver,
        )


def _circumstances(
    noise: Noise | NoiseName, headline: HeadlineErrors | None, perceiver: Perceiver, run: int
) -> Circumstances:
    hand, conditions = noise_of(noise), AS_FROZEN
    if headline is not None:
        if hand != NO_NOISE:
            raise BadData(
                "headline", "has a noise of its own", "Give a noise or a headline setting"
            )
        hand, conditions = tool_errors(headline, "own", AS_FROZEN, oracle=perceiver is ideal)
    return Circumstances(run, hand, conditions, perception=used_by(perceiver))


def score(
    task: Task, record: EpisodeRecord, library: Library, *, renderer: Renderer | None = None
) -> Score:
    """Grade an episode from its record alone, without physics.

    Args:
        task: What the record is about.
        record: Of play(), of an open episode, or of read_records().
        library: Has the task's objects.
        renderer: One that is running already; by default one is started, and ended afterwards.

    Raises:
        OtherTask: The record is about another task.
    """
    with running(renderer, task.setup.renderer) as drawing:
        load_scene(drawing, task.scene, library)
        return _score(task, record, drawing)


def replay(
    task: Task,
    record: EpisodeRecord,
    library: Library,
    *,
    perceiver: Perceiver = ideal,
    renderer: Renderer | None = None,
) -> tuple[EpisodeRecord, list[str]]:
    """Repeat a record's calls on a fresh table.

    Args:
        task: What the record is about.
        record: Of an agent without a pointing model, on the task as it was frozen.
        library: Has the task's objects.
        perceiver: What the tools saw with, if names came from an enrolment.
        renderer: One that is running already; by default one is started, and ended afterwards.

    Returns:
        The new record, and where it differs from the first, in words; nothing if the two are the
        same byte for byte, times apart.

    Raises:
        OtherTools: Tools of another version made the record.
        PerceptionDiffers: Its names came from another enrolment.
    """
    with running(renderer, task.setup.renderer) as drawing:
        again = replay_afresh(task, record, library, drawing, perceiver)
    return again, differences(record, again)
