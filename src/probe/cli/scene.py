"""`probe scene`: a settled table from a seed, as pictures and JSON."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from probe.api.resources import Pool, assets_folder, cache_folder, library
from probe.assets.library import Library
from probe.assets.looks import NEWEST_LOOKS, Looks
from probe.assets.tables import table_ids
from probe.cli.metavars import Seed
from probe.cli.numbers import check_numbers
from probe.cli.screen import say, sign, track
from probe.errors import BadData
from probe.files import check_writable, encode, write_bytes, write_picture
from probe.render.illumination import Illumination
from probe.render.lighting import light_of, require_light
from probe.render.photograph import load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.report.gallery import GalleryEntry, write_gallery
from probe.report.pictures import depth_image, label_image
from probe.scene.cameras import View
from probe.scene.document import write_scene
from probe.scene.lighting import lighting_of
from probe.scene.sampling import DEFAULT_COUNT, TIGHT, PileSettings
from probe.scene.scene import Scene
from probe.scene.setup import UR5_TABLE, RendererName, Setup, newest
from probe.scene.setup_file import read_setup
from probe.scene.visibility import Visibility
from probe.world.scenes import SettledScene, draw_scene

PAGE = "index.html"
_MANY = 40
"""Objects that take so long to settle that it has to be said."""


def scene(
    seed: Seed,
    out: Path = Path("outputs/scene"),
    pool: Pool = "procedural",
    objects: int = DEFAULT_COUNT,
    reach: float = TIGHT.reach,
    buried: int = TIGHT.buried,
    gallery: int = 0,
    lighting: str | None = None,
    looks: Looks = NEWEST_LOOKS,
    camera: View = "top",
    renderer: RendererName = "filament",
    setup: Path | None = None,
) -> None:
    """Settle a cluttered table from a seed and photograph it.

    Writes picture.png, depth.png (16 bit, 0.1 mm), labels.png (value = instance) and scene.json.

    Args:
        seed: A whole number, 0 or above; the same seed gives the same bytes.
        out: Folder for the files.
        pool: Which objects may appear; scans need PROBE_ASSETS.
        objects: How many.
        reach: How far from the table's middle they are dropped, metres: less is denser.
        buried: How many of the smallest objects are put down first, each with a larger one right
            over it; at most half of the objects.
        gallery: If above 0, write this many scenes, from this seed on, and a page of them.
        lighting: By default the set-up's, or "day_room" where that is even: one of 48 rooms, by
            the table, or "day_room_7". "ambient" is even light without shadows; other surroundings
            are a painted room (docs/reference/looks.md) or a file's name in PROBE_ASSETS/hdris,
            without its ending.
        looks: How what is made by formula looks; 1 as in the suite v1, clean, or 2, used.
        camera: From above, or obliquely from the front.
        renderer: What draws colour; blender needs the extra of that name, and more time.
        setup: File of another set-up (docs/how-to/extend/add-a-setup.md); the scene keeps it.
    """
    check_numbers({"SEED": seed, "--objects": objects, "--buried": buried, "--gallery": gallery})
    if 2 * buried > objects:
        reason = f"of {objects} objects, {buried} can't lie under others"
        raise BadData("--buried", reason, "Say at most half of --objects")
    _check_gallery(out, range(seed, seed + gallery))
    check_writable(out)
    around = newest(read_setup(setup) if setup else UR5_TABLE, lighting, looks, renderer)
    with sign("Reading the catalogue of objects ..."):
        things = library(pool)
    require_light(around.lighting, things.assets)
    recipe = _Recipe(things, objects, PileSettings(reach, buried), around)
    with Renderer(cache_folder() / "light", renderer) as drawing:
        studio = _Studio(drawing, camera, things.assets)
        if gallery == 0:
            if objects > _MANY:
                say(f"Settling {objects} objects; over {_MANY} may take minutes.")
            with sign(f"Settling {objects} objects and drawing them ..."):
                drawn = [recipe.settle(seed)]
                _write(out, drawn[0].scene, things, studio)
            say(f"Picture, depth, labels and scene are in {out}")
        else:
            drawn = _gallery(out, range(seed, seed + gallery), recipe, studio)
            say(f"{gallery} scenes are in {out / 'index.html'}")
    again = sum(each.restless > 0 for each in drawn)
    if again:
        say(f"Drawn again, because something moved on the rebuilt table: {again} of {len(drawn)}")


def _check_gallery(out: Path, wanted: range) -> None:
    """See that no gallery of other scenes is in the folder.

    Raises:
        BadData: One is.
    """
    if not (out / PAGE).exists():
        return
    there = {int(it.name) for it in out.iterdir() if it.is_dir() and it.name.isdecimal()}
    if not there <= set(wanted):
        raise BadData(out, f"holds a gallery of {len(there)} other scenes", "Say another --out")


@dataclass(frozen=True)
class _Studio:
    """What takes the pictures: a renderer, where it looks from, and where panoramas lie."""

    renderer: Renderer
    camera: View
    assets: Path | None

    def light(self, setup: Setup, table: str) -> Illumination:
        return light_of(lighting_of(setup.lighting, table), self.assets)


@dataclass(frozen=True)
class _Recipe:
    """What scenes are made of."""

    things: Library
    count: int
    pile: PileSettings
    setup: Setup

    def settle(self, seed: int) -> SettledScene:
        tables = table_ids(assets_folder())
        return draw_scene(seed, self.things, tables, self.count, self.pile, self.setup)


def _gallery(out: Path, seeds: range, recipe: _Recipe, studio: _Studio) -> list[SettledScene]:
    """Draw and write many scenes and the page of them."""
    drawn: list[SettledScene] = []
    entries: list[GalleryEntry] = []
    for seed in track(seeds, "Settling and drawing"):
        drawn.append(recipe.settle(seed))
        shares = _write(out / str(seed), drawn[-1].scene, recipe.things, studio)
        entries.append(_entry(drawn[-1].scene, shares, recipe.things))
    write_gallery(out / PAGE, entries)
    return drawn


def _write(folder: Path, settled: Scene, things: Library, studio: _Studio) -> dict[int, Visibility]:
    """Draw one scene and write its files; the scene comes last and so marks a complete folder."""
    renderer, camera = studio.renderer, settled.setup.camera(studio.camera)
    load_scene(renderer, settled, things)
    frame = photograph(
        renderer, settled, camera=camera, light=studio.light(settled.setup, settled.table)
    )
    assert frame.rgb is not None and frame.labels is not None
    write_picture(folder / "picture.png", frame.rgb)
    write_bytes(folder / "depth.png", encode(depth_image(frame.depth), "PNG"))
    write_bytes(folder / "labels.png", encode(label_image(frame.labels), "PNG"))
    write_scene(folder / "scene.json", settled)
    return measure(renderer, settled, camera)


def _entry(settled: Scene, shares: dict[int, Visibility], things: Library) -> GalleryEntry:
    objects = tuple(
        (things[item.object_id].name, shares[item.instance].fraction) for item in settled.objects
    )
    folder = str(settled.seed)
    return GalleryEntry(
        f"Seed {settled.seed}", f"{folder}/picture.png", f"{folder}/labels.png", objects
    )
