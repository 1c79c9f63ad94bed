import pytest
import yaml

from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.outcomes import FELT, SWEPT
from probe.toolshed.result import Answer
from probe.toolshed.toolshed import MANIPULATIONS, TURNS, Toolshed
from tabletops import Block, PaintedStation, paint


def handle(shed, words):
    return yaml.safe_load(shed.call("find_object", {"description": words}).text)["object_id"]


def listed(shed):
    return yaml.safe_load(shed.call("perceive_scene", {}).text)["objects"]


def test_perceive_tells_what_shows_and_no_more(shed, station):
    result = shed.call("perceive_scene", {})
    graph = yaml.safe_load(result.text)
    assert [o.get("name") for o in graph["objects"]] == [
        "red mug",
        None,
        "white ball",
        "blue book",
    ]
    assert graph["objects"][0]["box"] == [100, 100, 219, 219]
    assert graph["objects"][0]["description"] == "A red mug."
    assert "green" in graph["objects"][1]["description"]
    assert (result.picture == paint(station.blocks).rgb).all()
    assert not result.ended


def test_relations_and_regions(shed):
    graph = yaml.safe_load(shed.call("perceive_scene", {}).text)
    assert set(graph["relations"]) >= {"3 on 4", "2 above 4"}
    assert not any(r.startswith("1 ") or r.endswith(" 1") for r in graph["relations"])
    assert "middle centre" in graph["cluttered"] and "top right" in graph["clear"]


def test_find_gives_a_handle_and_marks_it(shed, station):
    result = shed.call("find_object", {"description": "the red mug"})
    found = yaml.safe_load(result.text)
    assert found["object_id"] == "object_1" and found["name"] == "red mug"
    u, v = found["point"]
    changed = (result.picture != paint(station.blocks).rgb).any(axis=2)
    assert changed.any() and not changed[v, u]
    assert result.point_px == (u, v)


def test_hidden_and_absent_read_the_same(shed, station):
    station.blocks.append(Block(45, (605, 455, 640, 500), height=0.01))
    hidden = shed.call("find_object", {"description": "yellow duck"})
    absent = shed.call("find_object", {"description": "purple hammer"})
    assert hidden.text == absent.text
    assert (hidden.picture == absent.picture).all()
    assert hidden.status == "failed"


def test_everything_that_is_listed_can_be_moved_at_once(shed, skills):
    graph = yaml.safe_load(shed.call("perceive_scene", {}).text)
    ids = [item["object_id"] for item in graph["objects"]]
    assert ids == ["object_1", "object_2", "object_3", "object_4"]
    ball = next(item for item in graph["objects"] if item.get("name") == "white ball")
    done = shed.call("grasp_and_remove", {"object_id": ball["object_id"]})
    assert done.status == "done" and skills.calls == [("grasp", 80 * 80, UR5_TABLE)]


def test_a_thing_keeps_its_id_and_what_moved_gets_a_new_one(shed):
    mug = handle(shed, "red mug")
    first = {i["name"]: i["object_id"] for i in listed(shed) if "name" in i}
    assert first["red mug"] == mug == handle(shed, "red mug")
    arguments = {"object_id": first["white ball"], "direction": "right", "distance_cm": 5}
    shed.call("push", arguments)
    then = {i["name"]: i["object_id"] for i in listed(shed) if "name" in i}
    assert then["red mug"] == mug and then["white ball"] not in first.values()


def test_words_that_nothing_fits_bring_a_list_to_act_on(shed):
    reply = shed.call("find_object", {"description": "the green mug"})
    assert reply.status == "failed" and reply.point_px is None
    assert reply.text.startswith(
        "Nothing that shows is called 'the green mug'. Nearest: object_1, "
    )
    assert "red mug, at [159, 159]" in reply.text
    assert shed.call("grasp_and_remove", {"object_id": "object_1"}).status == "done"


def test_what_was_found_by_likeness_says_so(shed):
    literal = yaml.safe_load(shed.call("find_object", {"description": "red mug"}).text)
    alike = yaml.safe_load(shed.call("find_object", {"description": "red cup"}).text)
    assert "note" not in literal and alike["name"] == "red mug"
    assert alike["object_id"] == literal["object_id"] and "comes nearest" in alike["note"]


