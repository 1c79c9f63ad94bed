"""The command probe-bridge."""

from __future__ import annotations

import argparse
import asyncio
import os
import signal
import ssl
import sys
from pathlib import Path
from typing import List, Optional

from probe_bridge.checks.screen import check_robot
from probe_bridge.command_log import NOWHERE, CommandLog
from probe_bridge.config_file import load_config
from probe_bridge.drivers import DRIVERS, open_driver
from probe_bridge.errors import BridgeError
from probe_bridge.robot import Robot
from probe_bridge.server import LOOPBACK, PORT, Address, listen

TOKEN = "PROBE_BRIDGE_TOKEN"
_SHORTEST = 20


def main(arguments: Optional[List[str]] = None) -> int:
    """Run the command; returns its exit status."""
    options = _parser().parse_args(arguments)
    if options.do == "check":
        return _check(options)
    return _serve_until_ended(options)


def _serve_until_ended(options: argparse.Namespace) -> int:
    try:
        token = _token(options.token_file)
        tls = _tls(options.tls_certificate, options.tls_key)
        config = load_config(options.config)
        log = CommandLog(options.log)
        robot = Robot(open_driver(options.driver, config), config)
    except BridgeError as error:
        print(f"probe-bridge: {error}", file=sys.stderr)
        return 1
    try:
        asyncio.run(_serve(robot, token, Address(options.host, options.port, tls), log))
    except OSError as error:
        print(f"probe-bridge: can't listen: {error}", file=sys.stderr)
        return 1
    finally:
        robot.close()  # a robot that can't be stopped has its traceback, and its line in the log
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser("probe-bridge", description="Let PROBE use this robot.")
    commands = parser.add_subparsers(required=True, dest="do")
    serve = commands.add_parser("serve", help="let clients use this computer's robot")
    serve.add_argument("--driver", required=True, choices=sorted(DRIVERS))
    serve.add_argument("--config", required=True, type=Path, help="the robot's file, JSON")
    serve.add_argument("--token-file", type=Path, help=f"or the variable {TOKEN}")
    serve.add_argument("--host", default=LOOPBACK, help="address to listen on (%(default)s)")
    serve.add_argument("--port", default=PORT, type=int, help="0 for any free one (%(default)s)")
    serve.add_argument("--tls-certificate", type=Path, help="PEM file; with --tls-key")
    serve.add_argument("--tls-key", type=Path, help="PEM file")
    serve.add_argument("--log", type=Path, default=NOWHERE, help="append all commands to this file")
    check = commands.add_parser("check", help="check a robot over its bridge")
    check.add_argument("address", help="ws://HOST:PORT or wss://HOST:PORT")
    check.add_argument("--token-file", type=Path, help=f"or the variable {TOKEN}")
    check.add_argument("--certificate", type=Path, help="of the bridge, PEM file")
    check.add_argument("--out", type=Path, help="file to write the outcomes to, JSON")
    return parser


def _check(options: argparse.Namespace) -> int:
    try:
        token = _token(options.token_file)
    except BridgeError as error:
        print(f"probe-bridge: {error}", file=sys.stderr)
        return 1
    return check_robot(options.address, token, options.certificate, options.out)


async def _serve(robot: Robot, token: str, address: Address, log: CommandLog) -> None:
    """Serve until a signal asks to end. The robot stops before anything else is closed."""
    ended = asyncio.Event()

    def end() -> None:
        ended.set()
        robot.halt("stopped", "The bridge is closing.")

    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        asyncio.get_running_loop().add_signal_handler(number, end)
    server = await listen(robot, token, address, log)
    host, port = server.sockets[0].getsockname()[:2]
    scheme = "wss" if address.tls else "ws"
    print(f"{robot.config.name} is served at {scheme}://{host}:{port}", flush=True)
    if not address.tls and host != LOOPBACK:
        print("Without TLS, others on this network can read the token.", file=sys.stderr)
    await ended.wait()
    server.close()
    await server.wait_closed()


def _token(path: Optional[Path]) -> str:
    try:
        text = path.read_text(encoding="ascii") if path else os.environ.get(TOKEN, "")
    except (OSError, ValueError) as error:
        raise BridgeError("refused", f"The token's file can't be read: {error}.") from error
    token = text.strip()
    if len(token) < _SHORTEST or not token.isascii() or not token.isprintable():
        raise BridgeError(
            "refused",
            f"The token has not the {_SHORTEST} printable characters that it needs.",
            'Make one: python3 -c "import secrets; print(secrets.token_urlsafe(32))" > token',
        )
    return token


def _tls(certificate: Optional[Path], key: Optional[Path]) -> Optional[ssl.SSLContext]:
    if certificate is None and key is None:
        return None
    if certificate is None or key is None:
        raise BridgeError("refused", "TLS needs both --tls-certificate and --tls-key.")
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    try:
        context.load_cert_chain(certificate, key)
    except (OSError, ssl.SSLError) as error:
        raise BridgeError("refused", f"The certificate can't be read: {error}.") from error
    return context
