"""Files and options that a command has to refuse in words."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path

from command import judged, probe, refusal
from verdict import Attack, some

from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.ordered import ORDERED

KIND, OPTIONS, MACHINE = "files", "options", "the machine"

Spoil = Callable[[Path], object]


def _written(content: bytes) -> Spoil:
    return lambda path: path.write_bytes(content)


def _halved(path: Path) -> None:
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def _as_folder(path: Path) -> None:
    path.unlink()
    path.mkdir()


def _as_pipe(path: Path) -> None:
    path.unlink()
    os.mkfifo(path)


def _linked(target: str) -> Spoil:
    def spoil(path: Path) -> None:
        path.unlink()
        path.symlink_to(target)

    return spoil


def _padded(path: Path) -> None:
    """Five million empty tasks."""
    path.write_bytes(b'{"tasks": [' + b"{}," * 5_000_000 + b"{}]}")


SPOILT: dict[str, Spoil] = {
    "empty": _written(b""),
    "half of it": _halved,
    "no text": _written(bytes(range(256)) * 50),
    "deep": _written(b"[" * 200_000),
    "a number": _written(b"1e999\n"),
    "null": _written(b"null\n"),
    "a list": _written(b"[]\n"),
    "another object": _written(b'{"a": 1}\n'),
    "a folder": _as_folder,
    "a pipe": _as_pipe,
    "a device without end": _linked("/dev/zero"),
    "a link to nowhere": _linked("/nowhere"),
    "a link to itself": _linked(SUITE),
    "five million tasks": _padded,
}


def attack_files(folder: Path, run: Path, scale: float) -> Iterator[Attack]:
    """Give commands spoilt copies of a run's files.

    Args:
        folder: For the copies.
        run: A folder that `probe run` left.
        scale: The share of spoilt files that is tried.
    """
    for file, (name, spoil) in some(
        list(product((SUITE, RECORDS, ORDERED), SPOILT.items())), scale
    ):
        if file == RECORDS and name == "empty":
            continue  # no episode has been run yet: that is no error
        copy = _copy(folder, run)
        spoil(copy / file)
        yield refusal(KIND, f"{file}: {name}", "rescore", copy)
    for name, spoil in some(list(SPOILT.items()), scale):
        copy = _copy(folder, run)
        spoil(copy / SUITE)
        yield refusal(KIND, f"suite show: {name}", "suite", "show", copy / SUITE)
    copy = _copy(folder, run)
    ordered = json.loads((copy / ORDERED).read_text())
    ordered["ordered"][0]["runs"] = 1_000_000_000
    (copy / ORDERED).write_text(json.dumps(ordered))
    yield refusal(KIND, "a thousand million runs", "rescore", copy)
    (copy / "prices.yaml").write_text("a: " + "[" * 20_000)
    yield refusal(
        KIND, "prices with 20,000 brackets", "run", "demo", "--model", "m", "--out", folder / "p",
        "--endpoint", "http://127.0.0.1:9/v1", "--prices", copy / "prices.yaml",
    )  # fmt: skip


def _copy(folder: Path, run: Path) -> Path:
    copy = folder / "copy"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(run, copy, ignore=shutil.ignore_patterns("pictures"))
    return copy


def attack_options(folder: Path, scale: float) -> Iterator[Attack]:
    """Give commands numbers and folders that they can't take: that share of what is known."""
    for words in some(_options(folder), scale):
        yield refusal(OPTIONS, " ".join(str(word)[:40] for word in words), *words)


def _options(folder: Path) -> list[tuple[str | Path, ...]]:
    out = ("--out", folder / "options")
    return [
        ("scene", "-3", *out), ("scene", "7", "--objects", "-1", *out),
        ("scene", "7", "--objects", "0", *out), ("scene", "7", "--reach", "-1", *out),
        ("scene", "7", "--reach", "nan", *out), ("scene", "7", "--gallery", "-2", *out),
        ("tools", "bench", "--grasps", "-1", *out), ("tools", "bench", "--pushes", "-1", *out),
        ("run", "demo", "--runs", "0", *out), ("run", "demo", "--runs", "-4", *out),
        ("run", "demo", "--workers", "0", *out), ("run", "demo", "--workers", "-1", *out),
        ("run", "demo", "--shard", "2/2", *out), ("run", "demo", "--shard", "-1/2", *out),
        ("run", "demo", "--shard", "0/0", *out), ("run", "demo", "--pose-jitter", "-1", *out),
        ("run", "demo", "--pose-jitter", "inf", *out), ("run", "demo", "--dials.over", "2", *out),
        ("run", "no-such-suite", *out), ("run", "demo", "--agent", "nobody", *out),
        ("suite", "build", folder / "b.json", "--counts.find", "-2"),
        ("suite", "build", folder / "b.json"), ("serve", "--task", "no-such-task", *out),
        ("human", "demo", "--port", "99999", *out), ("human", "demo", "--seats", "0", *out),
        ("report", folder / "nowhere"), ("rescore", folder / "nowhere"),
        ("merge", folder / "nowhere", "--out", folder / "m"), ("no-such-command",),
        ("run", "demo", "--agent", "always-A", "--out", "/proc/nowhere"),
        ("run", "demo", "--agent", "always-A", "--out", "/dev/null"),
        ("run", "demo", "--agent", "always-A", "--out", folder / ("a" * 300)),
    ]  # fmt: skip


def attack_memory(folder: Path, scale: float) -> Iterator[Attack]:
    """Start commands with less memory than they need: under that share of the limits."""
    for mebibytes in some((100, 200, 300, 350, 450, 600, 1000, 1500), scale):
        name, words = f"{mebibytes} MiB of addresses", ("run", "demo", "--agent", "always-A")
        try:
            ended = probe(*words, "--out", folder / str(mebibytes), most_bytes=mebibytes << 20)
        except subprocess.TimeoutExpired:
            yield Attack(MACHINE, name, "crashed", "hangs")
            continue
        whole = ended.returncode == 0 and "missing" not in ended.stdout
        yield Attack(MACHINE, name, "harmless") if whole else judged(MACHINE, name, ended)
