"""What docs/reference/agents.md says an agent can't get at, tried from within."""

import os
import socket
from dataclasses import replace

import pytest

from probe.agents.external import landlock
from probe.agents.external.factory import introduced
from probe.agents.external.readable_paths import ANSWERS, reach
from probe.agents.external.sandbox import Sandbox
from probe.episodes.grading import question_of
from probe.tasks.suite_file import demo_suite

TASK = replace(demo_suite().tasks[0], id="beneath-5ec2e7", seed=918_273_645)
QUESTION = question_of(TASK)

needs_landlock = pytest.mark.skipif(not landlock.version(), reason="no Landlock in this kernel")

WALKS = """
import gc, sys, types

def reachable():
    gc.collect()
    frames = [frame for frame in sys._current_frames().values()]
    for frame in list(frames):
        while frame.f_back is not None:
            frame = frame.f_back
            frames.append(frame)
    # What gc doesn't track (texts, numbers) is told by what refers to it.
    todo = [*gc.get_objects(), *frames, *(f.f_locals for f in frames), *sys.modules.values()]
    seen = {}
    while todo:
        thing = todo.pop()
        if id(thing) not in seen:
            seen[id(thing)] = thing
            todo += gc.get_referents(thing)
            if isinstance(thing, types.CodeType):
                todo += thing.co_consts
    return list(seen.values())

class Walks:
    def act(self, question, history):
        found = reachable()
        own = {f"{type(it).__module__}.{type(it).__name__}" for it in found}
        return Call.of("push", {
            "count": len(found),
            "types": sorted(name for name in own if name.startswith("probe.")),
            "modules": sorted(name for name in sys.modules if name.startswith("probe")),
            "id": any(isinstance(it, str) and "".join(["5ec2", "e7"]) in it for it in found),
            "seed": any(type(it) is int and it == int("".join(["918273", "645"])) for it in found),
            "question": any(isinstance(it, str) and it == question.text for it in found),
        })
"""


def test_a_walk_over_all_that_can_be_reached_finds_no_task(outsider):
    found = outsider(WALKS).act(QUESTION, ()).values
    assert found["count"] > 20_000 and found["question"]
    assert not found["id"]
    assert not found["seed"]
    hidden = ("probe.tasks", "probe.scene", "probe.generation", "probe.world", "probe.station")
    assert [name for name in found["types"] if name.startswith(hidden)] == []
    assert [name for name in found["modules"] if name.startswith(hidden)] == []
    assert "probe.episodes.turns.Question" in found["types"]


TRIES = """
import os, socket

def tried(do):
    try:
        return do()
    except Exception as error:
        return type(error).__name__

class Tries:
    def act(self, question, history):
        return Call.of("push", {"tried": [tried(do) for do in [ATTEMPTS]]})
"""


def tried(outsider, *attempts, **settings):
    code = TRIES.replace("ATTEMPTS", ", ".join(f"lambda: {attempt}" for attempt in attempts))
    return outsider(code, **settings).act(QUESTION, ()).values["tried"]


def test_its_environment_says_nothing_of_ours(outsider, monkeypatch):
    monkeypatch.setenv("PROBE_SALT", "s3cret-salt")
    monkeypatch.setenv("OPENAI_API_KEY", "s3cret-key")
    names, raw = tried(outsider, "sorted(os.environ)", "open('/proc/self/environ').read()")
    assert "s3cret" not in raw and "PROBE_" not in raw
    known = {
        "HOME", "LANG", "PATH", "PYTHONHASHSEED", "PYTHONPATH", "TMPDIR", "OMP_NUM_THREADS",
        # As `import probe` sets them: docs/decisions/0020.
        "OPENBLAS_CORETYPE", "NPY_DISABLE_CPU_FEATURES",
    }  # fmt: skip
    assert set(names) <= known


