"""Manifests and signatures, made and checked for real by ssh-keygen and sha256sum."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from forgeries import honest, write_folder
from probe.audit.manifest import MANIFEST, SIGNATURE, check_manifest, write_manifest
from probe.audit.signing import NoSshKeygen, sign, verify
from probe.errors import BadData


def new_key(path: Path, question_type: str = "ed25519") -> Path:
    command = ["ssh-keygen", "-q", "-t", question_type, "-N", "", "-C", "anna", "-f", str(path)]
    subprocess.run(command, check=True)
    return path


@pytest.fixture
def key(tmp_path: Path) -> Path:
    return new_key(tmp_path / "key")


@pytest.fixture
def out(tmp_path: Path, key: Path) -> Path:
    """A signed folder with a file in a folder of its own."""
    out = write_folder(tmp_path / "run", honest())
    (out / "pictures").mkdir()
    (out / "pictures" / "a b.jpg").write_bytes(b"\xff\xd8")
    assert write_manifest(out) == 4
    sign(out, key)
    return out


def public(key: Path) -> Path:
    return key.with_suffix(".pub")


def test_what_was_signed_is_verified_by_us_and_by_others(out, key):
    assert "Good" in verify(out, public(key)) and check_manifest(out) == 4
    subprocess.run(["sha256sum", "-c", "--strict", "--quiet", MANIFEST], cwd=out, check=True)
    signers = key.with_suffix(".signers")
    signers.write_text(f"anna {public(key).read_text()}")
    command = ["ssh-keygen", "-Y", "verify", "-n", "probe-audit", "-I", "anna"]
    command += ["-f", str(signers), "-s", str(out / SIGNATURE)]
    subprocess.run(command, input=(out / MANIFEST).read_bytes(), check=True)


def test_a_key_may_stand_among_others_without_a_comment(out, key, tmp_path):
    """As GitHub lists a user's keys."""
    others = [public(new_key(tmp_path / name)) for name in ("one", "two")]
    bare = [" ".join(path.read_text().split()[:2]) for path in (*others, public(key))]
    keys = tmp_path / "anna.keys"
    keys.write_text("\n".join(bare) + "\n")
    assert "Good" in verify(out, keys)


@pytest.mark.parametrize(
    "name", ["records.jsonl", "suite.json", "ordered.json", "pictures/a b.jpg"]
)
def test_a_changed_byte_of_any_file_is_found(out, name):
    content = bytearray((out / name).read_bytes())
    content[len(content) // 2] ^= 1
    (out / name).write_bytes(content)
    with pytest.raises(BadData, match=f"{name}: has changed since SHA256SUMS was written"):
        check_manifest(out)


def test_a_file_more_and_a_file_less_are_found(out):
    (out / "more.txt").write_text("")
    with pytest.raises(BadData, match=r"more\.txt: isn't in SHA256SUMS"):
        check_manifest(out)
    (out / "more.txt").unlink()
    (out / "ordered.json").unlink()
    with pytest.raises(BadData, match=r"ordered\.json: is in SHA256SUMS and missing here"):
        check_manifest(out)


def test_a_changed_manifest_is_not_what_was_signed(out, key):
    (out / "ordered.json").write_text("{}")
    write_manifest(out)
    assert check_manifest(out) == 4
    with pytest.raises(BadData, match="isn't a signature of SHA256SUMS by a key of"):
        verify(out, public(key))


def test_another_persons_key_is_not_the_signers(out, tmp_path):
    other = public(new_key(tmp_path / "other"))
    with pytest.raises(BadData, match=r"other\.pub.*Ask who signed it"):
        verify(out, other)


def test_a_signature_for_something_else_does_not_count(out, key):
    (out / SIGNATURE).unlink()
    command = ["ssh-keygen", "-Y", "sign", "-n", "git", "-f", str(key), str(out / MANIFEST)]
    subprocess.run(command, check=True, capture_output=True)
    with pytest.raises(BadData, match="isn't a signature"):
        verify(out, public(key))


def test_what_cannot_sign_is_told(out, key, tmp_path):
    (tmp_path / "no.key").write_text("nothing")
    for bad in (tmp_path / "no.key", tmp_path / "nowhere"):
        with pytest.raises(BadData, match="can't sign: .*Name an SSH key"):
            sign(out, bad)
        assert not (out / SIGNATURE).exists()
    with pytest.raises(BadData, match="there is no signature"):
        verify(out, public(key))
    with pytest.raises(BadData, match="nowhere"):
        verify(out, tmp_path / "nowhere")


def test_without_ssh_keygen_the_remedy_is_named(out, key, monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(NoSshKeygen, match="Install openssh-client"):
        sign(out, key)


def test_a_broken_manifest_and_odd_files_are_refused(out):
    (out / MANIFEST).write_text("0000  records.jsonl\n")
    with pytest.raises(BadData, match="SHA256SUMS, line 1: is no hash of a file"):
        check_manifest(out)
    (out / "link").symlink_to("/etc/passwd")
    with pytest.raises(BadData, match="link: is no plain file"):
        write_manifest(out)
