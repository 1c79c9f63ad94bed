"""A driver to copy. Every method says what the bridge expects; see also driver.py.

1. Copy this file to drivers/my_arm.py and rename the class.
2. Add "my_arm": "MyDriver" to DRIVERS in drivers/__init__.py.
3. Write a config file; examples/simulated.json shows all its fields.
4. Copy tests/drivers/test_ur_rtde.py and fake your arm's library in it. Test units, the joints'
   order and stop() before the arm moves for the first time.
5. Say here what was tried on hardware, and what never was.
"""

from __future__ import annotations

from probe_bridge.config import Config
from probe_bridge.driver import Reading, Shot
from probe_bridge.fields import Fields
from probe_bridge.trajectory import Trajectory


class MyDriver:
    """Connects in its constructor, and raises at once if the arm isn't there."""

    def __init__(self, config: Config) -> None:
        # The table "driver" of the config file is yours. end() refuses fields that you don't know.
        options = Fields(config.options, "config.driver")
        self._host = options.text("host")
        options.end()
        # Import the arm's library only here, so that the bridge runs without it:
        # self._arm = library("my_arm_sdk", "pip install my-arm-sdk").Arm(self._host)

    def joints(self) -> Reading:
        """Radians, in the order of the config's joints, and time.monotonic() of their measurement.

        Return what came last; don't wait. The bridge stops the arm when the time is 0.3 s old.
        """
        raise NotImplementedError

    def opening(self) -> float:
        """Metres between the pads, as measured: whoever grasps learns from this what it holds."""
        raise NotImplementedError

    def frame(self, camera: str, rgb: bool) -> Shot:
        """A picture that was taken after this call. Depth is registered to colour."""
        raise NotImplementedError

    def start(self, trajectory: Trajectory) -> None:
        """Begin, and return at once.

        If your arm takes

        - whole trajectories: send trajectory.every(0.05), with velocities if it wants them (ros2);
        - a stream of targets: start a Stream that sends trajectory.at(seconds) (ur_rtde);
        - velocities: send the plan's, and correct by what is measured (kinova_ros).
        """
        raise NotImplementedError

    def poll(self) -> bool:
        """True once the arm rests at the end. Raise if it gave up: the bridge then stops it."""
        raise NotImplementedError

    def start_grip(self, opening: float) -> None:
        """Begin to move the hand; return at once."""
        raise NotImplementedError

    def poll_grip(self) -> bool:
        """True once the hand rests, be it on a thing that it holds."""
        raise NotImplementedError

    def stop(self) -> None:
        """Come to rest now. It may be called at any moment, from any thread, and twice."""
        raise NotImplementedError

    def close(self) -> None:
        """Stop, and let go of the arm."""
        raise NotImplementedError
