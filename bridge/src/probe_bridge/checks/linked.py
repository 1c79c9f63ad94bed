"""Whether the bridge can be reached, speaks this version and lets in nobody without its token."""

from __future__ import annotations

from pathlib import Path
from typing import Optional

from probe_bridge.checks.outcome import Outcome, failed, passed
from probe_bridge.command_log import NOWHERE, CommandLog
from probe_bridge.errors import BridgeError
from probe_bridge.link import Link
from probe_bridge.wire import VERSION

LINK, TOKEN, HELLO = "link", "token", "version"

_WRONG = "surely-not-the-token-of-any-bridge"
_ANSWER = 3.0
_TRIES = 3


def check_token(address: str, token: str, certificate: Optional[Path]) -> Outcome:
    """The token is let in, and another one is not."""
    try:
        Link(address, token, certificate, CommandLog(NOWHERE)).close()
    except BridgeError as error:
        if error.kind == "unauthorized":
            remedy = "Use the token that the bridge was started with; copy its file again."
            return failed(TOKEN, "bad token", str(error), remedy)
        return failed(LINK, "no link", str(error), "Start the bridge; look at host and port.")
    try:
        Link(address, _WRONG, certificate, CommandLog(NOWHERE)).close()
    except BridgeError as error:
        if error.kind == "unauthorized":
            return passed(TOKEN, "The token is let in, and another one is refused.")
        return failed(TOKEN, "no link", str(error), "Look whether the bridge still runs.")
    text = "A wrong token is let in, so everyone on the network may move the robot."
    return failed(TOKEN, "open to all", text, "Stop the bridge. Install it again.")


def check_version(address: str, token: str, certificate: Optional[Path]) -> Outcome:
    """Both ends speak the same version of the protocol."""
    try:
        for _ in range(_TRIES):
            link = Link(address, token, certificate, CommandLog(NOWHERE))
            try:
                hello = link.send("hello", version=VERSION)
                if hello.came(_ANSWER):
                    told = hello.result.get("version")
                    break
            finally:
                link.close()
        else:
            text = f"The bridge lets clients in but did not answer {_TRIES} greetings."
            return failed(HELLO, "silent drop of messages", text, "Look into the bridge's log.")
    except BridgeError as error:
        if error.kind == "version":
            return _another(str(error))
        return failed(HELLO, "no link", str(error), error.remedy or "Look at the bridge's log.")
    if told != VERSION:
        return _another(f"The bridge says that it speaks version {told}, this client {VERSION}.")
    return passed(HELLO, f"Both ends speak version {VERSION}.")


def _another(text: str) -> Outcome:
    remedy = "Install the same release of probe-bridge on both computers."
    return failed(HELLO, "wrong version", text, remedy)
