"""Does this machine have what every command needs?"""

from __future__ import annotations

import platform
import sys
from collections.abc import Iterator

from probe import SUMS_BOUND
from probe.api.resources import cache_folder
from probe.cli.health.packages import installing, lacking
from probe.cli.health.requirement import Requirement
from probe.errors import NoGraphicsDriver, OutputFailed
from probe.files import check_writable
from probe.render.driver import require_driver

_DRIVER = "apt-get install mesa-vulkan-drivers libvulkan1"


def core_findings() -> Iterator[Requirement]:
    """What nothing works without, then whether sums come out as elsewhere."""
    version = platform.python_version()
    here = f"{version} on {platform.system()}, {platform.machine()}"
    fit = sys.version_info >= (3, 11) and platform.system() == "Linux"
    yield Requirement("Python", fit, here, "everything", "make demo PYTHON=python3.11", core=True)
    missing = lacking()
    found = f"missing: {', '.join(missing)}" if missing else "all are installed"
    yield Requirement("packages", not missing, found, "everything", installing(), core=True)
    yield _driver()
    yield _cache()
    words = "as on other machines" if SUMS_BOUND else "sums may differ in their last bits"
    use = "the same bytes as on other machines (docs/decisions/0020-the-same-sums-everywhere.md)"
    remedy = "unset OPENBLAS_CORETYPE NPY_DISABLE_CPU_FEATURES"
    yield Requirement("arithmetic", SUMS_BOUND, words, use, remedy)


def _driver() -> Requirement:
    use = "pictures, and so every episode"
    try:
        require_driver()
    except NoGraphicsDriver as lack:
        said = str(lack).partition(". ")[0]
        return Requirement("Vulkan driver", False, said, use, _DRIVER, core=True)
    return Requirement("Vulkan driver", True, "offers a device", use, core=True)


def _cache() -> Requirement:
    folder, use = cache_folder(), "objects that were computed once"
    try:
        check_writable(folder)
    except OutputFailed as failure:
        remedy = "export XDG_CACHE_HOME=FOLDER"
        return Requirement("cache", False, str(failure).partition(". ")[0], use, remedy, core=True)
    return Requirement("cache", True, str(folder), use, core=True)
