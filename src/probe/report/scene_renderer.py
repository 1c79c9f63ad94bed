"""Photographs the tables of a suite; what that takes is loaded when it is first needed."""

from __future__ import annotations

from collections.abc import Callable
from types import TracebackType

import numpy as np

from probe.assets.library import Library
from probe.episodes.grading import grade_episode, needs_labels
from probe.episodes.record import EpisodeRecord
from probe.render.lighting import light_of
from probe.render.photograph import load_scene, photograph
from probe.render.renderer import Renderer
from probe.render.renderers import Renderers
from probe.scene.scene import Scene
from probe.scene.setup import RendererName
from probe.scene.viewpoint import Viewpoint
from probe.tasks.grading import Score
from probe.tasks.suite import Suite, check_objects, part
from probe.tasks.task import Task
from probe.types import Frame


class SceneRenderer:
    """Draws and grades what happened at a suite's tables. Use it as a context manager.

    Args:
        suite: Whose tables.
        open_library: Opens the library that has the suite's objects.
    """

    def __init__(self, suite: Suite, open_library: Callable[[], Library]) -> None:
        self._suite = suite
        self._open_library = open_library
        self._renderers = Renderers()
        self._library: Library | None = None
        self._loaded_in: dict[str, str] = {}
        self._last: tuple[tuple[Scene, Viewpoint], Frame] | None = None

    def __enter__(self) -> SceneRenderer:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._renderers.__exit__(kind, error, trace)

    def frame(self, task: Task, scene: Scene, viewpoint: Viewpoint, *, rgb: bool = True) -> Frame:
        """A task's table as it stood in a scene of a record and was seen; the last one is kept.

        Raises:
            BadData: An object isn't what it was when the suite was made.
        """
        if self._last and self._last[0] == (scene, viewpoint):
            kept = self._last[1]
            if kept.rgb is not None or not rgb:
                return kept
        renderer, library = self._loaded(task, viewpoint.renderer if rgb else "filament")
        light = light_of(viewpoint.lighting, library.assets)
        found = photograph(renderer, scene, rgb=rgb, camera=viewpoint.camera, light=light)
        self._last = (scene, viewpoint), found
        return found

    def score(self, task: Task, record: EpisodeRecord) -> Score:
        """What an episode is worth; only what a grade depends on is drawn.

        Raises:
            OtherTask: The record is about something else, or the task has changed since.
        """
        labels = np.zeros((0, 0), np.uint8)
        if needs_labels(task, record):
            drawn = self.frame(task, record.scenes[-1], record.viewpoint, rgb=False).labels
            assert drawn is not None
            labels = drawn
        return grade_episode(task, record, labels)

    def _loaded(self, task: Task, name: RendererName) -> tuple[Renderer, Library]:
        if self._library is None:
            self._library = self._open_library()
        renderer = self._renderers[name]
        if self._loaded_in.get(name) != task.id:
            check_objects(part(self._suite, task), self._library)
            load_scene(renderer, task.scene, self._library)
            self._loaded_in[name], self._last = task.id, None
        return renderer, self._library
