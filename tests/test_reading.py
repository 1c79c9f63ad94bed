"""What isn't a file of a sensible size is refused before anything is done with it."""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
from pathlib import Path

import numpy as np
import OpenEXR
import pydantic
import pytest
from PIL import Image

from probe.assets.environments.hdr_file import read_panorama
from probe.assets.tables import load_table
from probe.bench.prices import read_prices
from probe.episodes.conventions import CONVENTIONS, read_conventions
from probe.episodes.files import read_records
from probe.episodes.folder import SETTING, setting_of_folder
from probe.episodes.ordered import ORDERED, read_ordered
from probe.episodes.remarks import REMARKS, read_remarks
from probe.errors import BadData
from probe.files import read_document
from probe.reading import DOCUMENT, VALUES, contents, json_contents
from probe.runs.variation import VARIATION, read_variation
from probe.scores.row_files import read_csv, read_json_lines
from probe.tasks.suite_file import demo_suite, read_suite, write_suite

GIB = 2**30


def pipe(path: Path) -> Path:
    os.mkfifo(path)
    return path


def folder(path: Path) -> Path:
    path.mkdir()
    return path


@pytest.mark.parametrize(
    "reader", [read_records, read_suite, read_prices, read_csv, read_json_lines, read_panorama]
)
@pytest.mark.parametrize(
    ("made", "words"),
    [
        (pipe, "is no regular file"),
        (folder, "is a folder, not a file"),
        (lambda path: Path("/dev/zero"), "is no regular file"),
    ],
)
def test_only_regular_files_are_read(tmp_path, reader, made, words):
    with pytest.raises(BadData, match=words):
        reader(made(tmp_path / "x"))


@pytest.mark.parametrize(
    ("name", "reader"),
    [
        (ORDERED, read_ordered),
        (CONVENTIONS, read_conventions),
        (VARIATION, read_variation),
        (SETTING, setting_of_folder),
        (REMARKS, read_remarks),
    ],
)
def test_a_link_to_nowhere_is_no_missing_file(tmp_path, name, reader):
    assert not reader(tmp_path)
    (tmp_path / name).symlink_to(tmp_path / "nowhere")
    with pytest.raises(BadData, match=rf"{name}.*(No such file|is a link to .*nowhere)"):
        reader(tmp_path)
    (tmp_path / name).unlink()
    (tmp_path / name).symlink_to(name)
    with pytest.raises(BadData, match=rf"{name}.*symbolic links"):
        reader(tmp_path)


def test_a_file_that_is_too_large_is_refused(tmp_path):
    path = tmp_path / "x"
    with path.open("wb") as file:
        file.truncate(DOCUMENT + 1)
    with pytest.raises(OSError, match="larger than the 64 MB"):
        contents(path)
    assert len(contents(path, DOCUMENT + 1)) == DOCUMENT + 1


def test_a_file_of_too_many_values_is_refused_before_it_is_parsed(tmp_path):
    path = tmp_path / "x"
    path.write_bytes(b"[" + b"0," * VALUES + b"0]")
    with pytest.raises(OSError, match=r"holds about 50,000,001 values, and at most 50,000,000"):
        json_contents(path, 2 * VALUES + 10)


class Anything(pydantic.RootModel[list[int]]):
    pass


def test_documents_that_are_nested_without_end_are_refused(tmp_path):
    path = tmp_path / "x.json"
    path.write_text("[" * 1_000_000)
    with pytest.raises(BadData, match="x.json"):
        read_document(path, Anything, "Write it again")


def test_an_order_of_a_thousand_million_runs_is_refused(tmp_path):
    order = {"ordered": [{"agent": "x", "arm": "", "runs": 1_000_000_000}]}
    (tmp_path / ORDERED).write_text(json.dumps(order))
    with pytest.raises(BadData, match=r"runs: Input should be less than or equal to 1000"):
        read_ordered(tmp_path)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[" * 20_000, "is nested too deep"),
        ("a: " + "{b: " * 20_000, "is nested too deep"),
        ("m: &a [1]\nn: &b [*a, *a]\no: [*b, *b]", "m: Input should be"),
        ("x" * 300_000, "larger than the 0 MB"),
        ("a: 2001-99-99", "month must be in"),
        ("\0", "special characters are not allowed"),
    ],
)
def test_prices_that_are_no_prices(tmp_path, text, words):
    path = tmp_path / "prices.yaml"
    path.write_text(text)
    with pytest.raises(BadData, match=words):
        read_prices(path)


def run_with(memory: int, code: str, *words: object) -> subprocess.CompletedProcess[str]:
    """Python code in a process that gets so many bytes of memory."""
    return subprocess.run(
        [sys.executable, "-c", code, *map(str, words)],
        capture_output=True,
        text=True,
        timeout=300,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (memory, memory)),
    )


READ = "import sys; from pathlib import Path; from probe.tasks.suite_file import read_suite\n"


@pytest.mark.slow
def test_five_million_empty_tasks_are_refused_in_little_memory(tmp_path):
    path = tmp_path / "suite.json"
    head = '{"version": 3, "name": "x", "objects": {}, "manifest": {}, "tasks": ['
    path.write_text(head + "{}," * 4_999_999 + "{}]}")
    ended = run_with(3 * GIB, READ + "read_suite(Path(sys.argv[1]))", path)
    assert "BadData" in ended.stderr and "tasks.0.id: Field required" in ended.stderr


@pytest.mark.slow
def test_a_suite_of_twenty_thousand_tasks_is_read(tmp_path):
    from dataclasses import replace

    demo = demo_suite()
    tasks = [replace(demo.tasks[n % 6], id=f"count-{n:08x}") for n in range(20_000)]
    write_suite(tmp_path / "suite.json", replace(demo, tasks=tuple(tasks)))
    read = "print(len(read_suite(Path(sys.argv[1])).tasks))"
    ended = run_with(8 * GIB, READ + read, tmp_path / "suite.json")
    assert ended.stdout == "20000\n", ended.stderr


def test_an_exr_that_claims_to_be_enormous_is_refused_by_its_header(tmp_path):
    path = tmp_path / "sky.exr"
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    with OpenEXR.File(header, {"RGB": np.ones((2, 4, 3), np.float32)}) as file:
        file.write(str(path))
    assert read_panorama(path).shape == (2, 4, 3)
    low_and_high = np.array([0, 0, 3, 1], "<i4").tobytes()
    far = np.array([0, 0, 2**30, 2**30], "<i4").tobytes()
    content = path.read_bytes()
    assert content.count(low_and_high) == 2  # data and display windows
    path.write_bytes(content.replace(low_and_high, far))
    with pytest.raises(BadData, match=r"1073741825 x 1073741825|can't be read as OpenEXR"):
        read_panorama(path)


def test_a_table_top_that_would_fill_the_memory_is_refused(tmp_path):
    home = tmp_path / "textures" / "Wood999_1K"
    home.mkdir(parents=True)
    Image.new("1", (30_000, 30_000)).save(home / "Wood999_1K_Color.png")
    with pytest.raises(BadData, match=r"Wood999_1K_Color.png"):
        load_table("Wood999", tmp_path)
