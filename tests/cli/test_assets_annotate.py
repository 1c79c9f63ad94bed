"""`probe assets annotate | review` from outside, against a server of moods."""

import csv
import json
import os
import subprocess
import sys

import pytest

from model_server import Reply, serving
from probe.assets.annotation.notes import read_notes

pytestmark = pytest.mark.slow

GOOD = {"name": "green thing", "category": "thing", "colours": ["green"], "description": "A thing."}
COUNT = 10
"""More than are drawn at once, and than the moods of the server."""


def probe(*arguments, **environment):
    return subprocess.run(
        [sys.executable, "-m", "probe", "assets", *map(str, arguments)],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )


def moody(number: int, body: dict[str, object]) -> Reply:
    """Of every ten requests: good ones, broken words, a refusal, errors, and one that is late."""
    moods = {
        2: Reply("I see a lovely thing."),
        4: Reply(refusal="I can't help with that."),
        5: Reply(status=429),
        6: Reply(status=500),
        8: Reply(json.dumps(GOOD), wait=4.0),
    }
    return moods.get(number % 10, Reply(json.dumps(GOOD)))


def test_nothing_is_lost_and_the_rest_is_asked_again(assets, tmp_path):
    def annotate(url: str):
        told = ("annotate", tmp_path, "--endpoint", url, "--model", "m", "--pool", "scans")
        return probe(*told, "--limit", COUNT, "--timeout", 2)

    with serving(moody) as served:
        first = annotate(served.url)
        assert first.returncode == 0, first.stderr
    notes = read_notes(tmp_path)
    failed = [note for note in notes if note.problem]
    assert len(notes) == COUNT and 1 <= len(failed) < COUNT / 2
    assert f"{COUNT - len(failed)} described, {len(failed)} without" in first.stdout
    content = served.bodies[0]["messages"][0]["content"]  # type: ignore[index]
    assert [part["type"] for part in content] == ["image_url"] * 6 + ["text"]
    with serving(lambda number, body: Reply(json.dumps(GOOD))) as question_type:
        assert annotate(question_type.url).returncode == 0
        assert len(question_type.bodies) == len(failed)
        assert annotate(question_type.url).returncode == 0
        assert len(question_type.bodies) == len(failed)
    assert all(note.done for note in read_notes(tmp_path))
    corrects(tmp_path)


def corrects(folder) -> None:
    assert probe("review", folder).returncode == 0
    assert (folder / "review.html").read_text().count("<article") == COUNT
    with (folder / "review.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    rows[3]["name"] = "emerald thing"
    with (folder / "review.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    told = probe("review", folder)
    assert "1 objects corrected" in told.stdout
    note = next(note for note in read_notes(folder) if note.id == rows[3]["id"])
    assert note.name == "emerald thing" and note.origins["name"] == "human"
    assert note.origins["category"] == "model"


def test_no_server_is_no_loss(tmp_path):
    told = probe(
        "annotate", tmp_path, "--endpoint", "http://127.0.0.1:9/v1", "--model", "m",
        "--pool", "procedural", "--limit", 1,
    )  # fmt: skip
    assert told.returncode == 0 and "0 described" not in told.stdout
    (note,) = read_notes(tmp_path)
    assert "127.0.0.1:9" in note.problem and not note.done
