"""What looking alone makes of Ranked: what is half hidden has a colour."""

from probe.generation.observer import Observer, resembling

OBSERVER = Observer(resembling)
