"""Everything PROBE raises on purpose; each message says what would have worked."""

from __future__ import annotations

import errno

from probe.closest import did_you_mean


class ProbeError(Exception):
    """Base of all expected failures; the command line prints it without a traceback."""


class Misuse(ProbeError):
    """Words of a command line that fit no command; its exit status is 2."""


class BadMesh(ProbeError):
    """A mesh file can't be used as an object."""

    def __init__(self, path: object, reason: str, remedy: str) -> None:
        super().__init__(f"{path}: {reason}. {remedy}")


class BadData(ProbeError):
    """A data file is missing, truncated or breaks its schema."""

    def __init__(self, path: object, reason: str, remedy: str) -> None:
        super().__init__(f"{path}: {reason}. {remedy}")


_LONGEST_NAME = 80
"""Characters of a name that is shown back."""

_SHOWN = 12
"""Known names that are listed."""


class UnknownName(ProbeError):
    """A name that is not in a catalogue; the message names those that come nearest.

    Args:
        kind: Of what ("suite").
        name: What was said.
        known: All that there are. Of a long list only the nearest names are told, if there are any.
        remedy: What else would work.
    """

    def __init__(self, kind: str, name: str, known: list[str], remedy: str = "") -> None:
        called = name if len(name) <= _LONGEST_NAME else f"{name[: _LONGEST_NAME - 3]}..."
        shown = ", ".join(known[:_SHOWN]) + (" ..." if len(known) > _SHOWN else ".")
        meant = did_you_mean(called, known)
        told = [f"There is no {kind} called {called!r}.", meant, f"Known: {shown}", remedy]
        if meant and len(known) > _SHOWN:
            told[2] = f"There are {len(known)}."
        super().__init__(" ".join(part for part in told if part))


class Unsatisfiable(ProbeError):
    """A scene that no draw could satisfy."""


class NoGraphicsDriver(ProbeError):
    """No Vulkan loader or driver on this machine."""


class RenderFailed(ProbeError):
    """The render worker died twice on the same request."""


class WorkerDied(ProbeError):
    """A worker process was killed from outside, most often for lack of memory.

    Args:
        doing: What it was doing ("setting up").
        remedy: How to go on.
    """

    def __init__(self, doing: str, remedy: str = "Run it again with --workers 1.") -> None:
        super().__init__(f"A worker process died while {doing}. {remedy}")


class Unfinished(ProbeError):
    """Something is missing of what was asked for, though what is there is whole.

    Args:
        missing: How many.
        total: Of how many.
        what: Of what ("episodes").
        remedy: How to go on.
    """

    def __init__(self, missing: int, total: int, what: str, remedy: str) -> None:
        super().__init__(f"{missing} of {total} {what} are missing. {remedy}")


class ObjectsRefused(ProbeError):
    """Objects were looked at, and some of them can't be used."""

    def __init__(self, refused: int, total: int) -> None:
        many = f"{refused} of {total} objects can't be used"
        super().__init__(f"{many}; the table says why. Mend or leave out those files.")


class ModelFailed(ProbeError):
    """A model gave no reply, or none that can be used."""


class MissingExtra(ProbeError):
    """Something needs a package that is installed on demand.

    Args:
        what: Needs it.
        extra: Of this project.
        folder: Of the clone, if that is where the package itself is.
    """

    def __init__(self, what: str, extra: str, folder: str | None = None) -> None:
        super().__init__(
            f"{what} needs more packages: python3 -m pip --python .venv/bin/python "
            f"install -e '{folder or f'.[{extra}]'}', where the project was cloned."
        )


class ArmInView(ProbeError):
    """A look at the table while the arm is in the way."""

    def __init__(self) -> None:
        super().__init__("The arm hides part of the table. Park it before looking.")


class RobotLost(ProbeError):
    """A robot's bridge refused something, was stopped, or doesn't answer."""


class StoppedByPerson(ProbeError):
    """A person stopped the robot, or refused a motion; it is no agent's doing."""


class DownloadFailed(ProbeError):
    """A file can't be fetched."""

    def __init__(self, url: str, reason: str) -> None:
        super().__init__(f"{url}: {reason}. Run it again to go on, or fetch it by other means.")


class OutputFailed(ProbeError):
    """Results can't be written (a full disk, a folder without permission).

    Args:
        path: Where to.
        reason: What the system said, or words.
    """

    def __init__(self, path: object, reason: OSError | str) -> None:
        code = reason.errno if isinstance(reason, OSError) else None
        remedy = _OUTPUT_REMEDIES.get(code or 0, "Choose another folder")
        words = (reason.strerror or str(reason)) if isinstance(reason, OSError) else reason
        super().__init__(f"{path}: {words}. {remedy}; nothing half-written is left.")


_FULL = "Free some space or choose another folder"
_FORBIDDEN = "Choose a folder that you may write to, or have its permissions changed"
_TAKEN = "Something else of that name is in the way: move it, or choose another folder"
_LONG = "Choose a shorter name"
_OUTPUT_REMEDIES = {
    errno.ENOSPC: _FULL,
    errno.EDQUOT: _FULL,
    errno.EFBIG: _FULL,
    errno.EACCES: _FORBIDDEN,
    errno.EPERM: _FORBIDDEN,
    errno.EROFS: _FORBIDDEN,
    errno.ENOENT: "No folder can be made there: choose another one",
    errno.ENOTDIR: _TAKEN,
    errno.EISDIR: _TAKEN,
    errno.EEXIST: _TAKEN,
    errno.ENOTEMPTY: _TAKEN,
    errno.ENAMETOOLONG: _LONG,
}
"""What to do, by why a file can't be written."""
