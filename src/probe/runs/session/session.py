"""A session from its first table to its last: lay, seal, play, open, write down; and again."""

from __future__ import annotations

from dataclasses import asdict

from probe.episodes.files import append_line, line_of
from probe.episodes.folder import RECORDS
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData, ProbeError, RobotLost
from probe.runs.session.events import Begun, Ended, Opened, Reasoned, Sealed, Unblinded, Verdict
from probe.runs.session.laying import laid
from probe.runs.session.log import SessionLog
from probe.runs.session.operator import ask_in_words
from probe.runs.session.order import Slot, slots_of
from probe.runs.session.playing import played
from probe.runs.session.resources import Robot, SessionResources
from probe.runs.session.seal import Truth, seal_of
from probe.runs.session.standing import SlotState, digest_of, digests_in, repair_of, state_of

Tables = tuple[tuple[str, int, tuple[str, ...]], ...]


class RobotSession:
    """Goes on where its log ends.

    Args:
        begun: What it is to be.
        resources: What it works with.

    Raises:
        BadData: The folder's session is another one, or its log can't be trusted.
    """

    def __init__(self, begun: Begun, resources: SessionResources) -> None:
        self._with = resources
        self._operator = resources.operator
        self._slots = slots_of(begun.plan, begun.agents)
        self._log = SessionLog(resources.out)
        if not self._log.events:
            self._log.add(begun)
        elif self._log.events[0] != begun:
            reason = "is of another session, or its agents or its suite have changed"
            raise BadData(resources.out, reason, "Say the same again, or choose another folder")

    def run(self) -> None:
        """Play what is left, then tell who was who.

        Raises:
            KeyboardInterrupt: The operator pauses; all that is over is written down.
        """
        self._repair()
        for slot in self._slots:
            while not self._state(slot).over:
                self._once(slot)
        tables = tables_of(self._slots)
        if not isinstance(self._log.events[-1], Unblinded):
            self._log.add(Unblinded(agents=tables))
        for task, run, names in tables:
            who = ", ".join(f"{number} was {name}" for number, name in enumerate(names, start=1))
            self._operator.tell(f"{task}, run {run}: agent {who}.")

    def _state(self, slot: Slot) -> SlotState:
        return state_of(slot, self._log.events)

    def _repair(self) -> None:
        """End what the log left in its midst, and ask for the words that it lacks."""
        there = digests_in(self._with.out)
        for slot in self._slots:
            if event := repair_of(slot, self._state(slot), there):
                self._log.add(event)
            if not self._state(slot).settled:
                self._operator.tell(f"{self._words(slot)} was broken off or isn't written up.")
                self._reason(slot)

    def _once(self, slot: Slot) -> None:
        task = self._with.suite[slot.task]
        self._operator.tell(f"{self._words(slot)}.")
        try:
            with self._with.robot(task) as robot:
                truth = laid(task, robot, self._with)
                self._log.add(Sealed(of=slot.key, seal=seal_of(truth)))
                self._operator.tell(f"Sealed: {seal_of(truth)}. Keep clear of the arm.")
                stopped = self._play(slot, robot, truth)
        except RobotLost as error:
            self._operator.tell(f"The robot is lost: {error}")
            self._operator.ask("Enter tries again, Ctrl-C pauses the session: ")
            return
        self._reason(slot)
        if stopped:
            raise KeyboardInterrupt

    def _play(self, slot: Slot, robot: Robot, truth: Truth) -> bool:
        """One try; returns whether the operator stopped it."""
        its, task = self._with, self._with.suite[slot.task]
        opened = Opened(**asdict(truth))
        try:
            agent = its.agents[slot.agent](slot.agent, task, slot.run, its.things, its.renderer)
            with robot.acting() as station:
                record, stopped = played(
                    task, slot, agent, station, its.perceiver, its.out, robot.film
                )
        except ProbeError as error:
            fault = f"{type(error).__name__}: {error}"
            self._log.add(Ended(of=slot.key, verdict="interrupted", fault=fault, opened=opened))
            self._operator.tell(f"Interrupted before the first picture: {error}")
            return False
        line, verdict = line_of(record), verdict_of(record, truth)
        letter = record.answer.choice if record.answer else None
        self._log.add(
            Ended(
                of=slot.key,
                verdict=verdict,
                record=digest_of(line),
                answer=letter,
                fault=record.fault,
                opened=opened,
            )
        )
        append_line(its.out / RECORDS, line)
        said = f"answers {letter}" if letter else f"gives no answer ({record.fault or record.end})"
        self._operator.tell(f"Agent {slot.number} {said}: {verdict}.")
        return stopped

    def _reason(self, slot: Slot) -> None:
        words = ask_in_words(self._operator, "What happened on the table, and why? ")
        self._log.add(Reasoned(of=slot.key, words=words))

    def _words(self, slot: Slot) -> str:
        tasks, tries = [task.id for task in self._with.suite.tasks], self._state(slot).tries
        return (
            f"Table {tasks.index(slot.task) + 1} of {len(tasks)} ({slot.task}), run {slot.run}, "
            f"agent {slot.number} of {len(self._with.agents)}"
        ) + (f", after {tries} tries" if tries else "")


def verdict_of(record: EpisodeRecord, truth: Truth) -> Verdict:
    """What a record is worth by the sealed truth."""
    if record.end == "fault":
        return "interrupted"
    said = record.answer.choice if record.answer else None
    return "right" if said == truth.answer else "wrong"


def tables_of(slots: tuple[Slot, ...]) -> Tables:
    """Task and run of each table, and its agents in the order of their numbers."""
    tables = dict.fromkeys((slot.task, slot.run) for slot in slots)
    return tuple(
        (task, run, tuple(it.agent for it in slots if (it.task, it.run) == (task, run)))
        for task, run in tables
    )
