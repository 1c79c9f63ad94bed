"""Tables for training a model by reward."""

from __future__ import annotations

from pathlib import Path

from probe.api.resources import cache_folder, everything
from probe.episodes.conditions import AS_FROZEN
from probe.episodes.noise import Noise
from probe.episodes.participation import Points
from probe.episodes.tool_errors import NoiseChoice, tool_errors
from probe.interfaces.training.tables import MOST, TrainingTables
from probe.runs.episode_worker import EpisodeWorkerSetup
from probe.runs.plan import RunOrder
from probe.tasks.suite import Suite, check_objects
from probe.transcripts.prompts import Graphs, told_with


def training_tables(
    suite: Suite,
    *,
    name: str = "learner",
    points: Points = "pixels",
    graphs: Graphs = "short",
    noise: Noise | NoiseChoice = "own",
    tables: int = MOST,
    out: str | Path | None = None,
    evaluation: bool = False,
) -> TrainingTables:
    """Tables for a trainer that learns from rewards, in the setting "text-only"; see ProbeEnv.

    Args:
        suite: Tasks for training; see load_suite().
        name: Of the model, for the records.
        points: How the model counts places; "0-1000" needs ProbeEnvThousandths.
        graphs: "short" or "full": how lists of objects are told.
        noise: How far the hand misses where it is sent; see run().
        tables: Episodes that may be under way at once; each has a process.
        out: Folder for the records, which `probe rescore` grades again; None to keep none.
        evaluation: Take tasks of evaluation, too, to measure a model that is never trained on them.

    Raises:
        NotForTraining: A task belongs to evaluation.
        BadData: The folder is about another suite, or another run is at work there.
    """
    check_objects(suite, everything())
    setting = told_with("text-only", graphs)
    hand, conditions = tool_errors(suite.headline, noise, AS_FROZEN, setting=setting)
    order = RunOrder(name, noise=hand, conditions=conditions, setting=setting, points=points)
    setup = EpisodeWorkerSetup(order, everything, cache_folder())
    return TrainingTables(
        suite,
        setup,
        most=tables,
        out=None if out is None else Path(out),
        evaluation=evaluation,
    )
