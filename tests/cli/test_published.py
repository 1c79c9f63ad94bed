"""`probe published` prints what docs/explanation/scores.md says of the paper's table."""

from __future__ import annotations

from probe.cli.published import published


def test_what_does_not_follow_is_counted_and_named(capsys):
    published()
    told = capsys.readouterr().out
    assert "5 of 16 averages don't follow from their cells; 3 of these are weighted" in told
    assert "GPT-5.4. The mean gain is 7.5 points of the cells, 8.0 as printed." in told
    assert "80 of 96 cells are a share of their tasks run once; 15 are no share of 3 runs" in told
    (nemotron,) = [line for line in told.splitlines() if "Nemotron" in line and "agentic" in line]
    # (28.2 + 79.2 + 59.3 + 29.1 + 0.0 + 38.0) / 6
    assert "46.8" in nemotron and "38.97" in nemotron and "no" in nemotron