def test_others_that_fit_as_well_have_ids(station, skills, specs):
    blocks = [*station.blocks, Block(45, (100, 600, 219, 719))]
    specs = specs | {45: specs[41]}
    shed = Toolshed(PaintedStation(blocks), Oracle(specs), skills, UR5_TABLE)
    found = yaml.safe_load(shed.call("find_object", {"description": "mug"}).text)
    (other,) = found["others_that_fit_as_well"]
    assert other == {"object_id": "object_2", "description": "red mug", "point": [159, 659]}
    assert shed.call("grasp_and_remove", {"object_id": "object_2"}).status == "done"


def test_others_that_may_be_meant_have_ids(shed):
    found = yaml.safe_load(shed.call("find_object", {"description": "striped mug"}).text)
    assert found["name"] == "red mug" and "not all of these words" in found["note"]
    ids = [other["object_id"] for other in found["others_that_may_be_meant"]]
    assert ids and found["object_id"] not in ids
    assert shed.call("grasp_and_remove", {"object_id": ids[0]}).status == "done"


def test_grasp_removes_and_shows_the_new_table(shed, station, skills):
    name = handle(shed, "white ball")
    result = shed.call("grasp_and_remove", {"object_id": name})
    assert result.text == (
        "Done: object_1 was lifted and dropped into the basket. Manipulations left: 9."
    )
    assert skills.calls == [("grasp", 80 * 80, UR5_TABLE)]
    assert (result.picture == paint(station.blocks).rgb).all()
    assert "white ball" not in shed.call("perceive_scene", {}).text


def test_push_hands_on_direction_and_metres(shed, skills):
    name = handle(shed, "white ball")
    arguments = {"object_id": name, "direction": "left", "distance_cm": 7.5}
    text = shed.call("push", arguments).text
    assert text.startswith("Done:") and f"{name} moved about 7 cm that way" in text
    assert skills.calls == [("push", "left", 0.075)]


@pytest.mark.parametrize("status", sorted(set(FELT) - {"removed"}))
def test_a_failed_grasp_says_what_else_could_help(shed, skills, status):
    name = handle(shed, "red mug")
    skills.status = status
    result = shed.call("grasp_and_remove", {"object_id": name})
    assert result.text.startswith("Failed: ") and result.status == "failed"
    assert result.text.endswith("Manipulations left: 9.")
    assert "red" not in result.text.split()


def test_a_grasp_and_a_push_that_nothing_leads_to_are_told_apart(shed, station, skills):
    """Both end before the arm moves, and each says of itself what could help."""
    name = handle(shed, "red mug")
    skills.status, skills.unmoved = "unreachable", True
    grasp = shed.call("grasp_and_remove", {"object_id": name}).text
    push = shed.call("push", {"object_id": name, "direction": "up", "distance_cm": 5}).text
    assert grasp == (
        f"Failed: no grip on {name} is within reach without hitting other objects. Nothing was "
        "moved. Push it to a freer place, or first clear what stands around it. "
        "Manipulations left: 9."
    )
    assert push == (
        "Failed: the arm can't make this push. Nothing was moved. Try another direction or a "
        "shorter distance, or grasp it. Manipulations left: 8."
    )


@pytest.mark.parametrize("status", sorted(set(SWEPT)))
def test_every_push_is_put_in_words(shed, skills, status):
    name = handle(shed, "red mug")
    skills.status = status
    arguments = {"object_id": name, "direction": "up", "distance_cm": 5}
    result = shed.call("push", arguments)
    assert result.text.split()[0] in ("Done:", "Failed:")
    assert result.picture is not None


def test_a_handle_goes_stale_when_its_pixels_change(shed, skills):
    name = handle(shed, "white ball")
    shed.call("push", {"object_id": name, "direction": "right", "distance_cm": 5})
    result = shed.call("grasp_and_remove", {"object_id": name})
    assert result.status == "malformed" and "out of date" in result.text
    assert len(skills.calls) == 1 and shed.manipulations == 1


