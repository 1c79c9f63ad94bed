"""A model that sees no pictures: trained on the setting text-only, and served."""

from __future__ import annotations

import base64
import json
import math
import shutil
from concurrent.futures import ThreadPoolExecutor

import pytest

from probe.errors import BadData
from probe.train.serve.speaking import ConversationTooLong, ServedModel
from probe.train.tune import libraries
from probe.train.tune.collating import encoded
from probe.train.tune.conversations import NotUnderstood, of_row, tools_of_row
from probe.train.tune.fine_tuning import train
from probe.train.tune.loading import load
from probe.train.tune.processors import sees
from probe.train.tune.run_card import Run
from probe.train.tune.training_log import read_log
from probe.train.tune.tuning import Tuning
from small_models import picture, small_dataset, small_model

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    return small_dataset(tmp_path_factory.mktemp("dataset"), pictures=False)


@pytest.fixture(scope="module")
def model(tmp_path_factory, dataset):
    return small_model(tmp_path_factory.mktemp("model"), dataset, pictures=False)


@pytest.mark.parametrize("lora", [None, 2])
def test_it_learns_without_pictures(tmp_path, dataset, model, lora):
    tuning = Tuning(learning_rate=1e-2, global_batch=2, epochs=3, lora=lora)
    folder = train(dataset, str(model), tmp_path, tuning, ())
    log = read_log(tmp_path)
    assert log[-1].loss < 0.98 * log[0].loss
    assert not sees(load(str(folder))[1])
    card = (tmp_path / "README.md").read_text()
    # Four episodes of each type, all with tools.
    assert "| count | 4 | 0 |" in card and "| find | 4 | 0 |" in card
    run = Run.model_validate_json((tmp_path / "run.json").read_text())
    assert run.tokens == 3 * tokens_of(dataset, model)
    assert f"{run.tokens:,} tokens read" in card


def tokens_of(dataset, model) -> int:
    processor = load(str(model))[1]
    return sum(
        encoded(processor, of_row(row), tools_of_row(row))["input_ids"].shape[1]
        for row in libraries.part("datasets").load_dataset(str(dataset))["train"]
    )


def test_it_makes_as_many_steps_as_are_asked_for(tmp_path, dataset, model):
    # Each of two steps reads all eight examples, where the epochs would be one.
    train(dataset, str(model), tmp_path, Tuning(1e-3, 1.0, global_batch=8, steps=2), ())
    run = Run.model_validate_json((tmp_path / "run.json").read_text())
    assert len(read_log(tmp_path)) == run.steps == 2
    assert run.tokens == 2 * tokens_of(dataset, model)


def test_attention_makes_no_plan_for_each_length(model):
    load(str(model))
    assert not libraries.torch().backends.cuda.cudnn_sdp_enabled()


def test_in_bfloat16_on_a_processor_that_has_it(tmp_path, dataset, model, monkeypatch):
    monkeypatch.setattr(libraries, "cpu_computes_in_bfloat16", lambda: True)
    tuning = Tuning(learning_rate=1e-3, global_batch=8, epochs=1, cpu_bfloat16=True)
    train(dataset, str(model), tmp_path / "short", tuning, ())
    run = Run.model_validate_json((tmp_path / "short" / "run.json").read_text())
    assert (run.weights, run.computed) == ("float32", "bfloat16")
    train(dataset, str(model), tmp_path / "long", Tuning(1e-3, global_batch=8, epochs=1), ())
    (short,), (long,) = read_log(tmp_path / "short"), read_log(tmp_path / "long")
    assert short.loss == pytest.approx(long.loss, rel=0.01) and short.loss != long.loss


def test_pictures_are_refused(tmp_path, model):
    with pytest.raises(BadData, match=r"pictures, and .*Write it with --setting text-only"):
        train(small_dataset(tmp_path), str(model), tmp_path / "out", Tuning(), ())
    assert not (tmp_path / "out").exists()
    pixel = base64.b64encode(picture(9)).decode()
    shown = {"type": "image_url", "image_url": {"url": f"data:image/jpeg;base64,{pixel}"}}
    body = {"messages": [{"role": "user", "content": [shown]}]}
    with pytest.raises(NotUnderstood, match="takes none: --setting text-only"):
        ServedModel(str(model)).reply(body)


