"""Training in two processes on the CPU, as on several GPUs."""

from __future__ import annotations

import subprocess
import sys

import pytest

from probe.train.tune.fine_tuning import train
from probe.train.tune.training_log import read_log
from probe.train.tune.tuning import Tuning
from small_models import small_dataset, small_model

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]


def launched(*words: object) -> subprocess.CompletedProcess[str]:
    """What comes of `probe train` in two processes."""
    command = ["-m", "torch.distributed.run", "--standalone", "--nproc_per_node", "2"]
    return subprocess.run(
        [sys.executable, *command, "-m", "probe", "train", *map(str, words)],
        capture_output=True, text=True, timeout=400,
    )  # fmt: skip


def test_two_processes_train_the_same_model_and_one_of_them_writes_it(tmp_path):
    dataset = small_dataset(tmp_path / "data")
    model = small_model(tmp_path / "model", dataset)
    train(dataset, str(model), tmp_path / "one", Tuning(learning_rate=1e-3, global_batch=4), ())
    options = ("--model", model, "--learning-rate", "1e-3", "--global-batch", "4")
    ended = launched(dataset, "--out", tmp_path / "two", *options)
    assert ended.returncode == 0, ended.stderr[-2000:]
    assert ended.stdout.count("Checkpoints go to") == ended.stdout.count("The model is in") == 1
    assert (tmp_path / "two" / "model" / "config.json").exists()
    assert (tmp_path / "two" / "run.json").exists()
    alone, together = (
        [entry.loss for entry in read_log(tmp_path / name)] for name in ("one", "two")
    )
    # Of nine examples the third step of an epoch has one, which both processes take.
    assert len(together) == len(alone) == 6
    assert together[:2] == pytest.approx(alone[:2], rel=1e-4)
    assert together == pytest.approx(alone, rel=1e-2)


def test_matrices_are_not_shared(tmp_path):
    dataset = small_dataset(tmp_path / "data")
    model = small_model(tmp_path / "model", dataset)
    ended = launched(dataset, "--out", tmp_path / "two", "--model", model, "--lora", "2")
    assert ended.returncode != 0
    assert "--lora: can't be shared by 2 processes. Train on one GPU" in " ".join(
        ended.stderr.split()
    )
    assert not (tmp_path / "two").exists()
