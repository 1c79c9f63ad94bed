"""Who points and where models are: what doesn't fit is refused before anything is begun."""

from __future__ import annotations

import pytest

from probe.cli.pointers import check_addresses
from probe.errors import BadData


@pytest.mark.parametrize(
    ("arm", "pointer", "endpoint", "said"),
    [
        ("direct", "self", None, "--pointer: nothing is pointed at in the arm direct"),
        ("blind", "gpt-5.4", None, "--pointer: nothing is pointed at"),
        ("agentic", "oracel", None, "there is no model 'oracel'"),
        ("agentic", "oracle", "localhost:8000/v1", "Begin it with http://"),
    ],
)
def test_what_doesnt_fit_is_refused(arm, pointer, endpoint, said):
    with pytest.raises(BadData, match=said):
        check_addresses(arm, pointer, endpoint)


@pytest.mark.parametrize(
    ("arm", "pointer", "endpoint"),
    [
        ("direct", "oracle", None),
        ("agentic", "self", "http://localhost:8000/v1"),
        ("agentic", "gpt-5.4", None),
        ("agentic", "google/gemini-unheard-of", None),
        ("agentic", "eyes", "https://example.org/v1"),
    ],
)
def test_what_fits_is_taken(arm, pointer, endpoint):
    check_addresses(arm, pointer, endpoint)
