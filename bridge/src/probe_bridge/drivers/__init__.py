"""The robots that the bridge can drive. Each file knows one robot's interface."""

from __future__ import annotations

from importlib import import_module
from typing import Any, Callable, Dict, cast

from probe_bridge.config import Config
from probe_bridge.driver import Driver
from probe_bridge.errors import BridgeError

DRIVERS: Dict[str, str] = {
    "simulated": "SimulatedDriver",
    "kinova_ros": "KinovaDriver",
    "ros2": "Ros2Driver",
    "ur_rtde": "UrDriver",
}
"""Names on the command line, which are also the files', and the classes in them."""


def open_driver(name: str, config: Config) -> Driver:
    """Connect to a robot.

    Raises:
        BridgeError: "refused"; there is no such driver, its library is not installed, or an
            option of it is wrong.
    """
    if name not in DRIVERS:
        raise BridgeError("refused", f"There is no driver {name!r}; known: {', '.join(DRIVERS)}.")
    module = import_module(f"probe_bridge.drivers.{name}")
    make = cast("Callable[[Config], Driver]", getattr(module, DRIVERS[name]))
    return make(config)


def library(name: str, remedy: str) -> Any:
    """A robot's own library, imported only now.

    Raises:
        BridgeError: "refused"; it is not installed.
    """
    try:
        return import_module(name)
    except ImportError as error:
        text = f"Python's package {name!r} can't be imported: {error}."
        raise BridgeError("refused", text, remedy) from error