def test_tools_in_no_form_that_a_template_knows_are_refused(model):
    body = {"messages": [{"role": "user", "content": "Hello"}], "tools": 5}
    with pytest.raises(NotUnderstood, match="template can't write it"):
        ServedModel(str(model)).reply(body)


def test_what_was_read_before_changes_no_reply(model):
    """Turns of two conversations in turn, against a server that reads all of each again."""
    served = ServedModel(str(model))
    told = {name: [{"role": "user", "content": f"{name} lies there."}] for name in ("A", "B")}
    for _ in range(3):
        for said in told.values():
            body = {"messages": said, "max_tokens": 12}
            reply = served.reply(body)
            assert reply == ServedModel(str(model)).reply(body)
            words = reply.reply.words or json.dumps(reply.reply.calls)
            said += [{"role": "assistant", "content": words}, {"role": "user", "content": "And?"}]


def test_replies_written_side_by_side_are_those_written_alone(model):
    bodies = [
        {"messages": [{"role": "user", "content": f"{name} lies there."}], "max_tokens": 12}
        for name in ("A mug", "B", "The long red pen", "C", "D")
    ]
    served = ServedModel(str(model), at_once=3)
    with ThreadPoolExecutor(len(bodies)) as pool:
        found = list(pool.map(served.reply, bodies))
    assert found == [ServedModel(str(model)).reply(body) for body in bodies]


def test_models_that_see_write_one_reply_at_a_time(tmp_path):
    seeing = small_model(tmp_path / "model", small_dataset(tmp_path / "data"))
    with pytest.raises(BadData, match="--at-once: .* one reply at a time, since it sees"):
        ServedModel(str(seeing), at_once=2)


@pytest.mark.parametrize("pictures", [False, True])
def test_a_reply_that_ends_in_another_of_its_models_ends_isnt_cut_off(tmp_path, pictures):
    folder = small_model(
        tmp_path / "m", small_dataset(tmp_path, pictures=pictures), pictures=pictures
    )
    body = {"messages": [{"role": "user", "content": "A lies there."}], "max_tokens": 12}
    asked = ServedModel(str(folder)).asked(body)
    with libraries.torch().inference_mode():
        first = int(load(str(folder))[0](**asked).logits[0, -1].argmax())
    path = folder / "generation_config.json"
    config = json.loads(path.read_text())
    path.write_text(json.dumps(config | {"eos_token_id": [config["eos_token_id"], first]}))
    reply = ServedModel(str(folder)).reply(body)
    assert (reply.tokens_out, reply.cut) == (1, False)


@pytest.mark.parametrize(
    "asked",
    [
        {"max_tokens": -1},
        {"max_completion_tokens": 0},
        {"max_tokens": "many"},
        {"temperature": math.inf},
        {"temperature": "x"},
    ],
)
def test_limits_that_make_no_sense_are_refused(model, asked):
    body = {"messages": [{"role": "user", "content": "A lies there."}], **asked}
    with pytest.raises(NotUnderstood, match="can't have|is no temperature"):
        ServedModel(str(model)).reply(body)


@pytest.mark.parametrize(("room", "said"), [(3, 3), (0, None)])
def test_a_conversation_must_leave_room_for_a_reply(tmp_path, model, room, said):
    body = {"messages": [{"role": "user", "content": "A lies there."}], "max_tokens": 12}
    start = ServedModel(str(model)).reply(body).tokens_in
    narrow = shutil.copytree(model, tmp_path / "narrow")
    config = json.loads((narrow / "config.json").read_text())
    config["max_position_embeddings"] = start + room
    (narrow / "config.json").write_text(json.dumps(config))
    served = ServedModel(str(narrow))
    if said is None:
        with pytest.raises(ConversationTooLong, match=f"has {start} tokens, and .*--graphs short"):
            served.reply(body)
    else:
        assert served.reply(body).tokens_out <= said


def test_replies_are_drawn_where_the_server_is_warm(model):
    """With the same seed the same; a request that says a temperature has that one."""
    body = {"messages": [{"role": "user", "content": "Say something."}], "max_tokens": 20}
    warm = [ServedModel(str(model), temperature=1.5, seed=n).reply(body) for n in (1, 1, 2)]
    greedy = ServedModel(str(model)).reply(body)
    assert warm[0] == warm[1] != warm[2] and greedy not in warm
    cold = ServedModel(str(model), temperature=1.5, seed=1).reply(body | {"temperature": 0})
    assert cold == greedy
