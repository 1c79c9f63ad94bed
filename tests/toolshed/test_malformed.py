"""Whatever an agent sends: clear words, a turn spent, nothing changed."""

import copy
import json

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from probe.toolshed.tools import TOOLS
from probe.toolshed.toolshed import TURNS

JUNK = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats(allow_nan=True)
    | st.text(st.characters(exclude_categories=[]), max_size=50)
    | st.just("x" * 1_000_000)
    | st.just(10**400),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=20), inner),
    max_leaves=5,
)
FIELDS = st.sampled_from(["object_id", "direction", "distance_cm", "description", "point", "y"])
CALLS = st.one_of(
    st.tuples(st.text(max_size=20) | JUNK, JUNK),
    st.tuples(
        st.sampled_from(["push", "grasp_and_remove"]),
        JUNK | st.dictionaries(FIELDS, JUNK | st.just("object_1"), max_size=4),
    ),
    st.tuples(st.sampled_from(["find_object"]), st.dictionaries(FIELDS, st.floats(), min_size=1)),
    st.tuples(
        st.sampled_from(["answer_question"]),
        st.fixed_dictionaries({"choice": JUNK, "point": st.lists(st.just(float("nan")))}),
    ),
    st.tuples(st.sampled_from(["perceive_scene"]), st.dictionaries(FIELDS, JUNK, min_size=1)),
)


@settings(
    max_examples=300,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)
@given(CALLS)
def test_malformed_calls_are_answered_and_change_nothing(shed, station, skills, call):
    shed.turns, shed.ended = 3, False
    before = copy.deepcopy(station.blocks)
    result = shed.call(*call)
    assert result.status == "malformed" and result.picture is None and not result.ended
    assert 20 < len(result.text) < 700
    assert "Traceback" not in result.text and "pydantic" not in result.text
    assert shed.turns == 4 and shed.manipulations == 0 and shed.answer is None
    assert station.blocks == before and skills.calls == []
    result.text.encode()


@pytest.mark.parametrize(
    ("name", "arguments", "expected"),
    [
        ("look", {}, "There is no tool called 'look'. Tools: perceive_scene, find_object"),
        (None, {}, "There is no tool called a NoneType"),
        ("find_object", {}, "'description' is missing. Call it like find_object(description="),
        ("find_object", "red mug", "have to be a JSON object, not 'str'"),
        ("find_object", {"description": "x" * 1_000_000}, "at most 300 characters"),
        ("perceive_scene", {"zoom": 2}, "perceive_scene did nothing: it takes no 'zoom'"),
        ("grasp_and_remove", {"object_id": "object_7"}, "no object_id 'object_7'"),
        ("grasp_and_remove", {"object_id": "red mug"}, "There are none yet"),
        (
            "push",
            {"object_id": "object_1", "direction": "north", "distance_cm": 50},
            "'direction': input should be 'up', 'down', 'left' or 'right'; 'distance_cm': input "
            "should be less than or equal to 20",
        ),
        (
            "push",
            {"object_id": "object_1", "direction": "up", "distance_cm": float("nan")},
            "finite number",
        ),
        ("answer_question", {"choice": "F"}, "'choice': input should be 'A', 'B', 'C', 'D' or"),
        ("answer_question", {"choice": "A", "point": [1, 2000]}, "'point': input should be less"),
        ("answer_question", {"choice": "A", "point": "(1, 2)"}, "'point': input should be a valid"),
    ],
)
def test_messages_say_what_would_be_right(shed, name, arguments, expected):
    assert expected in shed.call(name, arguments).text


def test_malformed_calls_take_turns(shed):
    ended = [shed.call("find_object", {"description": 7}).ended for _ in range(TURNS)]
    assert ended == [False] * (TURNS - 1) + [True]
    assert shed.answer is None


def test_every_tool_tells_how_it_is_called(shed):
    for name in TOOLS:
        text = shed.call(name, {"": 0}).text
        assert f"Call it like {name}(" in text
        json.dumps(text)
