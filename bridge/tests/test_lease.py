"""The robot stops when its client is silent, gone or asks for it."""

from __future__ import annotations

import threading
import time
from typing import Any, Dict, Iterator, List

import pytest

from bridges import TOKEN, Running, practice, running
from busy import Machine
from probe_bridge.client import RobotClient
from probe_bridge.errors import BridgeError
from probe_bridge.lease import LEASE
from probe_bridge.link import Link, Reply
from probe_bridge.mover import TICK
from probe_bridge.wire import pack, unpack_reply
from raw import HELLO, ask, connected, kind, now


@pytest.fixture
def bridge() -> Iterator[Running]:
    """An arm with a slow wrist: its motions are long, and quickly planned."""
    raw = practice()
    raw["joints"][5]["speed"] = 0.3
    with running(raw) as bridge:
        yield bridge


def long_path(bridge: Running) -> List[List[float]]:
    """A motion of about two seconds from where the arm is."""
    start = bridge.driver.joints().joints
    return [list(start), [*start[:5], start[5] + 0.6]]


def follow(bridge: Running, seq: int) -> Dict[str, Any]:
    return {"seq": seq, "do": "follow", "path": long_path(bridge), "speed": 1.0, **now()}


def stopped_after_lapse(bridge: Running) -> float:
    """Seconds from when the last lease lapsed to the first stop."""
    return bridge.driver.stops[0] - bridge.robot._mover._lease._until


def at_rest(bridge: Running) -> bool:
    before = bridge.driver.joints().joints
    time.sleep(0.1)
    return bridge.driver.joints().joints == before


def test_without_a_lease_the_arm_stops_in_time(bridge: Running, machine: Machine):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        reply = ask(socket, follow(bridge, 2))
        assert kind(reply) == "lease"
        assert LEASE == 0.5
        assert 0 <= stopped_after_lapse(bridge) <= TICK + machine.late
        assert at_rest(bridge)
        assert 0 < bridge.driver.executed[0].seconds < bridge.driver.executed[0].trajectory.duration
        # A late lease moves nothing; a new motion does.
        assert kind(ask(socket, {"seq": 3, "do": "lease", **now()})) == ""
        assert at_rest(bridge)
        assert kind(ask(socket, follow(bridge, 4))) == "lease"
        assert len(bridge.driver.executed) == 2


def test_only_leases_renew_and_pongs_do_not(bridge: Running, machine: Machine):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        socket.send(pack(follow(bridge, 2)))
        for seq in range(3, 8):
            socket.send(pack({"seq": seq, "do": "joints"}))
            socket.ping().wait(1)
            time.sleep(0.05)
        replies = [unpack_reply(socket.recv(5)) for _ in range(6)]
        assert [kind(r) for r in replies if r["seq"] == 2] == ["lease"]
        assert 0 <= stopped_after_lapse(bridge) <= TICK + machine.late


def test_leases_that_were_long_on_their_way_do_not_renew(bridge: Running, machine: Machine):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        begun = time.monotonic()
        socket.send(pack(follow(bridge, 2)))
        replies: List[Dict[str, Any]] = []
        for seq in range(3, 40):
            # As if each had been sent a second ago.
            old = {"seq": seq, "do": "lease", "seen": time.monotonic() - 1.0}
            replies.append(ask(socket, old))
            if replies[-1]["seq"] == 2:
                break
            time.sleep(0.05)
        assert kind(replies[-1]) == "lease"
        assert all(kind(reply) == "" for reply in replies[:-1])
        assert bridge.driver.stops[0] - begun < LEASE + TICK + machine.late


@pytest.mark.parametrize("seen", [-0.6, 100.0])
def test_a_motion_that_was_long_on_its_way_does_not_begin(bridge: Running, seen: float):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        late = {**follow(bridge, 2), "seen": time.monotonic() + seen}
        assert kind(ask(socket, late)) == "late"
        assert kind(ask(socket, {"seq": 3, "do": "home", "speed": 1.0, "seen": 0.0})) == "late"
        assert ask(socket, {"seq": 4, "do": "state"})["result"]["moving"] is False
    assert not bridge.driver.moves


def test_a_motion_may_be_slower_than_the_limits(bridge: Running, client: RobotClient):
    start = bridge.driver.joints().joints
    there = [*start[:5], start[5] + 0.06]
    client.follow([start, there])
    client.follow([there, start], speed=0.25)
    quick, slow = (motion for motion, _ in bridge.driver.executed)
    assert slow.duration == pytest.approx(4 * quick.duration, rel=0.01)
    fastest = [max(abs(v) for row in m.velocities for v in row) for m in (quick, slow)]
    assert fastest[1] == pytest.approx(fastest[0] / 4, rel=0.01)
    with pytest.raises(BridgeError, match="speed"):
        client.follow([start, there], speed=2.0)
    assert len(bridge.driver.executed) == 2


def test_leases_keep_it_going(bridge: Running):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        socket.send(pack(follow(bridge, 2)))
        reply: Dict[str, Any] = {"seq": 0}
        for seq in range(3, 100):
            reply = ask(socket, {"seq": seq, "do": "lease", **now()})
            if reply["seq"] == 2:
                break
            time.sleep(0.1)
        assert reply["result"]["joints"] == pytest.approx(
            list(bridge.driver.executed[0].trajectory.joints[-1])
        )
        assert bridge.driver.executed[0].trajectory.duration > 1.5
        assert not bridge.driver.stops


