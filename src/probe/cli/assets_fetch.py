"""`probe assets fetch`: public objects, materials and lights, and the scans of a suite."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import tyro

from probe.assets.fetching.download import download
from probe.assets.fetching.sites import place_of, places
from probe.assets.fetching.unpack import unpack
from probe.cli.assets_fetch_scans import SCANS, fetch_suite_scans
from probe.cli.screen import Column, ScreenTable, download_bar, say
from probe.errors import Misuse

_OUT = Path("outputs/fetched")


def fetch(
    name: Annotated[str, tyro.conf.Positional] = "",
    out: Path | None = None,
    sha256: str | None = None,
    mirror: str | None = None,
) -> None:
    """Download a public object, set, material or light; continues where it was interrupted.

    v1-scans: all scans of that suite, each from its source; only the right ones are kept.

    Args:
        name: v1-scans, or place and item, as bop/ycbv; without one, the places are listed.
        out: Folder for it: outputs/fetched, or where commands look for scans.
        sha256: What the file has to hash to, if you know it.
        mirror: Address of a folder with <id>.glb of v1-scans, instead of their sources.
    """
    if name == SCANS:
        if sha256 is not None:
            raise Misuse(f"{SCANS} has many files: their hashes are known. Leave --sha256 out.")
        fetch_suite_scans(out, mirror)
        return
    if mirror is not None:
        raise Misuse(f"--mirror is for {SCANS}. Leave it out.")
    if not name:
        _list()
        return
    _fetch_one(name, out or _OUT, sha256)


def _fetch_one(name: str, out: Path, sha256: str | None) -> None:
    place, item = place_of(name, places())
    file = out / place.file_of(item)
    with download_bar() as bar:
        task = bar.add_task(name, total=None)
        expected = sha256 or place.sha256.get(item)
        found = download(
            place.url_of(item),
            file,
            expected,
            lambda there, total: bar.update(task, completed=there, total=total),
        )
    folder = file
    if file.suffix == ".zip":
        folder = out / file.stem.removesuffix("_models")
        unpack(file, folder)
    say(f"SHA-256 {found}{'' if expected else ' (not known beforehand: compare it yourself)'}")
    say(f"Licence: {place.licence}. Next: {place.then.replace('{folder}', str(folder))}")


def _list() -> None:
    table = ScreenTable(
        "name", Column("what", overflow="fold"), "licence", title="probe assets fetch"
    )
    for site, place in places().items():
        table.add(f"{site}/{place.examples[0]}", place.about, place.licence)
    table.add(SCANS, "all scans of the suite of that name, from their sources", "by scan")
    table.show()
