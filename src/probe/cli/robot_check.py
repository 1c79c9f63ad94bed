"""`probe robot check`: whether a robot is fit for the tools, and what is wrong if not."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from probe.cli.metavars import Address
from probe.cli.robot_link import TOKEN_FILE, token_in
from probe.cli.screen import ScreenTable, say
from probe.errors import BadData
from probe.files import write_text
from probe.robot_check.box import KnownBox
from probe.robot_check.checking import Wishes, check, kit_of
from probe.scene.setup import UR5_TABLE
from probe.scene.setup_file import read_setup

if TYPE_CHECKING:
    from probe.robot_check.outcomes import Outcome

_WIDE = 118
_LEAST, _MOST = 0.02, 0.3


def check_robot(
    address: Address,
    token_file: Path = TOKEN_FILE,
    certificate: Path | None = None,
    setup: Path | None = None,
    box: tuple[float, float, float] = KnownBox().size,
    pick: bool = False,
    corrected: Path | None = None,
    out: Path | None = None,
) -> None:
    """Check a robot: link, clock, pictures, joints, stops, hand, and where its cameras stand.

    Asks before anything moves; end the input (Ctrl-D) to leave a part out. Ends with status 1 if
    something failed. See docs/how-to/bridge.md.

    Args:
        address: Of the robot's bridge.
        token_file: Has the bridge's token.
        certificate: Of the bridge, if no public authority vouches for it.
        setup: File of the set-up (docs/how-to/extend/add-a-setup.md).
        box: Size of the plain box that the arm holds up, along x, y and z, metres.
        pick: Try a pick as well, with the skill that agents use.
        corrected: File to write cameras with corrected poses to, for the robot's file.
        out: File to write what was found to, JSON.
    """
    if not all(_LEAST <= edge <= _MOST for edge in box):
        raise BadData("--box", f"{box} is no size in metres", f"Say {_LEAST} to {_MOST} each")
    around = read_setup(setup) if setup else UR5_TABLE
    if max(box[:2]) > around.gripper.max_opening - 0.03:
        reason = f"the hand opens {around.gripper.max_opening:.3f} m"
        raise BadData("--box", reason, "Take a box that is narrower by 3 cm")
    kit = kit_of(address, token_in(token_file), certificate, _tell)
    try:
        check(kit, Wishes(around, KnownBox(box), pick, corrected), _may)
    finally:
        _table(kit.outcomes).show(_WIDE)
        if out:
            write_text(out, json.dumps([each.values() for each in kit.outcomes], indent=1) + "\n")
    if not kit.well:
        sys.exit(1)


def _tell(outcome: Outcome) -> None:
    say(f"{outcome.verdict:8}{outcome.check}{f': {outcome.fault}' if outcome.fault else ''}")


def _may(text: str) -> bool:
    say(text, "Press Enter to go on, Ctrl-D to leave this out.")
    return bool(sys.stdin.readline())


def _table(outcomes: list[Outcome]) -> ScreenTable:
    table = ScreenTable("check", "", "what was found", "measured")
    for each in outcomes:
        fault = f"{each.fault}: " if each.fault else ""
        remedy = f"\n{each.remedy}" if each.remedy else ""
        measured = "\n".join(str(measure) for measure in each.measures)
        table.add(each.check, each.verdict, f"{fault}{each.text}{remedy}", measured)
    return table
