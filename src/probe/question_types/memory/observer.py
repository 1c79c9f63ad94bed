"""What looking alone makes of Memory: what is half hidden has a colour."""

from probe.generation.observer import Observer, resembling

OBSERVER = Observer(resembling)