def test_nothing_that_we_have_open_is_open_there(outsider, tmp_path):
    ours = os.open(tmp_path / "ours", os.O_CREAT | os.O_RDWR)
    os.set_inheritable(ours, True)
    try:
        (links,) = tried(
            outsider,
            "[os.readlink(f'/proc/self/fd/{n}') for n in range(4096)"
            " if os.path.islink(f'/proc/self/fd/{n}')]",
        )
    finally:
        os.close(ours)
    question_types = sorted(link.split(":")[0] for link in links)
    assert question_types == ["/dev/null", "pipe", "pipe", "socket"]


@needs_landlock
def test_files_are_shut_but_what_python_needs(outsider, tmp_path):
    other = tmp_path / "records.jsonl"
    other.write_text("{}")
    paths = [
        ANSWERS / "v1.json",
        ANSWERS / "demo.json",
        other,
        "/etc/passwd",
        f"/proc/{os.getpid()}/environ",
    ]
    reads = [f"open({str(path)!r}).read()" for path in paths]
    assert tried(outsider, *reads, "open('/tmp/probe-left-behind', 'w')") == ["PermissionError"] * (
        len(paths) + 1
    )
    own, list_ = tried(outsider, "open('own', 'w').write('x')", "os.listdir('.')")
    assert (own, list_) == (1, ["own"])


@needs_landlock
def test_what_it_starts_is_shut_in_as_well(outsider):
    (said,) = tried(
        outsider,
        f"__import__('subprocess').run(['cat', {str(ANSWERS / 'demo.json')!r}],"
        " capture_output=True, text=True).stderr",
    )
    assert "Permission denied" in said


@needs_landlock
def test_other_processes_are_out_of_reach(outsider):
    ours = os.getpid()
    assert (
        tried(outsider, f"open('/proc/{ours}/mem', 'rb')", f"os.listdir('/proc/{ours}/fd')")
        == ["PermissionError"] * 2
    )
    (kill,) = tried(outsider, f"os.kill({ours}, 0)")
    assert kill in ("ProcessLookupError", "PermissionError") or landlock.version() < 6


def test_the_network_is_shut_unless_it_may(outsider):
    with socket.create_server(("127.0.0.1", 0)) as server:
        call = f"socket.create_connection({server.getsockname()!r}, 5).close()"
        (shut,) = tried(outsider, call)
        assert shut in ("PermissionError", "OSError", "ConnectionRefusedError")
        (may,) = tried(outsider, call, sandbox=Sandbox(network=True))
        assert may is None


def test_what_is_kept_from_it_is_said(invite):
    confined, _ = introduced(invite(TRIES))
    assert confined.files == bool(landlock.version())
    confined, _ = introduced(invite(TRIES, sandbox=Sandbox(network=True)))
    assert not confined.network


def test_suites_of_every_copy_that_python_would_import_are_hidden(tmp_path, monkeypatch):
    other = tmp_path / "lib" / "python3.11" / "site-packages"
    (other / "probe" / "tasks" / "data").mkdir(parents=True)
    (other / "numpy").mkdir()
    monkeypatch.setattr("sys.prefix", str(tmp_path))
    found = reach(tmp_path / "own.py", (), ())
    mine = {path for path in found.whole if path.startswith(str(tmp_path))}
    assert mine == {str(tmp_path / "own.py"), str(other / "numpy")}


def test_what_is_hidden_is_hidden_within_what_may_be_read(tmp_path):
    (tmp_path / "deep" / "deeper").mkdir(parents=True)
    for name in ("deep/suite.json", "deep/deeper/weights", "code.py"):
        (tmp_path / name).write_text("")
    found = reach(tmp_path / "own.py", (tmp_path,), (tmp_path / "deep" / "suite.json",))
    mine = {path for path in found.whole if path.startswith(str(tmp_path))}
    assert mine == {str(tmp_path / name) for name in ("own.py", "code.py", "deep/deeper")}
    assert str(tmp_path) in found.names and str(tmp_path) not in found.whole
    assert not any(str(ANSWERS).startswith(path) for path in found.whole)
