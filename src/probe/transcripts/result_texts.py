"""What a model reads of its calls' results, one after another. Knows no server and no pictures."""

from __future__ import annotations

from probe.episodes.participation import Points
from probe.transcripts.coordinates import told
from probe.transcripts.prompts import Graphs
from probe.transcripts.short_results import ShortResults


class ResultTexts:
    """The results of one episode as a model reads them, for asking and for training.

    Args:
        points: How the model counts places.
        graphs: How lists are told to it.
    """

    def __init__(self, points: Points, graphs: Graphs = "full") -> None:
        self._points: Points = points
        self._short = ShortResults() if graphs == "short" else None

    def told(self, tool: str, text: str) -> str:
        """What the model reads of the next result.

        Args:
            tool: That was called; each call of the episode has to be told, in order.
            text: As the tool gave it and the record keeps it.
        """
        said = text if self._short is None else self._short.shortened(tool, text)
        return told(said, self._points)
