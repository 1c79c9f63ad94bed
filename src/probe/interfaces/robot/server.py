"""Serves a robot's page on this machine alone, in a thread beside what the robot does."""

from __future__ import annotations

from contextlib import AbstractContextManager

from probe.interfaces.human.server import served
from probe.interfaces.robot.app import RobotPanel, app_of


def panel_page(panel: RobotPanel, port: int) -> AbstractContextManager[str]:
    """Serve the page as long as the block lasts; gives its address.

    Args:
        panel: What it shows.
        port: Where to listen; 0 for any that is free.

    Raises:
        PortTaken: The port can't be used.
    """
    return served(app_of(panel), port)
