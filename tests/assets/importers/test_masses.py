"""Masses that stand in files beside a mesh, and none that don't."""

import pytest

from data_sets import box, obj_folder
from probe.assets.importers.adding import find_sources
from probe.assets.importers.masses import stated_mass
from probe.assets.importers.normalised import normalised
from probe.assets.importers.options import ImportOptions

URDF = """<robot name="r"><link name="table"><inertial><mass value="20"/></inertial></link>
<link name="tin"><inertial><mass value="0.3"/></inertial><visual><geometry>
<mesh filename="package://things/tin/model.obj"/></geometry></visual></link></robot>"""
SDF = """<sdf><model><link><inertial><mass>0.3</mass></inertial></link></model></sdf>"""
MJCF = """<mujoco><asset><mesh file="model.obj"/></asset><worldbody>
<body><geom type="box" size="1 1 1" mass="9"/></body>
<body><geom mesh="model" type="mesh" mass="0.2"/><geom type="sphere" mass="0.1"/></body>
</worldbody></mujoco>"""


@pytest.fixture
def mesh(tmp_path):
    return obj_folder(tmp_path / "things" / "tin")


def _stated(mesh):
    return stated_mass(mesh, mesh.parent, mesh.parents[1])


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("tin/tin.urdf", URDF),
        ("tin/model.sdf", SDF),
        ("tin/model.xml", MJCF),
        ("tin/facts.csv", "name,colour,mass_kg\ntin,red,0.3\n"),
        ("masses.csv", "Object,Mass [g]\nbox,12\ntin,300\n"),
        ("masses.csv", "file,weight (g)\ntin/model.obj,300\n"),
    ],
)
def test_a_mass_beside_a_mesh_is_read(mesh, name, text):
    (mesh.parents[1] / name).write_text(text)
    assert _stated(mesh) == (pytest.approx(0.3), ())
    (source,) = find_sources(mesh.parents[1], ImportOptions("obj"))
    entry = normalised(source, ImportOptions("obj"))[1]
    assert entry.mass == pytest.approx(0.3) and entry.provenance["mass"] == "source"


@pytest.mark.parametrize(
    ("name", "text", "remark"),
    [
        ("tin.urdf", '<!DOCTYPE a [<!ENTITY b "c">]>' + URDF, "defines entities"),
        ("tin.urdf", "<robot", "is no XML"),
        ("tin.urdf", URDF.replace("0.3", "heavy"), "'heavy'"),
        ("tin.urdf", URDF.replace("0.3", "0"), "a mass of 0 kg, which is not used"),
        ("masses.csv", "name,mass\ntin,0.3\n", "'mass' states no unit"),
        ("masses.csv", "name,mass_g\ntin,much\n", "'much'"),
    ],
)
def test_what_cant_be_used_is_said_and_the_object_still_let_in(mesh, name, text, remark):
    (mesh.parent / name).write_text(text)
    mass, remarks = _stated(mesh)
    assert mass is None and remark in remarks[0]
    (source,) = find_sources(mesh.parents[1], ImportOptions("obj"))
    assert remark in " ".join(normalised(source, ImportOptions("obj"))[1].remarks)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("tin/notes.xml", "<notes/>"),
        ("tin/prices.csv", "name,price\ntin,3\n"),
        ("masses.csv", "name,mass_g\nbox,12\n"),
        ("tin/scene.urdf", URDF.replace("tin/model.obj", "cup/model.obj")),
    ],
)
def test_files_about_other_things_say_nothing(mesh, name, text):
    (mesh.parents[1] / name).write_text(text)
    assert _stated(mesh) == (None, ())


def test_nothing_above_the_folder_that_was_asked_for_is_read(mesh):
    (mesh.parents[2] / "masses.csv").write_text("name,mass_g\ntin,300\n")
    assert _stated(mesh) == (None, ())


def test_a_gazebo_folder_s_words_still_name_it_in_the_middle_of_others(tmp_path):
    obj_folder(tmp_path / "a" / "tin", box((0.1, 0.06, 0.05)))
    obj_folder(tmp_path / "b" / "tin")
    (tmp_path / "masses.csv").write_text("folder,mass_g\na/tin,100\nb/tin,200\n")
    for folder, mass in (("a", 0.1), ("b", 0.2)):
        file = tmp_path / folder / "tin" / "model.obj"
        assert stated_mass(file, file.parent, tmp_path)[0] == pytest.approx(mass)
