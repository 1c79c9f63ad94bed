import csv

import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.errors import BadData, OutputFailed
from probe.scores.row_files import read_csv, read_json_lines, write_csv, write_json_lines
from score_rows import faulty, row

REDUCE = row(
    "reduce-1",
    precision=1 / 3,
    recall=0.5,
    exact=False,
    attempts_a_removal=1.25,
    others_disturbed=2,
    strict=False,
    tokens_in=1234,
    tokens_out=0,
    cost=0.1 + 0.2,
    seconds_agent=1e-9,
)
ROWS = [
    row("find-1", stratum="partly", necessary=2),
    faulty("count-2", run=3, agent="bob, jr"),
    REDUCE,
]
FORMS = [(write_csv, read_csv), (write_json_lines, read_json_lines)]


@pytest.mark.parametrize(("write", "read"), FORMS)
@pytest.mark.parametrize("rows", [ROWS, ROWS[:1], []])
def test_what_was_written_is_read(tmp_path, write, read, rows):
    path = tmp_path / "new" / "rows"
    write(path, rows)
    assert read(path) == rows


WRITE_AGAIN = "Write it again with `probe rescore`$"

WORDS = st.text(st.characters(exclude_categories=["Cs"]), min_size=1)


@pytest.mark.parametrize(("write", "read"), FORMS)
@given(agent=WORDS, fault=WORDS, cost=st.floats(0, 1e6), tokens=st.integers(0, 2**70))
def test_odd_words_and_numbers_survive(tmp_path_factory, write, read, agent, fault, cost, tokens):
    path = tmp_path_factory.getbasetemp() / "odd"
    rows = [faulty("find-1", agent=agent, fault=fault, cost=cost, tokens_in=tokens)]
    write(path, rows)
    assert read(path) == rows


def test_a_spreadsheet_sees_plain_cells(tmp_path):
    write_csv(tmp_path / "rows.csv", ROWS)
    with (tmp_path / "rows.csv").open(newline="") as file:
        first, second, third = csv.DictReader(file)
    assert (first["task"], first["correct"], first["stratum"]) == ("find-1", "true", "partly")
    assert (second["agent"], second["correct"]) == ("bob, jr", "false")
    assert (first["necessary"], second["necessary"]) == ("2", "")
    assert (first["tokens_in"], third["tokens_in"], third["tokens_out"]) == ("", "1234", "0")


@pytest.mark.parametrize(("write", "read"), FORMS)
def test_broken_files_are_named_with_their_line(tmp_path, write, read):
    path = tmp_path / "rows"
    write(path, ROWS)
    path.write_text(path.read_text().replace("count-2", "count-2\0").replace("bob", '"bob', 1))
    with pytest.raises(BadData, match="rows"):
        read(path)


@pytest.mark.parametrize(
    ("read", "text", "reason"),
    [
        (read_csv, "task,run\nfind-1,0\n", "row 1: suite: Field required"),
        (read_csv, "a\nb\n", rf"row 1: suite: Field required\. {WRITE_AGAIN}"),
        (read_csv, 'a,b\n"x', rf"rows: unexpected end of data\. {WRITE_AGAIN}"),
        (read_csv, b"\xff\xfe", rf"rows: isn't UTF-8\. {WRITE_AGAIN}"),
        (read_json_lines, b"\xff\xfe", rf"rows: isn't UTF-8\. {WRITE_AGAIN}"),
        (read_json_lines, "{}\n", rf"line 1: suite: Field required\. {WRITE_AGAIN}"),
        (read_json_lines, '{"suite": "s"', "line 1: the line: Invalid JSON"),
    ],
)
def test_what_is_wrong_is_said(tmp_path, read, text, reason):
    path = tmp_path / "rows"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(BadData, match=reason):
        read(path)


def test_a_row_that_contradicts_itself_is_named(tmp_path):
    path = tmp_path / "rows"
    write_csv(path, ROWS[:1])
    text = path.read_text()
    assert ",4,1,2," in text  # turns, manipulations, perceptions
    path.write_text(text.replace(",4,1,2,", ",4,0,2,"))
    words = f"row 1: the row: Value error, manipulated isn't.*{WRITE_AGAIN}"
    with pytest.raises(BadData, match=words):
        read_csv(path)


@pytest.mark.parametrize("read", [read_csv, read_json_lines])
def test_a_missing_file_is_named(tmp_path, read):
    with pytest.raises(BadData, match="none: No such file or directory. Check the path$"):
        read(tmp_path / "none")


@pytest.mark.parametrize("write", [write_csv, write_json_lines])
def test_nothing_is_left_half_written(tmp_path, write):
    (tmp_path / "file").write_text("")
    with pytest.raises(OutputFailed):
        write(tmp_path / "file" / "rows", ROWS)
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


@pytest.mark.parametrize(("write", "read"), FORMS)
def test_the_version_of_the_tools_is_kept(tmp_path, write, read):
    rows = [row("find-1"), row("find-2", tools=2)]
    write(tmp_path / "rows", rows)
    assert [it.tools for it in read(tmp_path / "rows")] == [1, 2]


@pytest.mark.parametrize(("write", "read"), FORMS)
def test_rows_of_the_first_version_read_as_release_0_1_wrote_them(tmp_path, write, read):
    write(tmp_path / "rows", ROWS)
    assert b"tools" not in (tmp_path / "rows").read_bytes().replace(b"seconds_tools", b"")
