"""Policies over the tools that need no model. They know what the tools tell them, no more."""
