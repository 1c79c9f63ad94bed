"""Memory's evidence: what the question names vanishes; the first picture tells what stood where."""

from probe.episodes.evidence import OracleRule, all_named

ORACLE_VIEW = OracleRule(all_named)
