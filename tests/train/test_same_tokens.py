"""What a model is trained on is what it is sent, token by token, through the real harness."""

from __future__ import annotations

import base64
import gc
import threading
import time
from contextlib import contextmanager
from dataclasses import replace

import pytest

from bench.painted import demo, plan
from bench.sitting_in import kept, run_in, seat_of
from free_ports import free_ports
from probe.train.choose.efficiency import reminded
from probe.train.dataset.examples import example_of
from probe.train.dataset.rows import trl_row
from probe.train.dataset.showing import EpisodePictures
from probe.train.dataset.table import write_table
from probe.train.dataset.text_only import no_pictures
from probe.train.serve.replying import read_reply
from probe.train.serve.serving import application
from probe.train.serve.speaking import GeneratedReply, ServedModel
from probe.train.tune.collating import IGNORED
from probe.train.tune.loading import collator_for
from probe.train.tune.processors import tokenizer_of
from small_models import small_dataset, small_model

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

SUITE = demo(1)


def calling(words: str, name: str, arguments: str) -> str:
    call = f'<tool_call>\n{{"name": "{name}", "arguments": {arguments}}}\n</tool_call>'
    return f"{words}\n{call}" if words else call


EPISODES = {
    "agentic": [
        calling("I look first.", "perceive_scene", "{}"),
        calling("Söme words: “it”.", "find_object", '{"description": "the thing at (620, 480)"}'),
        calling("", "grasp_and_remove", '{"object_id": "object_1"}'),
        calling("Now I know.", "answer_question", '{"choice": "B", "point": [12, 700]}'),
    ],
    "direct": ["It must be this one.\nANSWER: C (250, 750)"],
    "text-only": [
        calling("I look first.", "perceive_scene", "{}"),
        calling("", "find_object", '{"description": "white ball"}'),
        calling("", "grasp_and_remove", '{"object_id": "object_1"}'),
        calling("What has changed?", "perceive_scene", "{}"),
        calling("A slip.", "grasp_and_remove", '{"object_id": "object_1"}'),
        calling("Now I know.", "answer_question", '{"choice": "B", "point": [12, 700]}'),
    ],
}


class Overheard(ServedModel):
    """Says what it is told to say; keeps what it was given."""

    def begin(self, replies):
        self.replies, self.heard, self.bodies = list(replies), [], []

    def reply(self, body, given_up=None):
        asked = self.asked(body)
        self.heard.append(asked)
        self.bodies.append(body)
        said = read_reply(self.replies[len(self.heard) - 1])
        if said.calls and said.words:
            # As vLLM does, by its source.
            said = replace(said, words=f"{said.words}\n")
        return GeneratedReply(said, asked["input_ids"].shape[1], 5, cut=False)


@contextmanager
def listening(speaker):
    """The server as `probe serve-model` has it, in a thread."""
    import uvicorn

    port = free_ports()
    app = application(speaker, "scripted")
    server = uvicorn.Server(uvicorn.Config(app, port=port, log_level="warning"))
    thread = threading.Thread(target=server.run)
    thread.start()
    while not server.started:
        time.sleep(0.05)
    try:
        yield f"http://127.0.0.1:{port}/v1"
    finally:
        server.should_exit = True
        thread.join()


@pytest.fixture(autouse=True)
def collected():
    """What the harness leaves open; see tests/bench/conftest.py."""
    yield
    gc.collect()


@pytest.fixture(scope="module")
def speakers(tmp_path_factory):
    """One that sees, and a language model."""
    folder = tmp_path_factory.mktemp("tokens")
    data = small_dataset(folder, 1)
    return {
        pictures: Overheard(str(small_model(folder / str(pictures), data, pictures=pictures)))
        for pictures in (True, False)
    }


def pictures_in(body) -> list[bytes]:
    parts = [it for m in body["messages"] if isinstance(m["content"], list) for it in m["content"]]
    urls = [it["image_url"]["url"] for it in parts if it["type"] == "image_url"]
    return [base64.b64decode(url.partition(",")[2]) for url in urls]


def trained_on(record, body, points, speaker, folder):
    """The batch that training makes of the episode's record, by way of the data set's file."""
    from datasets import Dataset

    # All pictures but those of the last result: no reply follows that.
    pictures = iter(pictures_in(body))
    if record.setting.startswith("text-only"):
        assert not list(pictures)
        shown = no_pictures(record)
    else:
        first = (next(pictures),)
        later = tuple(
            next(pictures, None) if step.call.name != "answer_question" else None
            for step in record.steps
        )
        shown = EpisodePictures(first, later)
    example = example_of(SUITE.tasks[0], record, shown, points)
    write_table(folder / "rows.parquet", [trl_row(example)])
    rows = Dataset.from_parquet(str(folder / "rows.parquet"), cache_dir=str(folder / "cache"))
    return collator_for(speaker._processor)([rows[0]])


@pytest.mark.parametrize(
    ("setting", "points", "graphs", "pictures"),
    [
        ("agentic", "0-1000", "full", True),
        ("direct", "pixels", "full", True),
        ("text-only", "0-1000", "full", True),
        ("text-only", "0-1000", "short", True),
        ("text-only", "0-1000", "short", False),
    ],
)
def test_requests_are_what_training_shows_up_to_each_reply(
    tmp_path, speakers, setting, points, graphs, pictures
):
    speaker = speakers[pictures]
    speaker.begin(EPISODES[setting])
    order = plan(tmp_path / "out", setting, SUITE, points=points, graphs=graphs)
    with listening(speaker) as url:
        run_in(order, url)
    record = kept(tmp_path / "out")[SUITE.tasks[0].id]
    assert seat_of(record).faults == () and record.answer is not None
    # All that isn't refused is learnt: an episode with a reminder wouldn't be chosen.
    assert not reminded(record)
    assert len(speaker.heard) == len(EPISODES[setting])
    batch = trained_on(record, speaker.bodies[-1], points, speaker, tmp_path)
    ids, labels = batch["input_ids"][0].tolist(), batch["labels"][0].tolist()
    tokenizer = tokenizer_of(speaker._processor)
    expected, end = [IGNORED] * len(ids), 0
    refused = [step.status == "malformed" for step in record.steps] or [False]
    assert sum(refused) == (setting == "text-only")
    for asked, reply, slip in zip(speaker.heard, EPISODES[setting], refused, strict=True):
        sent = asked["input_ids"][0].tolist()
        assert ids[: len(sent)] == sent
        if setting != "text-only":
            patches = asked["pixel_values"]
            assert (batch["pixel_values"][: len(patches)] == patches).all()
        said = tokenizer.encode(f"{reply}<|im_end|>\n", add_special_tokens=False)
        assert ids[len(sent) : len(sent) + len(said)] == said
        end = len(sent) + len(said)
        if not slip:
            expected[len(sent) : end] = said
    if setting != "text-only":
        assert len(batch["pixel_values"]) == len(speaker.heard[-1]["pixel_values"])
    else:
        assert "pixel_values" not in batch
    assert labels == expected
    # Nothing follows the last reply.
    assert len(ids) == end
