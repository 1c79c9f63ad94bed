"""`probe audit` on folders made by hand, and, slowly, on an episode that was really played."""

from __future__ import annotations

import json
import re
import stat
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from forgeries import TASK, honest, moved, with_step, with_steps, write_folder
from pages import Page
from probe.agents.scripted import Scripted
from probe.api.rows import ROWS_CSV, SCORES
from probe.assets.folders import audit_key_file
from probe.assets.library import open_library
from probe.audit.audit_file import AUDIT, ReplayVerdict, hashes_of_lines, keep
from probe.cli.audit import NotAsRecorded, NotRepeated, audit
from probe.cli.report import write_run_report
from probe.cli.rescore import rescore
from probe.episodes.circumstances import Circumstances
from probe.episodes.files import append_record
from probe.episodes.folder import RECORDS
from probe.episodes.noise import NOISES
from probe.episodes.participation import ModelReply, Participation
from probe.episodes.play import play
from probe.episodes.record import EpisodeRecord, Seconds, TableState
from probe.episodes.replay import OtherTools
from probe.errors import BadData
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.scores.row_files import read_csv
from probe.tasks.suite import Suite, selection
from probe.tasks.suite_file import content_hash, write_suite
from run_folders import DEMO, episode, write_run


def told(capsys: pytest.CaptureFixture[str]) -> str:
    """What was printed, in one line."""
    return " ".join(capsys.readouterr().out.split())


def test_without_replays_the_checks_alone_are_made(tmp_path, capsys):
    out = write_folder(tmp_path, honest())
    audit(out)
    said = capsys.readouterr().out
    assert "1 results on demo, as packaged. All agree with themselves" in said
    assert "the folder's notes; 11 of 12 episodes are missing." in said
    assert f"{out}: not audited." in said
    forged = write_folder(tmp_path / "forged", with_steps(honest()))
    with pytest.raises(BadData, match=r"records\.jsonl, line 1: .*its last call says none"):
        audit(forged)
    assert not (forged / AUDIT).exists()


@pytest.mark.parametrize("count", ["0", "-1", "some", "1.5", "²"])
def test_numbers_of_replays_that_mean_nothing_are_refused(tmp_path, count):
    with pytest.raises(BadData, match="--replay: .* is no number of episodes"):
        audit(write_folder(tmp_path, honest()), replay=count)


def test_what_differed_once_is_said_again_and_fails(tmp_path, capsys):
    out = write_folder(tmp_path, honest())
    differs = ReplayVerdict(outcome="differs", reason="step 3: after")
    keep(out, dict.fromkeys(hashes_of_lines(out), differs), results=1, key_file=audit_key_file())
    with pytest.raises(NotAsRecorded, match="1 of 1 replays differ from what is recorded"):
        audit(out, replay="all")
    said = capsys.readouterr().out
    assert f"{TASK.id}, run 0 of anna differs: step 3: after" in said


@pytest.mark.slow
def test_an_audit_that_came_with_the_folder_is_set_aside(tmp_path, capsys):
    """One that was honestly made, by somebody else; and one of before there were keys."""
    out = write_folder(tmp_path / "run", honest())
    equal = dict.fromkeys(hashes_of_lines(out), ReplayVerdict(outcome="equal"))
    keep(out, equal, results=1, key_file=tmp_path / "theirs.key")
    text = json.loads((out / AUDIT).read_bytes())
    del text["sum"], text["seal"]
    for theirs in ((out / AUDIT).read_bytes(), json.dumps(text).encode()):
        (out / AUDIT).write_bytes(theirs)
        rescore(out, setting="agentic")
        assert f"{out}: not audited here (audit.json was made elsewhere)." in told(capsys)
        page = Page(write_run_report([out]).read_text())
        assert "not audited here (audit.json was made elsewhere)" in page.section("scores")
        capsys.readouterr()
        audit(out)
        said = told(capsys)
        assert f"{out}: audit.json was not made here: its verdicts don't count." in said
        assert f"{out}: not audited." in said
        assert stat.S_IMODE(audit_key_file().stat().st_mode) == 0o600


def test_what_cannot_be_repeated_fails_an_audit_of_all(tmp_path, capsys):
    pointed = Participation("agentic, pointer self", replies=(ModelReply(4),))
    out = write_folder(tmp_path, replace(honest(), participation=pointed))
    with pytest.raises(NotRepeated, match="1 of 1 results couldn't be repeated"):
        audit(out, replay="all")
    assert "1 can't be replayed: perception asked a model (pointer self)" in told(capsys)
    audit(out, replay="1")
    audit(out)


