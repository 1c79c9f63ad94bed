"""runs/student.sh from top to bottom, much smaller than it is."""

from __future__ import annotations

import pytest

from free_ports import free_ports
from probe.tasks.suite import part
from probe.tasks.suite_file import demo_suite, write_suite
from recipe_scripts import run_script
from small_models import small_dataset, small_model


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_from_the_packaged_episodes_to_a_table(tmp_path):
    """Nothing is collected: of the packaged episodes there are enough."""
    demo, out = demo_suite(), tmp_path / "out"
    one = next(task for task in demo.tasks if task.question_type == "count")
    write_suite(tmp_path / "one.json", part(demo, one))
    base = small_model(tmp_path, small_dataset(tmp_path, pictures=False), pictures=False)
    done = run_script(
        "student.sh",
        WORKERS="1",
        SUITE=str(tmp_path / "one.json"),
        OUT=str(out),
        PORT=str(free_ports()),
        BASE=str(base),
        SELECT="--no-near --counts count 2 find 2",
        TRAIN="--learning-rate 1e-3 --global-batch 2 --epochs 1",
        SERVE="--cpu-bfloat16 --most-tokens 16",
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    card = (out / "trained/README.md").read_text()
    assert "| count | 2 | 0 |" in card and "| find | 2 | 0 |" in card
    assert "155 episodes, 0 missing" in done.stdout
    for name in ("ladder.md", "table.md"):
        text = (out / name).read_text()
        assert "base, text-only, short graphs" in text, text
        assert "student, text-only, short graphs" in text, text
