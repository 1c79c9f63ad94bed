"""runs/student.sh and runs/scaling.sh from top to bottom, much smaller than they are."""

from __future__ import annotations

from pathlib import Path

import pytest

from free_ports import free_ports
from probe.tasks.suite import part
from probe.tasks.suite_file import demo_suite, write_suite
from recipe_scripts import run_script
from small_models import small_dataset, small_model

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]
SERVE = "--cpu-bfloat16 --most-tokens 16"


@pytest.fixture(scope="module")
def base(tmp_path_factory):
    folder = tmp_path_factory.mktemp("base")
    return small_model(folder, small_dataset(folder, pictures=False), pictures=False)


@pytest.fixture(scope="module")
def student(tmp_path_factory, base):
    """What was printed, and where everything is. Nothing is collected: there are enough."""
    folder = tmp_path_factory.mktemp("student")
    demo, out = demo_suite(), folder / "out"
    one = next(task for task in demo.tasks if task.question_type == "count")
    write_suite(folder / "one.json", part(demo, one))
    done = run_script(
        "student.sh",
        WORKERS="1",
        SUITE=str(folder / "one.json"),
        OUT=str(out),
        PORT=str(free_ports()),
        BASE=str(base),
        SELECT="--no-near --counts count 2 find 2",
        TRAIN="--learning-rate 1e-3 --global-batch 2 --epochs 1",
        SERVE=SERVE,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    return done.stdout, out


def check_tables(out: Path, *models: str) -> None:
    for name in ("ladder.md", "table.md"):
        text = (out / name).read_text()
        for model in models:
            assert f"{model}, text-only, short graphs" in text, text


def test_from_the_packaged_episodes_to_a_table(student):
    told, out = student
    card = (out / "trained/README.md").read_text()
    assert "| count | 2 | 0 |" in card and "| find | 2 | 0 |" in card
    assert "379 episodes, 0 missing" in told
    check_tables(out, "base", "student")


def test_more_examples_and_augmented_ones(student, base, tmp_path):
    done = run_script(
        "scaling.sh",
        WORKERS="1",
        STUDENT=str(student[1]),
        BASE=str(base),
        OUT=str(tmp_path),
        PORT=str(free_ports()),
        EXAMPLES="5",
        UNAUGMENTED="6",
        VALIDATION="--counts.count 1",
        SELECT="--no-near --counts count 2 find 2 compare 0 reduce 0 size 0",
        DATASET="--no-find",
        AUGMENT="--augment wordings",
        TUNE="--learning-rate 1e-3",
        SERVE=SERVE,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    card = (tmp_path / "trained/augmented-5/README.md").read_text()
    assert "4 examples and 4 that tell them again, 5 steps" in card
    # Four episodes, two of which are read twice.
    assert "4 examples, 6 steps" in (tmp_path / "trained/unaugmented-6/README.md").read_text()
    check_tables(tmp_path, "base", "augmented-5", "unaugmented-6")
