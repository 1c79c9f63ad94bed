"""The environment for models that count places in thousandths, as Qwen3-VL and our students do."""

from __future__ import annotations

from probe.episodes.participation import Points
from probe.interfaces.training.environment import ProbeEnv, as_tool
from probe.tasks.task import Letter


class ProbeEnvThousandths(ProbeEnv):
    """A ProbeEnv for a model that counts places from 0 to 1000, over a picture's width and height.

    The same but for places, in what tools are told and what they reply; records have pixels.

    Args:
        tables: See probe.training_tables; made with points="0-1000".

    Raises:
        BadData: The tables count places otherwise.
    """

    _points: Points = "0-1000"

    @as_tool
    def find_object(self, description: str) -> str:
        """Get object_id, description and box of one object that shows.

        Args:
            description: What it looks like ("red mug"), or where it is: "(u, v)" in thousandths of the picture's width and height.
        """  # noqa: E501 - an argument's description is one line
        ...

    @as_tool
    def answer_question(self, choice: Letter, point: list[float] | None = None) -> str:
        """Give the final answer, once.

        Args:
            choice: Letter of an option.
            point: Only if you are asked to point: [u, v] in thousandths of the picture's width and height on that object.
        """  # noqa: E501 - an argument's description is one line
        ...
