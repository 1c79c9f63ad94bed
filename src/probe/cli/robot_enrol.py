"""`probe robot enrol`: what an operator's objects look like."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import closing
from pathlib import Path

from probe.api.resources import cache_folder, everything
from probe.cli.metavars import File
from probe.cli.numbers import check_numbers
from probe.cli.operator import TerminalOperator
from probe.cli.robot_link import TOKEN_FILE, token_in
from probe.cli.screen import say
from probe.errors import UnknownName
from probe.perception.enrolled.enrolment_file import read_list, write_signatures
from probe.perception.enrolled.showing import shown
from probe.perception.enrolled.signature import Signature
from probe.perception.enrolled.simulated import enrol_simulated
from probe.render.renderer import Renderer
from probe.scene.cameras import View
from probe.scene.setup import UR5_TABLE
from probe.scene.setup_file import read_setup
from probe.station.remote import RobotStation, connected
from probe.types import Camera, Frame

_TABLE = "oak_planks"


def enrol(
    objects: File,
    address: str | None = None,
    token_file: Path = TOKEN_FILE,
    certificate: Path | None = None,
    setup: Path | None = None,
    camera: View = "front",
    views: int = 4,
) -> None:
    """Show the objects of a list to a camera one after another, and keep what they look like.

    Afterwards `--perception enrolled --enrolment OBJECTS` knows them by name. See
    docs/reference/perception.md.

    Args:
        objects: The list.
        address: Of the robot's bridge, whose camera looks; you are asked to lay out each object.
            Without one, the list's names are those of catalogue objects, and a simulated camera
            looks.
        token_file: Has the bridge's token.
        certificate: Of the bridge, if no public authority vouches for it.
        setup: File of the set-up (docs/how-to/extend/add-a-setup.md).
        camera: Which looks.
        views: Poses in which each object is shown to a robot's camera.
    """
    check_numbers({"--views": views})
    around = read_setup(setup) if setup else UR5_TABLE
    names = [known.name for known in read_list(objects)]
    if address is None:
        found = _shown_in_simulation(names, around.camera(camera))
    else:
        with closing(connected(address, token_in(token_file), certificate)) as client:
            station = RobotStation(client, around, camera)
            found = {name: shown(_posed(station, name, views)) for name in names}
    write_signatures(objects, found)
    say(f"{len(found)} objects are enrolled beside {objects}")


def _shown_in_simulation(names: Sequence[str], camera: Camera) -> dict[str, tuple[Signature, ...]]:
    things = everything()
    ids = {spec.name: spec.id for spec in things.specs}
    for name in names:
        if name not in ids:
            raise UnknownName("object", name, sorted(ids), "With --address, any name will do.")
    with Renderer(cache_folder() / "light") as renderer:
        wanted = [ids[name] for name in names]
        found = enrol_simulated(renderer, things, wanted, camera, _TABLE)
    return {name: found[ids[name]] for name in names}


def _posed(station: RobotStation, name: str, views: int) -> list[Frame]:
    """Frames of an object, each in a pose that a person has laid it in."""
    frames: list[Frame] = []
    for number in range(1, views + 1):
        where = f"alone on the table's middle, pose {number} of {views}"
        TerminalOperator().ask(f"Lay the {name} {where}; then Enter.")
        frames.append(station.observe(rgb=True))
    return frames
