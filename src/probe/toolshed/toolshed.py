"""The five tools over one station: checks a call, runs it, says in words what came of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import assert_never

from probe.asking import UnusableReply
from probe.changes.change import Change, Changes
from probe.changes.compare import compare
from probe.changes.sighting import Look, Sighting, including
from probe.perception.matching import Match, match, nearest
from probe.perception.pointer import Finder
from probe.perception.scene_graph import SceneDescriber
from probe.perception.things import Detector, Thing
from probe.scene.setup import Setup
from probe.station.station import Station
from probe.toolshed.answer_form import ANY_ANSWER, AnswerForm
from probe.toolshed.bystanders import bystander_words
from probe.toolshed.findings import Named, found_text, nearest_text
from probe.toolshed.graph import scene_text, told_text
from probe.toolshed.handles import Handles
from probe.toolshed.outcomes import (
    OutcomeText,
    grasp_words,
    no_grasp_words,
    no_push_words,
    push_words,
)
from probe.toolshed.parse import parse
from probe.toolshed.pictures import outlined
from probe.toolshed.refusals import BudgetSpent, EpisodeOver, PointMissing, Refusal
from probe.toolshed.result import LAST_TURN, Answer, ToolResult
from probe.toolshed.skills import SkillOutcome, Skills
from probe.toolshed.tools import (
    AnswerQuestion,
    FindObject,
    GraspAndRemove,
    PerceiveScene,
    Push,
    Request,
)
from probe.toolshed.view import CurrentView
from probe.types import Array

TURNS = 40
"""Calls in an episode, malformed ones included."""

MANIPULATIONS = 10
"""Grasps and pushes in an episode, failed ones included, unless its question allows fewer."""

_UNREADABLE = (
    "The perception model's reply could not be used: {reason}. Nothing changed on the table. Call "
    "{tool} again, or go by the picture."
)


class Toolshed:
    """One episode's tools.

    It asks the station only for frames, and the detector for what is visible in them. Errors that
    are not the agent's (a dead renderer, an arm left in view) are raised.

    Attributes:
        outcome: What came of the latest manipulation, for people who look for errors; None before
            the first. Agents get its words alone.
    """

    def __init__(
        self,
        station: Station,
        detector: Detector,
        skills: Skills,
        setup: Setup,
        *,
        pictures: bool = True,
        finder: Finder | None = None,
        teller: SceneDescriber | None = None,
        form: AnswerForm = ANY_ANSWER,
        guessed: bool = False,
        budget: int = MANIPULATIONS,
    ) -> None:
        """Set up the tools and look at the table once.

        Args:
            station: The arm, camera and table.
            detector: Names what is visible.
            skills: Grasps and pushes.
            setup: The table's.
            pictures: Whether results carry pictures; texts are the same without.
            finder: Finds what words describe; None to match them with what the detector finds.
            teller: Tells the scene graph; None to make it from what the detector finds.
            form: What a complete answer is; by default any letter without a point.
            guessed: Whether the same thing may be outlined otherwise next time: in two pieces, or
                in one with its neighbour.
            budget: Manipulations in the episode.
        """
        self.answer: Answer | None = None
        self.ended = False
        self.turns = 0
        self.manipulations = 0
        self.outcome: SkillOutcome | None = None
        self._station = station
        self._skills = skills
        self._setup = setup
        self._pictures = pictures
        self._view = CurrentView(station, detector, setup.basket, guessed=guessed)
        self._finder = finder
        self._teller = teller
        self._form = form
        self._budget = budget
        self._asked_for_point = False
        self._handles = Handles(detected=finder is None and not guessed)

    def first_picture(self) -> Array | None:
        """The picture that comes with the question; None if nobody looks at pictures."""
        return self._picture()

    @property
    def look(self) -> Look:
        """What the tools go by now, for people who look for errors; no agent gets it."""
        return self._view.look

    def call(self, name: object, arguments: object) -> ToolResult:
        """Run one call; whatever it is, it takes a turn.

        Args:
            name: Should be the name of a tool.
            arguments: Should be a mapping of its arguments, as parsed from JSON.
        """
        try:
            if self.ended:
                raise EpisodeOver
            self.turns += 1
            result = self._run(parse(name, arguments, self._view.frame.camera.width_px))
        except Refusal as refusal:
            result = ToolResult(str(refusal), status=refusal.status)
        except UnusableReply as failure:
            text = _UNREADABLE.format(reason=failure, tool=name)
            result = ToolResult(text, self._picture(), status="failed")
        if self.turns >= TURNS and self.answer is None and not self.ended:
            result = replace(result, text=f"{result.text}\n{LAST_TURN}")
        self.ended = self.ended or self.answer is not None or self.turns >= TURNS
        return replace(result, ended=self.ended)

    def _run(self, request: Request) -> ToolResult:
        match request:
            case PerceiveScene():
                return self._perceive()
            case FindObject(description=description):
                return self._find(description)
            case GraspAndRemove():
                return self._grasp(request)
            case Push():
                return self._push(request)
            case AnswerQuestion():
                return self._answer(request)
            case _:
                assert_never(request)

    def _perceive(self) -> ToolResult:
        if self._teller is None:
            things = self._view.things
            text = scene_text(things, [name for name, _ in self._issued(things)], self._view.frame)
        else:
            text = told_text(self._teller.tell(self._view.coloured))
        return ToolResult(text, self._picture())

    def _find(self, description: str) -> ToolResult:
        found = self._meant(description)
        if found is None:
            near = self._issued(self._resembling(description))
            return ToolResult(nearest_text(description, near), self._picture(), status="failed")
        text = found_text(found, self._issue)
        picture = outlined(self._view.rgb, found.thing) if self._pictures else None
        return ToolResult(text, picture, point_px=found.thing.point_px)

    def _issued(self, things: Sequence[Thing]) -> list[Named]:
        """Things with their handles."""
        return [(self._issue(thing), thing) for thing in things]

    def _issue(self, thing: Thing) -> str:
        return self._handles.issue(thing, self._view.frame)

    def _noted(self, changes: Changes, seen: Sighting, before: Look) -> tuple[Change, str]:
        """What became of a thing since a look, and of others in words; views and handles follow."""
        self._view.remember(changes)
        renamed = self._handles.follow(changes, before.table, self._view.frame)
        return changes.of(seen), bystander_words(changes, seen, renamed)

    def _handle_now(self, name: str, change: Change) -> str:
        """What a thing that was found on the table is called from now on."""
        if change.after is None or change.fate not in ("stayed", "moved", "turned"):
            return name
        return self._issue(change.after.thing)

    def _resembling(self, description: str) -> tuple[Thing, ...]:
        """What comes near to a description that nothing fits; a model that points says nothing."""
        return nearest(description, self._view.things) if self._finder is None else ()

    def _meant(self, description: str) -> Match | None:
        if self._finder is None:
            return match(description, self._view.things)
        return self._finder.find(description, self._view.coloured)

    def _grasp(self, request: GraspAndRemove) -> ToolResult:
        name, thing = request.object_id, self._take_up(request.object_id)
        before, seen = including(self._view.look, thing)
        outcome = self._skills.grasp_and_remove(
            self._station, before.table, thing.mask, self._setup
        )
        self.outcome = outcome
        if outcome.frame is before.table:
            return self._told(no_grasp_words(outcome.status, name), thing)
        self._view.show(outcome.frame)
        held = seen if outcome.status == "removed" else None
        change, others = self._noted(compare(before, self._view.look, held), seen, before)
        now = self._handle_now(name, change)
        told = grasp_words(outcome.status, name, change, now, outcome.shove)
        return self._told(told, thing, others)

    def _push(self, request: Push) -> ToolResult:
        name, thing = request.object_id, self._take_up(request.object_id)
        before, seen = including(self._view.look, thing)
        asked = request.distance_cm / 100
        outcome = self._skills.push(
            self._station, before.table, thing.mask, request.direction, asked, self._setup
        )
        self.outcome = outcome
        if outcome.frame is before.table:
            return self._told(no_push_words(outcome.status, name), thing)
        self._view.show(outcome.frame)
        change, others = self._noted(compare(before, self._view.look), seen, before)
        now = self._handle_now(name, change)
        told = push_words(outcome.status, name, change, outcome.moved, asked, now)
        return self._told(told, thing, others)

    def _answer(self, request: AnswerQuestion) -> ToolResult:
        """Record an answer.

        Raises:
            NoSuchOption: The question doesn't have its letter.
            PointMissing: It lacks a point; raised once, and never at the last turn.
        """
        last = self._asked_for_point or self.turns >= TURNS
        refusal = self._form.refusal_of(request.choice, request.point, last=last)
        if refusal is not None:
            self._asked_for_point = self._asked_for_point or isinstance(refusal, PointMissing)
            raise refusal
        self.answer = Answer(request.choice, request.point)
        return ToolResult("Your answer is recorded; the episode has ended.")

    def _take_up(self, object_id: str) -> Thing:
        """The thing that a manipulation is about; from here on it counts.

        Raises:
            BudgetSpent: No manipulation is left.
            UnknownHandle: No tool gave out this id.
            StaleHandle: Its pixels have changed.
        """
        if self.manipulations >= self._budget:
            raise BudgetSpent(self._budget)
        thing = self._handles.resolve(object_id, self._view)
        self.manipulations += 1
        return thing

    def _told(self, told: OutcomeText, thing: Thing, others: str = "") -> ToolResult:
        verdict = "Done" if told.worked else "Failed"
        left = f"Manipulations left: {self._budget - self.manipulations}."
        text = " ".join(filter(None, (f"{verdict}:", told.words, others, left)))
        status = "done" if told.worked else "failed"
        return ToolResult(text, self._picture(), status=status, point_px=thing.point_px)

    def _picture(self) -> Array | None:
        return self._view.rgb if self._pictures else None
