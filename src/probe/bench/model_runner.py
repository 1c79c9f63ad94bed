"""Seats a model at the tables of a plan: one sample is one episode, its record is written down."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import replace

from anyio import Lock
from anyio.to_thread import run_sync
from inspect_ai.model import CachePolicy, Model, get_model, model_roles
from inspect_ai.tool import ToolInfo
from inspect_ai.util import LimitExceededError

from probe.bench.conversation import in_words, with_tools
from probe.bench.finished import FinishedEpisode
from probe.bench.model_conversation import ModelConversation
from probe.bench.plan import Done, ModelRunPlan, lacking, taken_up
from probe.bench.pointing import Pointing
from probe.bench.prices import Price
from probe.bench.process import AskPointer
from probe.bench.process_pool import Assignment, EpisodeProcessLost, EpisodeProcessPool
from probe.bench.stopping import HOPELESS, RunStopped, SilenceLimit
from probe.bench.usage import EpisodeUsage
from probe.bench.wire import first_messages, tool_infos
from probe.episodes.files import line_of
from probe.episodes.folder import add_line
from probe.episodes.grading import question_of
from probe.episodes.participation import has_tools
from probe.errors import BadData, ModelFailed, ProbeError
from probe.runs.episode_worker import EpisodeWorkerSetup
from probe.runs.plan import Job, RunOrder
from probe.runs.work import failed
from probe.runs.worker_messages import (
    EpisodeFinished,
    FinishEpisode,
    GradeRecord,
    NoReply,
    PointerRequest,
)
from probe.toolshed.result import Answer
from probe.transcripts.messages import opening

ROLE = "pointer"
_GIVEN = f"--model-role {ROLE}"


class ModelRunner:
    """Everything of a plan that lives while it is run; nothing is started before the first sample.

    Args:
        plan: What is run.
        place_of: Makes what each table's process is told.
    """

    def __init__(
        self, plan: ModelRunPlan, place_of: type[EpisodeWorkerSetup] = EpisodeWorkerSetup
    ) -> None:
        self._plan = plan
        self._place_of = place_of
        self._tasks = {task.id: task for task in plan.tasks}
        self._lock: Lock | None = None
        self._pool: EpisodeProcessPool | None = None
        self._order: RunOrder | None = None
        self._done: Done = {}
        self._replies = ""
        self._folder = ExitStack()
        self._patience, self._over = SilenceLimit(), 0
        self.stopped: ProbeError | None = None

    def take_up(self, order: RunOrder) -> int:
        """Take up the folder, for this process alone; gives how many episodes it lacks.

        Raises:
            BadData: It is about something else, or another run is at work there.
            OutputFailed: It can't be written.
        """
        folder = taken_up(self._plan, order)
        self._done, self._replies = self._folder.enter_context(folder)
        self._order = order
        return lacking(self._plan, self._done)

    async def play(self, task: str, run: int, model: Model) -> FinishedEpisode:
        """One episode, or what an earlier run made of it.

        Args:
            task: Its id.
            run: Number of the run.
            model: Who acts.

        Raises:
            Stopped: Nothing can be played; `stopped` is the reason.
        """
        if self.stopped is not None:
            raise RunStopped(str(self.stopped))
        try:
            played = await self._play(task, run, model)
        except HOPELESS as error:
            self.stopped = error
            self._folder.close()
            raise RunStopped(str(error)) from error
        self._over += 1
        if self._over == len(self._plan.tasks) * self._plan.epochs:
            self._folder.close()
        return played

    def close(self) -> None:
        """End the processes that nobody uses, and leave the folder to others."""
        self._folder.close()
        if self._pool is not None:
            self._pool.close()

    async def _play(self, task: str, run: int, model: Model) -> FinishedEpisode:
        order = await self._open(model)
        job = Job(self._tasks[task], run)
        assert self._pool is not None
        line = self._done.get((task, run))
        if line is not None:
            async with self._pool.seat(_nobody) as assignment:
                return FinishedEpisode(await assignment.grade(GradeRecord(job, line)), None)
        episode_usage = EpisodeUsage()
        conversation = self._listener(job, model, episode_usage)
        limit = None
        try:
            left, limit = await self._played(job, order, conversation, model, episode_usage)
        except EpisodeProcessLost as error:
            # What was done at the lost table can't be told any more.
            seat = replace(conversation.seat(order.setting, order.points), replies=())
            record = replace(failed(job, order, str(error)), participation=seat)
            left = EpisodeFinished(line_of(record), None)
        await run_sync(add_line, self._plan.out, left.line)
        played = FinishedEpisode(left, conversation, limit)
        # Where the user's limit ended it, it isn't for the model's silence.
        self._patience.heard(conversation.unheard and limit is None, played.record.fault)
        return played

    async def _open(self, model: Model) -> RunOrder:
        """Take up the folder, if nobody has, and be ready for tables."""
        self._lock = self._lock or Lock()
        async with self._lock:
            plan = self._plan
            if self._order is None:
                order = plan.order(str(model), self._pointer_name())
                await run_sync(self.take_up, order)
            order = self._order
            assert order is not None
            if self._pool is None:
                place = self._place_of(
                    order,
                    plan.library,
                    plan.cache,
                    convention=plan.convention,
                    perceiver=plan.perceiver,
                    tables=plan.tables,
                )
                pointing = plan.pointer != "oracle"
                self._pool = EpisodeProcessPool(place, plan.workers, pointing=pointing)
            return order

    def _pointer_name(self) -> str:
        """Of the one that points; the harness leaves a role aside that nobody asks for."""
        pointer, given = self._plan.pointer, ROLE in model_roles()
        if given and self._plan.setting != "agentic":
            reason = "nothing is pointed at without tools and pictures"
            raise BadData(_GIVEN, reason, "Leave it out")
        if given and pointer != "role":
            raise BadData(_GIVEN, f"the pointer is {pointer}", "Say -T pointer=role, too")
        if pointer == "role" and not given:
            raise BadData("-T pointer=role", "nobody has this role", f"Say {_GIVEN}=NAME, too")
        return str(get_model(role=ROLE)) if given else pointer.removeprefix("oracle")

    def _listener(self, job: Job, model: Model, episode_usage: EpisodeUsage) -> ModelConversation:
        plan = self._plan
        scopes = {"folder": self._replies, "episode": f"{job.task.id} {job.run}"}
        scale, tools = job.task.scale, list[ToolInfo]()
        if has_tools(plan.setting):
            tools = tool_infos(plan.points, scale, plan.setting)
        cache = CachePolicy(expiry=None, scopes=scopes)
        return ModelConversation(model, tools, [], cache, self._price(model), episode_usage)

    def _pointing(self, model: Model, episode_usage: EpisodeUsage) -> AskPointer:
        if self._plan.pointer == "oracle":
            return _nobody
        pointer = model if self._plan.pointer == "self" else get_model(role=ROLE)
        cache = CachePolicy(expiry=None, scopes={"folder": self._replies, "role": ROLE})
        price = self._price(model) if pointer is model else self._plan.prices.get(str(pointer))
        return Pointing(pointer, episode_usage, cache, price)

    def _price(self, model: Model) -> Price | None:
        prices = self._plan.prices
        return prices.get(self._plan.called or "") or prices.get(str(model))

    async def _played(
        self,
        job: Job,
        order: RunOrder,
        conversation: ModelConversation,
        model: Model,
        episode_usage: EpisodeUsage,
    ) -> tuple[EpisodeFinished, LimitExceededError | None]:
        """What came of an episode, and which limit of the user's ended it, if one did."""
        assert self._pool is not None
        plan = self._plan
        async with self._pool.seat(self._pointing(model, episode_usage)) as assignment:
            shown = await assignment.sit(job)
            question = question_of(job.task)
            first = opening(plan.setting, plan.points, question, shown.pictures, job.task.scale)
            conversation.messages += first_messages(first)
            answer, fault, limit = None, None, None
            try:
                answer = await self._answered(job, conversation, assignment)
            except LimitExceededError as error:
                # The user's own limit: an episode without an answer, not a fault of ours.
                limit = error
            except ModelFailed as error:
                fault = str(error)
            seat = conversation.seat(order.setting, order.points, assignment.failures)
            return await assignment.leave(FinishEpisode(seat, answer, fault)), limit

    async def _answered(
        self, job: Job, conversation: ModelConversation, assignment: Assignment
    ) -> Answer | None:
        plan = self._plan
        if has_tools(plan.setting):
            await with_tools(conversation, assignment, plan.points, plan.graphs)
            return None
        return await in_words(conversation, plan.setting, job.task, plan.points)


async def _nobody(asked: PointerRequest) -> NoReply:
    return NoReply("nobody points")
