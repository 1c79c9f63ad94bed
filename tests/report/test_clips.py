import json
from dataclasses import replace

import pytest

from played_examples import played, write_page
from probe.episodes.participation import Participation
from probe.errors import BadData
from probe.report.clips import clip_stem, collect_clips
from probe.report.highlight import Shot
from run_folders import DEMO, episode

RECORD = episode(DEMO.tasks[0])
GRASP = 2


def put(folder, name: str, content: bytes = b"film"):
    (folder / "clips").mkdir(parents=True, exist_ok=True)
    (folder / "clips" / name).write_bytes(content)


def test_a_clip_is_named_by_what_moved_and_how():
    stem = clip_stem(RECORD, GRASP)
    moved = replace(DEMO.tasks[0].scene, objects=DEMO.tasks[0].scene.objects[::-1])
    step = RECORD.steps[GRASP - 1]
    after = replace(step, after=replace(step.after, scene=moved))
    others = {
        clip_stem(RECORD, GRASP + 1),
        clip_stem(replace(RECORD, run=1), GRASP),
        clip_stem(replace(RECORD, agent="bert"), GRASP),
        clip_stem(replace(RECORD, participation=Participation("text-only")), GRASP),
        clip_stem(replace(RECORD, steps=(RECORD.steps[0], after, *RECORD.steps[2:])), GRASP),
    }
    assert len(others) == 5
    assert stem not in others
    assert clip_stem(episode(DEMO.tasks[0]), GRASP) == stem


def test_clips_beside_the_page_are_found_and_those_of_a_run_are_taken_over(tmp_path):
    out, run = tmp_path / "out", tmp_path / "run"
    assert collect_clips(RECORD, out, [run]) == ()
    grasp, push = (clip_stem(RECORD, number) for number in (GRASP, GRASP + 1))
    put(run, f"{grasp}.webm", b"of the run")
    put(run, f"{clip_stem(RECORD, 1)}.webm")  # a search, in which nothing moves
    put(out, f"{push}.webp")
    found = collect_clips(RECORD, out, [run])
    assert found == ((GRASP, f"clips/{grasp}.webm"), (GRASP + 1, f"clips/{push}.webp"))
    assert (out / "clips" / f"{grasp}.webm").read_bytes() == b"of the run"
    assert sorted(path.stem for path in (out / "clips").iterdir()) == sorted([grasp, push])


def test_the_page_says_which_steps_have_a_clip(tmp_path):
    with_clip = replace(played(RECORD), clips=((GRASP, "clips/a.webm"),))
    text = write_page(tmp_path, [with_clip, played(episode(DEMO.tasks[1]))])
    index = json.loads(text.split('id="index-data">')[1].split("</script>")[0])
    assert [it["clips"] for it in index["episodes"]] == [{"2": "clips/a.webm"}, {}]


@pytest.mark.parametrize(
    ("clip", "video"),
    [
        ("clips/a.webm", True),
        ("clips/a.webp", False),
        ("data:video/webm;base64,AA", True),
        (None, False),
    ],
)
def test_a_player_is_for_videos_alone(clip, video):
    assert Shot("pictures/a.webp", "Moved", clip).is_video is video


def test_a_clip_that_cant_be_read_is_named(tmp_path, monkeypatch):
    name = f"{clip_stem(RECORD, GRASP)}.webm"
    put(tmp_path / "run", name)
    with (tmp_path / "run" / "clips" / name).open("wb") as large:
        large.truncate(1 << 34)
    with pytest.raises(BadData, match=name):
        collect_clips(RECORD, tmp_path / "out", [tmp_path / "run"])
