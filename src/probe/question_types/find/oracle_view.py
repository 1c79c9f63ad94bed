"""Find's evidence: what is faint comes to light."""

from probe.episodes.evidence import OracleRule, over_faint

ORACLE_VIEW = OracleRule(over_faint)