def test_the_seed_of_a_draw_is_told(tmp_path, capsys, monkeypatch):
    drawn: list[list[str]] = []

    def replayed(audit, claims, place, workers):
        drawn.append([claim.record.task for claim in claims])
        yield from ()

    monkeypatch.setattr("probe.cli.audit.replay_claims", replayed)
    out = write_folder(tmp_path, *map(honest, DEMO.tasks))
    audit(out, replay="2")
    (seed,) = re.findall(r"Replays 2 of 6 results, drawn by --seed (\d+)\.", told(capsys))
    for _ in range(8):
        audit(out, replay="2")
    audit(out, replay="2", seed=int(seed))
    assert drawn[0] == drawn[-1] and len(drawn[0]) == 2
    assert len({tuple(some) for some in drawn}) > 1
    for replay in (None, "all"):
        with pytest.raises(BadData, match="--seed: does nothing unless --replay says how many"):
            audit(out, replay=replay, seed=1)


def test_a_part_of_a_packaged_suite_is_told_as_such(tmp_path, capsys):
    some = [task for task in DEMO.tasks if task.question_type != "find"][:2]
    suite = selection(DEMO, tuple(some), "demo")
    out = write_run(tmp_path, [episode(task) for task in some], suite)
    remark = "2 of the 6 tasks of demo: not a score on demo"
    audit(out)
    assert "on demo (2 of 6 tasks), as packaged. All agree" in (said := told(capsys))
    assert remark in said
    rescore(out)
    assert remark in told(capsys)
    scores = json.loads((out / SCORES).read_text())
    assert (scores["suite"], scores["complete"]) == ("demo (2 of 6 tasks)", False)
    assert {row.suite for row in read_csv(out / ROWS_CSV)} == {"demo (2 of 6 tasks)"}
    page = Page(write_run_report([out]).read_text())
    assert remark in told(capsys)
    assert remark in page.all("p", class_="notice")[
        0
    ].text and "Rows are missing" not in page.section("scores")
    (title,) = page.all("h1")
    assert title.text == "Suite demo (2 of 6 tasks)"
    assert json.loads((out / SCORES).read_text()) == scores


def altered(name: str) -> Suite:
    """The demo's tasks with two answers of one type exchanged, under another name."""
    plain = [task for task in DEMO.tasks if task.question_type == "count"]
    other = replace(plain[0], answer="B" if plain[0].answer == "A" else "A")
    return selection(DEMO, (other, plain[1]), name)


def test_a_suite_that_is_not_of_the_package_is_told_by_its_content(tmp_path, capsys):
    suite = altered("m\u0456ne")
    out = write_run(tmp_path, [episode(task) for task in suite.tasks], suite)
    words = (
        f"m\\u0456ne isn't a suite of the package (SHA-256 of its content: {content_hash(suite)})"
    )
    audit(out)
    assert words in told(capsys)
    rescore(out)
    assert words in told(capsys)
    page = Page(write_run_report([out]).read_text())
    assert words in told(capsys) and words in page.all("p", class_="notice")[0].text
    scores = json.loads((out / SCORES).read_text())
    assert (scores["suite"], scores["complete"]) == ("m\\u0456ne", True)


@pytest.mark.parametrize("name", ["dem\u043e", "Demo", "demo ", "de\u200bmo", "V1\u00a0"])
def test_a_name_that_looks_like_a_packaged_one_is_refused(tmp_path, name):
    suite = altered(name)
    out = write_run(tmp_path, [episode(task) for task in suite.tasks], suite)
    for refuses in (audit, rescore, lambda it: write_run_report([it])):
        with pytest.raises(BadData, match=r"looks like the packaged (demo|v1)\."):
            refuses(out)
    assert not (out / SCORES).exists() and not (out / AUDIT).exists()


def test_the_suite_may_be_held_against_ones_own(tmp_path, capsys):
    out = write_folder(tmp_path / "run", honest())
    audit(out, suite="demo")
    assert f"{out}: its suite is demo, all of it." in told(capsys)
    write_suite(tmp_path / "mine.json", altered("mine"))
    with pytest.raises(
        BadData, match=r'isn.t the suite mine that --suite names: it is called "demo"'
    ):
        audit(out, suite=str(tmp_path / "mine.json"))


def test_a_folder_is_signed_and_verified(tmp_path, capsys):
    key = tmp_path / "key"
    command = ["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", str(key)]
    subprocess.run(command, check=True)
    out = write_folder(tmp_path / "run", honest())
    audit(out, sign=key)
    audit(out, verify=key.with_suffix(".pub"))
    said = capsys.readouterr().out
    assert "has the hashes of 3 files; its signature is SHA256SUMS.sig." in said
    assert "3 files are as they were signed." in said
    with pytest.raises(BadData, match="--replay: does nothing with --verify"):
        audit(out, verify=key.with_suffix(".pub"), replay="all")
    path = out / RECORDS
    # Times can be changed at will; nothing but the signature tells.
    path.unlink()
    append_record(path, replace(honest(), seconds=Seconds((0.1,) * 4, (0.1,) * 4)))
    audit(out)
    (out / AUDIT).unlink()
    with pytest.raises(BadData, match=r"records\.jsonl: has changed since SHA256SUMS"):
        audit(out, verify=key.with_suffix(".pub"))


