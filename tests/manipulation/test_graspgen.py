"""The GraspGen client against a server that speaks its protocol, in every mood."""

from __future__ import annotations

import threading
from collections.abc import Callable, Generator
from contextlib import contextmanager

import msgpack
import msgpack_numpy
import numpy as np
import pytest
import zmq

from manipulation.views import Block, view
from probe.manipulation.graspgen import DEPTH, GraspGen, GraspServerFailed
from probe.manipulation.target import target_of
from probe.manipulation.terrain import survey
from probe.scene.setup import UR5_TABLE
from probe.station.gripper import Gripper

BLOCK = Block(0.0, 0.0, (0.06, 0.04, 0.06))
WALL = Block(0.0, 0.045, (0.2, 0.03, 0.12))


@contextmanager
def serving(answer: Callable[[dict], object]) -> Generator[tuple[str, list[dict]]]:
    """A REP socket in a thread; None as an answer is silence, bytes are sent as they are."""
    heard: list[dict] = []
    socket = zmq.Context.instance().socket(zmq.REP)
    port = socket.bind_to_random_port("tcp://127.0.0.1")
    done = threading.Event()

    def serve() -> None:
        while not done.is_set():
            if not socket.poll(50):
                continue
            heard.append(msgpack.unpackb(socket.recv(), object_hook=msgpack_numpy.decode))
            said = answer(heard[-1])
            if said is None:
                done.wait()
            elif isinstance(said, bytes):
                socket.send(said)
            else:
                socket.send(msgpack.packb(said, default=msgpack_numpy.encode))
        socket.close(linger=0)

    thread = threading.Thread(target=serve)
    thread.start()
    try:
        yield f"tcp://127.0.0.1:{port}", heard
    finally:
        done.set()
        thread.join()


def above(points: np.ndarray, along: tuple[float, float, float]) -> np.ndarray:
    """A hand of theirs that reaches straight down around the points, closing along a direction."""
    pose = np.eye(4)
    x, z = np.array(along), np.array([0.0, 0.0, -1.0])
    pose[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    pose[:3, 3] = [*points.mean(axis=0)[:2], points[:, 2].max() - 0.015 + DEPTH]
    return pose.astype(np.float32)


def good(request: dict) -> dict:
    points = request["point_cloud"]
    grasps = np.stack([above(points, (1, 0, 0)), above(points, (0, 1, 0))])
    return {"grasps": grasps, "confidences": np.array([0.3, 0.9], np.float32), "num_grasps": 2}


def plan(address: str, *blocks: Block, timeout: float = 5.0):
    frame, masks = view(blocks)
    terrain = survey(frame, UR5_TABLE)
    target = target_of(frame, masks[0], terrain)
    return GraspGen(address, timeout=timeout)(target, terrain, Gripper())


def test_the_most_trusted_comes_first_and_is_closed_on_what_is_seen() -> None:
    with serving(good) as (address, heard):
        first, second = plan(address, BLOCK)
    assert first.merit == pytest.approx(0.9) and second.merit == pytest.approx(0.3)
    assert first.width == pytest.approx(0.04, abs=0.004)
    assert second.width == pytest.approx(0.06, abs=0.004)
    assert np.abs(first.hand.rotation[:, 1]) == pytest.approx([0, 1, 0], abs=1e-6)
    assert first.hand.rotation[:, 2] == pytest.approx([0, 0, -1], abs=1e-6)
    assert first.middle[:2] == pytest.approx([0, 0], abs=0.003) and first.tilt < 0.01
    assert heard[0]["action"] == "infer" and heard[0]["point_cloud"].dtype == np.float32


def test_a_grasp_that_would_meet_a_neighbour_is_left_out() -> None:
    with serving(good) as (address, _):
        (only,) = plan(address, BLOCK, WALL)
    assert only.merit == pytest.approx(0.3)


def test_no_grasps_are_none() -> None:
    empty = {"grasps": np.zeros((0, 4, 4), np.float32), "confidences": np.zeros(0, np.float32)}
    with serving(lambda _: empty) as (address, _):
        assert plan(address, BLOCK) == []
    with serving(lambda _: {"grasps": [], "confidences": []}) as (address, _):
        assert plan(address, BLOCK) == []


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        ({"error": "torch.cat(): expected a non-empty list"}, "torch.cat"),
        ({"grasps": np.ones((2, 4, 4), np.float32), "confidences": np.ones(2)}, "no rigid"),
        ({"grasps": np.ones((2, 3), np.float32), "confidences": np.ones(2)}, "no grasps"),
        ({"grasps": np.eye(4)[None], "confidences": np.ones(3)}, "no grasps"),
        ({"num_grasps": 3}, "no grasps"),
        (b"\xc1 nonsense", "understood"),
        (b"", "understood"),
        ([1, 2], "no answer"),
    ],
)
def test_an_answer_that_makes_no_sense_is_named(answer: object, words: str) -> None:
    with (
        serving(lambda _: answer) as (address, _),
        pytest.raises(GraspServerFailed, match=words) as failure,
    ):
        plan(address, BLOCK)
    assert address in str(failure.value)


def test_silence_ends_and_the_next_question_is_asked_anew() -> None:
    with serving(lambda _: None) as (address, _), pytest.raises(GraspServerFailed, match="0.3 s"):
        plan(address, BLOCK, timeout=0.3)
    with serving(good) as (address, _):
        assert len(plan(address, BLOCK)) == 2


def test_a_server_that_is_not_there_is_named() -> None:
    with pytest.raises(GraspServerFailed, match="no answer"):
        plan("tcp://127.0.0.1:9", BLOCK, timeout=0.3)
    with pytest.raises(GraspServerFailed, match="nowhere"):
        plan("nowhere", BLOCK, timeout=0.3)
