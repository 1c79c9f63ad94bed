"""What the environment's folders are used for, by pool."""

import pytest

from probe.api.resources import tables_for
from probe.assets.tables import table_ids


@pytest.mark.parametrize(
    ("pool", "photographed"), [("procedural", False), ("own+procedural", False), ("all", True)]
)
def test_suites_that_need_nothing_from_outside_get_no_table_from_there(
    pool, photographed, tmp_path, monkeypatch
):
    (tmp_path / "textures" / "Foam001_1K-JPG").mkdir(parents=True)
    monkeypatch.setenv("PROBE_ASSETS", str(tmp_path))
    assert set(tables_for(pool)) >= set(table_ids(None))
    assert ("Foam001" in tables_for(pool)) == photographed
