"""Bodies of procedural objects through the cache."""

import numpy as np
import pytest

from probe.assets.cache import Cache
from probe.assets.pools import procedural
from probe.assets.pools.procedural import procedural_body
from probe.assets.procedural import build
from probe.assets.procedural.tables import entries
from probe.errors import UnknownName


def test_data_files_are_read_once_for_all_objects(tmp_path, monkeypatch):
    bodies, data = Cache(tmp_path / "bodies"), Cache(tmp_path / "specs")
    procedural_body("proc_red_mug", bodies, data)

    def read_again(edition):
        raise AssertionError("the data files were read again")

    monkeypatch.setattr(procedural, "entries", read_again)
    for object_id in ("proc_pear", "proc_red_mug"):
        kept, fresh = procedural_body(object_id, bodies, data, 2), build(object_id, 2)
        assert np.array_equal(kept.mesh.surface.texture, fresh.mesh.surface.texture)
        assert np.array_equal(kept.mesh.vertices, fresh.mesh.vertices)
        assert len(kept.pieces) == len(fresh.pieces)
        for one, other in zip(kept.pieces, fresh.pieces, strict=True):
            assert np.array_equal(one.vertices, other.vertices)


@pytest.mark.slow
def test_what_is_kept_of_each_object_is_what_the_files_say(tmp_path):
    data = Cache(tmp_path)
    for _ in ("made", "read"):
        procedural._texts.cache_clear()
        for object_id, entry in entries(2).items():
            assert procedural._entry(object_id, data) == entry


def test_an_unknown_object_is_refused(tmp_path):
    with pytest.raises(UnknownName, match="proc_red_mugg"):
        procedural_body("proc_red_mugg", Cache(tmp_path), Cache(tmp_path))