def test_a_cut_connection_stops_the_arm(bridge: Running, machine: Machine):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        socket.send(pack(follow(bridge, 2)))
        time.sleep(0.25)
        cut = time.monotonic()
        socket.socket.shutdown(2)  # without a farewell
    deadline = time.monotonic() + 2
    while not bridge.driver.stops and time.monotonic() < deadline:
        time.sleep(0.01)
    assert bridge.driver.stops[0] - cut < machine.late
    assert at_rest(bridge)
    RobotClient(bridge.address, TOKEN).close()


def test_stop_in_the_middle(bridge: Running, client: RobotClient, machine: Machine):
    errors: List[BridgeError] = []

    def move() -> None:
        try:
            client.follow(long_path(bridge))
        except BridgeError as error:
            errors.append(error)

    motion = threading.Thread(target=move)
    motion.start()
    time.sleep(0.3)
    asked = time.monotonic()
    client.stop()
    assert bridge.driver.stops[0] - asked < machine.late
    motion.join()
    assert [error.kind for error in errors] == ["stopped"]
    assert at_rest(bridge)
    client.home()


def test_a_stop_that_is_lost_on_its_way_stops_all_the_same(
    bridge: Running, client: RobotClient, machine: Machine, monkeypatch: pytest.MonkeyPatch
):
    errors: List[str] = []

    def move() -> None:
        try:
            client.follow(long_path(bridge))
        except BridgeError as error:
            errors.append(error.kind)

    motion = threading.Thread(target=move)
    motion.start()
    while not bridge.driver.moves:
        time.sleep(0.01)
    send = Link.send

    def losing(link: Link, do: str, **arguments: object) -> Reply:
        return Reply(do) if do == "stop" else send(link, do, **arguments)

    monkeypatch.setattr(Link, "send", losing)
    monkeypatch.setattr("probe_bridge.client.ANSWER", 1.5)
    asked = time.monotonic()
    with pytest.raises(BridgeError, match="did not answer"):
        client.stop()
    motion.join()
    assert bridge.driver.stops[0] - asked < LEASE + TICK + machine.late
    assert errors == ["lease"]
    assert at_rest(bridge)


def test_a_motion_whose_request_or_answer_is_lost_ends_as_lost(
    bridge: Running, monkeypatch: pytest.MonkeyPatch
):
    client = RobotClient(bridge.address, TOKEN)
    send = Link.send

    def losing(link: Link, do: str, **arguments: object) -> Reply:
        return Reply(do) if do == "follow" else send(link, do, **arguments)

    monkeypatch.setattr(Link, "send", losing)
    monkeypatch.setattr("probe_bridge.client._LEASE_ANSWER", 0.5)
    with pytest.raises(BridgeError) as lost:
        client.follow(long_path(bridge))
    assert lost.value.kind == "lost"


def test_renewals_whose_answers_are_lost_now_and_then_do_not_matter(
    bridge: Running, client: RobotClient, monkeypatch: pytest.MonkeyPatch
):
    send, count = Link.send, [0]

    def losing(link: Link, do: str, **arguments: object) -> Reply:
        count[0] += 1
        real = send(link, do, **arguments)
        return Reply(do) if do == "lease" and count[0] % 2 else real

    monkeypatch.setattr(Link, "send", losing)
    monkeypatch.setattr("probe_bridge.client._LEASE_ANSWER", 0.6)
    client.joints()
    goal = long_path(bridge)[1]
    assert client.follow(long_path(bridge)) == pytest.approx(goal)
    assert not bridge.driver.stops


def test_stop_reaches_a_motion_that_is_still_being_planned(bridge: Running):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        socket.send(pack(follow(bridge, 2)))
        socket.send(pack({"seq": 3, "do": "stop"}))
        replies = {r["seq"]: r for r in (unpack_reply(socket.recv(5)) for _ in range(2))}
        assert kind(replies[2]) == "stopped"
        assert kind(replies[3]) == ""
    assert at_rest(bridge)


def test_stop_is_heard_however_much_is_waited_for(bridge: Running):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        for seq in range(2, 22):
            socket.send(pack({"seq": seq, "do": "wait", "seconds": 1.0}))
        socket.send(pack({"seq": 22, "do": "stop"}))
        replies = {r["seq"]: kind(r) for r in (unpack_reply(socket.recv(5)) for _ in range(21))}
        assert [seq for seq in replies if replies[seq] == "busy"] == [18, 19, 20, 21]
        assert replies[22] == ""
    assert bridge.driver.stops


def test_the_hand_needs_a_lease_too(bridge: Running):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        assert kind(ask(socket, {"seq": 2, "do": "grip", "opening": 0.0, **now()})) == "lease"
    assert 0 < bridge.driver.opening() < bridge.robot.config.max_opening


def test_a_program_that_is_interrupted_while_it_waits_stops_the_arm(
    bridge: Running, client: RobotClient, monkeypatch: pytest.MonkeyPatch
):
    from probe_bridge.link import Reply

    came = Reply.came

    def interrupted(self: Reply, seconds: float = 0.0) -> bool:
        if seconds == 0.12 and time.monotonic() > begun + 0.3:
            raise KeyboardInterrupt
        return came(self, seconds)

    begun = time.monotonic()
    monkeypatch.setattr(Reply, "came", interrupted)
    with pytest.raises(KeyboardInterrupt):
        client.follow(long_path(bridge))
    time.sleep(0.15)
    assert bridge.driver.stops
    assert at_rest(bridge)


def test_closing_the_bridge_stops_the_arm(bridge: Running):
    with connected(bridge.address) as socket:
        ask(socket, HELLO)
        socket.send(pack(follow(bridge, 2)))
        time.sleep(0.2)
        bridge.robot.halt("stopped", "The bridge is closing.")
        assert kind(unpack_reply(socket.recv(5))) == "stopped"
    assert at_rest(bridge)
