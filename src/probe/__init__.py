"""PROBE: questions about a cluttered table that only moving things can answer."""

import os as _os
from platform import machine as _machine

if _machine() in {"x86_64", "AMD64"}:
    # With AVX-512, OpenBLAS and NumPy (2.4's names) round otherwise than without it, and piles fall
    # another way. Both look when NumPy is first imported: whoever needs the same, imports us first.
    _os.environ.setdefault("OPENBLAS_CORETYPE", "Haswell")
    _os.environ.setdefault("NPY_DISABLE_CPU_FEATURES", "X86_V4 AVX512_ICL AVX512_SPR")

__version__ = "0.1.0"
