"""`probe assets fetch v1-scans`: the scans of a packaged suite, where the suite finds them."""

from __future__ import annotations

from pathlib import Path

from probe.api.resources import assets_folder, cache_folder
from probe.api.suites import load_suite
from probe.assets.cache import Cache
from probe.assets.fetching.download import Progress
from probe.assets.fetching.scan_manifest import ScanFile, scan_collections, scan_files
from probe.assets.fetching.suite_scans import ScanFetching, fetch_all
from probe.assets.folders import fetched_folder
from probe.cli.screen import download_bar, say, say_above
from probe.errors import ProbeError

SCANS = "v1-scans"


def fetch_suite_scans(out: Path | None, mirror: str | None) -> None:
    """Fetch what isn't there yet.

    Args:
        out: Gets the folder scans/; None for where commands look for it.
        mirror: Address of a folder with the finished files.

    Raises:
        BadData: Some scans are missing afterwards.
        OutputFailed: The disk is full, or the folder can't be written.
    """
    home = out or assets_folder() or fetched_folder()
    scans, prints = scan_files(), load_suite(SCANS).objects
    cache = Cache(cache_folder() / "bodies")
    fetching = ScanFetching(home / "scans", scan_collections(), prints, cache, mirror)
    with download_bar() as bar:
        task = bar.add_task(SCANS, total=None)

        def progress(scan: ScanFile) -> Progress:
            number = scans.index(scan) + 1
            bar.update(task, description=f"{scan.id} ({number} of {len(scans)})", completed=0)
            return lambda there, total: bar.update(task, completed=there, total=total)

        def failed(scan: ScanFile, error: ProbeError) -> None:
            say_above(bar, f"{scan.id}: {error}")

        fetch_all(scans, fetching, progress, failed)
    say(f"All {len(scans)} scans are in {fetching.folder}")
    if home != assets_folder():
        say(f"Next: export PROBE_ASSETS={home.resolve()}")
    say(f"Licences: {fetching.folder / 'index.csv'}. Check: probe suite verify {SCANS} --no-solve")
