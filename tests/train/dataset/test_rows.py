from __future__ import annotations

import json

from probe.train.dataset.rows import sharegpt_row, trl_row, vila_row


def files(example):
    return [f"{n}.jpg" for n in range(len(example.pictures))]


def test_trls_parts_stand_where_pictures_are_shown(examples):
    row = trl_row(examples[0])
    roles = [message["role"] for message in row["messages"]]
    assert roles[:6] == ["system", "user", "assistant", "tool", "user", "assistant"]
    question_types = [
        [part["type"] for part in message["content"]] for message in row["messages"][:5]
    ]
    assert question_types == [["text"], ["text", "image"], ["text"], ["text"], ["image"]]
    places = [p for m in row["messages"] for p in m["content"] if p["type"] == "image"]
    assert len(places) == len(row["images"]) == 5
    call = row["messages"][2]["tool_calls"][0]
    assert call["function"] == {"name": "find_object", "arguments": '{"description": "mug"}'}
    assert row["messages"][3]["tool_call_id"] == call["id"] == "call_1"
    assert row["messages"][1]["tool_calls"] is None


def test_sharegpts_turns_alternate_as_llama_factory_asks(examples):
    for example in examples:
        row = sharegpt_row(example, files(example))
        turns = [turn["from"] for turn in row["conversations"]]
        assert turns[0] == "human" and set(turns[1::2]) == {"gpt"}
        assert set(turns[2::2]) <= {"observation"} and len(turns) % 2 == 0
        text = "".join(turn["value"] for turn in row["conversations"])
        assert text.count("<image>") == len(row["images"])


def test_a_call_is_written_as_qwens_template_writes_it(examples):
    row = sharegpt_row(examples[0], files(examples[0]))
    assert row["conversations"][1]["value"] == (
        'I want the mug.\n<tool_call>\n{"name": "find_object", '
        '"arguments": {"description": "mug"}}\n</tool_call>'
    )
    assert row["conversations"][2]["value"] == (
        "object_id: object_1\nname: mug\ndescription: A mug.\n<image>"
    )
    names = [tool["name"] for tool in json.loads(row["tools"])]
    assert names[0] == "perceive_scene" and len(names) == 5
    assert sharegpt_row(examples[1], ["0.jpg"])["tools"] == ""


def test_vila_has_two_voices_and_the_rules_first(examples):
    for example in examples:
        row = vila_row(example, files(example))
        turns = [turn["from"] for turn in row["conversations"]]
        assert turns == ["human", "gpt"] * (len(turns) // 2)
        first = row["conversations"][0]["value"]
        assert first.startswith(example.messages[0].text)
        assert ("<tools>" in first) == (example.setting == "agentic")
        text = "".join(turn["value"] for turn in row["conversations"])
        assert text.count("<image>") == len(row["image"])
