"""Places in thousandths, and back."""

from __future__ import annotations

import json

from hypothesis import given
from hypothesis import strategies as st

from probe.episodes.turns import Call
from probe.transcripts.coordinates import as_said, meant, place_meant, told

TENTHS = st.integers(0, 10_000).map(lambda n: n / 10)


def test_pixels_stay_as_they_are():
    text = "point: [512, 300] in pixels"
    call = Call.of("find_object", {"description": "the thing at (512, 300)"})
    assert told(text, "pixels") is text
    assert meant(call, "pixels") is call and as_said(call, "pixels") is call
    assert place_meant((1.5, 2.0), "pixels") == (1.5, 2.0)


def test_places_in_texts_are_counted_in_thousandths():
    text = "point: [512, 256]\nbox: [0, 1023, 128, 64]\nothers: [[1024, 512], [2, 3]]"
    assert told(text, "0-1000") == (
        "point: [500, 250]\nbox: [0, 999, 125, 62]\nothers: [[1000, 500], [2, 3]]"
    )


def test_other_numbers_in_texts_stay():
    text = "Manipulations left: 3. It moved 5 cm (12). Numbers [1, 2, 3], object_4, 25 px"
    assert told(text, "0-1000") == text


def test_words_and_limits_change_with_them():
    assert told("(u, v) in pixels", "0-1000") == (
        "(u, v) in thousandths of the picture's width and height"
    )
    assert told("Input should be less than 1024", "0-1000") == "Input should be at most 1000"


def test_a_call_is_carried_out_in_pixels():
    found = meant(Call.of("find_object", {"description": "cup at (500, 250)"}), "0-1000")
    assert found.values == {"description": "cup at (512, 256)"}
    bare = meant(Call.of("find_object", {"description": "the thing at 500, 250"}), "0-1000")
    assert bare.values == {"description": "the thing at 512, 256"}
    answer = Call.of("answer_question", {"choice": "A", "point": [1000, 0]})
    u, v = meant(answer, "0-1000").values["point"]
    assert 1023 <= u < 1024 and v == 0


def test_what_fits_no_tool_is_left_alone():
    for call in (
        Call("answer_question", "no JSON"),
        Call.of("answer_question", {"choice": "A", "point": ["x", 2]}),
        Call.of("answer_question", {"choice": "A", "point": [True, 2]}),
        Call("answer_question", '{"choice": "A", "point": [1e999, 5]}'),
        Call("answer_question", '{"choice": "A", "point": [NaN, 5]}'),
        Call("answer_question", f'{{"choice": "A", "point": [{10**400}, 5]}}'),
        Call.of("push", {"object_id": "object_1", "distance_cm": 5}),
        Call("find_object", "[1, 2]"),
    ):
        assert meant(call, "0-1000") == call


@given(TENTHS, TENTHS)
def test_a_call_is_told_as_it_was_made(u: float, v: float):
    for said in (
        Call.of("answer_question", {"choice": "B", "point": [_number(u), _number(v)]}),
        Call.of("find_object", {"description": f"it is at ({_text(u)}, {_text(v)})"}),
    ):
        assert as_said(meant(said, "0-1000"), "0-1000") == said


def _number(value: float) -> float | int:
    return int(value) if value == int(value) else value


def _text(value: float) -> str:
    return json.dumps(_number(value))
