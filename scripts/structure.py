"""Figures of the code's structure: `python scripts/structure.py [CHECKOUT]`.

Prints files, lines, lengths of functions, class names that are defined twice, and how many files a
grasp and a picture pass through. A checkout of another commit is measured with the same eyes, so
that two can be compared; a file counts as passed through if one of its functions is called, in
this process or one that it starts, and if it isn't the command line's.
"""

from __future__ import annotations

import ast
import os
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from statistics import median, quantiles

_WATCH = """
import os, sys, threading

kept, seen, depth = os.environ["TOUCHED"], set(), {}
root = os.sep + os.path.join("src", "probe", "")

def watch(frame, event, _):
    name, code = frame.f_code.co_filename, frame.f_code.co_name
    if root not in name or code == "<module>":
        return
    me = threading.get_ident()
    if event == "call":
        begins = not START or (code == START and root + "toolshed" in name)
        if depth.get(me) or begins:
            depth[me] = depth.get(me, 0) + 1
            if name not in seen:
                seen.add(name)
                with open(kept, "a") as file:
                    file.write(name.split(root)[1] + "\\n")
    elif event == "return" and depth.get(me):
        depth[me] -= 1

threading.setprofile(watch)
sys.setprofile(watch)
"""
"""Notes files with a function that is called, from START on; Python runs it in each process."""


_RUN = ("run", "demo", "--agent", "scripted")
_SCENE = ("scene", "1")


def main(checkout: Path) -> None:
    """Measure one checkout and print a table in Markdown."""
    files = sorted((checkout / "src/probe").rglob("*.py"))
    trees = {path: ast.parse(path.read_text("utf-8")) for path in files}
    lengths = [len(path.read_text("utf-8").splitlines()) for path in files]
    functions = sorted(length for tree in trees.values() for length in _function_lengths(tree))
    names = Counter(name for tree in trees.values() for name in _public_classes(tree))
    rows: Mapping[str, object] = {
        "Python files": len(files),
        "of them more than a docstring": sum(len(tree.body) > 1 for tree in trees.values()),
        "lines": sum(lengths),
        "median lines of a file": median(lengths),
        "functions": len(functions),
        "lines of a function, 90th percentile": round(quantiles(functions, n=10)[-1]),
        "functions over 60 lines": sum(length > 60 for length in functions),
        "public class names defined more than once": sum(n > 1 for n in names.values()),
        "public names of `import probe`": _public_names(checkout),
        "files that `grasp_and_remove` passes through": _touched(checkout, "_grasp", _RUN),
        "files that a seed passes through to a picture": _touched(checkout, "", _SCENE),
    }
    print("| | |\n|---|---|")
    for name, value in rows.items():
        print(f"| {name} | {value:,} |" if isinstance(value, int) else f"| {name} | {value} |")


def _function_lengths(tree: ast.Module) -> Iterator[int]:
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            yield (node.end_lineno or node.lineno) - node.lineno + 1


def _public_classes(tree: ast.Module) -> Iterator[str]:
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            yield node.name


def _public_names(checkout: Path) -> int:
    said = _python(checkout, ["-c", "import probe; print(len(getattr(probe, '__all__', ())))"])
    return int(said.split()[-1])


def _touched(checkout: Path, start: str, command: Sequence[str]) -> int:
    """Files of the package with a function that is called, the command line's left out."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "sitecustomize.py").write_text(f"START = {start!r}\n{_WATCH}")
        kept = Path(folder) / "touched"
        more = {"TOUCHED": str(kept), "PYTHONPATH": f"{folder}:{checkout / 'src'}"}
        _python(checkout, ["-m", "probe", *command, "--out", f"{folder}/out"], more)
        return len({it for it in kept.read_text().splitlines() if not it.startswith("cli/")})


def _python(checkout: Path, arguments: Sequence[str], more: Mapping[str, str] = {}) -> str:
    at_home = {"PATH": os.environ["PATH"], "HOME": str(Path.home())}
    ended = subprocess.run(
        [sys.executable, *arguments],
        env={**at_home, "PYTHONPATH": str(checkout / "src"), **more},
        capture_output=True,
        text=True,
        check=False,
    )
    if ended.returncode:
        sys.exit(ended.stderr)
    return ended.stdout


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve())
