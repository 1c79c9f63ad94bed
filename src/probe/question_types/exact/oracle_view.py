"""Exact's evidence: what the question names vanishes."""

from probe.episodes.evidence import OracleRule, all_named

ORACLE_VIEW = OracleRule(all_named)
