"""`probe serve` from outside, short of an episode: what it refuses, and how it starts."""

import os
import subprocess
import sys
from dataclasses import replace

import pytest

from probe.episodes.folder import claim_setting, start_folder
from probe.tasks.suite_file import demo_suite, write_suite
from run_folders import DEMO, episode, write_run

WITHOUT_EXTRA = "import sys; sys.modules['fastmcp'] = None; from probe.cli import main; main()"


def python(*arguments, **environment):
    return subprocess.run(
        [sys.executable, *map(str, arguments)],
        env={**os.environ, "PROBE_ASSETS": "", **environment},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture
def other(tmp_path):
    """A folder of records about another suite."""
    write_suite(tmp_path / "other" / "suite.json", replace(demo_suite(), name="other"))
    return tmp_path / "other"


@pytest.fixture
def filaments(tmp_path):
    """A folder with a record of a table that was drawn as it was frozen."""
    return write_run(tmp_path / "filaments", [episode(DEMO.tasks[0])], pictures=False)


@pytest.fixture
def people(tmp_path):
    """A folder that people answer in."""
    start_folder(tmp_path / "people", demo_suite())
    claim_setting(tmp_path / "people", "human")
    return tmp_path / "people"


@pytest.mark.parametrize(
    ("arguments", "environment", "words"),
    [
        (["--task", "beneath-0"], {}, "There is no task called 'beneath-0'. Did you mean beneath-"),
        (["--suite", "/nowhere.json"], {}, "/nowhere.json"),
        (["--suite", "v1", "--task", "demo-1"], {}, "There is no task called 'demo-1'"),
        (["--out", "/proc/nowhere"], {}, "/proc/nowhere"),
        (["--out", "OTHER"], {}, "is another suite. Choose another folder"),
        (["--out", "FILAMENTS", "--renderer", "blender"], {}, "was run under other conditions"),
        (["--out", "PEOPLE"], {}, "is kept for records of the setting human. Choose another"),
        ([], {"VK_ICD_FILENAMES": "/nowhere", "VK_DRIVER_FILES": "/nowhere"}, "mesa-vulkan"),
    ],
    ids=[
        "no such task",
        "no suite",
        "no such task of v1",
        "unwritable",
        "another suite's folder",
        "another renderer's folder",
        "people's folder",
        "no driver",
    ],
)
def test_failures_are_one_line_with_a_remedy(
    tmp_path, other, filaments, people, arguments, environment, words
):
    folders = {"OTHER": str(other), "FILAMENTS": str(filaments), "PEOPLE": str(people)}
    told = [folders.get(word, word) for word in arguments]
    out = [] if "--out" in told else ["--out", tmp_path / "out"]
    result = python("-m", "probe", "serve", *told, *out, **environment)
    assert result.returncode == 1 and result.stdout == ""
    assert words in result.stderr and len(result.stderr.strip().splitlines()) == 1
    assert not (tmp_path / "out").exists()


def test_without_the_extra_it_says_what_to_install(tmp_path):
    result = python("-c", WITHOUT_EXTRA, "serve", "--out", tmp_path / "out")
    assert result.returncode == 1
    assert "install -e '.[serve]'" in result.stderr
    assert not (tmp_path / "out").exists()


def test_nothing_else_waits_for_fastmcp():
    told = "import sys, probe.cli; print({'fastmcp', 'mcp', 'mcp_types'} & set(sys.modules))"
    assert python("-c", told).stdout == "set()\n"


@pytest.mark.slow
def test_objects_that_have_changed_are_refused(tmp_path):
    suite = demo_suite()
    others = {id: (*numbers[:-1], 0.9) for id, numbers in suite.objects.items()}
    write_suite(tmp_path / "s.json", replace(suite, name="mine", objects=others))
    told = ("serve", "--suite", tmp_path / "s.json", "--out", tmp_path / "out")
    result = python("-m", "probe", *told)
    assert result.returncode == 1 and result.stdout == ""
    assert "has changed since" in result.stderr
    assert not (tmp_path / "out" / "records.jsonl").exists()
