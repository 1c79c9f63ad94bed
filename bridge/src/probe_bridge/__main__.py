"""python -m probe_bridge is the command probe-bridge."""

from __future__ import annotations

import sys

from probe_bridge.command import main

sys.exit(main())
