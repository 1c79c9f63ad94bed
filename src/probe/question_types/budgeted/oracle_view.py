"""Budgeted's evidence: what hides the target vanishes."""

from probe.episodes.evidence import OracleRule, over_marked

ORACLE_VIEW = OracleRule(over_marked)
