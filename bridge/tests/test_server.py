"""Who is let in, and what is refused at the door."""

from __future__ import annotations

import base64
import socket as sockets
import struct

import msgpack
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from bridges import TOKEN, Running
from probe_bridge.client import RobotClient
from probe_bridge.errors import BridgeError
from probe_bridge.server import Address
from probe_bridge.wire import MAX_REQUEST, VERSION, pack, unpack_reply
from raw import HELLO, ask, connected, kind, now


@pytest.mark.parametrize("token", [None, "", "wrong", TOKEN + "x", TOKEN[:-1], "\xff\xfe"])
def test_without_the_token_nobody_comes_in(bridge: Running, token: str | None):
    with pytest.raises(InvalidStatus) as refused, connected(bridge.address, token):
        pass
    assert refused.value.response.status_code == 401


def test_basic_or_double_authorisation_is_refused(bridge: Running):
    host, port = bridge.address[5:].split(":")
    basic = base64.b64encode(f"user:{TOKEN}".encode()).decode()
    twice = f"Authorization: Bearer {TOKEN}\r\n" * 2
    for header in (f"Authorization: Basic {basic}\r\n", twice):
        with sockets.create_connection((host, int(port)), 5) as plain:
            plain.sendall(
                f"GET / HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                f"Sec-WebSocket-Key: {base64.b64encode(bytes(16)).decode()}\r\n"
                f"Sec-WebSocket-Version: 13\r\n{header}\r\n".encode()
            )
            assert plain.recv(100).startswith(b"HTTP/1.1 401")


def test_the_client_says_that_the_token_is_wrong(bridge: Running):
    with pytest.raises(BridgeError) as refused:
        RobotClient(bridge.address, "another-token-of-some-length")
    assert refused.value.kind == "unauthorized"


def test_only_this_computer_can_connect_unless_told_otherwise(bridge: Running):
    assert bridge.host == Address().host == "127.0.0.1"


def test_a_second_client_is_told_and_the_first_stays(bridge: Running, client: RobotClient):
    with pytest.raises(BridgeError) as taken:
        RobotClient(bridge.address, TOKEN)
    assert taken.value.kind == "taken"
    assert client.joints()


def test_the_place_is_free_when_the_client_has_left(bridge: Running):
    for _ in range(3):
        RobotClient(bridge.address, TOKEN).close()


def test_another_version_is_refused_with_both_numbers(bridge: Running):
    with connected(bridge.address) as socket:
        reply = ask(socket, {"seq": 1, "do": "hello", "version": VERSION + 1})
        assert kind(reply) == "version"
        assert f"version {VERSION + 1}" in reply["error"]["text"]
        with pytest.raises(ConnectionClosed):
            socket.recv(5)


def test_hello_comes_first(bridge: Running):
    with connected(bridge.address) as socket:
        assert kind(ask(socket, {"seq": 1, "do": "joints"})) == "refused"
        assert kind(ask(socket, {**HELLO, "seq": 2})) == ""
        assert kind(ask(socket, {"seq": 3, "do": "joints"})) == ""


def test_replayed_and_older_requests_are_refused(bridge: Running):
    with connected(bridge.address) as socket:
        ask(socket, {**HELLO, "seq": 5})
        assert kind(ask(socket, {"seq": 6, "do": "joints"})) == ""
        for seq in (6, 5, 1):
            reply = ask(socket, {"seq": seq, "do": "home", "speed": 1.0, **now()})
            assert kind(reply) == "refused"
            assert "after 6" in reply["error"]["text"]
        assert kind(ask(socket, {"seq": 7, "do": "joints"})) == ""
    assert not bridge.driver.executed


def test_oversized_messages_end_the_connection(bridge: Running):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        socket.send(b"\x00" * (MAX_REQUEST + 1))
        with pytest.raises(ConnectionClosed) as closed:
            socket.recv(5)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1009


@pytest.mark.parametrize(
    "data",
    [
        "text",
        b"",
        b"\xc1",
        b"\x93\x01\x02",
        b"\x91" * 5000,
        pack({"seq": 2, "do": "joints"}) + b"\x00",
        msgpack.packb({"seq": 2, "do": "joints", "more": msgpack.ExtType(1, b"x")}),
        msgpack.packb({"seq": 2, "do": "joints", "more": b"bytes"}),
        msgpack.packb({"seq": 2, "do": "joints", 3: 4}),
        msgpack.packb([2, "joints"]),
        b"\xdf" + struct.pack(">I", 2**31),
    ],
)
def test_what_is_not_a_plain_table_is_refused_and_the_next_request_works(
    bridge: Running, data: str | bytes
):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        socket.send(data)
        assert kind(unpack_reply(socket.recv(5))) == "refused"
        assert kind(ask(socket, {"seq": 3, "do": "joints"})) == ""


@pytest.mark.parametrize(
    ("message", "named"),
    [
        ({"do": "joints"}, "request.seq is missing"),
        ({"seq": True, "do": "joints"}, "request.seq"),
        ({"seq": 2.0, "do": "joints"}, "request.seq"),
        ({"seq": 2**60, "do": "joints"}, "request.seq"),
        ({"seq": 2, "do": "dance"}, "request.do"),
        ({"seq": 2, "do": "joints", "fast": True}, "'fast'"),
        ({"seq": 2, "do": "observe", "camera": 3, "rgb": True}, "request.camera"),
        ({"seq": 2, "do": "observe", "camera": "table", "rgb": 1}, "request.rgb"),
        ({"seq": 2, "do": "glimpse", "camera": "table", "step": 0}, "request.step"),
        ({"seq": 2, "do": "glimpse", "camera": "table", "step": 17}, "request.step"),
        ({"seq": 2, "do": "glimpse", "camera": "table", "step": 1.5}, "request.step"),
        ({"seq": 2, "do": "follow", "path": []}, "request.path"),
        ({"seq": 2, "do": "follow", "path": [[0.0] * 5]}, "request.path[0]"),
        ({"seq": 2, "do": "follow", "path": [[0.0] * 5 + ["0"]]}, "request.path[0][5]"),
        ({"seq": 2, "do": "follow", "path": [[0.0] * 5 + [float("nan")]]}, "request.path[0][5]"),
        ({"seq": 2, "do": "follow", "path": [[0.0] * 5 + [2**63]]}, "request.path[0][5]"),
        ({"seq": 2, "do": "follow", "path": [[0.0] * 6] * 2001}, "2001 rows"),
        ({"seq": 2, "do": "follow", "path": [[0.0] * 6]}, "request.speed is missing"),
        ({"seq": 2, "do": "home", "speed": 1.01, "seen": 0.0}, "request.speed"),
        ({"seq": 2, "do": "home", "speed": 0.0, "seen": 0.0}, "request.speed"),
        ({"seq": 2, "do": "home", "speed": 1.0}, "request.seen is missing"),
        ({"seq": 2, "do": "lease"}, "request.seen is missing"),
        ({"seq": 2, "do": "grip", "opening": float("inf")}, "request.opening"),
        ({"seq": 2, "do": "grip", "opening": -0.01}, "request.opening"),
        ({"seq": 2, "do": "wait", "seconds": 1e9}, "request.seconds"),
    ],
)
def test_a_wrong_field_is_named(bridge: Running, message: dict[str, object], named: str):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        reply = ask(socket, message)
        assert kind(reply) == "refused"
        assert named in reply["error"]["text"]
    assert not bridge.driver.executed
