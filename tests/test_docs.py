"""What the docs show as Python runs as it stands, with `import probe` alone; so do examples."""

from __future__ import annotations

import ast
import importlib
import pkgutil
import re
from pathlib import Path

import pytest

import probe

ROOT = Path(__file__).resolve().parents[1]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
BLOCK = re.compile(r"^( *)```python([^\n]*)\n(.*?)^ *```$", re.MULTILINE | re.DOTALL)
"""Indentation, words after the language, code. "no-run" marks a part of a class or function."""

CODE = {
    str(page.relative_to(ROOT)): [found[2] for found in BLOCK.findall(page.read_text())
                                  if "no-run" not in found[1]]
    for page in PAGES
}  # fmt: skip
RUNNABLE = [page for page, blocks in CODE.items() if blocks]
EXAMPLES = sorted((ROOT / "examples").glob("*.py"))


def strangers(code: str) -> set[str]:
    """Modules of the package that code imports past the front door."""
    found = set[str]()
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Import):
            found |= {each.name for each in node.names}
        elif isinstance(node, ast.ImportFrom):
            found.add(node.module or "")
    return {name for name in found if name.startswith("probe.")}


def test_there_are_pages_with_code():
    assert {
        "docs/reference/looks.md",
        "docs/reference/perception.md",
        "docs/how-to/extend/add-a-backend.md",
    } <= {*RUNNABLE}


@pytest.mark.parametrize("page", RUNNABLE)
def test_pages_import_the_public_api_alone(page: str):
    assert strangers("\n".join(CODE[page])) == set()


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.name)
def test_examples_import_the_public_api_alone(path: Path):
    assert strangers(path.read_text()) == set()


def anchors_of(page: Path) -> set[str]:
    """What a link may name after "#": GitHub's slugs of the page's headings."""
    text = re.sub(r"^ *```.*?^ *```", "", page.read_text("utf-8"), flags=re.MULTILINE | re.DOTALL)
    titles = re.findall(r"^#+ +(.+)$", text, re.MULTILINE)
    plain = [re.sub(r"[^\w\- ]", "", title.lower()) for title in titles]
    return {title.replace(" ", "-") for title in plain}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_lead_somewhere(page: Path):
    text = re.sub(r"^ *```.*?^ *```", "", page.read_text("utf-8"), flags=re.MULTILINE | re.DOTALL)
    dead = list[str]()
    for link in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"[a-z]+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        found = target.exists() and ROOT in (target, *target.parents)
        if not found or (anchor and target.suffix == ".md" and anchor not in anchors_of(target)):
            dead.append(link)
    assert dead == []


@pytest.mark.slow
@pytest.mark.parametrize("page", RUNNABLE)
def test_code_of_a_page_runs(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": page}
    for number, block in enumerate(CODE[page]):
        exec(compile(block, f"{page}, block {number}", "exec"), names)


def test_every_public_name_is_there_and_documented():
    for name in probe.__all__:
        found = getattr(probe, name)
        if not name.startswith("_") and name not in {"SUMS_BOUND", "Perceiver"}:
            assert found.__doc__, name


@pytest.mark.parametrize("script", ["api_page", "cli_page"])
def test_a_generated_page_is_current(script: str):
    module = importlib.import_module(script)
    assert module.PAGE.read_text("utf-8") == module.page(), f"run scripts/{script}.py"


def test_the_rows_in_the_readme_are_those_of_the_results():
    """Those are written by benchmarks/baselines.py."""
    rows = re.findall(r"^\| .*\|$", (ROOT / "README.md").read_text("utf-8"), re.MULTILINE)
    results = (ROOT / "docs/results/baselines.md").read_text("utf-8").splitlines()
    assert len(rows) == 4 and set(rows) <= set(results)


def test_the_readme_counts_the_library():
    specs = probe.open_library("evaluation").specs
    text = " ".join((ROOT / "README.md").read_text("utf-8").split())
    categories = len({spec.category for spec in specs})
    counted = f"{categories} categories in the pool for evaluation: {len(specs):,} objects"
    assert counted in text
    assert f"[{len(probe.open_library('train').specs):,} others]" in text
    assert f"A sheet of {categories} small pictures" in text


def test_no_public_name_is_a_folder_or_module_of_the_package():
    """Importing a submodule would put it in the place of the name."""
    modules = {found.name for found in pkgutil.iter_modules(probe.__path__)}
    assert modules & set(probe.__all__) == set()


def test_the_index_of_decisions_names_each_by_its_title():
    folder = ROOT / "docs/decisions"
    listed = (folder / "README.md").read_text("utf-8")
    for page in folder.glob("0*.md"):
        title = page.read_text("utf-8").splitlines()[0].removeprefix("# ")
        assert f"- [{title}]({page.name})" in listed
