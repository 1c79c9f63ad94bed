"""Texts from outside, made fit for where they go. Knows no file and no screen."""

from __future__ import annotations


def writable(text: str) -> str:
    """A text as UTF-8 can hold it: halves of surrogate pairs, which models may send, become "?"."""
    return text.encode("utf-8", "replace").decode()
