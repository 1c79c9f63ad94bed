"""The server as the official client sees it, over a painted table."""

import json
import signal
import time

import anyio
import numpy as np
import pytest
from mcp_types import BlobResourceContents, ImageContent, TextContent, TextResourceContents

from interfaces import painted
from interfaces.clients import Player, Reply, decoded, playing, wired
from probe.episodes.files import read_records
from toolshed.test_tools import SNAPSHOT

SERVER = painted.__file__


def test_tools_are_the_benchmarks_own(tmp_path):
    with playing(SERVER, tmp_path) as player:
        tools = player.portal.call(player.client.list_tools).tools
    told = [
        {"name": t.name, "description": t.description, "parameters": t.input_schema} for t in tools
    ]
    assert told == json.loads(SNAPSHOT.read_text())
    assert all(tool.output_schema is None for tool in tools)


@pytest.mark.parametrize("mode", ["auto", "legacy"])
def test_question_and_first_picture_are_in_reach(tmp_path, mode):
    table = painted.open_episode().record.question.picture
    assert table is not None
    with playing(SERVER, tmp_path, mode=mode) as player:
        instructions = player.client.instructions
        look = player.call("perceive_scene")
        player.call("grasp_and_remove", object_id=handle(player, "white ball"))
        prompt = player.portal.call(player.client.get_prompt, "question")
        (question,) = read(player, "probe://question")
        (picture,) = read(player, "probe://first-picture")
    assert isinstance(question, TextResourceContents)
    assert question.text == "What is under the ball?\nA: a goose\nB: a duck"
    assert instructions and question.text in instructions and "40 tool calls" in instructions
    words, shown = (message.content for message in prompt.messages)
    assert isinstance(words, TextContent) and words.text == instructions
    assert isinstance(shown, ImageContent) and isinstance(picture, BlobResourceContents)
    for seen in (look.picture, decoded(shown.data), decoded(picture.blob)):
        assert seen is not None and close(seen, table)


@pytest.mark.slow
def test_results_are_the_tools_own(tmp_path):
    with playing(SERVER, tmp_path) as player:
        found = player.call("find_object", description="white ball")
        missed = player.call("find_object", description="yellow duck")
        stranger = player.call("dance", partner="red mug")
        wrong = player.call("push", object_id="object_1", direction="north", distance_cm=7)
        unknown = player.call("grasp_and_remove", object_id="object_9")
        grasp = player.call("grasp_and_remove", object_id="object_1")
        stale = player.call("grasp_and_remove", object_id="object_1")
        last = player.call("answer_question", choice=" b")
        over = player.call("perceive_scene")
    told = (found, missed, stranger, wrong, unknown, grasp, stale, last, over)
    tools = painted.open_episode()
    for reply, step in zip(told, read_records(tmp_path / "records.jsonl")[0].steps, strict=False):
        result = tools.step(step.call).result
        assert reply.text == result.text
        assert (reply.picture is None) == (result.picture is None)
        if reply.picture is not None and result.picture is not None:
            assert close(reply.picture, result.picture)
    did_nothing = (stranger, wrong, unknown, stale, over)
    assert [reply.error for reply in told] == [reply in did_nothing for reply in told]
    assert over == Reply("The episode has ended; no further call does anything.", None, True)


def test_budgets_are_the_benchmarks_own(tmp_path):
    with playing(SERVER, tmp_path) as player:
        replies = [player.call("dance") for _ in range(41)]
    assert [i for i, r in enumerate(replies) if "last turn" in r.text] == [39]
    assert "has ended" in replies[40].text
    (record,) = read_records(tmp_path / "records.jsonl")
    assert record.end == "out_of_turns" and len(record.steps) == 40


@pytest.mark.slow
def test_the_protocol_answers_while_the_arm_moves_and_calls_keep_their_order(tmp_path):
    with playing(SERVER, tmp_path) as player:
        assert handle(player, "white ball") == "object_1"
        began = time.perf_counter()
        grasp, look = player.portal.call(hurried, player)
        assert time.perf_counter() - began >= painted.SLOW
    assert "Done: object_1" in grasp.text and "white ball" not in look.text


async def hurried(player: Player) -> tuple[Reply, Reply]:
    """A grasp and a look at once, and a ping that waits for neither."""
    replies: dict[str, Reply] = {}

    async def call(name: str, arguments: dict[str, str]) -> None:
        replies[name] = Reply.of(await player.client.call_tool(name, arguments))

    async with anyio.create_task_group() as group:
        group.start_soon(call, "grasp_and_remove", {"object_id": "object_1"})
        await anyio.sleep(0.1)
        group.start_soon(call, "perceive_scene", {})
        began = time.perf_counter()
        await player.client.list_tools()
        assert time.perf_counter() - began < painted.SLOW / 2 and not replies
    return replies["grasp_and_remove"], replies["perceive_scene"]


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_server_that_is_told_to_end_writes_the_record(tmp_path, number):
    with wired(SERVER, tmp_path) as wire:
        wire.call("perceive_scene", {})
        wire.process.send_signal(number)
        assert wire.process.wait(10) == -number
    (record,) = read_records(tmp_path / "records.jsonl")
    assert record.end == "stopped" and len(record.steps) == 1


def test_nothing_that_is_sent_tells_what_nobody_sees(tmp_path):
    record = painted.open_episode().record
    with wired(SERVER, tmp_path) as wire:
        for method in ("tools/list", "prompts/list", "resources/list", "resources/templates/list"):
            assert "result" in wire.ask(method, {})
        assert "result" in wire.ask("prompts/get", {"name": "question"})
        for name in ("question", "first-picture", "answer", "record", "../records.jsonl"):
            wire.ask("resources/read", {"uri": f"probe://{name}"})
        wire.call("find_object", {"description": "the thing at (620, 470)"})
        wire.call("find_object", {"description": "white ball"})
        wire.call("grasp_and_remove", {"object_id": 917})
        wire.call("push", {"object_id": "917", "direction": "up", "distance_cm": 5})
        wire.call("answer_question", {"choice": "A"})
        words = "\n".join(text for message in wire.seen for text in texts(message))
    assert "white ball" in words
    secrets = ("secret", "_77", "duck-0815", "rubber", "yellow", "0.1234", "12345", record.task)
    for secret in (*secrets, *(f"id_{b.instance}" for b in painted.BLOCKS)):
        assert secret not in words, secret
    assert words.count("duck") == words.count("B: a duck")


@pytest.mark.parametrize("choice", ["A", "B"])
def test_right_and_wrong_are_told_alike(tmp_path, choice):
    with wired(SERVER, tmp_path) as wire:
        told = wire.call("answer_question", {"choice": choice})["result"]["content"]
    assert told == [{"type": "text", "text": "Your answer is recorded; the episode has ended."}]


def texts(message: object) -> list[str]:
    """All strings in a message, keys included, but for pictures."""
    if isinstance(message, str):
        return [message] if len(message) < 20_000 else []
    if isinstance(message, dict):
        return [t for key, value in message.items() for t in (key, *texts(value))]
    return [t for each in message for t in texts(each)] if isinstance(message, list) else []


def handle(player: Player, words: str) -> str:
    """The id that is found for some words."""
    first, _, _ = player.call("find_object", description=words).text.partition("\n")
    return first.removeprefix("object_id: ")


def read(player: Player, uri: str):
    return player.portal.call(player.client.read_resource, uri).contents


def close(seen: np.ndarray, meant: np.ndarray) -> bool:
    """Alike but for what JPEG loses."""
    return bool(np.abs(seen.astype(int) - meant).mean() < 2)
