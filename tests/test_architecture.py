"""The checks of `make check` fail on code that breaks the architecture."""

from __future__ import annotations

import ast
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import grimp
import pytest

from probe.cli import COMMANDS
from probe.tasks.registry import PARTS, question_types

ROOT = Path(__file__).resolve().parents[1]
BIN = Path(sys.executable).parent


def copied(folder: Path) -> Path:
    """A copy of the code and of what configures its checks."""
    ignore = shutil.ignore_patterns("__pycache__", "*.so")
    shutil.copytree(ROOT / "src", folder / "src", ignore=ignore)
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, folder)
    return folder


def plant(checkout: Path, module: str, line: str) -> None:
    """Add a module with one import to the copy, and its package if there is none yet."""
    path = checkout / "src" / "probe" / f"{module}.py"
    path.parent.mkdir(exist_ok=True)
    init = path.parent / "__init__.py"
    if not init.exists():
        init.write_text('"""A package."""\n')
    path.write_text(f'"""A module."""\n\n{line}\n')


def run(checkout: Path, *command: str) -> tuple[int, str]:
    """Exit status and output of a checking tool, run on the copy as `make check` runs it."""
    tool = [str(BIN / command[0]), *command[1:]]
    environment = os.environ | {"PYTHONPATH": str(checkout / "src"), "COLUMNS": "200"}
    done = subprocess.run(tool, cwd=checkout, env=environment, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def test_make_check_runs_these_commands():
    recipe = (ROOT / "Makefile").read_text()
    assert "$(BIN)/ruff check\n" in recipe
    assert "$(BIN)/lint-imports\n" in recipe


def test_the_code_as_it_is_keeps_the_architecture_and_mujoco_is_let_into_its_homes(tmp_path: Path):
    checkout = copied(tmp_path)
    plant(checkout, "world/planted", "import mujoco\n\nEngine = mujoco.MjModel")
    status, output = run(checkout, "lint-imports")
    assert status == 0, output
    status, output = run(checkout, "ruff", "check", "--select", "TID251")
    assert status == 0, output
    status, output = run(checkout, "ruff", "check", "src/probe/world/planted.py")
    assert status == 0, output


def test_a_folder_without_a_place_is_refused(tmp_path: Path):
    checkout = copied(tmp_path)
    plant(checkout, "utils/planted", "import math")
    status, output = run(checkout, "lint-imports")
    assert status != 0
    assert "utils" in output


WITHOUT_MUJOCO = ("tasks", "toolshed", "scene", "assets")
FORBIDDEN = [
    ("toolshed/upwards", "probe.tasks"),
    ("tasks/upwards", "probe.toolshed"),
    ("scene/upwards", "probe.world"),
    ("render/upwards", "probe.world"),
]
PARTS_OF_A_TYPE = [
    ("rules", "probe.toolshed.result"),
    ("rules", "probe.agents.moves"),
    ("oracle_view", "probe.agents.moves"),
    ("plan", "probe.generation.plan"),
    ("generator", "probe.verification.truth"),
    ("observer", "probe.verification.truth"),
    ("verifier", "probe.scores.row"),
    ("rules", "probe.question_types.find.rules"),
]


@pytest.fixture(scope="module")
def refused(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """What each tool says of a copy that breaks the architecture everywhere."""
    checkout = copied(tmp_path_factory.mktemp("refused"))
    for folder in WITHOUT_MUJOCO:
        plant(checkout, f"{folder}/engine", "import mujoco  # noqa: F401")
    for module, imported in FORBIDDEN:
        plant(checkout, f"{imported.removeprefix('probe.')}/other", "import math")
        plant(checkout, module, f"import {imported}")
    for part, imported in PARTS_OF_A_TYPE:
        path = checkout / "src" / "probe" / "question_types" / "beneath" / f"{part}.py"
        path.write_text(f"{path.read_text()}\nimport {imported}  # noqa: E402, F401\n")
    plant(checkout, "world/engine", "import mujoco")
    plant(checkout, "tasks/through", "import probe.world.engine")
    for folder in ("cli", "interfaces"):
        plant(checkout, f"{folder}/server", "import fastmcp\n\nServer = fastmcp.FastMCP")
    said = {tool: run(checkout, *tool.split()) for tool in ("ruff check", "lint-imports")}
    assert all(status != 0 for status, _ in said.values())
    return {tool: output for tool, (_, output) in said.items()}


def imported_by(module: str, output: str) -> set[str]:
    """What a module imports in the chains that import-linter reports."""
    return {*re.findall(rf"(?<![\w.]){re.escape(module)} -> ([\w.]+)", output)}


@pytest.mark.parametrize("folder", WITHOUT_MUJOCO)
def test_mujoco_is_kept_out(refused: dict[str, str], folder: str):
    assert re.search(rf"TID251.*\n *--> src/probe/{folder}/engine\.py:", refused["ruff check"])
    assert "mujoco" in imported_by(f"probe.{folder}.engine", refused["lint-imports"])


def test_fastmcp_is_kept_to_the_interfaces(refused: dict[str, str]):
    assert re.search(r"TID251.*\n *--> src/probe/cli/server\.py:", refused["ruff check"])
    assert "src/probe/interfaces/server.py" not in refused["ruff check"]


@pytest.mark.parametrize(("module", "imported"), FORBIDDEN)
def test_forbidden_directions_are_refused(refused: dict[str, str], module: str, imported: str):
    name = f"probe.{module.replace('/', '.')}"
    assert imported in imported_by(name, refused["lint-imports"])


@pytest.mark.parametrize(("part", "imported"), PARTS_OF_A_TYPE)
def test_a_part_of_a_type_knows_no_more_than_its_layer(
    refused: dict[str, str], part: str, imported: str
):
    name = f"probe.question_types.beneath.{part}"
    assert imported in imported_by(name, refused["lint-imports"])


def test_questions_get_no_physics_through_others(refused: dict[str, str]):
    """The whole way is told, in one chain."""
    way = r"probe\.tasks\.through -> probe\.world\.engine \S+\n +probe\.world\.engine -> mujoco "
    assert re.search(way, refused["lint-imports"])


def test_no_public_class_name_is_defined_twice():
    places: dict[str, list[str]] = {}
    for path in sorted((ROOT / "src" / "probe").rglob("*.py")):
        for node in ast.parse(path.read_text()).body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                places.setdefault(node.name, []).append(str(path.relative_to(ROOT)))
    assert len(places) > 400
    assert {name: found for name, found in places.items() if len(found) > 1} == {}


STARTED_BY_NAME = {
    "probe.__main__",
    "probe.agents.external.agent_process",
    "probe.agents.external.supervisor",
    "probe.bench.tasks",
    "probe.perception.sam3",
    "probe.render.blender",
    "probe.render.worker",
}
"""Modules that other processes, entry points or lazy imports name in text."""


def reached(imports: dict[str, set[str]], roots: set[str]) -> set[str]:
    """Modules that some of the roots lead to, themselves included.

    Args:
        imports: The modules that each module imports directly.
        roots: Where to begin.
    """
    found, waiting = set[str](), [*roots]
    while waiting:
        module = waiting.pop()
        if module not in found:
            found.add(module)
            waiting += imports.get(module, ())
    return found


def needed_by_nothing(package: str, roots: set[str]) -> set[str]:
    """Modules of a package with code in them that no root leads to."""
    graph = grimp.build_graph(package, cache_dir=None)
    modules = {name for name in graph.modules if not graph.find_children(name)}
    imports = {name: graph.find_modules_directly_imported_by(name) for name in graph.modules}
    return modules - reached(imports, roots)


def roots() -> set[str]:
    """Where everything in the package is begun from."""
    commands = {f"probe.cli.{command.module}" for command in COMMANDS.values()}
    parts = {f"probe.question_types.{name}.{part}" for name in question_types() for part in PARTS}
    scripts = [path.read_text("utf-8") for path in (ROOT / "scripts").glob("*.py")]
    by_scripts = {
        name for text in scripts for name in re.findall(r"^from (probe\.\S+)", text, re.M)
    }
    return {"probe", *STARTED_BY_NAME, *commands, *parts, *by_scripts}


def test_nothing_is_there_for_tests_and_benchmarks_alone():
    assert needed_by_nothing("probe", roots()) == set()


def test_a_module_that_nothing_imports_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    for name, line in [
        ("__init__", ""),
        ("begin", "from planted_package import used"),
        ("used", ""),
        ("idle", "from planted_package import idle_too"),
        ("idle_too", ""),
    ]:
        path = tmp_path / "planted_package" / f"{name}.py"
        path.parent.mkdir(exist_ok=True)
        path.write_text(f'"""A module."""\n\n{line}\n')
    monkeypatch.syspath_prepend(str(tmp_path))
    found = needed_by_nothing("planted_package", {"planted_package.begin"})
    assert found == {"planted_package.idle", "planted_package.idle_too"}


def test_every_folder_with_code_is_a_package():
    """Import-linter overlooks a folder that isn't."""
    code = (ROOT / "src" / "probe").rglob("*.py")
    folders = {path.parent for path in code}
    assert [folder for folder in folders if not (folder / "__init__.py").exists()] == []


def imports_of(path: Path) -> Iterator[str]:
    """Names of the modules that a file imports, anywhere in it."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield node.module or "."


def behind_the_api(folder: Path) -> list[str]:
    """Files of a folder that import modules of the package, instead of the package."""
    return [
        f"{path.name} imports {name}"
        for path in sorted(folder.glob("*.py"))
        for name in imports_of(path)
        if name.startswith("probe.")
    ]


def test_benchmarks_use_the_public_api_or_say_that_they_do_not():
    folder = ROOT / "benchmarks"
    assert behind_the_api(folder) == []
    scripts = [
        path
        for path in (folder / "internals").rglob("*.py")
        if '__name__ == "__main__"' in path.read_text()
    ]
    assert len(scripts) > 10
    head = {path.name: path.read_text().partition("\n\nfrom ")[0] for path in scripts}
    assert [name for name, words in head.items() if "Measures internals" not in words] == []


def test_a_benchmark_that_looks_behind_the_api_is_found(tmp_path: Path):
    (tmp_path / "open.py").write_text("import probe\nimport numpy\n")
    (tmp_path / "late.py").write_text("def main():\n    from probe.world.world import World\n")
    (tmp_path / "early.py").write_text("import probe.world\n")
    assert behind_the_api(tmp_path) == [
        "early.py imports probe.world",
        "late.py imports probe.world.world",
    ]
