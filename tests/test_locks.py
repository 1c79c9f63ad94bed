"""What is installed is what was locked: entries have hashes, and a wrong one stops it."""

from __future__ import annotations

import base64
import hashlib
import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
LOCKS = sorted(ROOT.glob("requirements*.lock"))
ENTRY = re.compile(
    r"[a-z0-9-]+==[0-9][0-9a-z.+]*( ; [^\n]+?)?( \\\n    --hash=sha256:[0-9a-f]{64})+\n"
)


@pytest.mark.parametrize("lock", LOCKS, ids=lambda path: path.name)
def test_every_line_of_a_lock_is_pinned_and_hashed(lock):
    entries = re.sub(r"^#.*\n", "", lock.read_text("utf-8"), flags=re.MULTILINE)
    assert ENTRY.sub("", entries) == ""


def test_scripts_install_from_an_index_by_lock_alone():
    """But for our own two packages, which come from this folder."""
    scripts = [path for path in (ROOT / "scripts").iterdir() if path.is_file()]
    words = {path.name: path.read_text("utf-8") for path in scripts}
    by_pip = sorted(name for name, text in words.items() if "-m pip" in text and "install" in text)
    assert by_pip == ["add-torch", "install-locked", "lock", "make-venv"]
    assert all("--require-hashes --only-binary :all:" in words[name] for name in by_pip[1:3])
    assert words["add-torch"].count("-m pip") == words["add-torch"].count(
        "install --quiet --dry-run"
    )
    (own,) = re.findall(r"-m pip [^\n]*\\\n +install [^\n]*", words["make-venv"])
    assert own.endswith(
        "install --quiet --no-deps --no-build-isolation --editable . --editable ./bridge"
    )


def test_both_builds_of_torch_are_of_one_version():
    cpu, card = (
        re.search(r"^torch==([0-9.]+)", (ROOT / name).read_text("utf-8"), re.MULTILINE)
        for name in ("requirements-torch-cpu.lock", "requirements-cuda.lock")
    )
    assert cpu and card and cpu[1] == card[1]


def test_what_is_installed_side_by_side_has_no_package_in_common():
    told = (ROOT / ".ci" / "run").read_text("utf-8")
    together = re.search(r"^make -j2 [^\n]*( \.venv/\.\w+){2,}$", told, re.MULTILINE)
    assert together
    names: list[str] = []
    for extra in re.findall(r"\.venv/\.(\w+)", together[0]):
        locks = [f"{extra}", f"{extra}-cpu"] if extra == "torch" else [extra]
        for lock in locks:
            text = (ROOT / f"requirements-{lock}.lock").read_text("utf-8")
            names += re.findall(r"^([a-z0-9-]+)==", text, re.MULTILINE)
    assert len(names) > 20 and len(set(names)) == len(names)


@pytest.fixture
def wheelhouse(tmp_path):
    """A wheel of a package that installs one file, and its hash."""
    path = tmp_path / "wheels" / "probe_lock_try-1.0-py3-none-any.whl"
    path.parent.mkdir()
    info = "probe_lock_try-1.0.dist-info"
    files = {
        "probe_lock_try.py": b"",
        f"{info}/METADATA": b"Metadata-Version: 2.1\nName: probe-lock-try\nVersion: 1.0\n",
        f"{info}/WHEEL": b"Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }

    def row(name, content):
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        return f"{name},sha256={digest},{len(content)}\n"

    record = "".join(row(*each) for each in files.items()) + f"{info}/RECORD,,\n"
    with zipfile.ZipFile(path, "w") as archive:
        for name, content in (*files.items(), (f"{info}/RECORD", record.encode())):
            archive.writestr(name, content)
    return path.parent, hashlib.sha256(path.read_bytes()).hexdigest()


@pytest.fixture
def install(tmp_path, wheelhouse):
    """Runs scripts/install-locked with a lock of the wheel with this hash, without a network."""
    python = Path(sys.base_prefix) / "bin" / "python3"
    (tmp_path / "scripts").mkdir()
    shutil.copy(ROOT / "scripts" / "install-locked", tmp_path / "scripts")
    subprocess.run([python, "-m", "venv", "--without-pip", tmp_path / ".venv"], check=True)
    settings = {"PIP_CONFIG_FILE": os.devnull, "PIP_NO_INDEX": "1"}
    settings |= {"PIP_FIND_LINKS": str(wheelhouse[0]), "PYTHON": str(python)}
    clean = {name: value for name, value in os.environ.items() if not name.startswith("PIP_")}

    def run(options):
        (tmp_path / "try.lock").write_text(f"probe-lock-try==1.0 {options}\n")
        return subprocess.run(
            [tmp_path / "scripts" / "install-locked", "try.lock"],
            env=clean | settings,
            capture_output=True,
            text=True,
        )

    return run


def installed(folder):
    return list((folder / ".venv").rglob("probe_lock_try.py"))


def test_a_tampered_hash_stops_the_install_in_words(tmp_path, wheelhouse, install):
    _, digest = wheelhouse
    wrong = digest[:-1] + ("0" if digest[-1] != "0" else "1")
    refused = install(f"--hash=sha256:{wrong}")
    assert refused.returncode == 1 and installed(tmp_path) == []
    assert "HASHES" in refused.stderr
    assert "It is for Python 3.11 to 3.14 on Linux x86_64; this is Python 3." in refused.stderr
    assert "don't install it" in refused.stderr and "docs/get-started/install.md" in refused.stderr
    assert install("").returncode == 1 and installed(tmp_path) == []
    assert install(f"--hash=sha256:{digest}").returncode == 0
    assert len(installed(tmp_path)) == 1


@pytest.mark.parametrize(("forbidden", "called"), [("", True), ("1", False)])
def test_root_installs_packages_of_the_system_unless_told_not_to(tmp_path, forbidden, called):
    for name, does in (("id", "echo 0"), ("apt-get", f'echo "$@" >> {tmp_path}/called')):
        (tmp_path / name).write_text(f"#!/bin/sh\n{does}\n")
        (tmp_path / name).chmod(0o755)
    bash = shutil.which("bash")
    assert bash
    done = subprocess.run(
        [bash, ROOT / "scripts" / "ensure-browser"],
        env={"PATH": str(tmp_path), "PROBE_NO_APT": forbidden},
        capture_output=True,
        text=True,
        check=True,
    )
    assert (tmp_path / "called").exists() == called
    assert "tests of the report in a browser are skipped" in done.stdout
