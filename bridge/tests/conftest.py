"""Fixtures that several tests share."""

from __future__ import annotations

from typing import Iterator

import pytest

from bridges import TOKEN, Running, practice, running
from busy import Machine
from probe_bridge.client import RobotClient


@pytest.fixture
def bridge() -> Iterator[Running]:
    with running(practice()) as bridge:
        yield bridge


@pytest.fixture
def client(bridge: Running) -> Iterator[RobotClient]:
    client = RobotClient(bridge.address, TOKEN)
    yield client
    client.close()


@pytest.fixture
def machine() -> Iterator[Machine]:
    machine = Machine()
    yield machine
    machine.close()
