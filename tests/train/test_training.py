"""Training on a very small model: what it refuses, and that it goes on where it was killed."""

from __future__ import annotations

import shutil
import signal
import subprocess
import sys
import time
from importlib import import_module

import pytest

from probe.episodes.folder import reserved
from probe.errors import BadData, MissingExtra, OutputFailed
from probe.train.dataset.manifest import Manifest, write_manifest
from probe.train.tune import libraries
from probe.train.tune.fine_tuning import train
from probe.train.tune.loading import NoModel, UnknownTemplate, load
from probe.train.tune.run_card import Run
from probe.train.tune.started import TRAINING, begun, take_up
from probe.train.tune.training_log import read_log
from probe.train.tune.tuning import Tuning
from small_models import small_dataset, small_model

TUNING = Tuning(learning_rate=1e-3, global_batch=4, save_every=2)
OPTIONS = ("--learning-rate", "1e-3", "--global-batch", "4", "--save-every", "2")
NOISE = 1e-3


def _weights(folder):
    # Named by text: the extra isn't there where the types are checked.
    return import_module("safetensors.torch").load_file(folder / "model.safetensors")


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    return small_dataset(tmp_path_factory.mktemp("dataset"))


@pytest.fixture(scope="module")
def model(tmp_path_factory, dataset):
    return small_model(tmp_path_factory.mktemp("model"), dataset)


