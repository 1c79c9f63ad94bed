from __future__ import annotations

import pytest

from probe.assets.pools.scan_catalogue import parse_scans, scan_rows, scan_sources
from probe.errors import BadData

HEAD = (
    "id,name,category,colours,description,mass,friction,hollow,shape,up,"
    "confirmed,cover,hideable,why"
)
GOOD = "mug,red mug,mug,red;black,A mug.,0.1,0.4,1,hollow,0;90;0,1,1,0,"


def test_a_line_is_read():
    (row,) = parse_scans(f"{HEAD}\n{GOOD}\n", "x.csv")
    assert row.colours == ("red", "black")
    assert row.up == (0, 90, 0)
    assert row.hollow and row.confirmed and not row.hideable


@pytest.mark.parametrize(
    ("line", "pattern"),
    [
        (GOOD.replace("0.1,0.4", "heavy,0.4"), "line 3, mass"),
        (GOOD.replace("0.1,0.4", "-1,0.4"), "line 3, mass"),
        (GOOD.replace("0;90;0", "0;90"), "line 3, up"),
        (GOOD.replace("mug,red", "Mug!,red", 1), "line 3, id"),
        (GOOD + ",surplus", "line 3"),
        ("mug,red mug", "line 3"),
        (GOOD.replace("mug,red mug", "mug2,red mug"), "'red mug' is there twice"),
        (GOOD.replace("red mug", "blue mug"), "'mug' is there twice"),
    ],
)
def test_a_bad_line_is_named(line, pattern):
    with pytest.raises(BadData, match=rf"x\.csv.*{pattern}"):
        parse_scans(f"{HEAD}\n{GOOD}\n{line}\n", "x.csv")


def test_our_catalogue_is_valid():
    rows = scan_rows()
    assert len(rows) == 165
    assert sum(row.confirmed for row in rows) > 80


def test_every_confirmed_scan_has_a_source(assets):
    sources = scan_sources(assets / "scans")
    assert all(row.id in sources for row in scan_rows() if row.confirmed)


def test_a_missing_index_is_named(tmp_path):
    with pytest.raises(BadData, match=r"index\.csv.*PROBE_ASSETS"):
        scan_sources(tmp_path)
