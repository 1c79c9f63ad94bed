"""How the scripted teacher speaks in a data set: with searches or without, in many ways or one."""

from __future__ import annotations

from dataclasses import dataclass, replace

from probe.agents.phrases import Say, plainly
from probe.train.choose.chosen import LoadedSelection
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.listed_ids import SayWithoutFinding
from probe.train.dataset.augment.rephrasing import rephrased


@dataclass(frozen=True)
class Speech:
    """How it speaks.

    Attributes:
        find: Whether it says that it looks for things by find_object; if not, those calls aren't
            told either.
        plain: Whether it says each thing in one way alone.
    """

    find: bool = True
    plain: bool = False

    def words(self, drawn: Say) -> Say:
        """What chooses its words, where this would draw them."""
        chosen = plainly if self.plain else drawn
        return chosen if self.find else SayWithoutFinding(chosen)


AS_TAUGHT = Speech()


def said_otherwise(chosen: LoadedSelection, speech: Speech) -> LoadedSelection:
    """A selection in other words of the teacher; its calls are as they were.

    Args:
        chosen: The scripted teacher's episodes.
        speech: How it speaks.

    Raises:
        NotCertain: Somebody else taught, or the teacher would do something else today.
    """
    said = (
        (task, rephrased(task, record, speech.words(speaker(task, record.run))))
        for task, record in chosen.episodes
    )
    return replace(chosen, episodes=tuple(said))
