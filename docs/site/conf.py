"""How Sphinx makes the site from the pages: `make docs`.

The source folder is the repository, so that links between pages work on the site as they do in a
checkout. The lists of links in docs/README.md are the site's navigation.
"""

from __future__ import annotations

import re
from pathlib import PurePosixPath

from sphinx.application import Sphinx

project = "PROBE"
author = "The PROBE developers"
html_title = "PROBE"
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "docs/README"
include_patterns = ["docs/**", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"]
# Sphinx looks through every folder that isn't excluded, through links to folders, too.
exclude_patterns = [".*", "outputs", "shared", "runs", "mutants", "docs/site"]
myst_heading_anchors = 4
highlight_language = "text"
# Pages that hold a program's output begin with the headings that it writes.
suppress_warnings = ["myst.header"]

html_theme = "furo"
html_extra_path = ["index.html"]
html_static_path = ["style.css"]
html_css_files = ["style.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
html_use_index = False
# Tables hold commands and file names, in which a quotation mark or two hyphens stay what they are.
smartquotes = False

_LINK = re.compile(r"\]\(([^)#\s]+\.md)\)")


def add_navigation(app: Sphinx, name: str, source: list[str]) -> None:
    """Append the navigation to a page that lists others, as Sphinx's handler of "source-read".

    The main page gets a part for each of its sections, with the pages that the section links. A
    README of another folder gets all pages of that folder.

    Args:
        app: Knows the source folder.
        name: The page's path without its ending.
        source: The page's text, alone in a list; changed in place.
    """
    folder = PurePosixPath(name).parent
    if name == root_doc:
        for section in source[0].split("\n## ")[1:]:
            title, _, body = section.partition("\n")
            source[0] += _toctree(list(dict.fromkeys(_LINK.findall(body))), caption=title)
    elif PurePosixPath(name).name == "README" and folder.parts[:1] == ("docs",):
        others = [path for path in (app.srcdir / folder).glob("*.md") if path.name != "README.md"]
        if others:
            source[0] += _toctree(["*"], glob="", hidden=folder.name != "decisions")


def _toctree(entries: list[str], *, hidden: bool = True, **options: str) -> str:
    lines = [f":{key}: {value}".rstrip() for key, value in options.items()]
    lines += [":hidden:"] if hidden else [":maxdepth: 1"]
    return "\n\n```{toctree}\n" + "\n".join([*lines, "", *entries]) + "\n```\n"


def setup(app: Sphinx) -> None:
    """Sphinx calls this when it starts."""
    app.connect("source-read", add_navigation)
