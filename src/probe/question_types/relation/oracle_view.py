"""Relation's evidence: all of the like covers vanish."""

from probe.episodes.evidence import OracleRule, like_covers

ORACLE_VIEW = OracleRule(like_covers)
