"""The question types, a folder each; `probe.tasks.registry` finds their parts."""
