"""The report in a real browser: what it loads, how it is used, what hostile words do."""

from __future__ import annotations

import pytest
from PIL import Image

from browser import Browser, chromium
from probe.cli.report import write_run_report
from probe.files import encode
from probe.report.clips import clip_stem
from run_folders import DEMO, episode, write_run

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(chromium() is None, reason="no Chromium: scripts/ensure-browser"),
]

BREAK = "document.title='broken'"
EVIL = f'</script><script>{BREAK}</script><img src=x onerror="{BREAK}">'
PLAIN = [task for task in DEMO.tasks if task.question_type != "find"]
LEFT, RIGHT, ESCAPE = ("ArrowLeft", 37), ("ArrowRight", 39), ("Escape", 27)
AT = "document.querySelector('#stage input[type=range]').value"
STEPS = "[...document.querySelectorAll('#stage input')].map((it) => it.value).join()"
ASKED = "document.getElementById('replay-question').textContent"


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """Four tasks by two agents, one of them hostile; with a failure and what was never run."""
    records = [episode(task, words=EVIL, agent=EVIL, right=False) for task in PLAIN]
    records += [episode(task) for task in PLAIN[:3]] + [episode(PLAIN[3], fault=EVIL)]
    folder = write_run(tmp_path_factory.mktemp("reports") / "run", records)
    return write_run_report([folder]).as_uri()


@pytest.fixture
def browser():
    with Browser() as found:
        yield found


def opened(browser: Browser) -> str:
    browser.wait("document.getElementById('replay').open")
    return browser.run(ASKED)


def nothing_amiss(browser: Browser) -> None:
    assert [it for it in browser.requests if not it.startswith(("file:", "data:"))] == []
    assert browser.complaints == []
    assert browser.run("document.title") == "PROBE report: demo"


def test_it_opens_from_disk_and_asks_for_nothing_else(browser, page):
    browser.open(page)
    assert browser.run("document.querySelectorAll('.card').length") == 4
    assert browser.run("document.getElementById('found').textContent").startswith("8 of 8 episodes")
    assert not any("/episodes/" in address for address in browser.requests)
    nothing_amiss(browser)


def test_an_episode_is_replayed_by_keyboard_alone(browser, page):
    browser.open(page)
    browser.run("document.querySelector('.card .run').focus()")
    browser.press("Enter", 13, "\r")
    first = opened(browser)
    assert browser.run(AT) == "0"
    browser.press(*RIGHT)
    browser.press(*RIGHT)
    assert browser.run(AT) == "2"
    step = "document.querySelector('#stage input').getAttribute('aria-valuetext')"
    assert browser.run(step) == "step 2 of 4, grasp_and_remove, failed"
    browser.press(*LEFT)
    browser.press("End", 35)
    assert browser.run(AT) == "4"
    browser.press("j")
    browser.press("j")
    browser.wait(f"{ASKED} !== {first!r}")
    browser.press("k")
    browser.press("k")
    browser.wait(f"{ASKED} === {first!r}")
    browser.press(*ESCAPE)
    browser.wait("!document.getElementById('replay').open")
    nothing_amiss(browser)


def test_the_focus_can_be_seen(browser, page):
    browser.open(page)
    for _ in range(3):
        browser.press("Tab", 9)
    outline = "getComputedStyle(document.activeElement).outlineStyle"
    assert browser.run("document.activeElement.tagName") == "A"
    assert browser.run(outline) == "solid"


def test_two_answers_to_a_question_stand_side_by_side(browser, page):
    browser.open(page)
    browser.run("document.querySelector('.card .run').click()")
    opened(browser)
    browser.press("c")
    browser.wait("document.querySelectorAll('#stage input').length === 2")
    browser.press(*RIGHT)
    assert browser.run(STEPS) == "1,1"
    address = browser.run("location.href")
    with Browser() as other:
        other.open(address)
        other.wait("document.querySelectorAll('#stage input').length === 2")
        nothing_amiss(other)


def test_filters_leave_what_fits(browser, page):
    browser.open(page)
    browser.press("/")
    assert browser.run("document.activeElement.name") == "text"
    browser.call("Input.insertText", text=PLAIN[0].id)
    assert browser.run("document.querySelectorAll('.card').length") == 1
    choose = "filters.elements.verdict.value = {!r}; filters.dispatchEvent(new Event('input'))"
    browser.run("filters.elements.text.value = ''; 0")
    browser.run(choose.format("missing"))
    words = browser.run("document.getElementById('found').textContent")
    assert words.startswith("1 of 8 episodes")
    browser.run(choose.format("right"))
    assert browser.run("shown.length") == 3


