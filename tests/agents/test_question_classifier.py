import json

import pytest

from probe.agents.question_classifier import most_likely, question_features, read_learnt
from probe.agents.text_features import texts
from probe.episodes.turns import Question
from probe.errors import BadData

NONE = "None of the above"


def asked(text: str, *options: str) -> Question:
    return Question(text, tuple(zip("ABCDE", options, strict=False)))


def test_the_largest_sum_of_weights_is_chosen():
    rule = most_likely({"word mug": 1.0, "word red": 0.5, "none": 1.2})
    assert rule(asked("Which?", "blue cup", "red mug", NONE)) == "B"
    assert rule(asked("Which?", "blue cup", "red cup", NONE)) == "C"


def test_without_weights_the_first_is_chosen():
    assert most_likely({})(asked("Which?", "blue cup", "red mug", NONE)) == "A"


def test_only_places_tell_options_apart_that_say_the_same():
    first, second = texts("Which marked one?", ("Object A", "Object B"))
    assert {name for name in {*first, *second} if first.get(name) != second.get(name)} <= {
        "word a",
        "word b",
    }


def test_coordinates_of_marks_are_read():
    text = "Which is larger? In the first picture, the marks are A at (612, 512) and B at (512, 0)."
    a, b = question_features(text, ("Object A", "Object B"))
    assert a["right of"] == pytest.approx(100 / 512) == -b["right of"]
    assert a["below"] == 1.0 == -b["below"]
    assert a["larger below"] == 1.0
    assert not any("612" in name or "pictur" in name for name in a)


def test_what_was_learnt_is_read_from_a_file(tmp_path):
    path = tmp_path / "learnt.json"
    path.write_text(json.dumps({"find": {"tasks": 3, "weights": {"none": 0.5}}}))
    assert read_learnt(path)["find"].weights == {"none": 0.5}


@pytest.mark.parametrize("text", [None, "{", '{"find": {"tasks": 0, "weights": {}}}'])
def test_a_missing_or_broken_file_says_how_to_write_it(tmp_path, text):
    path = tmp_path / "learnt.json"
    if text is not None:
        path.write_text(text)
    with pytest.raises(BadData, match="probe suite learn"):
        read_learnt(path)
