"""Intel's RealSense cameras over pyrealsense2, depth aligned to colour. Never tried on hardware."""

from __future__ import annotations

import threading
import time
from typing import Any

from probe_bridge.config import BridgeCamera
from probe_bridge.driver import Shot
from probe_bridge.drivers import library


class RealSense:
    """One camera that streams while it is open.

    Args:
        camera: Its size counts; its intrinsics have to be those of the colour stream.
        serial: Of the device.
        rate: Pictures a second.
    """

    def __init__(self, camera: BridgeCamera, serial: str, rate: int) -> None:
        rs: Any = library("pyrealsense2", "pip install pyrealsense2")
        self._lock = threading.Lock()
        config = rs.config()
        config.enable_device(serial)
        config.enable_stream(rs.stream.color, camera.width, camera.height, rs.format.rgb8, rate)
        config.enable_stream(rs.stream.depth, camera.width, camera.height, rs.format.z16, rate)
        self._pipeline = rs.pipeline()
        profile = self._pipeline.start(config)
        self._unit = float(profile.get_device().first_depth_sensor().get_depth_scale())
        self._align = rs.align(rs.stream.color)

    def frame(self, rgb: bool) -> Shot:
        """A picture that was not in the queue before."""
        with self._lock:
            self._pipeline.wait_for_frames(2000)
            frames = self._align.process(self._pipeline.wait_for_frames(2000))
            depth, colour = frames.get_depth_frame(), frames.get_color_frame()
            return Shot(
                depth.get_width(),
                depth.get_height(),
                bytes(depth.get_data()),
                self._unit,
                bytes(colour.get_data()) if rgb else None,
                time.monotonic(),
            )

    def close(self) -> None:
        self._pipeline.stop()
