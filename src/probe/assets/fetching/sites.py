"""Where public objects, materials and lights lie, from ``data/downloads.yaml``."""

from __future__ import annotations

import re
from functools import cache
from importlib.resources import files
from urllib.parse import quote

import yaml
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter

from probe.errors import BadData, UnknownName

_ITEM = re.compile(r"^[A-Za-z0-9][A-Za-z0-9_.()-]{0,150}$")


class DownloadSite(BaseModel):
    """A site with many items; ``{item}`` stands for one of them."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    about: str
    url: str = Field(pattern=r"^https?://.*\{item\}")
    file: str = Field(pattern=r"\{item\}")
    licence: str
    examples: tuple[str, ...] = Field(min_length=1)
    then: str
    sha256: dict[str, str]

    def url_of(self, item: str) -> str:
        return self.url.replace("{item}", quote(item))

    def file_of(self, item: str) -> str:
        return self.file.replace("{item}", item)


@cache
def places() -> dict[str, DownloadSite]:
    """All places by name."""
    text = (files("probe.assets") / "data" / "downloads.yaml").read_text("utf-8")
    return TypeAdapter(dict[str, DownloadSite]).validate_python(yaml.safe_load(text))


def place_of(name: str, known: dict[str, DownloadSite]) -> tuple[DownloadSite, str]:
    """The place and the item of a name like "bop/ycbv".

    Raises:
        UnknownName: There is no such place.
        BadData: The item's name is missing or can't be one.
    """
    site, _, item = name.partition("/")
    if site not in known:
        raise UnknownName("download", site, [f"{key}/..." for key in known])
    if not _ITEM.match(item):
        example = f"{site}/{known[site].examples[0]}"
        raise BadData(name, "names no item", f"Write it like {example}.")
    return known[site], item
