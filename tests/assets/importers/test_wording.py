"""Names that a person would give, from places where files say nothing."""

from pathlib import Path

import pytest

from probe.assets.importers.wording import draft_name, id_words, place_of, speaking_root


@pytest.mark.parametrize(
    ("file", "root", "name", "id_part", "home"),
    [
        ("ycb/003_apple/google_16k/textured.obj", "ycb", "apple", "apple", "ycb/003_apple"),
        ("ycb/apple/textured.obj", "ycb", "apple", "apple", "ycb/apple"),
        ("ycb/apple/textured.obj", "ycb/apple", "apple", "apple", "ycb/apple"),
        ("ycb/065-a_cups/poisson/nontextured.obj", "ycb", "cups", "cups", "ycb/065-a_cups"),
        ("gso/Red_Mug_900028/meshes/model.obj", "gso", "red mug", "red_mug", "gso/Red_Mug_900028"),
        ("x/Cap_oo1qph4wwiW/meshes/model.obj", "x", "cap", "cap", "x/Cap_oo1qph4wwiW"),
        ("pkg/meshes/visual/cup_visual.obj", "pkg", "cup", "cup", "pkg"),
        ("objects/apple/v2/mesh_final.obj", "objects", "apple", "apple", "objects/apple"),
        ("objects/remote_1.glb", "objects", "remote", "remote_1", "objects"),
        ("objects/RedMug.obj", "objects", "red mug", "red_mug", "objects"),
        # Nothing says anything, and a folder of numbered ones names none of them.
        ("set/0/model.obj", "set", "model", "model", "set/0"),
        ("scans/obj_000001.obj", "scans", "obj 000001", "obj_000001", "scans"),
        ("mine/7.obj", "mine", "object 7", "7", "mine"),
    ],
)
def test_the_nearest_place_that_says_something_names_an_object(file, root, name, id_part, home):
    raw, found = place_of(Path(file), Path(root))
    assert (draft_name(raw), id_words(raw)) == (name, id_part)
    assert found == Path(home).absolute()


def test_long_names_end_with_a_word_and_fit_the_table():
    whole = "razer kraken pro headset full size black with cable"
    name = draft_name("Razer_Kraken_Pro_headset_Full_size_Black_with_cable")
    assert len(name) <= 40 and whole.startswith(f"{name} ")


def test_one_file_or_a_technical_folder_is_named_by_what_holds_it(tmp_path):
    home = tmp_path / "apple" / "google_16k"
    home.mkdir(parents=True)
    (home / "textured.obj").touch()
    assert speaking_root(home / "textured.obj") == speaking_root(home) == tmp_path / "apple"
