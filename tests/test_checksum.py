"""Every single bit of a record's line, and hundreds of a suite's, are noticed when they flip."""

from __future__ import annotations

import hashlib
import json
import random
from dataclasses import replace
from pathlib import Path

import pytest

from probe.checksum import has_sum, with_sum, without_sum
from probe.cli.checksum_notice import tell_unsummed
from probe.episodes.files import line_of, read_records, record_of
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.record import EpisodeRecord, Seconds
from probe.errors import BadData
from probe.files import read_document
from probe.tasks.suite import Suite
from probe.tasks.suite_file import SuiteDocument, read_suite, write_suite
from run_folders import DEMO, episode
from task_examples import FIND, SCENE

FLIPS = 800
"""Of the bits of a suite, chosen by chance."""


def flipped(content: bytes, bit: int) -> bytes:
    place, mask = bit // 8, 1 << bit % 8
    return content[:place] + bytes([content[place] ^ mask]) + content[place + 1 :]


@pytest.fixture
def record() -> EpisodeRecord:
    """A small one: of one call, on a table of three things."""
    whole = episode(FIND)
    return replace(whole, steps=whole.steps[:1], answer=None, end="stopped", seconds=Seconds())


@pytest.fixture
def old(tmp_path: Path) -> Path:
    """A folder that was written before there were checksums."""
    write_suite(tmp_path / SUITE, Suite("own", DEMO.tasks, DEMO.objects))
    for name, text in ((SUITE, (tmp_path / SUITE).read_bytes()), (RECORDS, b"")):
        bare = without_sum(text) + b"\n" if text else b""
        (tmp_path / name).write_bytes(bare)
    lines = [without_sum(line_of(episode(task))) + b"\n" for task in DEMO.tasks[:3]]
    (tmp_path / RECORDS).write_bytes(b"".join([*lines, line_of(episode(DEMO.tasks[3]))]))
    return tmp_path


def test_a_line_is_json_that_ends_with_the_hash_of_what_stands_before(record):
    line = line_of(record)
    fields = json.loads(line)
    assert list(fields)[-1] == "sum" and line.endswith(b"\n")
    body = line[: line.rindex(b',"sum"')]
    assert fields["sum"] == hashlib.sha256(body).hexdigest()[:16]


def test_each_flipped_bit_of_a_line_is_refused(record):
    line = line_of(record)
    assert record_of(line) == record
    read = 0
    for bit in range(8 * len(line)):
        try:
            record_of(flipped(line, bit))
        except BadData:
            continue
        read += 1
    assert read == 0


def test_a_flip_between_lines_names_file_and_line(record, tmp_path):
    path, line = tmp_path / "records.jsonl", line_of(record)
    for bit in range(8):
        path.write_bytes(line + flipped(line, 8 * (len(line) - 1) + bit))
        with pytest.raises(BadData, match=r"records\.jsonl, line 2: "):
            read_records(path)
        path.write_bytes(flipped(line, 8 * (len(line) - 1) + bit) + line)
        with pytest.raises(BadData, match=r"records\.jsonl, line 1: "):
            read_records(path)


def test_a_changed_line_says_so(record, tmp_path):
    path = tmp_path / "records.jsonl"
    path.write_bytes(line_of(record).replace(b'"anna"', b'"anne"'))
    with pytest.raises(BadData, match=r"line 1: its checksum says that something in it has"):
        read_records(path)
    path.write_text(json.dumps(json.loads(line_of(record))) + "\n")
    with pytest.raises(BadData, match=r"line 1: its checksum isn't as it was written"):
        read_records(path)


@pytest.mark.parametrize("suite", [Suite("small", (FIND,), {}), DEMO], ids=["small", "demo"])
def test_flipped_bits_of_a_suite_are_refused(suite, tmp_path):
    path = tmp_path / "suite.json"
    marks = suite.objects or {it.object_id: (3.0, 0.51) for it in SCENE.objects}
    write_suite(path, Suite(suite.name, suite.tasks, marks))
    content, rng = path.read_bytes(), random.Random(0)
    # Half of them where fingerprints are, which no hash of a task covers.
    end = content.index(b'"manifest"')
    bits = [rng.randrange(8 * end) for _ in range(FLIPS // 2)]
    bits += [rng.randrange(8 * len(content)) for _ in range(FLIPS // 2)]
    read = 0
    for bit in bits:
        path.write_bytes(flipped(content, bit))
        try:
            read_suite(path)
        except BadData:
            continue
        read += 1
    assert read == 0


def test_what_has_no_checksum_is_read_and_told_once_a_file(old, capsys):
    assert len(read_records(old / RECORDS)) == 4 and read_suite(old / SUITE).tasks == DEMO.tasks
    tell_unsummed(old)
    first, second = capsys.readouterr().out.splitlines()
    assert first.startswith(f"{old / RECORDS}: 3 of 4 records have no checksum")
    assert second.startswith(f"{old / SUITE}: no checksum.")


def test_what_has_one_is_not_told_of(tmp_path, capsys):
    write_suite(tmp_path / SUITE, DEMO)
    (tmp_path / RECORDS).write_bytes(line_of(episode(DEMO.tasks[0])))
    tell_unsummed(tmp_path)
    assert capsys.readouterr().out == ""


def test_any_document_may_end_with_one(tmp_path):
    write_suite(tmp_path / "s.json", DEMO)
    document = read_document(tmp_path / "s.json", SuiteDocument, "Write it again")
    again = with_sum(document.model_dump_json(indent=1, exclude={"commitment"}).encode())
    assert (tmp_path / "s.json").read_bytes() == again and has_sum(again)
    assert not has_sum(without_sum(again))


def test_packaged_suites_are_as_they_were_frozen():
    """Whoever changes one has to say so here, too."""
    data = Path(read_suite.__code__.co_filename).parent / "data"
    frozen = {
        "behind": "746c1d14439803a1c7c794422b8d19b6cac8a00fee6e21da9d5c775111b359a4",
        "tour": "10dd346c0a72b55a11ccf05654ad0c04a40a02e175a0ce0b74d41f03b430e419",
        "v1.1": "7197f6be5042e0c91b72c592eee47a70da49e8c9d360ddd26720c63808768682",
        "v2": "033617181546dcb95b235b169ff7b485210028c4ea50c745184a4e2b7476aa67",
        "demo": "c21019d8441e1af8abb545027eea302fb31806b30b6fad43516e5e1c022d4d2f",
        "v1-scans": "180e3909898eed48524d66df3c353b2910bc2e41f69c93524abb50112d80987f",
        "v1-unfiltered": "bbeba7df3704195cf4733c06339a3a20eb5f1543208413e271bd81b0af62523e",
        "v1": "cdbbf75b5fe15603dc8979de65f945a7e6c313e751dcf42bae38930a5cd3d853",
    }
    said = (data / "SHA256SUMS").read_text().split()
    assert {f"{name}.json" for name in frozen} == {it.name for it in data.glob("*.json")}
    for name, known in frozen.items():
        content = (data / f"{name}.json").read_bytes()
        assert hashlib.sha256(content).hexdigest() == known
        assert said[said.index(f"{name}.json") - 1] == known
