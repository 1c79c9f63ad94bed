import pytest

from probe.agents.cover_nouns import hider


@pytest.mark.parametrize(
    ("name", "question_type"),
    [
        ("dark blue soup mug", "hollow"),
        ("blue and white striped open box", "hollow"),
        ("white mixing bowls", "hollow"),
        ("purple book", "flat"),
        ("brown cereal box", "flat"),
        ("Crosley red alarm clock", None),
        ("pickle jar", None),
        ("", None),
    ],
)
def test_a_name_says_what_a_thing_can_hide(name, question_type):
    assert hider(name) == question_type
