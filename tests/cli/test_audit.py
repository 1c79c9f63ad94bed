"""`probe audit` on folders made by hand, and, slowly, on an episode that was really played."""

from __future__ import annotations

import json
import stat
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from forgeries import TASK, honest, moved, with_step, with_steps, write_folder
from pages import Page
from probe.agents.scripted import Scripted
from probe.assets.folders import audit_key_file
from probe.assets.library import open_library
from probe.assets.tables import load_table
from probe.audit.audit_file import AUDIT, ReplayVerdict, hashes_of_lines, keep
from probe.cli.audit import NotAsRecorded, audit
from probe.cli.report import write_run_report
from probe.cli.rescore import rescore
from probe.episodes.files import append_record
from probe.episodes.folder import RECORDS
from probe.episodes.noise import NOISES
from probe.episodes.play import play
from probe.episodes.record import EpisodeRecord, Seconds, TableState
from probe.errors import BadData
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from run_folders import DEMO, episode, write_run


def told(capsys: pytest.CaptureFixture[str]) -> str:
    """What was printed, in one line."""
    return " ".join(capsys.readouterr().out.split())


def test_without_replays_the_checks_alone_are_made(tmp_path, capsys):
    out = write_folder(tmp_path, honest())
    audit(out)
    said = capsys.readouterr().out
    assert "1 results on demo, as packaged. All agree with themselves" in said
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


def test_an_audit_that_came_with_the_folder_is_set_aside(tmp_path, capsys):
    """One that was honestly made, by somebody else; and one of before there were keys."""
    out = write_folder(tmp_path / "run", honest())
    equal = dict.fromkeys(hashes_of_lines(out), ReplayVerdict(outcome="equal"))
    keep(out, equal, results=1, key_file=tmp_path / "theirs.key")
    text = json.loads((out / AUDIT).read_bytes())
    del text["sum"], text["seal"]
    for theirs in ((out / AUDIT).read_bytes(), json.dumps(text).encode()):
        (out / AUDIT).write_bytes(theirs)
        rescore(out, arm="agentic")
        assert f"{out}: not audited here (audit.json was made elsewhere)." in told(capsys)
        page = Page(write_run_report([out]).read_text())
        assert "not audited here (audit.json was made elsewhere)" in page.section("scores")
        capsys.readouterr()
        audit(out)
        said = told(capsys)
        assert f"{out}: audit.json was not made here: its verdicts don't count." in said
        assert f"{out}: not audited." in said
        assert stat.S_IMODE(audit_key_file().stat().st_mode) == 0o600


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
    plain = [task for task in DEMO.tasks if task.kind != "find"]
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
    agent = Scripted(task.kind, task.subject, generator(task.seed, "audit"), form=task.form)
    with Renderer() as renderer:
        top = load_table(task.scene.table, None)
        return play(task, agent, "anna", library, top, renderer, noise=NOISES["paper"])


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
    """What docs/audit.md says that a signature alone speaks for."""
    times = Seconds(*[(0.5,) * len(played.steps)] * 2)
    out = write_folder(tmp_path, replace(played, agent="bea", seconds=times))
    audit(out, replay="1")
    assert "audited: 1 of 1 replayed, all equal" in capsys.readouterr().out


def test_the_folder_of_an_audit_is_a_path(tmp_path: Path):
    with pytest.raises(BadData, match=r"suite\.json"):
        audit(tmp_path / "nowhere")
