"""Whatever an agent does in its process ends its episode in words, and nothing else."""

import os
import signal
import subprocess
import sys
import time

import psutil
import pytest

from probe.agents.external.sandbox import Sandbox
from probe.episodes.turns import Question

QUESTION = Question("What is under the mug?", (("A", "a die"), ("B", "a key")))

ACT = """
import gc, os, signal, socket, sys, time, ctypes

def wire():
    return next(each for each in gc.get_objects() if isinstance(each, socket.socket))

class Bad:
    def act(self, question, history):
        {line}
"""


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("raise ValueError('no idea')", "act() raised ValueError: no idea"),
        ("raise ValueError('\\x1b[2J\\ud800' + 9999 * 'x')", "ValueError: \ufffd[2J?xxx"),
        ("sys.exit(0)", "act() raised SystemExit: 0"),
        ("raise KeyboardInterrupt", "act() raised KeyboardInterrupt"),
        ("return 'A'", "act() gave a str, neither a Call nor None"),
        ("return Call('push', {'a': 1})", "TypeError: a Call holds a dict where text is wanted"),
        ("return Call('push', 'x' * 20001)", "a Call holds more than 20000 characters"),
        ("return self.act(question, history)", "act() raised RecursionError"),
        ("os._exit(3)", "ended its process with status 3"),
        ("ctypes.string_at(0)", "was killed by signal 11 (SIGSEGV)"),
        ("os.kill(os.getpid(), signal.SIGKILL)", "was killed by signal 9 (SIGKILL)"),
        ("os.abort()", "was killed by signal 6 (SIGABRT)"),
        ("wire().send(b'nonsense\\n'); time.sleep(60)", "(all of it: Invalid JSON"),
        ("wire().send(b'{\"call\": {\"name\": 1}}\\n')", "sent what is no reply (call.name: "),
        ("wire().send(b'[' * 90000 + b'\\n')", "sent what is no reply"),
        ("wire().send(b'\\x80\\n')", "sent what is no reply"),
        ("wire().send(b'{\"reply\": 1}\\n')", "sent what is no reply (reply: "),
        ("wire().sendall(b'x' * 10_000_000)", "sent more than 360000 bytes at once"),
        ("wire().close(); time.sleep(60)", "hung up"),
        ("return len(' ' * 10 ** 10)", "act() raised MemoryError"),
    ],
)  # fmt: skip
def test_what_is_the_agents_doing_is_told_in_words(outsider, line, words):
    agent = outsider(ACT.format(line=line))
    assert agent.act(QUESTION, ()) is None
    assert words in agent.fault
    assert len(agent.fault) <= 1000 and agent.fault.isprintable()


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("time.sleep(60)", "gave no reply within 1 s"),
        ("while True: pass", "gave no reply within 1 s"),
        ("wire().send(b'{\"call\": nu'); time.sleep(60)", "gave no reply within 1 s"),
        ("[signal.signal(n, signal.SIG_IGN) for n in (1, 2, 15)]; time.sleep(60)", "gave no reply"),
        ("time.sleep(60) if os.fork() else time.sleep(60)", "gave no reply within 1 s"),
    ],
)
def test_one_that_hangs_is_ended(outsider, line, words):
    agent = outsider(ACT.format(line=line), sandbox=Sandbox(seconds=1))
    assert agent.act(QUESTION, ()) is None
    assert words in agent.fault
    begun, process = time.monotonic(), psutil.Process(agent._process.pid)
    mine = [process, *process.children(recursive=True)]
    assert len(mine) > 1
    agent.close()
    assert time.monotonic() - begun < 4
    assert not any(each.is_running() for each in mine)


def test_a_flood_of_prints_is_cut_and_breaks_nothing(outsider, tmp_path):
    code = ACT.format(line="os.write(1, b'x' * 50_000_000); return Call.of('push')")
    agent = outsider(code)
    assert agent.act(QUESTION, ()).name == "push"
    agent.close()
    assert (tmp_path / "agent.log").stat().st_size < 70_000


def test_what_it_started_ends_with_it(outsider):
    """Even if that left its group and session."""
    line = "pid = os.fork() or (os.setsid(), os.fork(), time.sleep(99)); return Call.of('push')"
    agent = outsider(ACT.format(line=line))
    assert agent.act(QUESTION, ()) is not None
    started = psutil.Process(agent._process.pid).children(recursive=True)
    deadline = time.monotonic() + 5
    while len(started) < 4 and time.monotonic() < deadline:
        started = psutil.Process(agent._process.pid).children(recursive=True)
    assert len(started) >= 4
    agent.close()
    assert not any(each.is_running() for each in started)


WITHOUT_NAMESPACES = """
import os, sys, time
from probe.agents.external import supervisor
supervisor._unshare = lambda flags: False
out = int(sys.argv[1])
assert supervisor.guard(False) is False
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        os.write(out, f"{os.getpid()} ".encode())
        time.sleep(99)
    os.write(out, f"{os.getpid()} ".encode())
    time.sleep(99)
time.sleep(0.5)
os._exit(7)
"""


def test_what_it_started_ends_where_there_are_no_namespaces():
    reading, writing = os.pipe()
    process = subprocess.Popen(
        [sys.executable, "-c", WITHOUT_NAMESPACES, str(writing)], pass_fds=[writing]
    )
    os.close(writing)
    assert process.wait(20) == 7
    with os.fdopen(reading) as pipe:
        # To the end of it: whoever still lived would keep it open.
        started = [int(pid) for pid in pipe.read().split()]
    assert len(started) == 2
    assert not any(psutil.pid_exists(pid) for pid in started)


def test_its_process_ends_when_ours_is_killed(write):
    path = write(ACT.format(line="signal.signal(15, signal.SIG_IGN); time.sleep(99)"))
    code = f"""
import threading
from pathlib import Path
from probe.agents.external.factory import FileAgentFactory
from probe.agents.external.external_agent import ExternalAgent
from probe.agents.external.sandbox import AgentFile
from probe.episodes.turns import Question
agent = ExternalAgent(FileAgentFactory(AgentFile(Path({str(path)!r}))), "t", 0)
def tell():
    while agent._process is None or not hasattr(agent._process, "ready"): pass
    print(agent._process.pid, flush=True)
threading.Thread(target=tell, daemon=True).start()
agent.act(Question("?", ()), ())
"""
    ours = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert ours.stdout is not None
    guard = psutil.Process(int(ours.stdout.readline()))
    theirs = [guard, *guard.children(recursive=True)]
    ours.send_signal(signal.SIGKILL)
    ours.wait()
    ours.stdout.close()
    assert psutil.wait_procs(theirs, timeout=5)[1] == []
