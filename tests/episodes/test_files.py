import json
import resource
from dataclasses import replace

import pytest

from probe.checksum import without_sum
from probe.episodes.conditions import Conditions
from probe.episodes.files import (
    append_record,
    cut_off,
    line_of,
    read_records,
    record_of,
    set_aside_cut,
    write_records,
)
from probe.episodes.perceptions import PerceptionUsed
from probe.episodes.turns import Call
from probe.errors import BadData, OutputFailed
from probe.perception.dials import Dials
from probe.scene.lighting import Lighting
from probe.scene.scene import PlacedObject
from probe.scene.setup import UR5_TABLE
from probe.scene.viewpoint import Viewpoint
from probe.toolshed.version import TOOLS_VERSION
from probe.types import Pose


def test_records_survive_the_disk(tmp_path, play):
    path = tmp_path / "runs" / "records.jsonl"
    records = [play(), play(Call.of("perceive_scene"))]
    for record in records:
        append_record(path, record)
    assert read_records(path) == records
    again = tmp_path / "again.jsonl"
    write_records(again, read_records(path))
    assert again.read_bytes() == path.read_bytes()
    assert [f.name for f in path.parent.iterdir()] == ["records.jsonl"]


def test_how_many_manipulations_a_question_allows_survives_the_disk(play):
    record = play(Call.of("perceive_scene"))
    few = replace(record, question=replace(record.question, manipulations=3))
    assert record_of(line_of(few)).question.manipulations == 3
    assert b"manipulations" not in line_of(record)


def test_names_of_a_real_table_s_pictures_survive_the_disk(play):
    record = play(Call.of("perceive_scene"))
    filmed = replace(record, frames=("frames/demo-1-me-0/000", "frames/demo-1-me-0/001"))
    assert record_of(line_of(filmed)) == filmed
    assert b"frames" not in line_of(record)


@pytest.mark.parametrize(
    "names",
    [
        ["../000"],
        ["frames/../x/000"],
        ["/etc/000"],
        ["frames/a/0"],
        ["frames/a/b/000"],
        ["frames/a/000", "frames/a/001"],
    ],
)
def test_names_of_pictures_elsewhere_or_of_no_step_are_refused(play, names: list[str]):
    told = json.loads(without_sum(line_of(play()))) | {"frames": names}
    with pytest.raises(BadData, match="frames"):
        record_of(json.dumps(told).encode())


def test_conditions_and_sight_survive_the_disk(tmp_path, play):
    pose = Pose((0.01, -0.02, 1.18), (0.0, 1.0, 0.0, 0.0))
    record = replace(
        play(),
        conditions=Conditions("hdri", "raised", "other", 0.003, Dials(missed=0.2), "grasp"),
        viewpoint=Viewpoint(
            replace(UR5_TABLE.camera(), world_from_camera=pose), Lighting("loft", 0.5)
        ),
    )
    write_records(tmp_path / "records.jsonl", [record])
    assert read_records(tmp_path / "records.jsonl") == [record]


def test_perception_survives_the_disk_and_is_not_written_where_it_is_the_usual(tmp_path, play):
    used = PerceptionUsed("enrolled", 25, "0123456789ab")
    record = replace(play(), perception=used)
    write_records(tmp_path / "records.jsonl", [record])
    assert read_records(tmp_path / "records.jsonl") == [record]
    assert json.loads(line_of(record))["perception"]["objects"] == 25
    assert "perception" not in json.loads(line_of(play()))


@pytest.mark.parametrize(
    "said",
    [
        {"kind": "oracle", "objects": 0, "enrolment": ""},
        {"kind": "enrolled", "objects": 0, "enrolment": ""},
        {"kind": "segmenter", "objects": 25, "enrolment": "0123456789ab"},
    ],
)
def test_a_perception_that_cannot_be_is_refused(play, said):
    fields = json.loads(line_of(play()))
    del fields["sum"]
    with pytest.raises(BadData, match="perception"):
        record_of(json.dumps({**fields, "perception": said}).encode())


def test_records_of_before_there_were_conditions_are_read(tmp_path, play):
    fields = json.loads(line_of(play()))
    del fields["conditions"], fields["sight"], fields["sum"]
    (tmp_path / "records.jsonl").write_text(json.dumps(fields) + "\n")
    (record,) = read_records(tmp_path / "records.jsonl")
    assert record.untimed() == play().untimed()