def test_hostile_words_are_shown_as_words(browser, page):
    browser.open(page)
    for number in range(8):
        browser.run(f"openEpisode(shown[{number}].key)")
        opened(browser)
        browser.wait("stage.children.length === 1")
        browser.press(*RIGHT)
    assert EVIL in browser.run("document.body.textContent")
    nothing_amiss(browser)


def test_playing_takes_all_panels_to_their_end_together(browser, page):
    browser.open(page)
    browser.run("document.querySelector('.card .run').click()")
    opened(browser)
    browser.press("c")
    browser.wait("document.querySelectorAll('#stage input').length === 2")
    browser.press(" ", 32)
    browser.wait(f"{STEPS} === '1,1'")
    assert "Pause" in browser.run("playButton.textContent")
    browser.wait(f"{STEPS} === '4,4'")
    browser.wait("playButton.textContent.includes('Play')")
    browser.press(" ", 32)
    assert browser.run(STEPS) == "0,0"
    nothing_amiss(browser)


def test_the_line_of_steps_has_a_legend_and_goes_where_it_is_clicked(browser, page):
    browser.open(page)
    browser.run("document.querySelector('.card .run.wrong').click()")
    opened(browser)
    marks = "[...document.querySelectorAll('.track .mark-of')].map((it) => it.className.trim())"
    kinds = [mark.split()[1] for mark in browser.run(marks)]
    assert kinds == ["start", "look", "move", "move", "answer"]
    legend = browser.run("document.getElementById('replay-legend').textContent")
    for words in ("the start", "looked", "grasped or pushed", "failed", "the true object"):
        assert words in legend
    place = browser.run(
        "(() => { const box = document.querySelectorAll('.track .mark-of')[3]"
        ".getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; })()"
    )
    for kind in ("mousePressed", "mouseReleased"):
        browser.call(
            "Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], button="left",
            clickCount=1,
        )  # fmt: skip
    assert browser.run(AT) == "3"


def test_the_true_thing_is_marked_in_a_wrong_answer_alone(browser, page):
    browser.open(page)
    for verdict, marked in (("wrong", True), ("right", False)):
        browser.run(f"document.querySelector('.card .run.{verdict}').click()")
        browser.wait(f"document.querySelector('#stage .verdict.{verdict}') !== null")
        assert browser.run("document.querySelector('#stage .ring.truth') !== null") is marked


def test_a_click_shows_a_picture_in_full_size_and_another_puts_it_away(browser, page):
    browser.open(page)
    browser.run("document.querySelector('.card .run').click()")
    opened(browser)
    browser.run("document.querySelector('#stage .picture').click()")
    assert browser.run("large.open && large.querySelector('img').naturalWidth") == 1024
    browser.press(*RIGHT)
    browser.run("large.click()")
    assert browser.run("large.open") is False
    assert browser.run(AT) == "0"
    nothing_amiss(browser)


def test_a_clip_is_loaded_when_its_step_is_shown_and_not_before(browser, tmp_path):
    record = episode(PLAIN[0])
    folder = write_run(tmp_path / "run", [record])
    name = f"clips/{clip_stem(record, 2)}.webp"
    (folder / "clips").mkdir()
    (folder / name).write_bytes(encode(Image.new("RGB", (64, 64)), "WEBP"))
    browser.open(write_run_report([folder]).as_uri())
    browser.run("document.querySelector('.card .run').click()")
    opened(browser)
    browser.press(*RIGHT)
    assert not [it for it in browser.requests if name in it]
    browser.press(*RIGHT)
    browser.wait("document.querySelector('.film img')?.naturalWidth === 64")
    browser.press(*RIGHT)
    assert browser.run("document.querySelector('.film').children.length") == 0
    nothing_amiss(browser)


@pytest.mark.parametrize("width", [1400, 420])
def test_nothing_is_cut_off(width, page):
    with Browser(width) as browser:
        browser.open(page)
        browser.run("document.querySelectorAll('details').forEach((it) => { it.open = true; })")
        browser.run("openEpisode(shown[0].key, others(shown[0]).map((it) => it.key))")
        opened(browser)
        wide = "[...document.querySelectorAll('html, .scroll, dialog, .panel-of > *')]"
        cut = (
            f"{wide}.filter((it) => it.scrollWidth > it.clientWidth + 1).map((it) => it.className)"
        )
        assert browser.run(cut) == []


def test_a_single_file_needs_no_other(browser, tmp_path):
    folder = write_run(tmp_path / "run", [episode(task) for task in PLAIN])
    alone = tmp_path / "elsewhere.html"
    alone.write_bytes(write_run_report([folder], single=True).read_bytes())
    browser.open(alone.as_uri())
    browser.run("document.querySelector('.card .run').click()")
    opened(browser)
    browser.wait("document.querySelector('#stage img').naturalWidth === 1024")
    assert [it for it in browser.requests if it.startswith("file:")] == [alone.as_uri()]
    nothing_amiss(browser)
