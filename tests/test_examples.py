"""Every example runs as a reader would run it, and says what is true."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from probe.episodes.files import read_records
from probe.tasks.suite_file import read_suite

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"


@pytest.fixture
def example(tmp_path):
    """Runs an example in an empty folder; gives its output."""

    def run(name, *arguments, module=()):
        result = subprocess.run(
            [sys.executable, *module, str(EXAMPLES / name), *map(str, arguments)],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
        )
        assert result.returncode == 0, result.stderr
        return result.stdout

    return run


@pytest.mark.slow
def test_scene_draws_what_it_lists(example, tmp_path):
    told = example("scene.py", "--seed", 5, "--objects", 4, "--out", tmp_path / "scene.png")
    shares = [int(line.split("%")[0]) for line in told.splitlines() if line.endswith(" is visible")]
    assert len(shares) == 4 and shares == sorted(shares) and shares[0] >= 0 and shares[-1] <= 100
    picture = np.asarray(Image.open(tmp_path / "scene.png"))
    assert picture.shape == (1024, 1024, 3) and picture.std() > 10


@pytest.mark.slow
def test_play_uncovers_the_answer(example, tmp_path):
    told = example("play.py", "--out", tmp_path / "play")
    before, after = told.split("> grasp_and_remove(object_id='object_10')\n")
    assert after.startswith("Done:")
    assert 'name: "black tape"' not in before and 'name: "black tape"' in after
    assert told.endswith("The right answer is C; this one is right.\n")
    first, outlined, revealed = (
        np.asarray(Image.open(tmp_path / "play" / name))
        for name in ("1-perceive_scene.png", "2-find_object.png", "3-grasp_and_remove.png")
    )
    assert first.shape == (1024, 1024, 3)
    assert (first != outlined).any() and (first != revealed).any()


@pytest.mark.slow
def test_an_agent_is_scored_and_its_record_replays(example, tmp_path):
    run = ("-m", "probe", "run", "demo", "--limit", 2, "--out", tmp_path / "run", "--agent")
    told = example("agent.py:LiftWhatIsNamed", module=map(str, run))
    assert "in a process of its own" in told
    records = read_records(tmp_path / "run" / "records.jsonl")
    tasks = read_suite(tmp_path / "run" / "suite.json").tasks
    assert [record.task for record in records] == [task.id for task in tasks[:2]]
    assert all(
        record.agent == "LiftWhatIsNamed" and record.participation is None for record in records
    )
    record, task = records[0], tasks[0]
    assert record.answer and record.answer.choice == task.answer
    assert record.manipulations == 1
    again = example("replay.py", "--folder", tmp_path / "run")
    assert "The replay is the same, byte for byte.\nGraded: right. The replay: right.\n" in again


@pytest.mark.slow
def test_the_shortest_agent_answers_a_part_of_v1_and_scripts_read_the_end(example, tmp_path):
    run = ("run", "v1", "--limit", "2", "--out", tmp_path / "run", "--json", "--agent")
    told = example("my_agent.py:Agent", module=("-m", "probe", *map(str, run)))
    assert json.loads(told) == {
        "suite": "v1",
        "tasks": 2,
        "episodes": 2,
        "missing": 0,
        "records": str(tmp_path / "run" / "records.jsonl"),
    }
    records = read_records(tmp_path / "run" / "records.jsonl")
    assert [record.agent for record in records] == ["Agent"] * 2
    assert all(record.answer and record.answer.choice == "A" for record in records)
    assert "object_1" in (tmp_path / "run" / "agent.log").read_text()


@pytest.mark.slow
def test_another_program_plays_over_mcp(example, tmp_path):
    out = tmp_path / "run"
    told = example("mcp_client.py", "--out", out)
    assert "the green mug covered one object" in told and "Done: object_10 was lifted" in told
    (record,) = read_records(out / "records.jsonl")
    assert record.end == "answered" and record.agent == "mcp" and len(record.steps) == 4
    with Image.open(out / "grasp_and_remove.jpg") as image:
        assert image.size == (1024, 1024)


@pytest.mark.slow
def test_the_strip_is_wide_and_light_enough_for_the_readme(example, tmp_path):
    told = example("strip.py", "--out", tmp_path / "strip.jpg")
    assert told.startswith("right; ")
    with Image.open(tmp_path / "strip.jpg") as image:
        assert image.format == "JPEG" and image.width == 1600
    assert (tmp_path / "strip.jpg").stat().st_size < 400_000
