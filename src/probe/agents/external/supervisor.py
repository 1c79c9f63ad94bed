"""Between us and an agent: a process that ends all that the agent has started. Knows no agent.

`python -m probe.agents.external.supervisor HANDLE NETWORK`; HANDLE is that of a socket to us,
NETWORK 1 where the agent may use it. Imports nothing that starts threads: a process with threads
gets no namespaces.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import signal
import sys
from importlib import import_module
from pathlib import Path

_SUBREAPER, _DEATH_SIGNAL = 36, 1
_USERS, _PROCESSES, _IPC, _NETWORK = 0x10000000, 0x20000000, 0x08000000, 0x40000000
_KILLED = 128
"""What shells add to a signal's number to make a status of it."""

_libc = ctypes.CDLL(None, use_errno=True)


def guard(network: bool) -> bool:
    """Fork: the child goes on, with whether it has namespaces; here all is ended when it is over.

    Where the kernel lets us, the child gets namespaces of its own: it sees no process outside, has
    no network unless it may, and when it ends all ends that it has started.

    Args:
        network: Leave the network as it is.
    """
    _libc.prctl(_SUBREAPER, 1, 0, 0, 0)
    _libc.prctl(_DEATH_SIGNAL, signal.SIGTERM, 0, 0, 0)
    apart = _unshare(_USERS | _PROCESSES | _IPC | (0 if network else _NETWORK))
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGTERM})
    first = os.fork()
    if first == 0:
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})
        # The first process of a namespace is deaf to many signals, its own as well; so it waits.
        agent = os.fork() if apart else 0
        if agent == 0:
            return apart
        _let_go()
        os._exit(_status(_reap(agent)))
    signal.signal(signal.SIGTERM, lambda *_: _kill(first))
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})
    _let_go()
    status = _status(_reap(first))
    _end_children()
    os._exit(status)


def _unshare(flags: int) -> bool:
    user, group = os.getuid(), os.getgid()
    if _libc.unshare(flags) != 0:
        return False
    # It stays who it was; where that may not be said it is nobody, which will do.
    with contextlib.suppress(OSError):
        Path("/proc/self/setgroups").write_text("deny")
        Path("/proc/self/uid_map").write_text(f"{user} {user} 1")
        Path("/proc/self/gid_map").write_text(f"{group} {group} 1")
    return True


def _let_go() -> None:
    """Close all we have open, so that an end of it is one."""
    sys.stdout.flush()
    os.closerange(0, os.sysconf("SC_OPEN_MAX"))


def _reap(wanted: int) -> int:
    """Wait until a process ends; how, as os.wait has it. Orphans that come to us go as well."""
    while True:
        process, how = os.wait()
        if process == wanted:
            return how


def _status(how: int) -> int:
    code = os.waitstatus_to_exitcode(how)
    return code if code >= 0 else _KILLED - code


def _end_children() -> None:
    """Kill what is left; what these leave behind comes to us and is killed in turn."""
    with contextlib.suppress(ChildProcessError):
        while True:
            for process in _children():
                _kill(process)
            os.wait()


def _kill(process: int) -> None:
    with contextlib.suppress(ProcessLookupError):
        os.kill(process, signal.SIGKILL)


def _children() -> list[int]:
    """Processes whose parent we are."""
    ours, found = str(os.getpid()), list[int]()
    for folder in os.scandir("/proc"):
        if not folder.name.isdigit():
            continue
        with contextlib.suppress(OSError):
            # A name in brackets comes first and may hold anything.
            after = Path(folder.path, "stat").read_text().rpartition(")")[2].split()
            if after[1] == ours:
                found.append(int(folder.name))
    return found


if __name__ == "__main__":
    handle, network = map(int, sys.argv[1:])
    apart = guard(bool(network))
    import_module("probe.agents.external.agent_process").main(handle, apart=apart)
