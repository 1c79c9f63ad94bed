"""Our convex pieces beside CoACD's: `python benchmarks/internals/collision.py --help`.

Measures internals, not the public API. Needs `pip install coacd`, and PROBE_ASSETS for scans. Of
each object: how many pieces, CPU seconds to find them, how far the true surface lies from that of
the pieces together, how much of a cavity they leave open, and whether and how fast piles of five
such objects come to rest. An hour on one core, a quarter with `--quick`.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import tyro

import probe  # before NumPy's first sum: piles fall the same everywhere
from probe.api.resources import Pool, library
from probe.assets.collision.cavity import find_cavity
from probe.assets.collision.hulls import hull_of
from probe.assets.collision.pieces import convex_pieces
from probe.assets.mesh.lattice import lattice_points
from probe.assets.mesh.mesh import Body, ConvexPiece, TexturedMesh
from probe.assets.spec import ObjectSpec
from probe.cli.shards import parse_shard
from probe.errors import Unsatisfiable
from probe.scene.sampling import draw_drop
from probe.types import Array
from probe.world.model import Item
from probe.world.settle import settle

Pieces = tuple[ConvexPiece, ...]
COPIES = 5
MOST_PIECES, MOST_CORNERS = 24, 63
"""What ours are bound to, and the other is bound to as well."""


@dataclass(frozen=True)
class Measured:
    """Figures of one object's pieces.

    Attributes:
        pieces: How many.
        seconds: CPU time to find them.
        off: Mean distance of the object's surface from the pieces', metres.
        off_95: The same, 95th percentile.
        open: Share of the cavity that is left open; NaN without one.
        settled: Share of piles that came to rest.
        settling: CPU seconds for each pile that did.
    """

    pieces: int
    seconds: float
    off: float
    off_95: float
    open: float
    settled: float
    settling: float


QUICK = {
    "preprocess_resolution": 30,
    "mcts_iterations": 60,
    "mcts_nodes": 10,
    "mcts_max_depth": 2,
}
"""CoACD's least settings, for a quarter of the time."""


def coacd_pieces(mesh: TexturedMesh, settings: dict[str, int]) -> Pieces:
    """CoACD's, with its own threshold and our limits; it takes all objects alike."""
    import coacd  # pyright: ignore[reportMissingImports]

    library: Any = coacd
    library.set_log_level("error")
    parts = library.run_coacd(
        library.Mesh(mesh.vertices.astype(float), mesh.faces.astype(int)),
        max_convex_hull=MOST_PIECES,
        max_ch_vertex=MOST_CORNERS,
        decimate=True,
        seed=0,
        **settings,
    )
    return tuple(ConvexPiece(np.asarray(corners)) for corners, _ in parts)


def distances(mesh: TexturedMesh, pieces: Pieces) -> Array:
    """Of points on an object's surface from that of its pieces together, metres, inside or out."""
    step = float(np.ptp(mesh.vertices, axis=0).max()) / 40
    points = lattice_points(mesh.vertices.astype(float), mesh.faces, step)
    nearest = np.full(len(points), np.inf)
    for piece in pieces:
        hull = hull_of(piece.vertices)
        if hull is not None:
            outside = points @ hull.equations[:, :3].T + hull.equations[:, 3]
            nearest = np.minimum(nearest, outside.max(axis=1))
    return np.abs(nearest)


def piles(spec: ObjectSpec, body: Body, seeds: int) -> tuple[float, float]:
    """Share of piles of copies that come to rest, and mean CPU seconds of these."""
    times: list[float] = []
    for seed in range(seeds):
        rng = np.random.default_rng(seed)
        items = [Item(number, spec, body) for number in range(1, COPIES + 1)]
        drops = {item.instance: draw_drop(rng) for item in items}
        start = time.process_time()
        try:
            settle(items, drops, rng)
        except Unsatisfiable:
            continue
        times.append(time.process_time() - start)
    return len(times) / seeds, float(np.mean(times)) if times else math.nan


def measured(
    spec: ObjectSpec, mesh: TexturedMesh, method: Callable[[TexturedMesh, bool], Pieces], seeds: int
) -> Measured:
    """All figures of one object by one method."""
    start = time.process_time()
    pieces = method(mesh, spec.hollow)
    seconds = time.process_time() - start
    off = distances(mesh, pieces)
    cavity = find_cavity(mesh.vertices.astype(float), mesh.faces) if spec.hollow else None
    open_share = cavity.kept([piece.vertices for piece in pieces]) if cavity else math.nan
    settled, settling = piles(spec, Body(mesh, pieces), seeds)
    off_95 = float(np.percentile(off, 95))
    return Measured(len(pieces), seconds, float(off.mean()), off_95, open_share, settled, settling)


def spread(specs: Sequence[ObjectSpec], count: int) -> list[ObjectSpec]:
    """So many of them, each of another category, evenly over the list."""
    kinds = list({spec.category: spec for spec in reversed(specs)}.values())[::-1]
    return [kinds[int(at)] for at in np.linspace(0, len(kinds) - 1, min(count, len(kinds)))]


def main(
    procedural: int = 30,
    scans: int = 10,
    seeds: int = 3,
    quick: bool = False,
    shard: str = "0/1",
) -> None:
    """Print a line for each object and method, and the methods' ratios.

    Args:
        procedural: Objects of the procedural pool.
        scans: Real scans.
        seeds: Piles of each object.
        quick: Have CoACD search less, on a coarser mesh.
        shard: "0/2" and "1/2" in two processes share the work; each sums up its own.
    """
    settings = QUICK if quick else {}

    def other_pieces(mesh: TexturedMesh, hollow: bool) -> Pieces:
        return coacd_pieces(mesh, settings)

    found: dict[str, list[tuple[Measured, Measured]]] = {}
    pools: dict[Pool, int] = {"procedural": procedural, "scans": scans}
    for pool, count in pools.items():
        if not count:
            continue
        things = library(pool)
        for spec in parse_shard(shard).of(spread(things.specs, count)):
            mesh = things.body(spec.id).mesh
            ours = measured(spec, mesh, convex_pieces, seeds)
            other = measured(spec, mesh, other_pieces, seeds)
            print(f"{spec.id}\n  ours  {ours}\n  CoACD {other}", flush=True)
            found.setdefault(f"{pool}{', hollow' if spec.hollow else ''}", []).append((ours, other))
    for name, pairs in found.items():
        print(f"{name}, n = {len(pairs)}: " + "; ".join(_ratios(pairs)))


def _ratios(pairs: Sequence[tuple[Measured, Measured]]) -> list[str]:
    lines: list[str] = []
    for field in Measured.__dataclass_fields__:
        ours, other = (np.array([getattr(pair[side], field) for pair in pairs]) for side in (0, 1))
        both = np.isfinite(ours) & np.isfinite(other)
        if both.any():
            a, b = float(ours[both].mean()), float(other[both].mean())
            ratio = f", CoACD / ours {b / a:.2f}" if a else ""
            lines.append(f"{field} {a:.4g} against {b:.4g}{ratio}")
    return lines


if __name__ == "__main__":
    print(f"probe {probe.__version__}")
    tyro.cli(main)
