"""`probe robot`, with a twin in a process of its own."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from probe.episodes.files import read_records
from probe.perception.enrolled.enrolment_file import read_enrolment
from probe.tasks.suite_file import demo_suite

TASK = demo_suite().tasks[0]
ADDRESS = r"ws://127\.0\.0\.1:\d+"
PROBE = [sys.executable, "-m", "probe", "robot"]


@pytest.fixture
def twin(tmp_path: Path) -> Iterator[str]:
    asked = ["--suite", "demo", "--task", TASK.id, "--haste", "4", "--port", "0"]
    command = [*PROBE, "twin", *asked, "--token-file", str(tmp_path / "token")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            found = next(filter(None, (re.search(ADDRESS, line) for line in process.stdout)))
            yield found[0]
            process.send_signal(signal.SIGINT)
            assert process.wait(30) == 0
        finally:
            process.kill()


def probe(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([*PROBE, *words], capture_output=True, text=True, timeout=300)


REPLIES = {
    "when it lies so": "ok",
    "Which letter": "E",
    "What differs": "a spoon more",
    "What happened": "It said so at once.",
    "tries again": "",
}


def talked(*words: str, until: str = "never") -> tuple[int, str, str]:
    """Run a command whose questions are answered until it says something; its status and words."""
    pipe = subprocess.PIPE
    with subprocess.Popen(
        [*PROBE, *words], stdin=pipe, stdout=pipe, stderr=pipe, text=True
    ) as process:
        assert process.stdin and process.stdout and process.stderr
        heard: list[str] = []
        for line in process.stdout:
            heard.append(line)
            if until in line:
                process.stdin.close()
            reply = next((it for part, it in REPLIES.items() if part in line), None)
            if reply is not None and not process.stdin.closed:
                process.stdin.write(reply + "\n")
                process.stdin.flush()
        return process.wait(30), "".join(heard), process.stderr.read()


@pytest.mark.slow
def test_an_agent_works_on_the_twin_and_leaves_a_record(tmp_path: Path, twin: str) -> None:
    key, out = ["--token-file", str(tmp_path / "token")], tmp_path / "out"
    key += ["--approve", "auto", "--slow-motions", "0", "--page-port", "0"]
    done = probe("run", twin, "--suite", "demo", "--task", TASK.id, "--out", str(out), *key)
    assert done.returncode == 0, done.stderr
    (record,) = read_records(out / "records.jsonl")
    assert (record.task, record.agent, record.perception.kind) == (TASK.id, "scripted", "segmenter")
    assert record.fault is None and len(record.frames) == len(record.steps) + 1 > 1
    assert all((out / f"{name}.jpg").exists() for name in record.frames)
    commands = [json.loads(line) for line in (out / "commands.jsonl").read_text().splitlines()]
    assert [(line["event"], line["do"]) for line in commands[:2]] == [
        ("asked", "hello"),
        ("ended", "hello"),
    ]
    again = probe("run", twin, "--suite", "demo", "--task", TASK.id, "--out", str(out), *key)
    assert again.returncode == 1 and "--run 1" in again.stderr
    (tmp_path / "wrong").write_text("not the token of this bridge\n")
    key[1] = str(tmp_path / "wrong")
    refused = probe(
        "run", twin, "--suite", "demo", "--task", TASK.id, "--out", str(tmp_path / "other"), *key
    )
    assert refused.returncode == 1 and "unauthorized" in refused.stderr


@pytest.mark.slow
def test_a_session_goes_on_where_its_operator_left_it(tmp_path: Path, twin: str) -> None:
    plan, out = tmp_path / "session.yaml", tmp_path / "out"
    plan.write_text(
        f"suite: demo\ntasks: [{TASK.id}]\nagents: [always-A, always-E]\nseed: 1\noperator: Jana\n"
    )
    command = ["session", twin, str(plan), "--out", str(out)]
    command += ["--token-file", str(tmp_path / "token"), "--page-port", "0"]
    status, said, failed = talked(*command, until="agent 2 of 2")
    assert status == 1 and "standard input: has ended" in failed
    assert "agent 1 of 2" in said and "always-" not in said
    unfinished = probe("verify-session", str(out))
    assert unfinished.returncode == 1 and "1 of 2 episodes are missing" in unfinished.stderr
    status, said, failed = talked(*command)
    assert status == 0, failed
    assert "agent 1 was always-" in said
    assert said.count("Any key stops the robot, and so does http://127.0.0.1:") == 1
    assert "all fit" in probe("verify-session", str(out)).stdout
    records = [it for it in read_records(out / "records.jsonl") if it.answer]
    assert sorted((it.agent, it.answer.choice) for it in records if it.answer) == [
        ("always-A", "A"),
        ("always-E", "E"),
    ]


@pytest.mark.parametrize("written", ["no JSON", "[]", '[{"name": "top"}]'])
def test_a_twin_is_told_only_of_cameras_that_there_are(tmp_path: Path, written: str) -> None:
    (tmp_path / "cameras.json").write_text(written)
    done = probe("twin", "--box", "0.06", "0.06", "0.1", "--port", "0",
                 "--cameras", str(tmp_path / "cameras.json"),
                 "--token-file", str(tmp_path / "token"))  # fmt: skip
    assert done.returncode == 1 and "cameras.json" in done.stderr, done.stderr
    assert "Traceback" not in done.stderr


def test_a_token_that_isnt_there_is_named(tmp_path: Path) -> None:
    where = ["--token-file", str(tmp_path / "nope"), "--out", str(tmp_path / "out")]
    done = probe("run", "ws://127.0.0.1:9", "--suite", "demo", "--task", TASK.id, *where)
    assert done.returncode == 1 and "nope" in done.stderr and "--token-file" in done.stderr
    assert "Traceback" not in done.stderr


def test_labels_are_no_perception_for_a_robot() -> None:
    done = probe("run", "ws://127.0.0.1:9", "--suite", "demo", "--task", TASK.id,
                 "--perception", "oracle")  # fmt: skip
    assert done.returncode == 1 and "a robot has none" in done.stderr


@pytest.mark.slow
def test_objects_of_the_catalogue_are_enrolled_without_a_robot(tmp_path: Path) -> None:
    listed = tmp_path / "objects.yaml"
    listed.write_text("version: 1\nobjects:\n- name: red mug\n- name: banana\n- name: carrot\n")
    done = probe("enrol", str(listed))
    assert done.returncode == 0, done.stderr
    known = read_enrolment(listed)
    assert [item.words.name for item in known.objects] == ["red mug", "banana", "carrot"]
    assert all(item.views for item in known.objects)
    listed.write_text("version: 1\nobjects:\n- name: unicorn\n")
    refused = probe("enrol", str(listed))
    assert refused.returncode == 1 and "'unicorn'" in refused.stderr
