"""The robot as requests see it: a driver behind limits, pictures and motions in threads."""

from __future__ import annotations

import asyncio
import time
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Callable, Dict, TypeVar

from probe_bridge.config import BridgeCamera, Config
from probe_bridge.curve import Row
from probe_bridge.driver import Driver
from probe_bridge.errors import BridgeError
from probe_bridge.mover import Mover
from probe_bridge.replies import described, glimpsed, pictured
from probe_bridge.requests import (
    Bare,
    Follow,
    Glimpse,
    Grip,
    Hello,
    Home,
    Observe,
    Renew,
    Request,
    Wait,
)
from probe_bridge.wire import VERSION

_T = TypeVar("_T")


class Robot:
    """Answers requests. Motions and pictures are made in threads, so that others get through.

    Args:
        driver: Of the robot; the Robot closes it.
        config: Whose limits count.
    """

    def __init__(self, driver: Driver, config: Config) -> None:
        self.config = config
        self._driver = driver
        self._mover = Mover(driver, config)
        self._moving = ThreadPoolExecutor(1, "motion")
        self._looking = ThreadPoolExecutor(2, "pictures")
        # Of its own, so that nothing that matters ever waits for a film's picture.
        self._filming = ThreadPoolExecutor(1, "film")
        self._films = False

    def halt(self, kind: str, text: str) -> None:
        """Stop arm and hand now, from any thread.

        Raises:
            BridgeError: "fault"; the driver could not.
        """
        self._mover.halt(kind, text)

    def close(self) -> None:
        """Stop the robot and let go of it."""
        try:
            self._mover.close()
        finally:
            self._moving.shutdown()
            self._looking.shutdown()
            self._filming.shutdown()
            self._driver.close()

    async def answer(self, request: Request) -> Dict[str, Any]:
        """What a request asked for.

        Raises:
            BridgeError: It was refused, or it failed.
        """
        if isinstance(request, Hello):
            return self._hello(request.version)
        if isinstance(request, Observe):
            return await self._observe(request)
        if isinstance(request, Glimpse):
            return await self._glimpse(request)
        if isinstance(request, Wait):
            await asyncio.sleep(request.seconds)
            return {}
        if isinstance(request, Renew):
            self._mover.renew(request.seen)
            return {"moving": self._mover.busy, "clock": time.monotonic()}
        if isinstance(request, Bare):
            return await self._bare(request.do)
        return await self._move(request)

    def _hello(self, version: int) -> Dict[str, Any]:
        if version != VERSION:
            raise BridgeError(
                "version",
                f"The client speaks version {version}, this bridge {VERSION}.",
                "Install the same release of probe-bridge on both machines.",
            )
        return described(self.config, time.monotonic())

    async def _observe(self, request: Observe) -> Dict[str, Any]:
        camera = self._camera(request.camera)
        return await self._in_thread(
            self._looking,
            lambda: pictured(self._driver.frame(camera.name, request.rgb), camera),
        )

    async def _glimpse(self, request: Glimpse) -> Dict[str, Any]:
        camera = self._camera(request.camera)
        if self._films:
            raise BridgeError("busy", "The last glimpse is still being taken.", "Ask for fewer.")
        asked, self._films = time.monotonic(), True
        try:
            result = await self._in_thread(
                self._filming,
                lambda: {
                    **glimpsed(self._driver.frame(camera.name, True), camera, request.step),
                    "joints": self._joints()["joints"],
                },
            )
        finally:
            self._films = False
        return {**result, "took": time.monotonic() - asked}

    def _camera(self, name: str) -> BridgeCamera:
        camera = self.config.cameras.get(name)
        if camera is None:
            known = ", ".join(self.config.cameras) or "none"
            raise BridgeError("refused", f"There is no camera {name!r}; known: {known}.")
        return camera

    async def _bare(self, do: str) -> Dict[str, Any]:
        if do == "stop":
            self.halt("stopped", "The client asked the robot to stop.")
            return {}
        if do == "joints":
            return await self._in_thread(self._looking, self._joints)
        return await self._in_thread(self._looking, self._state)

    async def _move(self, request: Request) -> Dict[str, Any]:
        if isinstance(request, Grip):
            opening, most = request.opening, self.config.max_opening
            if opening > most:
                raise BridgeError("refused", f"The hand opens {most} m, not {opening}.")
            self._mover.claim(request.seen)
            reached = await self._in_thread(self._moving, lambda: self._mover.grip(opening))
            return {"opening": reached}
        assert isinstance(request, (Follow, Home))
        path, speed = request.path if isinstance(request, Follow) else None, request.speed
        self._mover.claim(request.seen)

        def move() -> Row:
            return self._mover.home(speed) if path is None else self._mover.follow(path, speed)

        return {"joints": list(await self._in_thread(self._moving, move))}

    def _joints(self) -> Dict[str, Any]:
        reading = self._driver.joints()
        return {"joints": list(reading.joints), "stamp": reading.stamp}

    def _state(self) -> Dict[str, Any]:
        return {
            **self._joints(),
            "opening": self._driver.opening(),
            "moving": self._mover.busy,
            "lease_left": self._mover.lease_left,
            "clock": time.monotonic(),
        }

    async def _in_thread(self, threads: ThreadPoolExecutor, work: Callable[[], _T]) -> _T:
        """Do work in a thread; what a driver raises becomes a "fault"."""
        try:
            return await asyncio.get_running_loop().run_in_executor(threads, work)
        except BridgeError:
            raise
        except Exception as error:
            raise BridgeError("fault", f"The driver failed: {error!r}.") from error
