"""Things in use: the same shapes and nearly the same colours, other surfaces."""

import numpy as np
import pytest

from probe.assets.procedural import build


@pytest.fixture(scope="module", params=["proc_blue_mug", "proc_straw_hat"])
def both(request):
    return build(request.param), build(request.param, 2)


def test_only_the_surface_differs(both):
    new, used = both
    for name in ("vertices", "normals", "uvs", "faces"):
        assert np.array_equal(getattr(new.mesh, name), getattr(used.mesh, name))
    pairs = zip(new.pieces, used.pieces, strict=True)
    assert all(np.array_equal(one.vertices, other.vertices) for one, other in pairs)
    assert (new.mesh.surface.normal, new.mesh.surface.roughness_map) == (None, None)


def test_its_gloss_and_relief_vary(both):
    surface = both[1].mesh.surface
    assert np.ptp(surface.roughness_map) > 20
    assert surface.normal[..., :2].std() > 1


def test_its_colours_stay_about_the_same_and_fade(both):
    new, used = (body.mesh.surface.texture.reshape(-1, 3).astype(float) for body in both)
    assert np.abs(new.mean(axis=0) - used.mean(axis=0)).max() < 16
    assert np.ptp(used, axis=1).mean() < np.ptp(new, axis=1).mean()


def test_it_looks_the_same_each_time():
    one, other = (build("proc_blue_mug", 2).mesh.surface for _ in range(2))
    for name in ("texture", "normal", "roughness_map"):
        assert np.array_equal(getattr(one, name), getattr(other, name))
