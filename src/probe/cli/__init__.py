"""The command line: `probe demo | scene | assets | suite | run | merge | report | ...`."""

from __future__ import annotations

import sys

import tyro

from probe.cli.assets import app as assets_app
from probe.cli.demo import demo
from probe.cli.human import human
from probe.cli.merge import merge
from probe.cli.report import report
from probe.cli.rescore import rescore
from probe.cli.robustness import robustness
from probe.cli.run import run
from probe.cli.scene import scene
from probe.cli.serve import serve
from probe.cli.suite import app as suite_app
from probe.cli.tools import app as tools_app
from probe.errors import ProbeError

app = tyro.extras.SubcommandApp()
for command in (demo, scene, run, merge, report, rescore, robustness, serve, human):
    app.command(command)
app.command(assets_app, name="assets")
app.command(suite_app, name="suite")
app.command(tools_app, name="tools")


def main() -> None:
    """Run the command line; expected failures become one line and exit status 1."""
    try:
        app.cli(prog="probe", description="Questions that only moving things can answer.")
    except ProbeError as failure:
        sys.exit(f"probe: {failure}")
    except KeyboardInterrupt:
        sys.exit("probe: interrupted")