def test_scores_and_reports_say_how_far_they_are_audited(tmp_path, capsys):
    plain = [task for task in DEMO.tasks if task.question_type != "find"]
    out = write_run(tmp_path / "run", [episode(task) for task in plain])
    rescore(out)
    assert f"{out}: not audited." in " ".join(capsys.readouterr().out.split())
    assert "not audited" in Page(write_run_report([out]).read_text()).section("scores")
    keep(
        out,
        dict.fromkeys(hashes_of_lines(out), ReplayVerdict(outcome="equal")),
        results=4,
        key_file=audit_key_file(),
    )
    words = "audited: 4 of 4 replayed, all equal"
    assert words in Page(write_run_report([out]).read_text()).section("scores")
    capsys.readouterr()
    rescore(out)
    assert words in capsys.readouterr().out
    other = write_run(tmp_path / "other", [episode(task, agent="bea") for task in plain])
    both = Page(write_run_report([out, other], tmp_path / "both").read_text()).section("scores")
    assert f"run : {words}" in both and "other : not audited" in both
    append_record(out / RECORDS, episode(plain[0], run=1))
    rescore(out)
    assert "not audited: records, suite or" in capsys.readouterr().out


@pytest.fixture(scope="module")
def played(cache) -> EpisodeRecord:
    """A real episode in which something is lifted by a hand that errs."""
    task = DEMO.tasks[0]
    library = open_library("procedural", None, cache)
    agent = Scripted(
        task.question_type, task.subject, generator(task.seed, "audit"), form=task.form
    )
    with Renderer() as renderer:
        return play(task, agent, "anna", library, renderer, Circumstances(noise=NOISES["paper"]))


def invented(record: EpisodeRecord) -> EpisodeRecord:
    """The record with the thing beneath the cover elsewhere from the grasp on."""
    target = DEMO.tasks[0].targets[0]
    grasped = next(n for n, step in enumerate(record.steps) if step.call.name.startswith("grasp"))
    for number in range(grasped, len(record.steps)):
        after = record.steps[number].after
        table = TableState(moved(after.scene, target), after.joints)
        record = with_step(record, number, after=table)
    return record


def retold(record: EpisodeRecord) -> EpisodeRecord:
    return with_step(record, 0, text=record.steps[0].text + "\nThe answer is A.")


FORGED: dict[str, tuple[Callable[[EpisodeRecord], EpisodeRecord], str]] = {
    "the target under an invented point": (invented, "differs: step 3: after, step 4: after"),
    "what a tool told": (retold, "differs: step 1: text"),
    "another run's luck": (lambda it: replace(it, run=1), "differs: step 3: "),
    "another noise": (lambda it: replace(it, noise=NOISES["none"]), "differs: step 3: "),
}


@pytest.mark.slow
def test_an_honest_episode_replays_and_is_known_from_then_on(played, tmp_path, cache, capsys):
    out = write_folder(tmp_path, played)
    audit(out, replay="all")
    assert "audited: 1 of 1 replayed, all equal" in capsys.readouterr().out
    before = (out / AUDIT).read_bytes()
    audit(out, replay="all")
    assert (out / AUDIT).read_bytes() == before
    assert "Replaying" not in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.parametrize("name", FORGED)
def test_a_replay_finds_what_the_checks_cannot(played, tmp_path, capsys, name):
    forge, words = FORGED[name]
    out = write_folder(tmp_path, forge(played))
    audit(out)
    with pytest.raises(NotAsRecorded, match="1 of 1 replays differ"):
        audit(out, replay="all")
    assert words in capsys.readouterr().out
    (verdict,) = json.loads((out / AUDIT).read_text())["verdicts"].values()
    assert verdict["outcome"] == "differs"


@pytest.mark.slow
def test_names_and_times_are_what_no_replay_can_tell(played, tmp_path, capsys):
    """What docs/how-to/audit.md says that a signature alone speaks for."""
    times = Seconds(*[(0.5,) * len(played.steps)] * 2)
    out = write_folder(tmp_path, replace(played, agent="bea", seconds=times))
    audit(out, replay="1")
    assert "audited: 1 of 1 replayed, all equal" in capsys.readouterr().out


def test_the_folder_of_an_audit_is_a_path(tmp_path: Path):
    with pytest.raises(BadData, match=r"suite\.json"):
        audit(tmp_path / "nowhere")


def test_what_other_tools_made_is_checked_and_not_replayed(tmp_path, capsys):
    out = write_folder(tmp_path, replace(honest(), tools=1))
    audit(out)
    assert "1 can't be replayed: version 1 of the tools made it" in told(capsys)
    with pytest.raises(OtherTools, match="Install probe-vqa 0.1 for that"):
        audit(out, replay="all")
