from __future__ import annotations

from probe.train.serve.replying import ServedReply, read_reply


def test_words_and_a_call_are_told_apart():
    call = '{"name": "find_object", "arguments": {"description": "mug"}}'
    said = f"I look.\n<tool_call>\n{call}\n</tool_call>"
    assert read_reply(said) == ServedReply("I look.", (("find_object", '{"description": "mug"}'),))


def test_several_calls_and_none():
    call = '<tool_call>\n{"name": "perceive_scene", "arguments": {}}\n</tool_call>'
    assert read_reply(f"{call}\n{call}") == ServedReply("", (("perceive_scene", "{}"),) * 2)
    assert read_reply("I see it.\nANSWER: B ") == ServedReply("I see it.\nANSWER: B")


def test_a_call_that_cannot_be_read_is_words():
    for broken in ('{"name": "push"', '{"arguments": {}}', "[1]"):
        text = f"So.\n<tool_call>\n{broken}\n</tool_call>"
        assert read_reply(text) == ServedReply(text)
    assert read_reply("<tool_call>\n{") == ServedReply("<tool_call>\n{")
