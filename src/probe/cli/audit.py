"""`probe audit`: whether records are what they say: checks, replays, hashes, a signature."""

from __future__ import annotations

import secrets
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path

from probe.api.resources import audit_key_file, opener
from probe.audit.audit_file import audit_of, counted
from probe.audit.auditing import Audit, begin, replay_claims
from probe.audit.manifest import MANIFEST, SIGNATURE, check_manifest, write_manifest
from probe.audit.replaying import Claim, Replayer
from probe.audit.signing import sign as sign_manifest
from probe.audit.signing import verify as verify_manifest
from probe.cli.audit_words import tell_checks, tell_verdicts
from probe.cli.checksum_notice import tell_unsummed
from probe.cli.metavars import RunFolder
from probe.cli.numbers import check_numbers
from probe.cli.option_conflicts import refuse_stray
from probe.cli.screen import bar, say
from probe.engines.local import LocalEngine
from probe.episodes.folder import SUITE
from probe.episodes.replay import check_tools
from probe.errors import BadData, ProbeError
from probe.tasks.suite import Suite
from probe.tasks.suite_file import find_suite, read_suite

_SEED_BITS = 62


class NotAsRecorded(ProbeError):
    """A replay came out otherwise."""

    def __init__(self, out: Path, differ: int, replayed: int) -> None:
        super().__init__(
            f"{out}: {differ} of {replayed} replays differ from what is recorded. Audit it with "
            "the release, the assets and the kind of machine that it was run with: what is honest "
            "comes out equal there."
        )


class NotRepeated(ProbeError):
    """All was to be replayed, and some of it can't be."""

    def __init__(self, out: Path, unable: int, results: int) -> None:
        super().__init__(
            f"{out}: {unable} of {results} results couldn't be repeated, so that nothing confirms "
            "them. Don't count them, or have them run again where somebody watches."
        )


def audit(
    out: RunFolder,
    replay: str | None = None,
    workers: int = 1,
    sign: Path | None = None,
    verify: Path | None = None,
    seed: int | None = None,
    suite: str | None = None,
) -> None:
    """Check a run's records; replay them, sign the folder, or verify who signed it, on request.

    The verdicts are kept in audit.json; the same command continues where it stopped. A file that
    was made with another user's key, or with none, doesn't count.

    Args:
        out: Folder that `probe run` wrote to.
        replay: How many episodes to replay, drawn at random, or "all".
        workers: Processes that replay.
        sign: SSH key to sign the hashes of all files with, last of all.
        verify: File of SSH public keys, one of which must have signed the folder as it is.
        seed: Of the draw; by default a new one, which is printed.
        suite: What the folder's suite has to be: the name of a packaged one, or your own file.
    """
    check_numbers({"--workers": workers, "--seed": seed})
    count = _count(replay)
    if not count:
        refuse_stray("audit", "unless --replay says how many", {"--seed": seed})
    if verify is not None:
        refuse_stray("audit", "with --verify", {"--sign": sign, "--replay": replay})
        _verify(out, verify)
    asked, reference = read_suite(out / SUITE), find_suite(suite) if suite else None
    found = begin(out, asked, audit_key_file(), reference)
    tell_unsummed(out)
    tell_checks(out, asked, found)
    if suite is not None:
        say(f"{out}: its suite is {suite}, all of it.")
    if replay is not None and found.claims:
        # The tools of all records of a folder have one version.
        check_tools(found.claims[0].record)
    if verify is None and (replay is not None or sign is None):
        _replay(found, asked, _drawn(found, count, seed), workers, whole=count is None)
    if sign is not None:
        files = write_manifest(out)
        sign_manifest(out, sign)
        say(f"{out / MANIFEST} has the hashes of {files} files; its signature is {SIGNATURE}.")


def _count(replay: str | None) -> int | None:
    """How many episodes to replay; None for all."""
    if replay is None or replay == "all":
        return 0 if replay is None else None
    if not replay.isascii() or not replay.isdigit() or int(replay) < 1:
        raise BadData("--replay", f"{replay} is no number of episodes", 'Say 1 or more, or "all"')
    return int(replay)


def _drawn(audit: Audit, count: int | None, seed: int | None) -> list[Claim]:
    """What to replay; tells the seed of a draw, so that it can be made again."""
    if seed is None:
        seed = secrets.randbits(_SEED_BITS)
    if count and count < len(audit.claims):
        say(f"Replays {count} of {len(audit.claims)} results, drawn by --seed {seed}.")
    return audit.lacking(count, seed)


def _verify(out: Path, keys: Path) -> None:
    words = verify_manifest(out, keys)
    files = check_manifest(out)
    say(words, f"{files} files are as they were signed.")


def _replay(
    audit: Audit, suite: Suite, claims: Sequence[Claim], workers: int, *, whole: bool
) -> None:
    """Replay what has no verdict yet, and say what is known then.

    Raises:
        NotAsRecorded: Something differs.
        NotRepeated: The whole folder was to be replayed, and something can't be.
    """
    place = Replayer(suite, opener())
    audit.keep()
    if claims:
        with (
            bar() as progress,
            closing(replay_claims(audit, claims, place, LocalEngine(workers))) as results,
        ):
            line = progress.add_task("Replaying", total=len(claims))
            for _ in results:
                progress.update(line, advance=1)
    tell_verdicts(audit)
    say(f"{audit.out}: {audit_of(audit.out, audit.key_file).words}.")
    audited = counted(audit.verdicts, len(audit.claims))
    if audited.differ:
        raise NotAsRecorded(audit.out, audited.differ, audited.equal + audited.differ)
    if whole and audited.unable:
        raise NotRepeated(audit.out, audited.unable, audited.results)