def losses(out):
    return {entry.step: entry.loss for entry in read_log(out)}


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_a_killed_training_goes_on_with_the_same_loss(tmp_path, dataset, model):
    train(dataset, str(model), tmp_path / "whole", TUNING, ())
    cut = tmp_path / "cut"
    command = [sys.executable, "-m", "probe", "train", str(dataset), "--out", str(cut)]
    process = subprocess.Popen(
        [*command, "--model", str(model), *OPTIONS],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    while len(losses(cut)) < 3 and process.poll() is None:
        time.sleep(0.05)
    process.send_signal(signal.SIGKILL)
    assert process.wait() == -signal.SIGKILL
    assert not (cut / "model").exists() and (cut / "checkpoints/checkpoint-2").exists()
    # As if it had been killed while it saved the next one.
    (cut / "checkpoints/checkpoint-4").mkdir(exist_ok=True)
    (cut / "checkpoints/checkpoint-4/trainer_state.json").write_text("")
    train(dataset, str(model), cut, TUNING, ())
    whole = losses(tmp_path / "whole")
    # 9 examples, 4 a step, twice.
    assert sorted(whole) == [1, 2, 3, 4, 5, 6]
    assert losses(cut) == pytest.approx(whole, abs=NOISE)
    assert whole[6] < whole[1]
    read, after = (
        {it.step: it.tokens for it in read_log(tmp_path / name)} for name in ("whole", "cut")
    )
    assert after[6] == read[6] - read[2]  # since it went on
    run = Run.model_validate_json((cut / "run.json").read_text())
    assert run.steps == 6 and run.versions["trl"] and run.begun.tuning["epochs"] == 2.0
    assert f"| 6-6 | {losses(cut)[6]:.4f} |" in (cut / "README.md").read_text()
    # A finished one has nothing left to do.
    before = (cut / "run.json").read_bytes()
    train(dataset, str(model), cut, TUNING, ())
    assert (cut / "run.json").read_bytes() == before
    with pytest.raises(BadData, match=r"was begun with epochs 2.0, not 3.0"):
        train(dataset, str(model), cut, Tuning(1e-3, 3.0, 4, save_every=2), ())


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_lora_leaves_a_whole_model(tmp_path, dataset, model):
    tuning = Tuning(learning_rate=1e-2, global_batch=9, epochs=1, lora=2)
    folder = train(dataset, str(model), tmp_path, tuning, ())
    before, after = load(str(model))[0].state_dict(), load(str(folder))[0].state_dict()
    assert before.keys() == after.keys()
    changed = {name for name in before if not before[name].equal(after[name])}
    assert changed and not any("norm" in name or "embed_tokens" in name for name in changed)
    assert (tmp_path / "adapter/adapter_config.json").exists()


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
@pytest.mark.parametrize(("lora", "kept"), [(None, "float32"), (2, "bfloat16")])
def test_where_a_gpu_computes_in_bfloat16_weights_are_trained_in_float32(
    tmp_path, dataset, model, monkeypatch, lora, kept
):
    # Processors do so too.
    monkeypatch.setattr(libraries, "computes_in_bfloat16", lambda: True)
    tuning = Tuning(learning_rate=1e-5, global_batch=9, epochs=1, lora=lora)
    folder = train(dataset, str(model), tmp_path, tuning, ())
    run = Run.model_validate_json((tmp_path / "run.json").read_text())
    assert run.weights == "float32"
    assert "trained are float32" in (tmp_path / "README.md").read_text()
    before, after = _weights(model), _weights(folder)
    assert {str(it.dtype) for it in after.values()} == {f"torch.{kept}"}
    if lora is None:
        # A step of 1e-5 is a fraction of what bfloat16 tells apart near 0.02.
        (name,) = (it for it in before if it.endswith("layers.1.mlp.up_proj.weight"))
        assert (before[name] != after[name]).float().mean() > 0.9


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
@pytest.mark.parametrize(
    ("tuning", "steps"),
    [
        (Tuning(learning_rate=1e-3, global_batch=9, epochs=1), [1]),
        # Its last step isn't an epoch's.
        (Tuning(learning_rate=1e-3, global_batch=4, steps=2, save_every=1), [1, 2]),
    ],
)
def test_a_model_is_never_without_its_card(tmp_path, dataset, model, tuning, steps):
    (tmp_path / "README.md").mkdir()
    with pytest.raises(OutputFailed, match=r"README\.md"):
        train(dataset, str(model), tmp_path, tuning, ())
    assert not (tmp_path / "model").exists()
    (tmp_path / "README.md").rmdir()
    folder = train(dataset, str(model), tmp_path, tuning, ())
    assert (tmp_path / "run.json").exists() and (tmp_path / "README.md").is_file()
    assert sorted(losses(tmp_path)) == steps and load(str(folder))


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_a_loss_that_isnt_finite_ends_it(tmp_path, dataset, model):
    tuning = Tuning(learning_rate=1e30, global_batch=4, save_every=1)
    with pytest.raises(BadData, match="--learning-rate: the loss of step 2 is (nan|inf)"):
        train(dataset, str(model), tmp_path, tuning, ())
    assert sorted(losses(tmp_path)) == [1] and not (tmp_path / "model").exists()


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_two_cannot_train_in_one_folder(tmp_path, dataset, model):
    take_up(tmp_path, begun(dataset, str(model), TUNING))
    with (
        reserved(tmp_path, TRAINING),
        pytest.raises(BadData, match="another run is at work there"),
    ):
        train(dataset, str(model), tmp_path, TUNING, ())


def broken(tmp_path, folder):
    copy = tmp_path / "broken"
    shutil.copytree(folder, copy)
    return copy


@pytest.mark.parametrize("cut", [10, 0])
def test_nothing_is_trained_on_a_corrupted_shard(tmp_path, dataset, cut):
    data = broken(tmp_path, dataset)
    shard = next((data / "data").glob("*.parquet"))
    whole = shard.read_bytes()
    shard.write_bytes(whole[:-cut] if cut else whole[:2000] + b"?" + whole[2001:])
    with pytest.raises(BadData, match=rf"{shard.name}: .*Write the data set again"):
        train(data, "anything", tmp_path / "out", TUNING, ())
    assert not (tmp_path / "out").exists()


def test_nothing_is_trained_without_a_type_that_is_named(tmp_path, dataset):
    with pytest.raises(BadData, match="there is no example of size"):
        train(dataset, "anything", tmp_path / "out", TUNING, ("size",))
    data = broken(tmp_path, dataset)
    manifest = Manifest.model_validate_json((data / "manifest.json").read_text())
    empty = manifest.examples | {"size": {"agentic": 0, "direct": 0}}
    write_manifest(data, manifest.model_copy(update={"examples": empty}))
    with pytest.raises(BadData, match="there is no example of size"):
        train(data, "anything", tmp_path / "out", TUNING, ())
    assert not (tmp_path / "out").exists()


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_a_model_that_is_not_there_or_cut_off_is_named(tmp_path, dataset, model):
    with pytest.raises(NoModel, match="nowhere can't be loaded"):
        train(dataset, str(tmp_path / "nowhere"), tmp_path / "out", TUNING, ())
    cut = broken(tmp_path, model)
    weights = (cut / "model.safetensors").read_bytes()
    for size in (0, 1000, len(weights) - 1000):
        (cut / "model.safetensors").write_bytes(weights[:size])
        with pytest.raises(NoModel, match="broken can't be loaded"):
            train(dataset, str(cut), tmp_path / "out", TUNING, ())
    assert not (tmp_path / "out").exists()


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
def test_a_template_of_an_unknown_kind_is_named(tmp_path, dataset, model):
    other = broken(tmp_path, model)
    template = other / "chat_template.jinja"
    template.write_text(template.read_text() + "{# mine #}")
    for _ in range(2):
        with pytest.raises(UnknownTemplate, match=r"turns in the chat template of .*broken"):
            train(dataset, str(other), tmp_path / "out", TUNING, ())
        template.unlink(missing_ok=True)
    assert not (tmp_path / "out").exists()


@pytest.mark.slow
def test_one_process_with_several_gpus_is_refused(tmp_path, dataset, model, monkeypatch):
    monkeypatch.setattr(libraries.torch().cuda, "device_count", lambda: 2)
    with pytest.raises(BadData, match=r"GPUs: one process sees 2\. Start it through accelerate"):
        train(dataset, str(model), tmp_path / "out", TUNING, ())
    assert not (tmp_path / "out").exists()


def test_without_the_extra_it_is_named(tmp_path, dataset, monkeypatch):
    monkeypatch.setitem(sys.modules, "torch", None)
    with pytest.raises(MissingExtra, match=r"install -e '\.\[train\]'"):
        train(dataset, "anything", tmp_path / "out", TUNING, ())
