"""What a new user types in the first hour: does each end in a result or in one clear line?

Runs 25 commands, right and wrong ones, in an empty folder with an empty cache, each at a terminal
of its own, and writes how each ended: its exit status, its last line, the time to the first sign of
life and the longest time without one. Takes about 5 minutes on two idle cores.

    .venv/bin/python benchmarks/first_hour.py --out outputs/first-hour
"""

from __future__ import annotations

import argparse
import fcntl
import json
import os
import pty
import re
import select
import struct
import subprocess
import sys
import tempfile
import termios
import time
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import psutil

import probe

TYPED = (
    "",
    "--help",
    "--version",
    "doctor",
    "rnu demo",
    "run",
    "run dmeo",
    "run demo --agnt random",
    "run demo --agent rnadom",
    "run demo --workers two",
    "run demo --agent random --limit 1",
    "run v1 --agent random --out outputs/earlier",
    "run v1 --limit 5 --agent examples/my_agent.py:Agent --out outputs/mine",
    "run demo --agent examples/no_agent.py:Agent",
    "run demo --agent random --out /proc/run",
    "run demo --model mine --endpoint http://localhost:9/v1 --out outputs/model",
    "report outputs/earlier",
    "report outputs/nowhere",
    "rescore outputs/earlier",
    "scene 7",
    "scene -3",
    "assets list --category mug",
    "assets show red_block",
    "tools bench --grasps -1",
    "suite show v3",
)
_PATIENCE = 900.0
_ESCAPES = re.compile(r"\x1b(\[[0-9;?]*[A-Za-z]|[()][A-Z0-9])")


@dataclass(frozen=True)
class Ending:
    """How a command ended.

    Attributes:
        typed: Its words.
        status: Exit status; None if it had to be ended.
        lines: Lines of output that aren't empty.
        last: The last of them.
        traceback: Whether there was one.
        first: Seconds until something was shown.
        silence: The longest time without anything new, seconds.
        silence_cpu: The same in seconds of the processor, which other programs don't lengthen.
        total: Seconds in all.
        load: The machine's load average over a minute, at the start.
    """

    typed: str
    status: int | None
    lines: int
    last: str
    traceback: bool
    first: float
    silence: float
    silence_cpu: float
    total: float
    load: float


def main() -> None:
    """Run them and write the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("outputs/first-hour"))
    parser.add_argument("--only", type=int, nargs="*", help="numbers of commands, from 1")
    asked = parser.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        place = Path(name)
        _earlier(place / "outputs" / "earlier")
        (place / "examples").symlink_to(Path(__file__).resolve().parents[1] / "examples")
        endings: list[Ending] = []
        for number, typed in enumerate(TYPED, 1):
            if not asked.only or number in asked.only:
                endings.append(typed_in(place, typed))
                print(_row(number, endings[-1]), flush=True)
    text = json.dumps([asdict(it) for it in endings], indent=1)
    (asked.out / "endings.json").write_text(text)
    calm = sum(it.silence_cpu <= 2 for it in endings)
    clear = sum(not it.traceback and it.status is not None for it in endings)
    print(f"n = {len(endings)}: {clear} ended without a traceback, {calm} never silent for 2 CPU s")


def typed_in(place: Path, typed: str) -> Ending:
    """Run a command in a folder with a cache of its own, at a terminal of 100 columns."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, 100, 0, 0))
    env = os.environ | {"XDG_CACHE_HOME": str(place / "cache"), "TERM": "xterm", "PAGER": "cat"}
    load, start = os.getloadavg()[0], time.monotonic()
    process = subprocess.Popen(
        [sys.executable, "-m", "probe", *typed.split()],
        cwd=place,
        env=env,
        stdin=subprocess.DEVNULL,
        stdout=theirs,
        stderr=theirs,
        start_new_session=True,
    )
    os.close(theirs)
    shown, times = _watched(ours, process, start)
    status = process.poll()
    if status is None:
        os.killpg(process.pid, 9)
        process.wait()
    os.close(ours)
    text = _ESCAPES.sub("", shown.decode(errors="replace"))
    lines = [it.split("\r")[-1].strip() for it in text.replace("\r\n", "\n").split("\n")]
    lines = [it for it in lines if it]
    gaps = [(b[0] - a[0], b[1] - a[1]) for a, b in zip(times, times[1:], strict=False)]
    return Ending(
        typed=f"probe {typed}".strip(),
        status=status,
        lines=len(lines),
        last=lines[-1] if lines else "",
        traceback="Traceback" in text,
        first=round(times[1][0], 2),
        silence=round(max(gap[0] for gap in gaps), 2),
        silence_cpu=round(max(gap[1] for gap in gaps), 2),
        total=round(times[-1][0], 2),
        load=round(load, 1),
    )


def _watched(
    terminal: int, process: subprocess.Popen[bytes], start: float
) -> tuple[bytes, list[tuple[float, float]]]:
    """What is shown, and when: seconds since the start, and of the processor."""
    shown, times, spent = b"", [(0.0, 0.0)], 0.0
    while time.monotonic() - start < _PATIENCE:
        ready, _, _ = select.select([terminal], [], [], 0.05)
        spent = max(spent, _spent(process.pid))
        if ready:
            try:
                shown += os.read(terminal, 65536)
            except OSError:  # the last process that had it is gone
                break
            times.append((time.monotonic() - start, spent))
        elif process.poll() is not None:
            break
    process_ended = time.monotonic()
    while process.poll() is None and time.monotonic() - process_ended < 5:
        time.sleep(0.02)
    times.append((time.monotonic() - start, spent))
    return shown, times


def _spent(pid: int) -> float:
    """Seconds of the processor that a process and those it started have taken."""
    total = 0.0
    try:
        ours = psutil.Process(pid)
        for process in (ours, *ours.children(recursive=True)):
            used = process.cpu_times()
            total += used.user + used.system + used.children_user + used.children_system
    except psutil.Error:
        pass
    return total


def _earlier(out: Path) -> None:
    """A run from before: one episode."""
    suite = probe.load_suite("demo")
    probe.run(replace(suite, tasks=suite.tasks[:1]), out, agent="random")


def _row(number: int, it: Ending) -> str:
    ended = "ended by force" if it.status is None else f"status {it.status}"
    quiet = f"first {it.first} s, silent {it.silence} s ({it.silence_cpu} CPU s)"
    return f"{number}. {it.typed} | {ended}, {it.lines} lines | {quiet} | {it.last[:150]}"


if __name__ == "__main__":
    main()
