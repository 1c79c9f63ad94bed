"""Tells one episode again in one of the ways in which that may be done."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Literal

import numpy as np

from probe.agents.phrases import PhraseBook, Say
from probe.episodes.record import EpisodeRecord
from probe.scene.seeds import generator
from probe.tasks.task import Task
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listed_ids import without_finding
from probe.train.dataset.augment.mirrored import mirrored
from probe.train.dataset.augment.recolouring import recoloured
from probe.train.dataset.augment.refusing import with_a_slip
from probe.train.dataset.augment.renaming import Descriptions, renamed
from probe.train.dataset.augment.renumbering import renumbered
from probe.train.dataset.augment.reordering import reordered
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.resizing import resized
from probe.train.dataset.augment.rewording import reworded
from probe.train.dataset.augment.speech import Speech
from probe.train.dataset.augment.thinning import thinned

_AskedAgain = Literal["phrases", "options", "names", "ids", "colours", "sizes", "fewer"]
AugmentationWay = Literal["mirrored", "wordings", "refused"] | _AskedAgain
"""How an episode may be told again: mirrored left to right, asked in other words, with other
phrases of its teacher, with its options or marks under other letters, with other names of all
things, with other object_ids, with other colours (Compare), with other sizes of the marked things
(Size), with fewer things on the table, or with a call that is refused."""

SHORT_ALONE: tuple[AugmentationWay, ...] = "sizes", "fewer"
"""Ways for short lists alone: a full one also tells which parts of the table are cluttered or clear
and what is near what, by boxes' distances."""

_Retell = Callable[[Task, EpisodeRecord, np.random.Generator, Say], tuple[Task, EpisodeRecord]]
_RETELL: Mapping[AugmentationWay, _Retell] = {
    "options": reordered,
    "ids": renumbered,
    "colours": recoloured,
    "sizes": resized,
    "fewer": thinned,
}


_VARYING: tuple[_AskedAgain, ...] = ("names", "sizes")


@dataclass(frozen=True)
class Teller:
    """Tells episodes again.

    Attributes:
        seed, speech, ways: As in augmented().
        known: Names that things may have.
    """

    seed: int
    speech: Speech
    ways: Collection[AugmentationWay]
    known: Descriptions

    def several(
        self, way: AugmentationWay, task: Task, record: EpisodeRecord, often: int
    ) -> list[tuple[Task, EpisodeRecord]]:
        """An episode told so often, each time otherwise; what comes out the same is left out.

        Raises:
            NotCertain: It can't be told so even once, or comes out as it was.
        """
        told, doubts = list[tuple[Task, EpisodeRecord]](), list[NotCertain]()
        as_it_went = task, self._shown(record)
        for time in range(often):
            try:
                again = self._once(way, *self._varied(task, record, time), time)
            except NotCertain as doubt:
                doubts.append(doubt)
                continue
            if again not in (as_it_went, *told):
                told.append(again)
        if not told:
            raise doubts[0] if doubts else NotCertain(record.task, "it comes out the same")
        return told

    def _varied(self, task: Task, record: EpisodeRecord, time: int) -> tuple[Task, EpisodeRecord]:
        """From the second time on with other names and sizes, if these are among the ways.

        Then the answer to an episode that is told often can't be learnt by heart. As it was, where
        that isn't certain.
        """

        def rng(name: str) -> np.random.Generator:
            return generator(self.seed, f"varied {name}", task.id, record.run, time)

        again = task, record
        for way in _VARYING if time else ():
            if way in self.ways:
                with suppress(NotCertain):
                    again = self._said(way, *again, rng)
        return again

    def _once(
        self, way: AugmentationWay, task: Task, record: EpisodeRecord, time: int
    ) -> tuple[Task, EpisodeRecord]:
        def rng(name: str) -> np.random.Generator:
            # The first time is as without balance.
            return generator(self.seed, name, task.id, record.run, *([time] if time else []))

        match way:
            case "mirrored":
                return task, mirrored(task, self._shown(record))
            case "wordings":
                return task, reworded(task, self._shown(record), rng("wording"))
            case "refused":
                say = self.speech.words(PhraseBook(rng("refused phrases")))
                return task, with_a_slip(self._shown(record), rng("refused"), say)
            case _:
                task, again = self._said(way, task, record, rng)
                return task, self._shown(again)

    def _shown(self, record: EpisodeRecord) -> EpisodeRecord:
        return record if self.speech.find else without_finding(record)

    def _said(
        self,
        way: _AskedAgain,
        task: Task,
        record: EpisodeRecord,
        rng: Callable[[str], np.random.Generator],
    ) -> tuple[Task, EpisodeRecord]:
        """An episode whose teacher is asked again what it would say."""
        drawn = "phrases" if way == "phrases" else f"{way} phrases"
        phrases = speaker(task, record.run) if way == "options" else PhraseBook(rng(drawn))
        say = self.speech.words(phrases)
        if way == "names":
            return renamed(task, record, rng("names"), say, self.known)
        if way == "phrases":
            return task, rephrased(task, record, say)
        return _RETELL[way](task, record, rng(way), say)
