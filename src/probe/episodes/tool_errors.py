"""How far tools err in a run: as its suite says, or as somebody asks."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Literal

from probe.episodes.conditions import NO_DIALS, Conditions
from probe.episodes.noise import NO_NOISE, NOISES, Noise, NoiseName
from probe.episodes.participation import has_pointer, has_tools
from probe.episodes.record import EpisodeRecord
from probe.perception.dials import Dials
from probe.tasks.headline import HeadlineErrors

NoiseChoice = Literal["own", NoiseName]
"""A hand's errors by name; "own": tools err as the suite says, or not at all if it says nothing."""

HEADLINE = HeadlineErrors(
    NOISES["paper"].grasp, NOISES["paper"].push, Dials(over=0.14, under=0.08, general=1.0)
)
"""Of new suites: the paper's hand, and a detector that errs as often as our RGB-D segmenter and
tells kinds of things, so that no answer is to be copied from its lists.

On 14 tables of evaluation objects in the light of rooms (seeds 980000 on) it cut 28 of 198 objects
that are seen in two, merged 15 with a neighbour, missed none and made none up
(`benchmarks/internals/detector_errors.py`). The paper gives no rates of perception.
"""


def tool_errors(
    headline: HeadlineErrors | None,
    noise: Noise | NoiseChoice,
    conditions: Conditions,
    *,
    setting: str = "",
    oracle: bool = True,
) -> tuple[Noise, Conditions]:
    """How far the hand errs in a run, and its conditions with how often the detector does.

    Args:
        headline: The errors of the suite's headline setting; None if it has none.
        noise: What was asked for; a Noise is the hand's, whatever the suite says.
        conditions: Likewise; rates of a detector's errors that were asked for stay.
        setting: How the agent may answer; where it has no tools, the headline setting adds nothing.
        oracle: Whether perception is the ideal detector, whose errors are added.
    """
    if isinstance(noise, Noise):
        return noise, conditions
    if noise != "own":
        return NOISES[noise], conditions
    if headline is None or not has_tools(setting):
        return NO_NOISE, conditions
    asked = conditions.dials != NO_DIALS or conditions.ideal == "perception"
    if oracle and not asked:
        conditions = replace(conditions, dials=headline.dials)
    return Noise(headline.grasp, headline.push), conditions


def label_of(record: EpisodeRecord, headline: HeadlineErrors | None, setting: str) -> str:
    """In what an episode differs from the headline setting of its suite, in a few words.

    Of a suite without one: from its task and the usual perception. A robot's hand errs by itself,
    and so does a model that points; nothing is said of them.

    Args:
        record: The episode.
        headline: Of its suite.
        setting: How the agent was allowed to answer.
    """
    if headline is None or not has_tools(setting):
        return record.label
    dials, noise = record.conditions.dials, Noise(headline.grasp, headline.push)
    if dials == headline.dials:
        record = replace(record, conditions=replace(record.conditions, dials=NO_DIALS))
    hand = "" if record.frames or record.noise == noise else _hand(record.noise)
    errs = dials != NO_DIALS or bool(record.perception.label) or has_pointer(setting)
    eye = "" if errs or headline.dials == NO_DIALS else "ideal detector"
    return ", ".join(filter(None, (record.label, hand, eye)))


def hands_words(records: Iterable[EpisodeRecord], headline: HeadlineErrors | None) -> str:
    """What to say where hands err by different amounts; empty if they err alike.

    Args:
        records: Of all results that stand side by side; a robot's hand is left out, for nobody
            knows how far it errs.
        headline: Of their suite; with one, each result's setting tells how it differs from that.
    """
    hands = {it.noise for it in records if it.manipulations and not it.frames}
    if headline is not None or len(hands) < 2:
        return ""
    several = "; ".join(_hand(it) for it in sorted(hands, key=lambda it: (it.grasp, it.push)))
    return (
        f"In these results the hand errs by different amounts ({several}). A difference may come "
        "from that"
    )


def _hand(noise: Noise) -> str:
    if noise == NO_NOISE:
        return "ideal hand"
    return f"hand off by {1000 * noise.grasp:g} mm, pushing by {1000 * noise.push:g} mm"
