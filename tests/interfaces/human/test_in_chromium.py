"""The pages in a real browser, over painted tables."""

import json

import pytest

from browser import Browser, chromium
from interfaces.human.conftest import serving
from interfaces.human.page import AtPage
from interfaces.human.painted_hall import COUNT, Room, hall_in
from probe.episodes.files import read_records
from probe.episodes.remarks import read_remarks
from probe.episodes.turns import Call
from task_examples import FIND

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(chromium() is None, reason="there is no Chromium"),
]

FIND_BALL = Call.of("find_object", {"description": "white ball"})


@pytest.fixture
def port(tmp_path):
    with serving(hall_in(tmp_path, Room(slow=0.5))) as found:
        yield found


def text(browser, id):
    return browser.run(f"document.getElementById({json.dumps(id)}).textContent")


def test_two_people_play_at_once_and_one_reloads_in_the_middle(port, tmp_path):
    with Browser() as here, Browser(420, 800) as there:
        ada, bea = AtPage(here, port), AtPage(there, port)
        ada.begin("Ada")
        bea.begin("Bea <b>")
        assert text(here, "question") == FIND.question
        assert text(there, "manipulations") == "10"
        ada.do(FIND_BALL)
        ada.click("#grasp")
        here.call("Page.reload")  # while the arm moves
        ada.wait("document.readyState === 'complete' && steps.children.length === 3")
        ada.wait_for_table()
        assert ada.told().startswith("Done: object_1")
        assert text(here, "turns") == "38" and text(here, "manipulations") == "9"
        assert here.run("movers.hidden"), "what lies in the basket can't be moved"
        assert there.run("steps.children.length") == 1
        ada.do(Call.of("answer_question", {"choice": "B", "point": [622, 470]}))
        bea.do(Call.of("answer_question", {"choice": "E"}))
        assert not here.complaints and not there.complaints
        assert all(url.startswith(ada.home) for url in (*here.requests, *there.requests))
    first, second = read_records(tmp_path / "records.jsonl")
    assert (first.agent, len(first.steps)) == ("Ada", 3)
    assert first.answer and first.answer.point_px == pytest.approx((622, 470), abs=2)
    assert (second.agent, second.answer and second.answer.choice) == ("Bea <b>", "E")


def test_a_click_points_and_finds(port):
    with Browser() as browser:
        ada = AtPage(browser, port)
        ada.begin("Ada")
        ada.point(150, 160)
        assert browser.run("description.value") in {
            f"the thing at ({u}, {v})" for u in (149, 150, 151) for v in (159, 160, 161)
        }
        assert not browser.run("ring.hidden")
        ada.click("#find-form .row button:not(#perceive)")
        ada.wait("steps.children.length === 2 && !controls.disabled")
        assert "red mug" in ada.told()
        browser.run("picture.focus()")
        browser.press("ArrowRight", 39)
        ada.wait("/15[789], (159|16[01])/.test(description.value)")


def test_words_of_a_suite_are_shown_as_they_are(port, tmp_path):
    with Browser() as browser:
        ada = AtPage(browser, port)
        ada.begin("Ada")
        ada.click("#stop")
        ada.click("#sure-yes")
        ada.wait("!next.hidden && next.offsetParent !== null")
        assert "without an answer" in text(browser, "between-words")
        ada.click("#ambiguous")
        ada.wait("kept.textContent === 'Kept.'")
        ada.type("note", "two <i>limes</i>")
        browser.run("kept.textContent = ''")
        ada.click("#keep")
        ada.wait("kept.textContent === 'Kept.'")
        ada.click("#next")
        ada.wait_for_table()
        assert text(browser, "question") == COUNT.question
        labels = browser.run("[...options.children].map((each) => each.textContent).join('|')")
        assert labels == "A2|B3|C<script>4</script>"
        assert not browser.run("ambiguous.checked")
        assert not browser.complaints
    *_, remark = read_remarks(tmp_path)
    assert remark.note == "two <i>limes</i>" and remark.task == FIND.id


def test_a_server_that_is_gone_is_told_in_words(tmp_path):
    with Browser() as browser:
        with serving(hall_in(tmp_path, Room())) as port:
            ada = AtPage(browser, port)
            ada.begin("Ada")
        ada.click("#perceive")
        ada.wait("!trouble.hidden")
        assert "can't be reached" in text(browser, "trouble")
