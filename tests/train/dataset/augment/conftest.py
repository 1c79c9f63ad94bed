"""Packed episodes of the scripted teacher that many tests tell again."""

from __future__ import annotations

import pytest

from packed_teacher import packed_episodes, some_of_each_type


@pytest.fixture(scope="session")
def episodes(tmp_path_factory):
    """Some of each type, from all batches."""
    return some_of_each_type(tmp_path_factory.mktemp("packed"))


@pytest.fixture(scope="session")
def first_batch(tmp_path_factory):
    """All of the first batch."""
    return packed_episodes(tmp_path_factory.mktemp("packed"))
