import pytest

from probe.errors import BadData
from probe.generation.build_folder import CandidateLog
from probe.report.build_log import Candidates, count_candidates, read_build_log

LINES = [
    "size\t3\tkept\tTrue\t\t10.5",
    "count\t0\tcover\t-\tnothing covers anything\t1.0",
    "count\t1\tsolvable\tFalse\tnone of 6 attempts\t30.0",
    "count\t2\tcover\t-\t\t1.5",
    "count\t3\tkept\tFalse\t\t20.0",
]


def test_candidates_are_counted_by_type_and_check():
    count, size = count_candidates(CandidateLog.parse(line) for line in LINES)
    assert count == Candidates("count", 4, 1, 0, 2, 52.5, (("cover", 2), ("solvable", 1)))
    assert size == Candidates("size", 1, 1, 1, 1, 10.5, ())


def test_a_log_is_read(tmp_path):
    path = tmp_path / "log.txt"
    path.write_text("\n".join(LINES) + "\n")
    assert [it.question_type for it in read_build_log(path)] == ["count", "size"]


def test_what_is_no_log_is_refused_by_line(tmp_path):
    path = tmp_path / "log.txt"
    path.write_text(LINES[0] + "\nhello\n")
    with pytest.raises(BadData, match=r"log.txt, line 2: .* Take the log that"):
        read_build_log(path)
    with pytest.raises(BadData, match="absent"):
        read_build_log(tmp_path / "absent")
