"""`probe robot`: robots behind bridges, and the twin that stands in for one."""

from __future__ import annotations

import secrets
import signal
import threading
from pathlib import Path
from typing import Literal

from probe.api.resources import cache_folder, everything, library, tables_for
from probe.assets.library import Library
from probe.cli.command_app import CommandApp
from probe.cli.numbers import check_numbers
from probe.cli.robot_check import check_robot
from probe.cli.robot_enrol import enrol
from probe.cli.robot_link import TOKEN_FILE, token_in
from probe.cli.robot_run import run
from probe.cli.robot_session import session, verify_session
from probe.cli.screen import say
from probe.errors import BadData
from probe.files import write_text
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.setup import UR5_TABLE
from probe.scene.setup_file import read_setup
from probe.tasks.suite_file import find_suite
from probe.twin.config import FASTEST
from probe.twin.flaws import NO_FLAWS, Flaws
from probe.twin.only_box import BoxLibrary, box_scene
from probe.twin.serving import TwinSettings, listening, twin_of
from probe.twin.trace import traced
from probe.types import Vector3
from probe.world.scenes import make_scene

app = CommandApp()
app.command(name="check")(check_robot)
app.command(enrol)
app.command(run)
app.command(session)
app.command(verify_session)

PORT = 8731
_FLAWS = {"real": Flaws(), "none": NO_FLAWS}


@app.command
def twin(
    suite: str | None = None,
    task: str | None = None,
    setup: Path | None = None,
    box: tuple[float, float, float] | None = None,
    seed: int = 0,
    flaws: Literal["real", "none"] = "real",
    haste: float = 1.0,
    host: str = "127.0.0.1",
    port: int = PORT,
    token_file: Path = TOKEN_FILE,
    cameras: Path | None = None,
    trace: Path | None = None,
) -> None:
    """Serve a simulated table as if it were a real robot's, until Ctrl-C.

    It moves by the clock, its cameras err, and nobody behind the bridge learns what lies there.

    Args:
        suite: Whose task's table it is; without one, a table is drawn from the seed.
        task: Id of the task.
        setup: File of the set-up of a table from the seed (docs/how-to/extend/add-a-setup.md).
        box: Only a plain box of this size stands on the table, as `probe robot check` asks for.
        seed: Of a table without a task, and of all errors.
        flaws: Of the cameras: those of a real one, or none.
        haste: How much faster than a real robot it is.
        host: Address to listen on; by default no other computer gets to it.
        port: 0 for any free one.
        token_file: Has the token that clients must know; written if it isn't there.
        cameras: File that tells where its cameras stand, from `probe robot check --corrected`.
        trace: File for the arm's angles and speeds in the physics, whatever the bridge says.
    """
    check_numbers({"--seed": seed, "--port": port})
    if not 0.1 <= haste <= FASTEST:
        raise BadData("--haste", f"{haste} is too slow or too fast", f"Say 0.1 to {FASTEST:g}")
    if (suite is None) != (task is None) or (suite and (setup or box)):
        reason = "a suite's table needs --suite and --task; its set-up is the task's"
        raise BadData(
            "--suite, --task, --setup, --box", reason, "Say both of the first, or neither"
        )
    settings = TwinSettings(_FLAWS[flaws], haste, seed, ("top", "front"), cameras)
    things, scene = _table(suite, task, setup, box, seed)
    token = _token(token_file)
    with (
        Renderer(cache_folder() / "light") as renderer,
        traced(trace) as watch,
        twin_of(scene, things, renderer, settings, watch) as robot,
        listening(robot, token, host, port) as address,
    ):
        say(f"The twin of {scene.setup.name!r} listens at {address}; its token is in {token_file}")
        _until_ended()


def _table(
    suite: str | None, task: str | None, setup: Path | None, box: Vector3 | None, seed: int
) -> tuple[Library, Scene]:
    if suite is None:
        around = read_setup(setup) if setup else UR5_TABLE
        if box:
            return BoxLibrary(box, cache_folder()), box_scene(around, seed)
        things = library("procedural")
        return things, make_scene(seed, things, tables_for("procedural"), setup=around)
    return everything(), find_suite(suite)[task or ""].scene


def _token(path: Path) -> str:
    """The token in a file; drawn and written where there is none yet."""
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        write_text(path, secrets.token_urlsafe(24) + "\n", private=True)
    return token_in(path)


def _until_ended() -> None:
    """Wait for Ctrl-C, or for whoever ends the process.

    Shells let what they start in the background ignore Ctrl-C's signal, so it is asked for.
    """
    ended = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: ended.set())
    ended.wait()
