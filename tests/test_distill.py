"""runs/distill.sh from top to bottom, much smaller than it is; its one task is made already."""

from __future__ import annotations

import shutil
import tarfile
from dataclasses import replace
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from free_ports import free_ports
from lessons import FIRST_SEED
from model_server import Reply, serving
from probe.assets.library import TRAINING_POOL, open_library
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.generation.build_folder import BuildFolder, TaskSlot
from probe.tasks.suite import part, selection
from probe.tasks.suite_file import demo_suite, read_suite, write_suite
from probe.train.collect.batches import TASKS
from probe.train.collect.training import FIRST_EPISODE
from recipe_scripts import ROOT, run_script

SMALL = {
    "ARMS": "direct",
    "WORKERS": "1",
    "COUNTS": "--counts.count 1 --counts.find 0 --counts.size 0 --counts.reduce 0 "
    "--counts.compare 0 --batch 1",
    "SELECT": "--slack 9 --no-near",
    "TINY": "--width 48 --layers 2 --words 600 --vision-width 32 --vision-layers 2 --side-px 64",
    "TRAIN": "--learning-rate 1e-3 --global-batch 1 --epochs 1",
    "SERVE": "--most-tokens 16",
}


def script(folder: Path, port: int, *words: str, **more: str) -> CompletedProcess[str]:
    settings = {"SUITE": str(folder / "one.json"), "OUT": str(folder / "out"), "PORT": str(port)}
    return run_script(*words, **(SMALL | settings | more))


def make_ready(collected: Path, cache: Path) -> None:
    """The first task of a collection, one of those whose episodes are packaged."""
    packaged = "collected/batches/0of1-00000/suite.json"
    with tarfile.open(ROOT / "runs/data/teacher.tar.xz") as archive:
        archive.extract(packaged, collected.parent / "packaged", filter="data")
    tasks = read_suite(collected.parent / "packaged" / packaged).tasks
    task = next(task for task in tasks if task.id == "count-87d88442")
    BuildFolder(collected / TASKS).keep(
        TaskSlot("count", FIRST_EPISODE),
        replace(task, id="count-00000001", seed=FIRST_SEED),
        open_library(TRAINING_POOL, None, cache),
    )


def begun_with_these_settings(folder: Path) -> None:
    """What the script writes first, so that it goes on with the task that is there."""
    said = SMALL | {"SUITE": str(folder / "one.json")}
    names = ("SUITE", "ARMS", "COUNTS", "SELECT", "TINY", "TRAIN")
    lines = "".join(f"{name}={said[name]}\n" for name in names)
    (folder / "out/settings").write_text(lines)


def who_answered(folder: Path) -> set[str]:
    """As the harness's log has it from the replies, not from what was asked for."""
    from inspect_ai.log import list_eval_logs, read_eval_log

    logs = [read_eval_log(it) for it in list_eval_logs(str(folder))]
    return {sample.output.model for log in logs for sample in log.samples or []}


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_the_recipe(tmp_path, cache):
    make_ready(tmp_path / "out/collected", cache)
    begun_with_these_settings(tmp_path)
    demo = demo_suite()
    one = next(task for task in demo.tasks if task.question_type == "count")
    write_suite(tmp_path / "one.json", part(demo, one))
    done = script(tmp_path, free_ports(), "distill.sh")
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    out = tmp_path / "out"
    table = (out / "table.md").read_text()
    rows = [line.split(" | ")[0].strip("| ") for line in table.splitlines() if line[:1] == "|"][2:]
    assert {"untrained, direct", "trained, direct", "scripted, scripted"} < set(rows)
    assert "question-only, blind" in rows and any(row.startswith("always-") for row in rows)
    assert (out / "trained/README.md").exists()
    for name in ("untrained", "trained"):
        assert who_answered(out / "runs" / f"{name}-direct") == {name}
    several_servers_share_the_tasks(tmp_path)
    nobody_else_answers(tmp_path)


def several_servers_share_the_tasks(folder: Path) -> None:
    """Two of them, one task each."""
    demo, two = demo_suite(), str(folder / "two.json")
    write_suite(folder / "two.json", selection(demo, demo.tasks[:2], demo.name))
    again = {"SERVERS": "2", "SUITE": two, "OUT": str(folder / "again")}
    model = str(folder / "out/trained/model")
    done = script(folder, free_ports(2), "serve_and_run.sh", "trained", model, **again)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    runs = folder / "again/runs"
    assert {it.task for it in read_records(runs / "trained-direct" / RECORDS)} == {
        task.id for task in demo.tasks[:2]
    }
    for shard in (folder / "again/shards/trained-direct-of-2").iterdir():
        assert len(read_records(shard / RECORDS)) == 1


def nobody_else_answers(folder: Path) -> None:
    """The model again, where a stranger listens who says something to everybody."""
    shutil.rmtree(folder / "out/runs")
    with serving(lambda number, body: Reply("ANSWER: A")) as stranger:
        port = int(stranger.url.rpartition(":")[2].removesuffix("/v1"))
        done = script(
            folder, port, "serve_and_run.sh", "trained", str(folder / "out/trained/model")
        )
    assert done.returncode == 1
    assert f"Something else listens at port {port}" in done.stderr
    assert stranger.requests == 0 and not (folder / "out/runs").exists()
