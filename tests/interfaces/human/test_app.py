"""The real application over HTTP, its tables painted."""

import io
import json
import time

import numpy as np
import pytest
from PIL import Image

from interfaces.human.conftest import serving
from interfaces.human.painted_hall import COUNT, Room, hall_in, secrets
from interfaces.human.visitor import Visitor
from interfaces.painted import BLOCKS
from probe.episodes.files import read_records
from probe.episodes.remarks import Remark, read_remarks
from probe.episodes.turns import Call
from probe.toolshed.result import Answer
from probe.toolshed.tools import tool_schemas
from tabletops import paint
from task_examples import FIND


def pixels(reply):
    return np.asarray(Image.open(io.BytesIO(reply.body)))


def play_to_the_end(visitor):
    visitor.call("perceive_scene")
    visitor.call("find_object", description="white ball")
    visitor.call("grasp_and_remove", object_id="object_2")
    return visitor.call("answer_question", choice="B", point=[620, 480])


def test_an_episode_is_the_agents_episode(visitor, tmp_path):
    state = visitor.enter()
    assert (state["number"], state["total"], state["done"]) == (1, 2, 0)
    assert state["question"] == FIND.question and state["asksPoint"]
    assert state["options"] == [[option.letter, option.text] for option in FIND.options]
    assert (state["turnsLeft"], state["manipulationsLeft"]) == (40, 10)
    assert (pixels(visitor.picture(0)) == paint(BLOCKS).rgb).all()
    visitor.call("perceive_scene")
    state = visitor.call("find_object", description="white ball")
    assert state["objects"] == [
        {"id": "object_1", "called": "red mug"},
        {"id": "object_2", "called": "white ball"},
    ]
    state = visitor.call("grasp_and_remove", object_id="object_2")
    assert (state["turnsLeft"], state["manipulationsLeft"]) == (37, 9)
    left = [block for block in BLOCKS if block.instance != 702]
    assert (pixels(visitor.picture(state["entries"][-1]["picture"])) == paint(left).rgb).all()
    assert visitor.call("answer_question", choice="B", point=[620, 480])["over"]
    (record,) = read_records(tmp_path / "records.jsonl")
    assert (record.task, record.agent, record.run, record.end) == (FIND.id, "Ada", 0, "answered")
    assert record.answer and record.answer.choice == "B" and record.answer.point_px == (620, 480)
    assert record.steps[2].call == Call.of("grasp_and_remove", {"object_id": "object_2"})
    told = [entry["text"] for entry in visitor.state()["entries"]]
    assert told == [step.text for step in record.steps]
    assert not list((tmp_path / "unfinished").iterdir())


def test_the_next_question_and_the_end(visitor, tmp_path):
    visitor.enter()
    play_to_the_end(visitor)
    assert visitor.post("next").status == 200
    state = visitor.state()
    assert (state["number"], state["done"], state["entries"]) == (2, 1, [])
    assert state["question"] == COUNT.question and not state["asksPoint"]
    visitor.post("stop", turn=0)
    state = visitor.state()
    assert state["over"] and state["done"] == 2
    visitor.post("next")
    assert visitor.state()["number"] == 0
    ends = [record.end for record in read_records(tmp_path / "records.jsonl")]
    assert ends == ["answered", "stopped"]


def test_refusals_are_told_in_the_tools_words_and_cost_a_turn(visitor):
    visitor.enter()
    state = visitor.call("grasp_and_remove", object_id="object_5")
    assert state["entries"][0]["status"] == "malformed"
    assert "An object_id comes from perceive_scene or find_object" in state["entries"][0]["text"]
    assert (state["turnsLeft"], state["manipulationsLeft"]) == (39, 10)
    state = visitor.call("teleport", to="basket")
    assert "There is no tool called 'teleport'" in state["entries"][1]["text"]


def test_a_page_that_is_behind_does_nothing(visitor):
    visitor.enter()
    visitor.call("perceive_scene")
    reply = visitor.post("call", turn=0, tool="perceive_scene", arguments={})
    assert reply.status == 409 and "behind" in reply.json["error"]
    assert len(visitor.state()["entries"]) == 1


def test_two_people_have_two_tables(visitor, tmp_path):
    bea = Visitor(visitor.port, "Bea")
    visitor.enter()
    bea.enter()
    visitor.call("find_object", description="white ball")
    visitor.call("grasp_and_remove", object_id="object_1")
    assert bea.state()["entries"] == []
    state = bea.call("grasp_and_remove", object_id="object_1")
    assert state["entries"][0]["status"] == "malformed"
    assert (pixels(bea.picture(0)) == paint(BLOCKS).rgb).all()
    visitor.call("answer_question", choice="B", point=[620, 480])
    bea.call("answer_question", choice="A", point=[5, 5])
    records = read_records(tmp_path / "records.jsonl")
    said = {record.agent: record.answer and record.answer.choice for record in records}
    assert said == {"Ada": "B", "Bea": "A"}


