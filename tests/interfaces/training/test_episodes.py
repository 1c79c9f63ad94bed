"""Episodes at tables in processes: side by side, killed, lost; played on painted tables."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Generator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from multiprocessing import active_children
from pathlib import Path
from threading import Timer

import pytest

from interfaces.training.painted_tables import TASKS, painted_tables
from probe.agents.reading import read_graph
from probe.bench.process_pool import EpisodeProcessLost
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.errors import BadData
from probe.interfaces.training.environment import ProbeEnv
from probe.interfaces.training.tables import TooFewTables
from probe.interfaces.training.thousandths import ProbeEnvThousandths

pytestmark = pytest.mark.slow

OVER = "The episode has ended; no further call does anything."


def other_than(letter: str) -> str:
    return next(it for it in "AB" if it != letter)


def played(env: ProbeEnv, number: int) -> float | None:
    """Look, remove a thing and answer: rightly on even tries."""
    task = TASKS[number % len(TASKS)]
    env.reset(task=task.id, prompt=[])
    assert env.perceive_scene().startswith("# All that shows")
    assert "lifted and dropped into the basket" in env.grasp_and_remove("object_1")
    env.answer_question(task.answer if number % 2 == 0 else other_than(task.answer))
    return env.get_reward()


def test_an_episode_from_its_reset_to_its_reward(tmp_path):
    with painted_tables(tmp_path) as tables:
        env = ProbeEnv(tables)
        env.reset(task=TASKS[0].id)
        assert "'description' is missing; it takes no 'wrong'" in env.find_object(wrong=1)
        assert "recorded" in env.answer_question(choice=TASKS[0].answer)
        assert env.push("object_2", "up", 5) == OVER
        assert (env.get_reward(), env.get_reward()) == (1.0, 1.0)
        assert env.push("object_2", "up", 5) == OVER
        record = env.record
        assert record is not None and record.setting == "text-only, short graphs"
        assert [step.call.name for step in record.steps] == ["find_object", "answer_question"]
        env.reset(task=TASKS[1].id)
        assert env.get_reward() == 0.0
        assert env.record is not None and env.record.end == "stopped"


def test_places_in_thousandths_are_those_of_the_list(tmp_path):
    """A model reads thousandths and says thousandths; the tools and the record have pixels."""
    with painted_tables(tmp_path, points="0-1000") as tables:
        env = ProbeEnvThousandths(tables)
        env.reset(task=TASKS[0].id)
        listed = env.perceive_scene()
        ((u, v),) = re.findall(r"^- object_1 .*? \[(\d+), (\d+)\]", listed, re.MULTILINE)
        u, v = int(u), int(v)
        found = env.find_object(f"the thing at ({u}, {v})")
        assert found.startswith("- object_1 ") and f"[{u}, {v}]" in found
        env.answer_question(TASKS[0].answer, [u, v])
        assert env.get_reward() == 1.0
        record = env.record
        assert record is not None and record.answer is not None and record.participation is not None
        look, find, _ = record.steps
        pixel = next(it for it in read_graph(look.text).objects if it.object_id == "object_1").point
        assert find.point_px == pixel and round(pixel[0] * 1000 / 1024) == u != pixel[0]
        assert record.answer.point_px == pytest.approx((1.024 * u, 1.024 * v))
        assert record.participation.points == "0-1000"


def test_many_side_by_side_lose_nothing(tmp_path):
    out, count = tmp_path / "out", 8
    with painted_tables(tmp_path, most=4, out=out) as tables, ThreadPoolExecutor(4) as threads:
        envs = [ProbeEnv(tables) for _ in range(4)]
        rewards = [
            reward
            for start in range(0, count, 4)
            for reward in threads.map(played, envs, range(start, start + 4))
        ]
        with pytest.raises(TooFewTables, match="4 episodes are under way"):
            for env in [*envs, ProbeEnv(tables)]:
                env.reset(task=TASKS[0].id)
    assert rewards == [1.0, 0.0] * (count // 2)
    records = read_records(out / RECORDS)
    assert len(records) == count == len({(it.task, it.run) for it in records})
    assert all(it.end == "answered" and len(it.steps) == 3 for it in records)
    with painted_tables(tmp_path, out=out) as tables:
        played(ProbeEnv(tables), 0)
    assert read_records(out / RECORDS)[-1].run == 2
    before = (out / RECORDS).read_bytes()
    with pytest.raises(BadData, match="was run with other --points"):
        painted_tables(tmp_path, points="0-1000", out=out)
    assert (out / RECORDS).read_bytes() == before


def test_a_killed_process_is_replaced_and_its_episode_goes_on(tmp_path):
    with painted_tables(tmp_path, most=1) as tables:
        env, before = ProbeEnv(tables), set(active_children())
        env.reset(task=TASKS[0].id)
        assert "red mug" in env.perceive_scene()
        assert "lifted" in env.grasp_and_remove("object_1")
        (child,) = set(active_children()) - before
        os.kill(child.pid or 0, signal.SIGKILL)
        assert "red mug" not in env.perceive_scene()
        env.answer_question(TASKS[0].answer)
        assert env.get_reward() == 1.0
        assert env.record is not None and env.record.participation is not None
        (fault,) = env.record.participation.faults
        assert "SIGKILL" in fault


@contextmanager
def interrupted(seconds: float) -> Generator[None]:
    """The block, interrupted as by Ctrl-C."""

    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        with pytest.raises(KeyboardInterrupt):
            yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def _wake(pid: int) -> None:
    with suppress(ProcessLookupError):
        os.kill(pid, signal.SIGCONT)


def test_an_interrupted_call_leaves_nothing_to_whoever_comes_next(tmp_path):
    with painted_tables(tmp_path, most=2) as tables:
        env = ProbeEnv(tables)
        env.reset(task=TASKS[0].id)
        env.perceive_scene()
        (process,) = active_children()
        assert process.pid is not None
        os.kill(process.pid, signal.SIGSTOP)
        with interrupted(0.5):
            env.grasp_and_remove("object_2")
        Timer(1, _wake, [process.pid]).start()
        assert played(env, 0) == 1.0


def test_an_episode_whose_table_always_dies_is_missing_and_others_go_on(tmp_path):
    (tmp_path / "deaths").write_text("3")
    with painted_tables(tmp_path, out=tmp_path / "out") as tables:
        dying, other = ProbeEnv(tables), ProbeEnv(tables)
        dying.reset(task=TASKS[0].id)
        other.reset(task=TASKS[1].id)
        assert "red mug" in dying.perceive_scene()
        for _ in range(2):
            with pytest.raises(EpisodeProcessLost, match=r"ended with status 9 \(3 times in all\)"):
                dying.grasp_and_remove("object_1")
        assert dying.get_reward() is None
        other.answer_question(TASKS[1].answer)
        assert other.get_reward() == 1.0
        assert played(dying, 2) == 1.0
    assert [it.end for it in read_records(tmp_path / "out" / RECORDS)] == [
        "fault",
        "answered",
        "answered",
    ]


UNCLOSED = """
from pathlib import Path
from interfaces.training.painted_tables import TASKS, painted_tables
from probe.interfaces.training.environment import ProbeEnv

if __name__ == "__main__":
    env = ProbeEnv(painted_tables(Path(__file__).parent))
    env.reset(task=TASKS[0].id)
    print(env.perceive_scene())
"""


def test_a_program_that_closes_nothing_ends(tmp_path):
    (tmp_path / "unclosed.py").write_text(UNCLOSED)
    tests = Path(__file__).resolve().parents[2]
    places = os.pathsep.join([str(tests), os.environ.get("PYTHONPATH", "")])
    command = [sys.executable, str(tmp_path / "unclosed.py")]
    ended = subprocess.run(
        command, env=os.environ | {"PYTHONPATH": places}, capture_output=True, timeout=300
    )
    assert ended.returncode == 0 and b"red mug" in ended.stdout
