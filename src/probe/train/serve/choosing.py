"""How the next token is chosen, by what a model recommends and a request asks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from probe.train.tune import libraries

Process = Callable[[Any, Any], Any]
"""Of all tokens so far (1, n) and scores (1, m), other scores: transformers' LogitsProcessor."""


class Chooser:
    """Chooses a reply's tokens.

    Args:
        recommended: The model's GenerationConfig, which a penalty for repetitions, and at a
            temperature top_k, top_p and min_p are from.
        temperature: At 0 the likeliest is chosen.
        kept_to: What rules tokens out before all that.
    """

    def __init__(
        self, recommended: Any, temperature: float, kept_to: Process | None = None
    ) -> None:
        library = libraries.part("transformers.generation.logits_process")
        asked = [(library.RepetitionPenaltyLogitsProcessor, recommended.repetition_penalty, 1.0)]
        if temperature > 0:
            asked += [
                (library.TemperatureLogitsWarper, float(temperature), 1.0),
                (library.TopKLogitsWarper, recommended.top_k, 0),
                (library.TopPLogitsWarper, recommended.top_p, 1.0),
                (library.MinPLogitsWarper, recommended.min_p, 0.0),
            ]
        made: list[Process] = [
            kind(value) for kind, value, neutral in asked if value not in (None, neutral)
        ]
        self._processes = [*([kept_to] if kept_to else []), *made]
        self._drawn = temperature > 0

    def choose(self, tokens: Sequence[int], scores: Any) -> int:
        """The next token.

        Args:
            tokens: All so far.
            scores: Of each token of the vocabulary, (m,).
        """
        torch = libraries.torch()
        before, scores = torch.tensor([tokens], device=scores.device), scores[None].float()
        for process in self._processes:
            scores = process(before, scores)
        if self._drawn:
            return int(torch.multinomial(scores.softmax(-1), 1))
        return int(scores.argmax())