def test_a_handle_stays_good_while_other_things_move(shed, skills):
    mug, ball = handle(shed, "red mug"), handle(shed, "white ball")
    shed.call("grasp_and_remove", {"object_id": ball})
    assert shed.call("grasp_and_remove", {"object_id": mug}).status == "done"


def test_a_handle_stays_good_when_more_of_its_thing_shows(shed, skills):
    book, ball = handle(shed, "blue book"), handle(shed, "white ball")
    shed.call("grasp_and_remove", {"object_id": ball})
    shed.call("grasp_and_remove", {"object_id": book})
    assert skills.calls[1][1] > skills.calls[0][1] + 300 * 400 - 80 * 80 * 2 - 400


def test_a_handle_goes_stale_when_something_covers_it_or_a_thin_thing_moves(shed, station, specs):
    station.blocks = [Block(41, (100, 100, 219, 219), height=0.001)]
    mug = Toolshed(station, Oracle(specs), shed._skills, UR5_TABLE)
    name = handle(mug, "red mug")
    station.blocks = [Block(41, (180, 100, 299, 219), height=0.001)]
    mug._view.show(station.observe(rgb=False))
    assert "out of date" in mug.call("grasp_and_remove", {"object_id": name}).text


def test_manipulations_are_budgeted_and_failures_count(shed, skills):
    name = handle(shed, "red mug")
    skills.status = "slipped"
    for left in reversed(range(MANIPULATIONS)):
        result = shed.call("grasp_and_remove", {"object_id": name})
        assert f"Manipulations left: {left}." in result.text
    refused = shed.call("push", {"object_id": name, "direction": "up", "distance_cm": 5})
    assert refused.status == "refused" and "used up" in refused.text
    assert len(skills.calls) == MANIPULATIONS
    assert shed.call("perceive_scene", {}).status == "done"


def test_a_question_may_allow_fewer_manipulations(station, skills, specs):
    shed = Toolshed(station, Oracle(specs), skills, UR5_TABLE, budget=1)
    name = handle(shed, "red mug")
    skills.status = "slipped"
    told = shed.call("grasp_and_remove", {"object_id": name}).text
    assert "Manipulations left: 0." in told
    refused = shed.call("grasp_and_remove", {"object_id": name})
    assert refused.status == "refused" and "all 1 manipulations are used up" in refused.text
    assert len(skills.calls) == 1


def test_turns_are_budgeted(shed):
    for _ in range(TURNS - 1):
        assert not shed.call("nonsense", {}).ended
    last = shed.call("perceive_scene", {})
    assert last.ended and last.text.endswith("last turn; the episode has ended.")
    after = shed.call("answer_question", {"choice": "A"})
    assert after.ended and shed.answer is None and shed.turns == TURNS


def test_the_answer_ends_the_episode(shed):
    result = shed.call("answer_question", {"choice": "b", "point": [512, 300]})
    assert result.ended and shed.answer == Answer("B", (512, 300))
    assert shed.call("perceive_scene", {}).text.startswith("The episode has ended")


def test_texts_are_the_same_without_pictures_and_colours_are_drawn_once(station, skills, specs):
    named = PaintedStation([b for b in station.blocks if b.instance != 44])
    calls = [
        ("perceive_scene", {}),
        ("find_object", {"description": "red mug"}),
        ("grasp_and_remove", {"object_id": "object_1"}),
        ("perceive_scene", {}),
    ]
    blind = Toolshed(named, Oracle(specs), skills, UR5_TABLE, pictures=False)
    texts = [blind.call(*call) for call in calls]
    assert named.drawn == 2 and all(result.picture is None for result in texts)
    named.blocks = [b for b in station.blocks if b.instance != 44]
    seeing = Toolshed(named, Oracle(specs), skills, UR5_TABLE)
    assert [r.text for r in texts] == [seeing.call(*call).text for call in calls]
    assert named.drawn > 1


def test_the_first_picture_is_the_table(shed, station):
    assert (shed.first_picture() == paint(station.blocks).rgb).all()
