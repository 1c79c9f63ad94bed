"""The protocol of the small server; test_same_tokens and test_distill have models behind it."""

from __future__ import annotations

import asyncio
import json
import socket
from typing import Any

import pytest

from probe.cli.serve_model import serve_model
from probe.errors import BadData
from probe.train.serve.replying import ServedReply
from probe.train.serve.serving import application, reserved, serve
from probe.train.serve.speaking import ConversationTooLong, GeneratedReply
from probe.train.serve.writing import GivenUp
from probe.train.tune.conversations import of_request

REPLY = ServedReply("I look.", (("perceive_scene", "{}"),))


class TooLong:
    """Has no room for a reply."""

    def reply(self, body, given_up):
        raise ConversationTooLong(9000, 8192)


class Replies:
    """Says one thing to whoever is understood."""

    def __init__(self, said: GeneratedReply) -> None:
        self._said = said

    def reply(self, body, given_up):
        of_request(body["messages"])
        return self._said


def asked(said: GeneratedReply, body: Any) -> Any:
    from starlette.testclient import TestClient

    with TestClient(application(Replies(said), "student")) as client:  # type: ignore[arg-type]
        return client.post("/v1/chat/completions", json=body)


HELLO = {"messages": [{"role": "user", "content": "What is under the mug?"}]}


@pytest.mark.filterwarnings("default")
def test_a_call_comes_in_openais_form():
    told = asked(GeneratedReply(REPLY, 30, 9, cut=False), HELLO).json()
    (choice,) = told["choices"]
    assert choice["finish_reason"] == "tool_calls" and choice["message"]["content"] == "I look."
    (call,) = choice["message"]["tool_calls"]
    assert call["function"] == {"name": "perceive_scene", "arguments": "{}"}
    assert told["usage"] == {"prompt_tokens": 30, "completion_tokens": 9, "total_tokens": 39}
    assert told["model"] == "student"


@pytest.mark.filterwarnings("default")
def test_words_and_words_that_are_cut_off():
    for cut, ending in ((False, "stop"), (True, "length")):
        (choice,) = asked(GeneratedReply(ServedReply("ANSWER: B"), 3, 4, cut), HELLO).json()[
            "choices"
        ]
        assert choice["finish_reason"] == ending
        assert choice["message"] == {"role": "assistant", "content": "ANSWER: B"}


@pytest.mark.filterwarnings("default")
@pytest.mark.parametrize(
    "body",
    [
        {},
        {"messages": []},
        {"messages": [{"content": "x"}]},
        ["x"],
        *(HELLO | {"stream": True}, HELLO | {"n": 2}, HELLO | {"tool_choice": "required"}),
    ],
)
def test_what_is_not_understood_is_told(body):
    answer = asked(GeneratedReply(REPLY, 1, 1, cut=False), body)
    assert answer.status_code == 400 and answer.json()["error"]["message"]


@pytest.mark.filterwarnings("default")
def test_what_changes_nothing_may_be_said():
    usual = {"stream": False, "n": 1, "stop": None, "top_p": 1.0, "tool_choice": "auto"}
    assert asked(GeneratedReply(REPLY, 1, 1, cut=False), HELLO | usual).status_code == 200


@pytest.mark.filterwarnings("default")
def test_a_conversation_that_is_too_long_is_told_in_openais_words():
    from starlette.testclient import TestClient

    with TestClient(application(TooLong(), "student")) as client:  # type: ignore[arg-type]
        told = client.post("/v1/chat/completions", json=HELLO)
    error = told.json()["error"]
    assert (told.status_code, error["code"]) == (400, "context_length_exceeded")
    assert (
        "9000 tokens" in error["message"] and "maximum context length is 8192" in error["message"]
    )


class Waits:
    """Says nothing until nobody waits for it any more."""

    def __init__(self) -> None:
        self.gave_up = False

    def reply(self, body, given_up):
        self.gave_up = given_up.wait(30)
        raise GivenUp


def test_who_hangs_up_is_not_waited_for():
    body = json.dumps(HELLO).encode()
    events = iter([{"type": "http.request", "body": body}, {"type": "http.disconnect"}])
    path = "/v1/chat/completions"
    scope = {"type": "http", "method": "POST", "path": path, "headers": [], "query_string": b""}

    async def receive():
        return next(events)

    async def send(_):
        """To nobody."""

    speaker = Waits()
    asyncio.run(application(speaker, "student")(scope, receive, send))  # type: ignore[arg-type]
    assert speaker.gave_up


@pytest.mark.filterwarnings("default")
def test_it_answers_for_no_other_model():
    said = GeneratedReply(REPLY, 1, 1, cut=False)
    assert asked(said, HELLO | {"model": "student"}).status_code == 200
    answer = asked(said, HELLO | {"model": "teacher"})
    assert answer.status_code == 404
    error = answer.json()["error"]
    assert error["code"] == "model_not_found" and error["param"] == "model"
    assert "'teacher'" in error["message"] and "'student'" in error["message"]


def test_a_port_that_is_taken_is_named_before_a_model_is_loaded():
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        with pytest.raises(BadData, match=f"--port: {port} can't be used .*Choose another"):
            serve_model("nowhere", port)
    with pytest.raises(BadData, match="--port: 70000 is out of range"):
        serve_model("nowhere", 70000)


@pytest.mark.filterwarnings("default")
def test_of_two_that_begin_at_once_one_serves():
    with reserved(0) as held:
        port = held.getsockname()[1]
        with reserved(port) as faster:
            faster.listen()
            with pytest.raises(BadData, match=f"--port: {port} can't be used"):
                serve(Replies(GeneratedReply(REPLY, 1, 1, cut=False)), "student", held)  # type: ignore[arg-type]
