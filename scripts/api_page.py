"""Write docs/reference/api.md: each public name with its signature and docstring.

A test compares them.
"""

from __future__ import annotations

import inspect
import re
import typing
from pathlib import Path

import probe

PAGE = Path(__file__).parents[1] / "docs" / "reference" / "api.md"

HEAD = """# The Python API

`import probe` offers the names on this page and no others; everything else may change without
notice. The package imports each name when you first use it, so `import probe` itself takes
milliseconds. If your program needs the same tables on every machine, import `probe` before NumPy
([why](../decisions/0020-the-same-sums-everywhere.md)).

`scripts/api_page.py` writes this page from the docstrings.
"""


def described(name: str) -> str:
    """One name: a heading, the signature of a function or class, and the docstring."""
    found = getattr(probe, name)
    lines = [f"## `{name}`", ""]
    if inspect.isfunction(found):
        lines += ["```", f"{name}{_signature(found)}", "```", ""]
    doc = inspect.getdoc(found) if inspect.isclass(found) or inspect.isfunction(found) else None
    if doc:
        lines += ["```text", doc, "```", ""]
    elif typing.get_origin(found) is not None:
        lines += [f"A type: `{_plain(str(found))}`.", ""]
    if inspect.isclass(found):
        lines += _methods(found)
    return "\n".join(lines)


def page() -> str:
    """The whole page."""
    names = sorted((n for n in probe.__all__ if n[0] != "_" and n != "SUMS_BOUND"), key=str.lower)
    functions = [n for n in names if inspect.isfunction(getattr(probe, n))]
    others = [n for n in names if n not in functions]
    parts = [HEAD, "# Functions\n", *map(described, functions), "# Classes\n"]
    return "\n".join([*parts, *map(described, others)]).rstrip("\n") + "\n"


def _methods(found: type) -> list[str]:
    lines = list[str]()
    for name, member in vars(found).items():
        if name.startswith("_") or not inspect.isfunction(member):
            continue
        first = (inspect.getdoc(member) or "").split("\n")[0]
        lines += [f"- `{name}{_signature(member)}`: {first}"]
    return [*lines, ""] if lines else []


def _signature(function: object) -> str:
    return _plain(str(inspect.signature(function)))  # pyright: ignore[reportArgumentType]


def _plain(text: str) -> str:
    """Without quotes of postponed annotations, addresses in memory, or all of the usual set-up."""
    text = text.replace(repr(probe.Setup()), "Setup()")
    text = re.sub(r"(: |-> )'([^']*)'", r"\1\2", text)
    return re.sub(r"<function (\w+) at 0x[0-9a-f]+>", r"\1", text)


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