def test_what_found_no_room_is_taken_back(tmp_path, play):
    path, line = tmp_path / "records.jsonl", line_of(play())
    append_record(path, play())
    before = path.read_bytes()
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (len(before) + len(line) // 2, limits[1]))
    try:
        with pytest.raises(OutputFailed, match="Free some space"):
            append_record(path, play())
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert path.read_bytes() == before
    append_record(path, play())
    assert len(read_records(path)) == 2


def test_a_line_that_was_cut_off_is_set_aside(tmp_path, play):
    path, line = tmp_path / "records.jsonl", line_of(play())
    assert set_aside_cut(path) is None
    path.write_bytes(line + line[:100])
    assert [record.untimed() for record in read_records(path, whole=False)] == [play().untimed()]
    aside = set_aside_cut(path)
    assert aside is not None and aside.read_bytes() == line[:100] + b"\n"
    assert path.read_bytes() == line
    assert set_aside_cut(path) is None


def test_an_unchanged_table_is_written_once(play):
    steps = json.loads(line_of(play()))["steps"]
    assert [step["after"] is None for step in steps] == [True, True, False, *[True] * 4]


def test_timing_lies_apart(play):
    one, other = play(), play()
    assert line_of(one, timed=False) == line_of(other, timed=False)
    assert one.untimed() == other.untimed()


def test_a_line_that_is_cut_off_is_named(tmp_path, play):
    path = tmp_path / "records.jsonl"
    whole = line_of(play())
    path.write_bytes(whole + whole[:-40])
    with pytest.raises(
        BadData, match=r"records.jsonl, line 2: .*If these are your own records, delete this line"
    ):
        read_records(path)
    with pytest.raises(BadData, match=r"records.jsonl, line 2: is cut off"):
        append_record(path, play())
    assert path.read_bytes() == whole + whole[:-40]


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"version": 1}, "version"),
        ({"end": "bored"}, "end"),
        ({"start": {"scene": None, "joints": []}}, "start.scene"),
        ({"more": 1}, "more"),
    ],
)
def test_lines_that_are_no_records_are_refused(tmp_path, play, change, reason):
    path = tmp_path / "records.jsonl"
    fields = json.loads(line_of(play()))
    del fields["sum"]
    path.write_text(json.dumps(fields | change) + "\n")
    with pytest.raises(BadData, match=f"line 1: {reason}"):
        read_records(path)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(BadData, match="nowhere.jsonl"):
        read_records(tmp_path / "nowhere.jsonl")


@pytest.mark.parametrize("rest", [b"", b"x", b"x" * 65_535, b"x" * 65_536, b"x" * 200_000])
@pytest.mark.parametrize("before", [b"", b"a\n", b"a" * 100_000 + b"\n"])
def test_what_was_cut_off_is_found_however_long_it_is(tmp_path, before, rest):
    (tmp_path / "records.jsonl").write_bytes(before + rest)
    assert cut_off(tmp_path / "records.jsonl") == rest


def test_the_version_of_the_tools_is_kept(play):
    record = play()
    assert record.tools == TOOLS_VERSION
    assert json.loads(line_of(record))["tools"] == TOOLS_VERSION
    assert record_of(line_of(record)) == record


def test_records_that_name_no_version_are_of_the_first_and_keep_their_bytes(play):
    first = replace(play(), tools=1)
    line = line_of(first)
    assert "tools" not in json.loads(line)
    assert record_of(line) == first and line_of(record_of(line)) == line


@pytest.mark.parametrize("version", [0, -1, 1.5, 10**9, "x"])
def test_a_version_that_cannot_be_is_refused(play, version):
    said = json.loads(without_sum(line_of(play()))) | {"tools": version}
    with pytest.raises(BadData, match="tools"):
        record_of(json.dumps(said).encode())


@pytest.mark.parametrize(
    ("ids", "said"),
    [
        (["proc_red_mug", "own_cup"], None),
        (["proc_orange_mug"], "train"),
        (["proc_orange_mug", "proc_red_mug"], "both"),
        (["own_cup"], None),
    ],
)
def test_a_record_says_whether_its_objects_are_for_training(play, ids, said):
    record = play()
    placed = tuple(PlacedObject(n, name, Pose()) for n, name in enumerate(ids, start=1))
    scene = replace(record.start.scene, objects=placed)
    shown = replace(record, start=replace(record.start, scene=scene))
    line = json.loads(without_sum(line_of(shown)))
    assert line.get("pool") == said
    assert record_of(line_of(shown)) == shown
    for other in {None, "train", "both"} - {said}:
        with pytest.raises(BadData, match="by its objects it is"):
            record_of(json.dumps(line | {"pool": other}).encode())
