"""A twin behind a bridge that listens: in a thread of this process, on this machine alone."""

from __future__ import annotations

import asyncio
import json
import threading
from collections.abc import Generator, Mapping
from concurrent.futures import Future
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from probe.assets.library import Library
from probe.errors import BadData, MissingExtra, OutputFailed
from probe.reading import words
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.cameras import View
from probe.scene.scene import Scene
from probe.scene.setup import Setup
from probe.stage.stage import FilmStage, robot_pieces
from probe.station.remote import BASKET_VIEW
from probe.twin.body import TwinBody, Watch
from probe.twin.config import twin_config
from probe.twin.driver import TwinDriver
from probe.twin.flaws import Flaws
from probe.types import Camera
from probe.world.world import World

if TYPE_CHECKING:
    from probe_bridge.config import Config
    from probe_bridge.robot import Robot


@dataclass(frozen=True)
class TwinSettings:
    """How a twin differs from a perfect robot.

    Attributes:
        flaws: Of its cameras.
        haste: How much faster than a real one it is.
        seed: Of all that is drawn by chance.
        views: Fixed cameras that it has, beside the one over the basket.
        cameras: File in which its cameras are told otherwise than they were meant to stand, as
            `probe robot check --corrected` writes it.
    """

    flaws: Flaws = Flaws()
    haste: float = 1.0
    seed: int = 0
    views: tuple[View, ...] = ("front",)
    cameras: Path | None = None


@contextmanager
def twin_of(
    scene: Scene,
    library: Library,
    renderer: Renderer,
    settings: TwinSettings,
    watch: Watch | None = None,
) -> Generator[Robot]:
    """A scene's table as a robot for a bridge.

    Args:
        scene: What lies there, and the set-up.
        library: Has its objects.
        renderer: For this twin alone.
        settings: How it differs from a perfect robot.
        watch: Is told of every step of the physics; for measurements.

    Raises:
        MissingExtra: probe-bridge isn't installed.
        BadData: The file of cameras is of no use.
    """
    try:
        from probe_bridge.robot import Robot
    except ImportError as error:
        raise MissingExtra("A robot's twin", "robot", "./bridge") from error
    setup = scene.setup
    cameras = {view: setup.camera(view) for view in settings.views}
    eyes = {**cameras, BASKET_VIEW: setup.basket_camera}
    config = _config(setup, settings, eyes)
    stage = FilmStage(setup, tuple(robot_pieces(setup)))
    load_scene(renderer, scene, library, more=stage.meshes)
    body = TwinBody(World(scene, library), settings.haste, watch)
    # A renderer takes seconds to start, and clients don't wait that long for a picture.
    renderer.draw(scene.objects, setup.basket_camera, rgb=True)
    robot = Robot(TwinDriver(body, renderer, stage, eyes, settings.flaws, settings.seed), config)
    try:
        yield robot
    finally:
        robot.close()


def _config(setup: Setup, settings: TwinSettings, eyes: Mapping[str, Camera]) -> Config:
    from probe_bridge.config_file import read_config
    from probe_bridge.errors import BridgeError

    told = twin_config(setup, settings.views, settings.haste)
    if settings.cameras is not None:
        told["cameras"] = _cameras_in(settings.cameras)
    try:
        config = read_config(told)
    except BridgeError as error:
        remedy = "Let `probe robot check --corrected` write it for this set-up"
        raise BadData(settings.cameras or setup.name, str(error), remedy) from error
    if settings.cameras is not None and set(config.cameras) != set(eyes):
        reason = f"it tells of {sorted(config.cameras)}, and the twin has {sorted(eyes)}"
        raise BadData(settings.cameras, reason, "Take the file of this set-up's check")
    return config


def _cameras_in(path: Path) -> object:
    try:
        return json.loads(words(path))
    except ValueError as error:
        raise BadData(path, f"it is no JSON: {error}", "Write it again") from error


@contextmanager
def listening(robot: Robot, token: str, host: str, port: int) -> Generator[str]:
    """Let a robot's bridge listen; gives the address for clients.

    Args:
        robot: Whom clients move.
        token: What they must know.
        host: Where to listen.
        port: The same; 0 is any free one.

    Raises:
        OutputFailed: The port is taken.
    """
    ready: Future[str] = Future()
    ended = threading.Event()
    thread = threading.Thread(
        target=lambda: asyncio.run(_serve(robot, token, host, port, ready, ended)), name="bridge"
    )
    thread.start()
    try:
        yield _address(ready, f"{host}:{port}")
    finally:
        ended.set()
        thread.join()


def _address(ready: Future[str], where: str) -> str:
    try:
        return ready.result()
    except OSError as error:
        raise OutputFailed(where, error) from error


async def _serve(
    robot: Robot, token: str, host: str, port: int, ready: Future[str], ended: threading.Event
) -> None:
    try:
        from probe_bridge.server import Address, listen

        server = await listen(robot, token, Address(host, port))
    except Exception as error:  # whoever waits hears of it, whatever it is
        ready.set_exception(error)
        return
    async with server:
        at = next(iter(server.sockets)).getsockname()
        ready.set_result(f"ws://{at[0]}:{at[1]}")
        await asyncio.get_running_loop().run_in_executor(None, ended.wait)
