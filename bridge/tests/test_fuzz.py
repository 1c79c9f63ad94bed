"""Commands, most of them wrong: the arm never leaves its box or passes a limit."""

from __future__ import annotations

import random
from typing import Any, Dict

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bridges import quick, running
from fuzzing import fuzz
from limits import broken_limits
from probe_bridge.errors import BridgeError
from probe_bridge.planning import START
from probe_bridge.requests import read_request
from probe_bridge.wire import pack, unpack_request
from raw import connected

RAW = quick(50.0)


@pytest.mark.parametrize("commands", [200, pytest.param(2000, marks=pytest.mark.slow)])
def test_no_fuzzed_command_breaks_a_limit(commands: int):
    rng = random.Random(20)
    done = 0
    with running(RAW) as bridge:
        while done < commands:
            with connected(bridge.address) as socket:
                done += fuzz(socket, bridge.robot, rng, commands - done)
        executed = list(bridge.driver.executed)
    print(f"{len(executed)} motions")
    assert len(executed) > commands / 20
    place = executed[0].trajectory.joints[0]
    for motion, seconds in executed:
        jump = max(abs(a - b) for a, b in zip(motion.joints[0], place))
        assert jump <= START
        assert broken_limits(motion, seconds, RAW, samples=25) == []
        place = motion.at(seconds)[0]


leaf = st.none() | st.booleans() | st.integers(-(2**63), 2**64 - 1) | st.floats() | st.text()
plain = leaf | st.binary() | st.lists(leaf | st.lists(leaf, max_size=7), max_size=4)
names = st.sampled_from(
    [
        "seq",
        "do",
        "path",
        "speed",
        "seen",
        "opening",
        "camera",
        "rgb",
        "step",
        "seconds",
        "version",
        "x",
    ]
)
does = st.sampled_from(
    ["hello", "observe", "glimpse", "follow", "grip", "wait", "joints", "home", "lease"]
)


@settings(max_examples=100, deadline=None)
@given(st.dictionaries(names, plain, max_size=6), does | plain)
def test_any_table_is_read_or_refused(message: Dict[str, Any], do: object):
    try:
        seq, _ = read_request(unpack_request(pack({"seq": 1, **message, "do": do})), 6)
    except BridgeError as error:
        assert error.kind == "refused"
    else:
        assert seq >= 1


@settings(max_examples=100, deadline=None)
@given(st.binary(max_size=200))
def test_any_bytes_are_read_or_refused(data: bytes):
    try:
        assert isinstance(unpack_request(data), dict)
    except BridgeError as error:
        assert error.kind == "refused"
