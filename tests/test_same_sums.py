"""Importing the package first makes sums come out alike on machines with and without AVX-512."""

from __future__ import annotations

import json
import os
import platform
import subprocess
import sys

import pytest

SAY = """
import json
import probe, numpy
from numpy._core._multiarray_umath import __cpu_dispatch__, __cpu_features__
from threadpoolctl import threadpool_info
blas = [pool["architecture"] for pool in threadpool_info() if pool["user_api"] == "blas"]
used = [name for name in __cpu_dispatch__ if __cpu_features__[name]]
print(json.dumps({"numpy": used, "blas": blas}))
"""


@pytest.mark.skipif(platform.machine() != "x86_64", reason="about x86-64's instructions")
def test_neither_numpy_nor_its_blas_uses_avx512():
    own = {"OPENBLAS_CORETYPE", "NPY_DISABLE_CPU_FEATURES"}
    bare = {name: value for name, value in os.environ.items() if name not in own}
    child = [sys.executable, "-W", "error", "-c", SAY]
    said = subprocess.run(child, env=bare, check=True, capture_output=True, text=True).stdout
    assert json.loads(said) == {"numpy": ["X86_V3"], "blas": ["Haswell"]}


KEY = """
from pathlib import Path
from probe.assets.cache import Cache
print(Cache(Path("cache")).path("ab"))
"""


@pytest.mark.skipif(platform.machine() != "x86_64", reason="about x86-64's instructions")
def test_what_other_sums_gave_is_kept_under_another_name():
    own = {"OPENBLAS_CORETYPE", "NPY_DISABLE_CPU_FEATURES"}
    bare = {name: value for name, value in os.environ.items() if name not in own}

    def key(code: str, **more: str) -> str:
        child = [sys.executable, "-c", code]
        return subprocess.run(
            child, env={**bare, **more}, check=True, capture_output=True, text=True
        ).stdout

    first, late = key(KEY), key(f"import numpy\n{KEY}")
    assert first != late
    assert key(KEY, OPENBLAS_CORETYPE="SkylakeX") == late
    assert key(KEY, NPY_DISABLE_CPU_FEATURES="AVX512_SPR") == late
    # A process that is started by one of ours has the same sums, whatever it imports first.
    features = "X86_V4 AVX512_ICL AVX512_SPR"
    bound = key(
        f"import numpy\n{KEY}", OPENBLAS_CORETYPE="Haswell", NPY_DISABLE_CPU_FEATURES=features
    )
    assert bound == first
