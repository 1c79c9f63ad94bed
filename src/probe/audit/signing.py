"""Signs a manifest and checks whose signature it bears, with OpenSSH's own tool and keys."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

from probe.audit.manifest import MANIFEST, SIGNATURE
from probe.errors import BadData, ProbeError

NAMESPACE = "probe-audit"
"""What a signature is for, so that none of another kind passes for one."""

_SIGNER = "signer"


class NoSshKeygen(ProbeError):
    """OpenSSH's tool isn't here."""

    def __init__(self) -> None:
        super().__init__(
            "Signing and checking signatures needs ssh-keygen (OpenSSH 8.2 or newer). "
            "Install openssh-client."
        )


def sign(out: Path, key: Path) -> None:
    """Sign a folder's manifest; ssh-keygen asks for a passphrase if the key has one.

    Args:
        out: The folder; its manifest has been written.
        key: A private key, or a public one whose private part an agent holds.

    Raises:
        NoSshKeygen: It isn't installed.
        BadData: It can't sign with this key.
    """
    (out / SIGNATURE).unlink(missing_ok=True)
    done = _run(["sign", "-f", str(key), "-n", NAMESPACE, str(out / MANIFEST)])
    if done.returncode:
        raise BadData(key, f"can't sign: {_said(done)}", "Name an SSH key, as `ssh-keygen` makes")


def verify(out: Path, keys: Path) -> str:
    """Check that one of some keys has signed a folder's manifest; returns ssh-keygen's words.

    Args:
        out: The folder.
        keys: Public keys, one a line, as in `id_ed25519.pub` or https://github.com/NAME.keys.

    Raises:
        NoSshKeygen: It isn't installed.
        BadData: None of them has signed it, or a file can't be read.
    """
    try:
        text = (out / MANIFEST).read_bytes()
        lines = [line.strip() for line in keys.read_text("utf-8").splitlines()]
    except (OSError, UnicodeDecodeError) as error:
        raise BadData(keys, str(error), "Check the path") from error
    if not (out / SIGNATURE).exists():
        raise BadData(out / SIGNATURE, "there is no signature", "Ask for a signed folder")
    with tempfile.NamedTemporaryFile("w", suffix=".signers") as signers:
        bare = (line for line in lines if line and not line.startswith("#"))
        signers.write("".join(f"{_SIGNER} {line}\n" for line in bare))
        signers.flush()
        who = ["-f", signers.name, "-I", _SIGNER, "-n", NAMESPACE]
        done = _run(["verify", *who, "-s", str(out / SIGNATURE)], text)
    if done.returncode:
        reason = f"isn't a signature of {MANIFEST} by a key of {keys}: {_said(done)}"
        raise BadData(out / SIGNATURE, reason, "Ask who signed it for their public key")
    return done.stdout.decode("utf-8", "replace").strip()


def _run(arguments: list[str], text: bytes | None = None) -> subprocess.CompletedProcess[bytes]:
    try:
        command = ["ssh-keygen", "-Y", *arguments]
        return subprocess.run(command, input=text, capture_output=True, check=False)
    except FileNotFoundError as error:
        raise NoSshKeygen from error


def _said(done: subprocess.CompletedProcess[bytes]) -> str:
    return " ".join((done.stderr or done.stdout).decode("utf-8", "replace").split())
