"""A selection retold for students that see no pictures: the setting "text-only"."""

from __future__ import annotations

from dataclasses import replace

from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.train.choose.chosen import LoadedSelection
from probe.train.dataset.showing import EpisodePictures
from probe.transcripts.messages import participation_of
from probe.transcripts.prompts import Graphs, graphs_of, setting_named, told_with

_OPTION = "--setting text-only"


def as_text_only(chosen: LoadedSelection, graphs: Graphs) -> LoadedSelection:
    """A selection whose episodes say that their agents saw no picture.

    Args:
        chosen: A teacher's episodes, all with tools.
        graphs: How a student is told lists.

    Raises:
        BadData: An episode has no tools, a model pointed in it, so that lists have no ids, or lists
            were told to its model in another way.
    """
    setting = told_with("text-only", graphs)
    counts = {
        question_type: {setting: sum(settings.values())}
        for question_type, settings in chosen.document.examples.items()
    }
    return replace(
        chosen,
        episodes=tuple((task, _unseen(record, setting)) for task, record in chosen.episodes),
        document=chosen.document.model_copy(update={"examples": counts}),
    )


def no_pictures(record: EpisodeRecord) -> EpisodePictures:
    """What an episode shows in which nobody sees anything."""
    return EpisodePictures((), (None,) * len(record.steps))


def _unseen(record: EpisodeRecord, setting: str) -> EpisodeRecord:
    if record.setting not in ("", "agentic", setting):
        reason = f"{record.task} was played in the setting {record.setting}"
        remedy = "Select episodes with tools alone, without --pointer: --direct-share 0"
        if setting_named(record.setting) == "text-only":
            remedy = f"Say --graphs {graphs_of(record.setting)}, as its model was told lists"
        raise BadData(_OPTION, reason, remedy)
    return replace(record, participation=replace(participation_of(record), setting=setting))
