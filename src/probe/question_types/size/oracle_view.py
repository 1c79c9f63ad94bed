"""Size's evidence: both marked things lie open."""

from probe.episodes.evidence import OracleRule, over_marked

ORACLE_VIEW = OracleRule(over_marked)
