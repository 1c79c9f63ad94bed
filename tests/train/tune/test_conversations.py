"""Requests and rows in one form. That tokens are equal, too, is seen in test_same_tokens."""

from __future__ import annotations

import base64

import pytest

from probe.train.dataset.rows import trl_row
from probe.train.tune.conversations import NotUnderstood, of_request, of_row


def shown(picture: bytes) -> dict[str, object]:
    url = "data:image/jpeg;base64," + base64.b64encode(picture).decode()
    return {"type": "image_url", "image_url": {"url": url}}


def test_a_request_in_openais_form(examples):
    (first, *_) = examples[0].pictures
    calls = [{"id": "x", "function": {"name": "push", "arguments": '{"direction": "up"}'}}]
    told = of_request(
        [
            {"role": "user", "content": [{"type": "text", "text": "What?"}, shown(first)]},
            {"role": "assistant", "content": None, "tool_calls": calls},
            {"role": "tool", "content": "Done.", "tool_call_id": "x"},
        ]
    )
    assert [part["type"] for part in told[0]["content"]] == ["text", "image"]
    assert told[0]["content"][1]["image"].size == (64, 64)
    assert told[1]["content"] == []
    assert told[1]["tool_calls"][0]["function"]["arguments"] == {"direction": "up"}
    assert told[2] == {"role": "tool", "content": [{"type": "text", "text": "Done."}]}


def test_a_row_has_its_pictures_in_their_places(examples):
    row = trl_row(examples[0])
    told = of_row(row)
    places = [part["image"] for it in told for part in it["content"] if part["type"] == "image"]
    assert places == row["images"] and len(places) == 5
    assert told[2]["tool_calls"][0]["function"]["arguments"] == {"description": "mug"}


@pytest.mark.parametrize(
    "message",
    [
        {"content": "Who?"},
        {"role": "user", "content": [{"type": "video_url", "video_url": {}}]},
        {"role": "user", "content": [{"type": "image_url", "image_url": {"url": "http://x/y"}}]},
        {"role": "assistant", "content": "", "tool_calls": [{"id": "x"}]},
        {"role": "user", "content": [shown(b"no picture")]},
    ],
)
def test_what_is_in_another_form_is_refused(message):
    with pytest.raises(NotUnderstood):
        of_request([message])
