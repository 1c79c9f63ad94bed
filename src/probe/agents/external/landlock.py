"""Landlock: how a process gives up rights to files for good, with no rights of its own needed.

https://docs.kernel.org/userspace-api/landlock.html; numbers of <linux/landlock.h>. What follows
from it: such a process can't look into processes outside of it either (ptrace, /proc/PID/mem).
"""

from __future__ import annotations

import ctypes
import os
import stat
from collections.abc import Mapping
from dataclasses import dataclass

_CREATE, _ADD, _RESTRICT = 444, 445, 446
_ASK_VERSION, _PATH_BENEATH = 1, 1
_NO_NEW_PRIVILEGES = 38

_EXECUTE, _WRITE_FILE, _READ_FILE, _READ_DIR = 1 << 0, 1 << 1, 1 << 2, 1 << 3
_TRUNCATE, _IOCTL = 1 << 14, 1 << 15
_OF_FILES = _EXECUTE | _WRITE_FILE | _READ_FILE | _TRUNCATE | _IOCTL

LIST = _READ_DIR
READ = _EXECUTE | _READ_FILE | _READ_DIR
WRITE = (1 << 16) - 1

_RIGHTS = {1: 13, 2: 14, 3: 15, 4: 15}
"""How many rights to files each version knows; later ones 16."""
_NETWORK_SINCE, _SCOPES_SINCE = 4, 6
_BOTH = 0b11
"""Of TCP binding and connecting; of signals to and abstract sockets of processes outside."""

_libc = ctypes.CDLL(None, use_errno=True)


@dataclass(frozen=True)
class Restriction:
    """What a restricted process is kept from.

    Attributes:
        tcp: From TCP; other protocols aren't covered.
        signals: From signalling processes outside.
    """

    tcp: bool
    signals: bool


class _Path(ctypes.Structure):
    _pack_ = 1
    _layout_ = "ms"
    _fields_ = (("allowed", ctypes.c_uint64), ("descriptor", ctypes.c_int32))


def version() -> int:
    """Of this kernel's Landlock; 0 where there is none."""
    return max(_libc.syscall(_CREATE, None, ctypes.c_size_t(0), ctypes.c_uint32(_ASK_VERSION)), 0)


def restrict(allowed: Mapping[str, int], *, network: bool) -> Restriction:
    """Give up all rights to files but those named, for this process and those it will start.

    Args:
        allowed: LIST, READ or WRITE by file or folder; a folder's go for all that is in it.
        network: Leave the network as it is.

    Raises:
        OSError: This kernel can't; then some rights may be lost already.
    """
    known = version()
    rights = (1 << _RIGHTS.get(known, 16)) - 1
    numbers = [rights]
    if known >= _NETWORK_SINCE:
        numbers.append(0 if network else _BOTH)
    if known >= _SCOPES_SINCE:
        numbers.append(_BOTH)
    ruleset = (ctypes.c_uint64 * len(numbers))(*numbers)
    size = ctypes.c_size_t(ctypes.sizeof(ruleset))
    handle = _done(_libc.syscall(_CREATE, ctypes.byref(ruleset), size, ctypes.c_uint32(0)))
    try:
        for path, wanted in allowed.items():
            _allow(handle, path, wanted & rights)
        _done(_libc.prctl(_NO_NEW_PRIVILEGES, 1, 0, 0, 0))
        _done(_libc.syscall(_RESTRICT, handle, ctypes.c_uint32(0)))
    finally:
        os.close(handle)
    return Restriction(tcp=not network and known >= _NETWORK_SINCE, signals=known >= _SCOPES_SINCE)


def _allow(handle: int, path: str, rights: int) -> None:
    """Allow what a path leads to; nothing if it leads nowhere."""
    try:
        descriptor = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return
    try:
        if not stat.S_ISDIR(os.fstat(descriptor).st_mode):
            rights &= _OF_FILES
        rule = _Path(rights, descriptor)
        if rights:
            _done(
                _libc.syscall(_ADD, handle, _PATH_BENEATH, ctypes.byref(rule), ctypes.c_uint32(0))
            )
    finally:
        os.close(descriptor)


def _done(result: int) -> int:
    if result < 0:
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number))
    return result
