"""HTML pages as tests read them."""

from __future__ import annotations

from collections.abc import Iterator
from html.parser import HTMLParser
from typing import NamedTuple


class Element(NamedTuple):
    """One element: its attributes, and its text with that of its descendants."""

    tag: str
    attributes: dict[str, str | None]
    text: str


_VOID = {"meta", "img", "input", "br"}


def _words(texts: list[str]) -> str:
    """Texts of elements apart, with single spaces of the usual width."""
    return " ".join(" ".join(texts).split())


class _Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None], list[str]]] = []
        self.open: list[tuple[str, list[str]]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        texts: list[str] = []
        self.elements.append((tag, dict(attrs), texts))
        if tag not in _VOID:
            self.open.append((tag, texts))

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs), []))

    def handle_endtag(self, tag: str) -> None:
        while self.open and self.open.pop()[0] != tag:
            pass

    def handle_data(self, data: str) -> None:
        for _, texts in self.open:
            texts.append(data)


class Page:
    """A parsed page."""

    def __init__(self, html: str) -> None:
        reader = _Reader()
        reader.feed(html)
        self.elements = [
            Element(tag, attributes, "".join(texts) if tag == "script" else _words(texts))
            for tag, attributes, texts in reader.elements
        ]

    def all(self, tag: str, **attributes: str) -> list[Element]:
        """Elements of a tag; `class_` for the class."""
        wanted = {name.rstrip("_"): value for name, value in attributes.items()}
        return [e for e in self.elements if e.tag == tag and wanted.items() <= e.attributes.items()]

    def section(self, id: str) -> str:
        """All text of a section."""
        (found,) = self.all("section", id=id)
        return found.text

    def addresses(self) -> Iterator[str]:
        """Whatever the page loads or links to."""
        for element in self.elements:
            for name in ("src", "href", "data", "action", "srcset"):
                value = element.attributes.get(name)
                if value:
                    yield value
