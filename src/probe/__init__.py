"""PROBE: questions about a cluttered table that only moving things can answer."""

import os as _os
import sys as _sys
from platform import machine as _machine

_binding = {
    # With AVX-512, OpenBLAS and NumPy (2.4's names) round otherwise than without it, and piles fall
    # another way. Both look when NumPy is first imported: whoever needs the same, imports us first.
    "OPENBLAS_CORETYPE": "Haswell",
    "NPY_DISABLE_CPU_FEATURES": "X86_V4 AVX512_ICL AVX512_SPR",
}
_here = _machine() in {"x86_64", "AMD64"}
_late = "numpy" in _sys.modules and not _binding.items() <= _os.environ.items()

if _here:
    for _name, _value in _binding.items():
        _os.environ.setdefault(_name, _value)

SUMS_BOUND = not _here or (not _late and _binding.items() <= _os.environ.items())
"""Whether this process's sums come out as on other machines: not if NumPy was there before us, nor
if the environment says otherwise."""

__version__ = "0.1.0"
