"""Agents that somebody else wrote, each in a process of its own that gets question and history.

Knows no task: what isn't handed over can't be walked to.
"""
