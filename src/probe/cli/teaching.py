"""Who teaches, with which objects, for `probe collect`; as the command line has it."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

from probe.api.resources import TRAINING_POOL, Pool, opener
from probe.assets.pools.split import read_split
from probe.bench.models import settings_of
from probe.episodes.conditions import Conditions, LightKind, RendererKind
from probe.episodes.noise import NoiseName
from probe.episodes.participation import Points
from probe.toolshed.version import TOOLS_VERSION
from probe.train.collect.settings import CollectionSettings
from probe.train.collect.teacher import TEACHER
from probe.train.collect.training import Training
from probe.transcripts.prompts import Graphs

WORKERS = 2
"""Processes of this machine, if nobody says otherwise."""


@dataclass(frozen=True)
class TeachingSetup:
    """Who teaches, with which objects, and under which conditions.

    Attributes:
        model: A model that teaches, by a name of docs/how-to/models.md or the harness's own; by
            default the scripted teacher, which gives its reasons in words.
        endpoint: Address of a server that speaks OpenAI's protocol.
        prices: A file that says what tokens cost.
        points: How coordinates are written; by default as suits the model, or in pixels.
        graphs: How perceive_scene's lists are told to a model that teaches without pictures: "full"
            (the default) or "short".
        pool: Which objects appear, by default those for training; records and data sets say so if
            others do.
        split: Take the training part of this split alone (`probe assets split`).
        noise: How far the hand errs.
        lighting: Of the pictures.
        renderer: What draws the pictures: as tasks are made, which is Filament, or another; blender
            needs the extra of that name, and more time.
        workers: Processes; by default 2, and on a cluster one on each core.
    """

    model: str | None = None
    endpoint: str | None = None
    prices: Path | None = None
    points: Points | None = None
    graphs: Graphs | None = None
    pool: Pool = TRAINING_POOL
    split: Path | None = None
    noise: NoiseName = "none"
    lighting: LightKind = "own"
    renderer: RendererKind = "own"
    workers: int | None = None

    @property
    def counting(self) -> Points:
        """How places are counted."""
        return self.points or (settings_of(self.model).points if self.model else "pixels")

    @property
    def training(self) -> Training:
        """Opens the objects.

        Raises:
            BadData: The split can't be read.
        """
        return Training(opener(self.pool), self.split and read_split(self.split))

    @property
    def conditions(self) -> Conditions:
        """In what episodes differ from tasks."""
        return Conditions(lighting=self.lighting, renderer=self.renderer)

    def settings(self, shard: str, first: int) -> CollectionSettings:
        """What must stay the same in a folder.

        Args:
            shard: Which part of the tasks.
            first: Number of the first episode.
        """
        mark = None
        if self.split is not None:
            # Opening it says what is wrong with it, if something is.
            self.training()
            mark = hashlib.sha256(self.split.read_bytes()).hexdigest()[:16]
        return CollectionSettings(
            agent=self.model or TEACHER,
            pool=self.pool,
            split=mark,
            points=self.counting,
            graphs=self.graphs or "full",
            noise=self.noise,
            # As it was called before a task could stand in another light than an even one.
            lighting="ambient" if self.lighting == "own" else self.lighting,
            renderer=self.renderer,
            shard=shard,
            first=first,
            tools=TOOLS_VERSION,
        )
