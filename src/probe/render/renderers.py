"""One renderer of each kind, started when it is first asked for."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from types import TracebackType
from typing import Literal

from probe.render.renderer import Renderer
from probe.scene.setup import RendererName


class Renderers:
    """Renderers by what draws colour. Use it as a context manager.

    Args:
        cache: Folder for prepared light, as a Renderer has it.
    """

    def __init__(self, cache: Path | None = None) -> None:
        self._cache = cache
        self._open = ExitStack()
        self._started: dict[RendererName, Renderer] = {}

    def __enter__(self) -> Renderers:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._open.close()

    def require(self, name: RendererName | Literal["own"]) -> None:
        """See that a renderer can be started here, before anybody needs it.

        Args:
            name: Of the renderer; "own" for whatever tasks were frozen with, and then Filament,
                which draws depth and labels in any case.

        Raises:
            NoGraphicsDriver, MissingExtra: As Renderer.
        """
        _ = self["filament" if name == "own" else name]

    def __getitem__(self, name: RendererName) -> Renderer:
        """The renderer of this name.

        Raises:
            NoGraphicsDriver, MissingExtra: As Renderer.
        """
        if name not in self._started:
            self._started[name] = self._open.enter_context(Renderer(self._cache, name))
        return self._started[name]
