"""What was wrong with a command's arguments, in one line instead of the parser's box."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from probe.closest import did_you_mean

_RULE = re.compile(r"[─-]{3,}")
_ESCAPES = re.compile(r"\x1b\[[0-9;]*m")


def in_a_line(box: str, arguments: Sequence[str]) -> str:
    """The parser's words as one line with the closest match and where help is.

    Args:
        box: What the parser printed: a title, parts between horizontal rules, a frame around.
        arguments: As they were typed, the command first.
    """
    parts = list(_parts(box))
    if "╭" not in box:
        # Without UTF-8, the title stands above a rule of its own.
        del parts[:1]
    first = parts[0] if parts else "These arguments don't fit"
    asked = re.search(r"probe(?: [a-z][\w-]*){1,2} --help", " ".join(parts[1:]))
    helped = asked[0] if asked else _help_of(arguments)
    return f"{_message(first, parts[1:])} See `{helped}`."


def _message(first: str, others: Sequence[str]) -> str:
    """What is wrong, and what was meant."""
    if missing := re.fullmatch(r"Missing from probe.*?: (.+)", first):
        found = re.findall(r"(\S+) (.*?)\.? \(required\)", missing[1])
        return " ".join(f"{name} is missing: {words}." for name, words in found)
    if below := re.fullmatch(r"Expected one of \{(.*)\}\.", first):
        return f"A command is missing; known: {below[1]}."
    if choice := re.fullmatch(r"invalid choice '(.*)' for argument '(.*)'\. Expected .*", first):
        known = re.findall(r"'([^']+)'", first.partition("Expected one of")[2])
        return _unknown(f"{choice[2]}: there is no {choice[1]!r}", choice[1], known)
    if stray := re.fullmatch(r"Unrecognized options: (.*)", first):
        return _stray(stray[1], others)
    if wrong := re.match(r"Error parsing (\S+): (.*)", first):
        return f"{wrong[1]}: {_reason(wrong[2])}."
    return f"{first.rstrip('.')}."


def _stray(said: str, others: Sequence[str]) -> str:
    """Something that a command doesn't have: an option, a command below it, or one word more."""
    word = said.split(",")[0]
    listed = next((it for it in others if it.startswith("Available subcommands: ")), None)
    if listed is not None and not word.startswith("-"):
        known = listed.removeprefix("Available subcommands: ").split(", ")
        return _unknown(f"There is no command called {word!r}", word, known)
    if not word.startswith("-"):
        return f"{word!r} is one word too many."
    near = next((it for it in others if re.match("Perhaps you meant|Arguments similar", it)), "")
    options = list(dict.fromkeys(re.findall(r"(?<!\S)--[a-z][\w.-]*", near)))
    options = [it for it in options if it != "--help"]
    return _unknown(f"There is no option {word}", word, options, few=False)


def _unknown(words: str, name: str, known: Sequence[str], *, few: bool = True) -> str:
    meant = did_you_mean(name, known)
    listed = f"Known: {', '.join(known)}." if few else ""
    return " ".join(part for part in (f"{words}.", meant, listed) if part)


def _reason(words: str) -> str:
    """Why a value can't be read, without the parser's types."""
    if found := re.search(r"invalid literal for int\(\) with base 10: ('.*?')", words):
        return f"{found[1]} is no whole number"
    if found := re.search(r"could not convert string to float: ('.*?')", words):
        return f"{found[1]} is no number"
    if found := re.search(r"from \[(.*?)\]\.", words):
        choices = re.search(r"does not match choices \((.*?)\)", words)
        known = f"; known: {choices[1]}" if choices and choices[1] != "'None'," else ""
        return f"{found[1]} can't be read{known}"
    return words.rstrip(".")


def _parts(box: str) -> Iterator[str]:
    """The texts between the rules of a box, each as one line."""
    lines = [_ESCAPES.sub("", line).strip(" │") for line in box.splitlines()]
    part: list[str] = []
    for line in lines:
        if line.startswith(("╭", "╰")) or _RULE.fullmatch(line):
            if part:
                yield " ".join(part)
            part = []
        elif line:
            part.append(line)
    if part:
        yield " ".join(part)


def _help_of(arguments: Sequence[str]) -> str:
    """How help on the command is asked for."""
    return f"probe {arguments[0]} --help" if arguments else "probe --help"
