"""The site that `make docs` builds: a dead link stops it, and its pages ask nobody for anything."""

from __future__ import annotations

import importlib.util
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from browser import Browser, chromium

ROOT = Path(__file__).resolve().parents[1]
NEEDED = importlib.util.find_spec("sphinx") and importlib.util.find_spec("furo")
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not NEEDED, reason="Sphinx is not installed: make docs"),
]
ELSEWHERE = re.compile(
    r"""(?:\bsrc=|<link[^>]*\bhref=|url\(|@import )\s*["']?((?:https?:)?//[^"')\s>]+)"""
)


def build(source: Path, out: Path) -> subprocess.CompletedProcess[str]:
    """Run what `make docs` runs, on the pages below another folder."""
    (line,) = re.findall(r"/sphinx-build (.*)", (ROOT / "Makefile").read_text("utf-8"))
    changed = {"docs/site": str(source / "docs/site"), ".": str(source), "outputs/site": str(out)}
    changed["outputs/.doctrees"] = str(out.with_name("doctrees"))
    words = [changed.get(word, word) for word in shlex.split(line)]
    command = [sys.executable, "-m", "sphinx", *words]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("site") / "html"
    made = build(ROOT, out)
    assert made.returncode == 0, made.stderr
    return out


@pytest.mark.parametrize(
    ("link", "fails"),
    [
        ("other.md", False),
        ("other.md#a-heading", False),
        ("absent.md", True),
        ("other.md#absent", True),
        ("absent.txt", True),
    ],
)
def test_a_dead_link_fails_the_build(link: str, fails: bool, tmp_path: Path):
    shutil.copytree(ROOT / "docs/site", tmp_path / "docs/site")
    page = f"# Title\n\n## Part\n\n[other](other.md)\n\n[link]({link})\n"
    (tmp_path / "docs/README.md").write_text(page)
    (tmp_path / "docs/other.md").write_text("# Other\n\n## A heading\n\nText.\n")
    made = build(tmp_path, tmp_path / "html")
    assert (made.returncode != 0) == fails, made.stderr
    assert ("absent" in made.stderr) == fails


def test_pages_name_no_file_of_others(site: Path):
    pages = [*site.rglob("*.html"), *site.rglob("*.css")]
    assert len(pages) > 50
    found = {str(p.relative_to(site)): ELSEWHERE.findall(p.read_text("utf-8")) for p in pages}
    assert {name: links for name, links in found.items() if links} == {}


def test_a_file_of_others_would_be_found():
    for text in (
        '<script src="https://a.b/c.js">',
        '<link rel="x" href="//a.b/c">',
        "url(http://a)",
    ):
        assert ELSEWHERE.search(text)


@pytest.mark.skipif(chromium() is None, reason="there is no Chromium")
@pytest.mark.parametrize("width", [390, 1280])
def test_a_page_in_a_browser_asks_nobody_and_fits(site: Path, width: int):
    with Browser(width, 900) as browser:
        browser.open((site / "index.html").as_uri())
        browser.wait("document.title.includes('PROBE') && location.href.includes('README')")
        for page in ("results/baselines", "reference/cli", "tutorials/evaluate-a-model"):
            browser.open((site / f"docs/{page}.html").as_uri())
            assert browser.run("document.documentElement.scrollWidth <= innerWidth"), page
        assert all(address.startswith(("file:", "data:")) for address in browser.requests)
        assert browser.complaints == []
