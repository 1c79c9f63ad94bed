"""How the next token is chosen, by what a model recommends and a request asks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from probe.errors import BadData
from probe.train.tune import libraries

Process = Callable[[Any, Any], Any]
"""Of all tokens so far (1, n) and scores (1, m), other scores: transformers' LogitsProcessor."""

_TOP_K = 50
"""Of a model that recommends none: what generate() takes then (transformers 5.23)."""

_NEUTRAL = (None, 0, 1, False)
_NOT_KEPT_TO = (
    "bad_words_ids",
    "begin_suppress_tokens",
    "encoder_no_repeat_ngram_size",
    "encoder_repetition_penalty",
    "epsilon_cutoff",
    "eta_cutoff",
    "exponential_decay_length_penalty",
    "forced_bos_token_id",
    "forced_eos_token_id",
    "guidance_scale",
    "min_length",
    "min_new_tokens",
    "no_repeat_ngram_size",
    "num_beams",
    "sequence_bias",
    "stop_strings",
    "suppress_tokens",
    "top_h",
    "typical_p",
)


def check_recommended(model: str, recommended: Any) -> None:
    """See that replies can be chosen as a model recommends.

    Args:
        model: For the message.
        recommended: Its GenerationConfig.

    Raises:
        BadData: It recommends what a Chooser doesn't do.
    """
    for name in _NOT_KEPT_TO:
        value = getattr(recommended, name, None)
        if value not in _NEUTRAL:
            reason = f"it recommends {name} = {value}, which this server doesn't keep to"
            raise BadData(f"{model}: generation_config.json", reason, "Take that out of it")


class Chooser:
    """Chooses a reply's tokens.

    Args:
        recommended: The model's GenerationConfig, which gives a penalty for repetitions and, at a
            temperature, top_k, top_p and min_p.
        temperature: At 0 the likeliest is chosen.
        kept_to: What rules tokens out before all that.
    """

    def __init__(
        self, recommended: Any, temperature: float, kept_to: Process | None = None
    ) -> None:
        library = libraries.part("transformers.generation.logits_process")
        asked = [(library.RepetitionPenaltyLogitsProcessor, recommended.repetition_penalty, 1.0)]
        if temperature > 0:
            top_k = _TOP_K if recommended.top_k is None else recommended.top_k
            asked += [
                (library.TemperatureLogitsWarper, float(temperature), 1.0),
                (library.TopKLogitsWarper, top_k, 0),
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
        torch, scores = libraries.torch(), scores[None].float()
        if self._processes:
            before = torch.tensor([tokens], device=scores.device)
            for process in self._processes:
                scores = process(before, scores)
        if self._drawn:
            return int(torch.multinomial(scores.softmax(-1), 1))
        return int(scores.argmax())