def test_a_person_who_points_nowhere_is_asked_once(visitor, tmp_path):
    visitor.enter()
    state = visitor.call("answer_question", choice="B")
    assert not state["over"] and state["turnsLeft"] == 39
    assert "point at something" in state["entries"][0]["text"]
    assert visitor.call("answer_question", choice="B")["over"]
    (record,) = read_records(tmp_path / "records.jsonl")
    assert record.answer == Answer("B", None)


def test_what_was_begun_is_gone_on_with_after_a_restart(tmp_path):
    with serving(hall_in(tmp_path, Room())) as port:
        visitor = Visitor(port)
        visitor.enter()
        visitor.call("perceive_scene")
        visitor.call("find_object", description="white ball")
        before = visitor.call("grasp_and_remove", object_id="object_2")
        shown = visitor.picture(3).body
    assert not (tmp_path / "records.jsonl").exists()
    with serving(hall_in(tmp_path, Room())) as port:
        again = Visitor(port)
        assert again.get("/seat/state", name="Ada").status == 409
        assert again.enter() == before
        assert again.picture(3).body == shown
        again.call("answer_question", choice="B", point=[620, 480])
    (record,) = read_records(tmp_path / "records.jsonl")
    assert len(record.steps) == len(record.seconds.agent) == 4


def test_a_seat_that_somebody_else_needs_is_given_back(tmp_path):
    room = Room()
    with serving(hall_in(tmp_path, room, seats=1)) as port:
        ada, bea = Visitor(port), Visitor(port, "Bea")
        ada.enter()
        before = ada.call("perceive_scene")
        bea.enter()
        reply = ada.post("call", turn=1, tool="perceive_scene", arguments={})
        assert reply.status == 409 and "Load the page again" in reply.json["error"]
        assert ada.enter() == before
        # Ada, Bea and Ada again have had two places each, of which two at most are open.
        until(lambda: room.open <= 2)
    assert room.open == 0


def until(holds):
    limit = time.monotonic() + 20
    while not holds():
        assert time.monotonic() < limit
        time.sleep(0.01)


def test_nobody_is_turned_out_while_the_arm_moves(tmp_path):
    room = Room()
    with serving(hall_in(tmp_path, room, seats=1)) as port:
        ada, bea = Visitor(port), Visitor(port, "Bea")
        room.gate.clear()
        ada.post("enter")
        reply = bea.post("enter")
        assert reply.status == 409 and "All seats are taken" in reply.json["error"]
        reply = ada.post("next")
        assert reply.status == 409 and "still going on" in reply.json["error"]
        room.gate.set()
        assert ada.state()["number"] == 1


def test_practice_tells_what_was_right_and_writes_nothing_down(tmp_path):
    with serving(hall_in(tmp_path, Room())) as port:
        ada = Visitor(port, practice=True)
        assert ada.enter()["practice"]
        state = ada.call("answer_question", choice="A", point=[5, 5])
        assert state["over"] and not state["feedback"]["correct"]
        assert state["feedback"]["verdict"] == "Right is B, lime."
        assert (pixels(ada.evidence(1)) == paint(BLOCKS).rgb).all()
        assert ada.evidence(2).status == 400
        reply = ada.post("remark", number=1, ambiguous=True, note="")
        assert reply.status == 409 and "no remarks" in reply.json["error"]
        ada.post("next")
        state = ada.state()
        assert (state["number"], state["done"], state["feedback"]) == (2, 1, None)
        assert ada.evidence(0).status == 400
        ada.post("stop", turn=0)
        assert ada.state()["feedback"]["correct"] is False
        assert ada.post("enter").json["done"] == 0, "it begins anew once all is done"
    assert not (tmp_path / "records.jsonl").exists()
    assert not (tmp_path / "remarks.jsonl").exists()


def test_who_goes_from_practice_to_the_suite_has_one_seat(tmp_path):
    room = Room()
    with serving(hall_in(tmp_path, room, seats=1)) as port:
        practising, ada = Visitor(port, practice=True), Visitor(port)
        practising.enter()
        assert not ada.enter()["practice"]
        reply = practising.post("call", turn=0, tool="perceive_scene", arguments={})
        assert reply.status == 409 and "Load the page again" in reply.json["error"]
        state = ada.call("answer_question", choice="A", point=[5, 5])
        assert state["feedback"] is None and ada.evidence(0).status == 400
    (record,) = read_records(tmp_path / "records.jsonl")
    assert record.task == FIND.id


def test_the_door_offers_practice_where_there_is_some(tmp_path):
    with serving(hall_in(tmp_path / "some", Room())) as port:
        assert "Practise first" in Visitor(port).get("/").body.decode()
    hall = hall_in(tmp_path / "none", Room(), practice=None)
    with serving(hall) as port:
        assert "Practise first" not in Visitor(port).get("/").body.decode()
        reply = Visitor(port, practice=True).post("enter")
        assert reply.status == 409 and "nothing to practise on" in reply.json["error"]


