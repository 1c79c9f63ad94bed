"""Everyday things made by formula: everything about them is in ``data/``. No files, no scans."""

from probe.assets.procedural.catalogue import build, specs

__all__ = ["build", "specs"]
