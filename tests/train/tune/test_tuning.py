"""Settings of a training that are refused before anything is begun."""

from __future__ import annotations

import sys
from math import inf, nan

import pytest

from probe.cli import main
from probe.errors import BadData
from probe.train.tune.tuning import Tuning


@pytest.mark.parametrize(
    ("option", "settings"),
    [
        ("--lora", {"lora": 0}),
        ("--warmup", {"warmup": -1.0}),
        ("--warmup", {"warmup": 1.0}),
        ("--epochs", {"epochs": 0.0}),
        ("--epochs", {"epochs": inf}),
        ("--learning-rate", {"learning_rate": 0.0}),
        ("--learning-rate", {"learning_rate": nan}),
        ("--global-batch", {"global_batch": 0}),
        ("--steps", {"steps": 0}),
        ("--device-batch", {"device_batch": 0}),
        ("--save-every", {"save_every": 0}),
        ("--loaders", {"loaders": -1}),
        ("--seed", {"seed": -1}),
        ("--seed", {"seed": 2**32}),
    ],
)
def test_a_setting_out_of_range_is_named(option, settings):
    with pytest.raises(BadData, match=f"^{option}: .* is out of range. Say "):
        Tuning(**settings)


def test_what_is_at_the_edge_is_taken():
    Tuning(lora=1, warmup=0.0, epochs=0.5, save_every=1, loaders=0, seed=2**32 - 1)


def test_the_command_says_so_in_one_line(tmp_path, monkeypatch):
    words = ["probe", "train", "nowhere", "--out", str(tmp_path / "out"), "--epochs", "0"]
    monkeypatch.setattr(sys, "argv", words)
    with pytest.raises(SystemExit, match="^probe: --epochs: 0.0 is out of range"):
        main()
    assert not (tmp_path / "out").exists()


def test_a_batch_that_does_not_come_out_even_is_refused():
    assert Tuning().accumulation(8) == 4
    with pytest.raises(BadData, match="32 isn't a multiple of 3 x 1"):
        Tuning().accumulation(3)