def test_remarks_stand_beside_the_records(visitor, tmp_path):
    visitor.enter()
    assert visitor.post("remark", number=2, ambiguous=True, note="").status == 409
    said = visitor.post("remark", number=1, ambiguous=True, note=" <i>two limes</i> ").json
    assert said["remark"] == {"ambiguous": True, "note": "<i>two limes</i>"}
    play_to_the_end(visitor)
    visitor.post("remark", number=1, ambiguous=False, note="")
    first, second = read_remarks(tmp_path)
    assert first == Remark(FIND.id, "Ada", True, "<i>two limes</i>")
    assert second == Remark(FIND.id, "Ada", False, "")


def test_no_reply_tells_more_than_the_tools(visitor):
    for path in ("/", "/base.css", "/static/seat.js", "/static/tools.js", "/static/seat.css"):
        assert visitor.get(path).status == 200
    visitor.get("/seat", name="Ada")
    visitor.evidence(0)
    visitor.enter()
    for number in range(3):
        visitor.picture(number)
    play_to_the_end(visitor)
    visitor.post("next")
    visitor.state()
    visitor.call("answer_question", choice="A")
    visitor.post("next")
    visitor.state()
    counts = ("content-length", "etag", "date", "last-modified")
    for reply in visitor.heard:
        question_type = reply.headers["content-type"]
        said = json.dumps({k: v for k, v in reply.headers.items() if k not in counts})
        if question_type == "image/png":
            assert not Image.open(io.BytesIO(reply.body)).info
        else:
            said += reply.body.decode()
        wary = ('answer"', "correct", "seed", "instance", "target")
        for secret in (*secrets(), *(wary if question_type == "application/json" else ())):
            assert secret not in said, (secret, said[:200])


def test_a_right_and_a_wrong_answer_are_told_alike(tmp_path):
    told = []
    for letter in ("A", "B"):
        with serving(hall_in(tmp_path / letter, Room())) as port:
            visitor = Visitor(port)
            visitor.enter()
            state = visitor.call("answer_question", choice=letter, point=[5, 5])
            told.append({**state, "entries": [entry["text"] for entry in state["entries"]]})
    assert told[0] == told[1]


def test_only_our_own_pages_may_ask(visitor):
    said = json.dumps({"name": "Eve"}).encode()
    question_type = {"content_type": "application/json"}
    assert visitor.send("GET", "/", host="evil.example").status == 400
    assert visitor.send("GET", "/", host="evil.example:8137").status == 400
    assert visitor.send("GET", "/", host=f"localhost:{visitor.port}").status == 200
    refused = visitor.send(
        "POST", "/seat/enter", said, origin="http://evil.example", **question_type
    )
    assert refused.status == 403
    assert visitor.send("POST", "/seat/enter", said, content_type="text/plain").status == 415
    assert visitor.send("POST", "/seat/enter", b" " * 30_000, **question_type).status == 413
    assert visitor.send("GET", "/seat/enter").status == 405
    assert visitor.get("/seat/state", name="Eve").status == 409
    own = f"http://127.0.0.1:{visitor.port}"
    assert visitor.send("POST", "/seat/enter", said, origin=own, **question_type).status == 200


@pytest.mark.parametrize("path", ["/", "/seat?name=Ada", "/static/seat.js", "/nowhere"])
def test_every_reply_says_what_may_be_loaded(visitor, path):
    reply = visitor.get(path)
    assert reply.headers["content-security-policy"].startswith("default-src 'none'; script-src")
    assert "unsafe" not in reply.headers["content-security-policy"]
    assert reply.headers["x-content-type-options"] == "nosniff"
    assert reply.headers["cache-control"] == "no-store"


@pytest.mark.parametrize(
    "body", [b"", b"[]", b"{}", b"\xff", b'{"name": 3}', b'{"name": "A", "more": 1}', b"[" * 9000]
)
def test_odd_requests_are_refused_in_words(visitor, body):
    reply = visitor.send("POST", "/seat/call", body, content_type="application/json")
    assert reply.status == 400 and "can't be used" in reply.json["error"]


def test_names_are_escaped(visitor):
    page = visitor.get("/seat", name="<img src=x onerror=alert(1)>").body.decode()
    assert "<img src=x" not in page and "&lt;img src=x" in page
    assert visitor.get("/seat", name="").status == 400
    assert visitor.get("/seat", name="a\u202eb").status == 400
    assert visitor.get("/seat", name=" Ada ").headers["location"].endswith("name=Ada")


def test_the_page_tells_of_the_tools_in_the_agents_words(visitor):
    page = visitor.get("/seat", name="Ada").body.decode()
    for tool in tool_schemas():
        assert tool.name in page
    assert FIND.question not in page and "http" not in page.replace("http-equiv", "")
