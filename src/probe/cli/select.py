"""`probe select`: choose the episodes to learn from; nothing that belongs to evaluation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from probe.api.resources import cache_folder, everything
from probe.assets.mesh.fingerprint import Fingerprint
from probe.assets.pools.split import read_split
from probe.cli.checksum_notice import tell_unsummed
from probe.cli.metavars import RunFolders
from probe.cli.near_duplicates import near_groups, those_here
from probe.cli.numbers import check_numbers
from probe.cli.screen import ScreenTable, say
from probe.errors import BadData
from probe.files import check_new
from probe.tasks.suite import Suite
from probe.tasks.suite_file import find_suite, packaged_suites
from probe.tasks.task import QuestionType
from probe.train.choose.candidates import EpisodeCandidate
from probe.train.choose.chosen import SelectionDocument, write_selection
from probe.train.choose.efficiency import SLACK
from probe.train.choose.evaluation import evaluation_of
from probe.train.choose.gathering import candidates_of
from probe.train.choose.selection import BEYOND_SHARE, Recipe
from probe.train.choose.selection import select as selected
from probe.train.collect.batches import SETTINGS, batches

_SHOWN = 5


def select(
    collected: RunFolders,
    out: Path = Path("outputs/selected"),
    counts: dict[QuestionType, int] | None = None,
    total: int | None = None,
    direct_share: float = 0.5,
    slack: int = SLACK,
    least: int = 0,
    seed: int = 0,
    against: tuple[str, ...] = (),
    split: Path | None = None,
    near: bool = True,
    workers: int = 2,
) -> None:
    """Choose successful, efficient episodes; the suites of the package are always kept out.

    Args:
        collected: Folders that `probe collect` wrote.
        out: A new folder for the choice.
        counts: Examples of each type at most; by default all that can be learnt from.
        total: Examples of all types together, in the proportions of what can be had of each; it is
            an error if there are fewer. Of episodes with tools, and with the same seed, a larger
            selection has all of a smaller.
        direct_share: Part of a type's examples that may be without tools.
        slack: Manipulations over the median of a type's successes that are accepted.
        least: Manipulations that an episode with tools must have, so that a student doesn't learn
            to answer at the first look.
        seed: Chooses among equals.
        against: More suites to keep out: files that `probe suite build` wrote.
        split: Objects for evaluation (`probe assets split`), to be kept out with their
            near-duplicates.
        near: Look for near-duplicates among all objects that appear, for scenes and split; the
            first time this takes minutes, then it is known. Otherwise ids are compared.
        workers: Processes that compare objects.
    """
    if not collected:
        raise BadData("probe select", "was given no folder", "Name one that collect wrote")
    if not 0 <= direct_share <= 1:
        raise BadData("--direct-share", f"{direct_share} is no share", "Say a number from 0 to 1")
    counted = {
        f"--counts.{question_type}": count for question_type, count in (counts or {}).items()
    }
    numbers = {
        "--total": total,
        "--slack": slack,
        "--least": least,
        "--seed": seed,
        "--workers": workers,
    }
    check_numbers({**counted, **numbers})
    check_new(out)
    objects: dict[str, Fingerprint] = {}
    candidates = _candidates(collected, objects)
    packaged = [find_suite(name) for name in packaged_suites()]
    others = [find_suite(name) for name in against]
    suites = [*packaged, *others]
    parts = read_split(split) if split else None
    groups = _alike(objects, packaged, others, workers) if near else []
    recipe = Recipe(dict(counts or {}), direct_share, slack, seed, total, least)
    found = selected(candidates, evaluation_of(suites, parts, groups), recipe)
    if not found.chosen:
        raise _nothing_chosen(collected[0], found.dropped)
    names = [suite.name for suite in suites]
    document = write_selection(out, found, recipe, objects, collected, names)
    _print(document, len(candidates))
    say(f"They are in {out}; `probe dataset {out} OUT` writes them down for trainers.")


def _candidates(
    collected: Sequence[Path], objects: dict[str, Fingerprint]
) -> list[EpisodeCandidate]:
    """Episodes to choose from; fingerprints of what appears in them are added to `objects`."""
    candidates, unfinished = candidates_of(collected, objects)
    kept = [batch for folder in collected for batch in batches(folder)]
    tell_unsummed(*(batch.setting(setting) for batch in kept for setting in SETTINGS))
    if unfinished:
        say(f"{unfinished} batches aren't whole yet and are left out.")
    return candidates


def _nothing_chosen(collected: Path, dropped: dict[str, int]) -> BadData:
    _print_dropped(dropped)
    direct = "Say --direct-share 1, or collect with --settings agentic"
    remedy = direct if dropped[BEYOND_SHARE] else "Collect more"
    return BadData(collected, "holds no episode to learn from", remedy)


def _alike(
    objects: Mapping[str, Fingerprint],
    packaged: Sequence[Suite],
    others: Sequence[Suite],
    workers: int,
) -> list[list[str]]:
    """Groups of near-duplicates among collected objects and those of suites."""
    things = everything()
    shown = [objects, *(it.objects for it in [*those_here(packaged, things), *others])]
    return near_groups(shown, things, cache_folder() / "near", workers)


def _print(document: SelectionDocument, episodes: int) -> None:
    table = ScreenTable("type", "with tools", "without", "manipulations at most")
    for question_type, settings in document.examples.items():
        most = document.limits.get(question_type)
        cells = (
            str(sum(settings.values()) - settings["direct"]),
            str(settings["direct"]),
            "" if most is None else str(most),
        )
        table.add(question_type, *cells)
    table.show()
    letters = ", ".join(f"{letter} {count}" for letter, count in document.letters.items())
    say(f"Right answers: {letters}. From {episodes} episodes.")
    _print_dropped(document.dropped)
    refused = document.refused
    say(f"{len(refused)} tasks belong to evaluation and were refused.")
    for it in refused[:_SHOWN]:
        say(f"  {it.task}: {it.leak}, {it.detail}")
    if len(refused) > _SHOWN:
        say(f"  ... and {len(refused) - _SHOWN} more, in selection.json.")


def _print_dropped(dropped: dict[str, int]) -> None:
    for reason, count in sorted(dropped.items(), key=lambda item: -item[1]):
        say(f"left out, {reason}: {count}")
