"""The command as a process: what it prints, what it refuses, how it ends."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from bridges import EXAMPLES, TOKEN
from probe_bridge.client import RobotClient
from probe_bridge.command import main
from probe_bridge.errors import BridgeError

SERVE = ["serve", "--driver", "simulated", "--config", str(EXAMPLES / "simulated.json")]


def started(*options: str) -> subprocess.Popen[str]:
    """The command with the token in its environment, once it listens."""
    environment = {**os.environ, "PROBE_BRIDGE_TOKEN": TOKEN, "PYTHONUNBUFFERED": "1"}
    environment["PYTHONPATH"] = os.pathsep.join(path for path in sys.path if path)
    command = [sys.executable, "-m", "probe_bridge", *SERVE, "--port", "0", *options]
    return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)


def address(process: subprocess.Popen[str]) -> str:
    assert process.stdout
    line = process.stdout.readline()
    assert "is served at" in line
    return line.split()[-1]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_it_serves_and_a_signal_stops_the_arm_first(number: signal.Signals):
    with started() as process:
        client = RobotClient(address(process), TOKEN)
        start = client.joints()
        link: Any = client._link
        motion = link.send(
            "follow", path=[list(start), [*start[:5], 3.0]], speed=1.0, seen=time.monotonic()
        )
        process.send_signal(number)
        assert motion.came(5)
        with pytest.raises(BridgeError) as error:
            _ = motion.result
        assert error.value.kind in ("stopped", "lost")
        client.close()
        assert process.wait(10) == 0


def test_tls_with_a_certificate_of_ones_own(tmp_path: Path):
    certificate, key = tmp_path / "bridge.pem", tmp_path / "bridge.key"
    subprocess.run(
        "openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN=robot"
        f" -addext subjectAltName=IP:127.0.0.1 -keyout {key} -out {certificate}".split(),
        check=True,
        capture_output=True,
    )
    with started("--tls-certificate", str(certificate), "--tls-key", str(key)) as process:
        url = address(process)
        assert url.startswith("wss://")
        client = RobotClient(url, TOKEN, certificate)
        assert client.joints()
        client.close()
        with pytest.raises(BridgeError, match="certificate"):
            RobotClient(url, TOKEN)
        process.terminate()
        assert process.wait(10) == 0


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"--config": "missing.json"}, "missing.json can't be read"),
        ({"--driver": "kinova_ros"}, "config.driver.prefix is missing"),
        ({"--tls-key": "key.pem"}, "--tls-certificate"),
        ({"--token-file": "no-such-file"}, "token's file can't be read"),
        ({}, "make one"),
    ],
)
def test_what_is_wrong_is_said_without_a_traceback(
    change: dict[str, str],
    says: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
):
    monkeypatch.setenv("PROBE_BRIDGE_TOKEN", TOKEN if change else "short")
    options = dict(zip(SERVE[1::2], SERVE[2::2]))
    options.update(change)
    flat = [word for pair in options.items() for word in pair]
    assert main(["serve", *flat]) == 1
    assert says.lower() in capsys.readouterr().err.lower()


def test_a_token_from_a_file(tmp_path: Path):
    file = tmp_path / "token"
    file.write_text("another-token-in-a-file\n")
    with started("--token-file", str(file)) as process:
        url = address(process)
        with pytest.raises(BridgeError):
            RobotClient(url, TOKEN)
        RobotClient(url, "another-token-in-a-file").close()
        process.terminate()
        assert process.wait(10) == 0
