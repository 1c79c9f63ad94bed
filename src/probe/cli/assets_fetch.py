"""`probe assets fetch`: public objects, materials and lights."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import tyro

from probe.assets.fetching.download import download
from probe.assets.fetching.sites import place_of, places
from probe.assets.fetching.unpack import unpack
from probe.cli.screen import Column, ScreenTable, download_bar, say


def fetch(
    name: Annotated[str, tyro.conf.Positional] = "",
    out: Path = Path("outputs/fetched"),
    sha256: str | None = None,
) -> None:
    """Download a public object, set, material or light; continues where it was interrupted.

    Args:
        name: Place and item, as bop/ycbv; without one, the places are listed.
        out: Folder for it.
        sha256: What the file has to hash to, if you know it.
    """
    if not name:
        _list()
        return
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
    table.show()
