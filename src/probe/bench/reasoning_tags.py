"""Bounds what it costs the harness to look for tags in a reply's words. Asks nothing.

It looks for passages of reasoning with expressions whose time grows with the number of tags times
the length of the text: 100,000 tags stop all episodes for good. Providers give no way in before
that, so that one function of its own is replaced; tests/bench/test_reasoning_tags.py notices when
the harness no longer calls it.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

MOST_STEPS = 20_000_000
"""Tags times characters; about half a second."""

_TAGS = ("<think", "<summary")
_PARSER, _FIRST = "inspect_ai.model._reasoning", "_find_nested_think_block"
_WITH_INTERNAL, _INTERNAL = "inspect_ai.model._providers.anthropic", "parse_content_with_internal"


class TooManyTags(ValueError):
    """A reply in which looking for reasoning would take too long."""


def check_tags(content: str) -> None:
    """See that looking for reasoning in a text takes no more steps than it may.

    Raises:
        TooManyTags: It does.
    """
    tags = sum(content.count(tag) for tag in _TAGS)
    if tags * len(content) > MOST_STEPS:
        text = f"{len(content):,} characters"
        raise TooManyTags(f"it has {tags:,} tags of reasoning in {text}, too many to look through")


def bound_tags(provider: str) -> None:
    """Have the harness check every text before it looks for reasoning; again does no harm.

    Args:
        provider: Module of the model's provider. That of Anthropic's also looks for data that
            Inspect's bridges leave in texts. There are none here, and what a model writes there
            would be taken for broken ones.
    """
    module = import_module(_PARSER)
    first = getattr(module, _FIRST, None)
    if first is not None and not isinstance(first, _Checked):
        setattr(module, _FIRST, _Checked(first))
    if provider == _WITH_INTERNAL:
        setattr(import_module(provider), _INTERNAL, _no_internal)


class _Checked:
    """The harness's first look at a text, after ours."""

    def __init__(self, look: Any) -> None:
        self._look = look

    def __call__(self, content: Any) -> Any:
        if isinstance(content, str):  # else the server broke the protocol: the harness says so
            check_tags(content)
        return self._look(content)


def _no_internal(content: str, tag: str) -> tuple[str, None]:
    return content, None
