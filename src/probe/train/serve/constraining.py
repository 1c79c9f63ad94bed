"""Keeps a language model's reply to a form: some words, then one call that fits a tool's schema.

llguidance says at each place which tokens may follow; all others get no chance. Knows no protocol.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from probe.train.tune import libraries
from probe.train.tune.conversations import NotUnderstood

MOST_WORDS = 2000
"""Characters that may stand before a call, twice what our teacher says at most. A "<" begins the
call, so none may be among them."""

_AS_TRAINED = {"whitespace_flexible": False, "item_separator": ", ", "key_separator": ": "}
"""JSON as templates write it, and so as models have learnt it."""


class CallForms:
    """What tokens make calls, for a model's tokenizer.

    Args:
        tokenizer: A fast one of transformers.

    Raises:
        MissingExtra: llguidance isn't installed.
    """

    def __init__(self, tokenizer: Any) -> None:
        self._guidance = libraries.part("llguidance")
        written = tokenizer.backend_tokenizer.to_str()
        self._tokens = self._guidance.LLTokenizer(written, eos_token=tokenizer.eos_token_id)

    def keep_to(self, tools: Sequence[Mapping[str, Any]]) -> KeptToCalls:
        """What keeps one reply to a call of these tools, for transformers' `logits_processor`.

        Args:
            tools: As OpenAI's protocol has them.

        Raises:
            NotUnderstood: They aren't in that form, or a schema asks for what can't be kept to.
        """
        begin, end = self._in_grammar("<tool_call>"), self._in_grammar("</tool_call>")
        matcher = self._guidance.LLMatcher(self._tokens, grammar_of(tools, begin, end))
        if error := matcher.get_error():
            reason = error.splitlines()[0]
            remedy = "Change the schema, or serve the model without --constrained"
            raise NotUnderstood(f"no reply can be kept to its tools' schemas ({reason}). {remedy}")
        return KeptToCalls(matcher)

    def _in_grammar(self, tag: str) -> str:
        """A tag as a grammar names it: ordinary text, or a token of its own."""
        tokens = self._tokens.tokenize_str(tag)
        alone = len(tokens) == 1 and self._tokens.is_special_token(tokens[0])
        return tag if alone else json.dumps(tag)


class KeptToCalls:
    """Rules out the tokens that may not follow in a reply; transformers calls it for each token."""

    def __init__(self, matcher: Any) -> None:
        self._matcher = matcher
        self._begun = False

    def __call__(self, input_ids: Any, scores: Any) -> Any:
        """The same scores, without hope for tokens that may not follow.

        Args:
            input_ids: All tokens so far, (1, n).
            scores: Of each token of the vocabulary, (1, m).
        """
        if self._begun:
            self._matcher.consume_token(int(input_ids[0, -1]))
        self._begun = True
        bits = np.frombuffer(self._matcher.compute_bitmask(), np.uint8)
        allowed = np.unpackbits(bits, bitorder="little", count=scores.shape[1]).astype(bool)
        torch = libraries.torch()
        ruled_out = torch.from_numpy(~allowed).to(scores.device)
        return scores.masked_fill(ruled_out, float("-inf"))


def grammar_of(tools: Sequence[Mapping[str, Any]], begin: str, end: str) -> str:
    """Words, then a call of one of these tools in Hermes' form: a grammar in Lark's notation.

    Args:
        tools: As OpenAI's protocol has them.
        begin: Of a call, its tag in that notation.
        end: The same of its end.

    Raises:
        NotUnderstood: They aren't in that form.
    """
    try:
        functions = [_call(tool["function"]) for tool in tools]
    except (KeyError, TypeError) as error:
        raise NotUnderstood("its tools aren't functions with names") from error
    calls = [f"call_{number}" for number in range(len(functions))]
    return "\n".join(
        [
            f'start: WORDS {begin} "\\n" ({" | ".join(calls)}) "\\n" {end}',
            f"WORDS: /[^<]{{0,{MOST_WORDS}}}/",
            *(f"{name}: {each}" for name, each in zip(calls, functions, strict=True)),
        ]
    )


def _call(function: Mapping[str, Any]) -> str:
    begin = f'{{"name": {json.dumps(function["name"])}, "arguments": '
    schema = {**(function.get("parameters") or {"type": "object"}), "x-guidance": _AS_TRAINED}
    return f'{json.dumps(begin)} %json {json.dumps(schema)} "}}"'
