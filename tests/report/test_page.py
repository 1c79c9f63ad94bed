"""The report: rates with intervals, and a page that nothing can inject into."""

import re

import pytest
from probe.report.episode_view import EpisodeView
from probe.report.tally import rates

from probe.episodes.record import End, EpisodeRecord, Step, Table
from probe.episodes.turns import Call, Question
from probe.report.page import write_report
from probe.scene.scene import Scene
from probe.tasks.grading import Score
from probe.toolshed.result import Answer

EMPTY = Table(Scene(0, "oak", ()), (0.0,) * 6)
EVIL = "<script>alert(1)</script>"


def view(
    kind: str, *, right: bool, words: str = "", end: End = "answered", options: int = 5
) -> EpisodeView:
    letters = "ABCDE"[:options]
    question = Question(
        f"What {words}?", tuple((letter, f"{words} {letter}") for letter in letters)
    )
    step = Step(
        Call("push", f'{{"object_id": "{words}"}}', words), "failed", words, (512, 256), EMPTY
    )
    record = EpisodeRecord(
        f"{kind}-1", "scripted", 0, question, EMPTY, (step,), Answer("A"), end,
        words if end == "fault" else None,
    )  # fmt: skip
    score = Score(right, right, "right" if right else "wrong")
    return EpisodeView(kind, record, score, "A", ("pictures/0.jpg", "pictures/1.jpg"))


def test_rates_count_faults_and_never_leave_the_denominator():
    views = [view("find", right=True)] * 7 + [view("find", right=False)] * 2
    views += [view("find", right=False, end="fault"), view("size", right=True, options=2)]
    find, size, total = rates(views)
    assert (find.name, find.right, find.n, find.faults) == ("find", 7, 10, 1)
    # Wilson's interval for 7 of 10, as in Brown, Cai and DasGupta (2001).
    assert (round(find.low, 3), round(find.high, 3)) == (0.397, 0.892)
    assert (find.chance, size.chance) == pytest.approx((0.2, 0.5))
    assert (total.name, total.right, total.n) == ("all", 8, 11)


def test_words_of_models_and_catalogues_are_text(tmp_path):
    page = tmp_path / "index.html"
    write_report(page, EVIL, [view("find", right=False, words=EVIL, end="fault")])
    text = page.read_text()
    assert "<script" not in text
    assert "&lt;script&gt;" in text


def test_the_page_loads_nothing_from_elsewhere_and_pictures_late(tmp_path):
    page = tmp_path / "index.html"
    write_report(page, "A suite", [view("find", right=True, words="red mug")])
    text = page.read_text()
    assert not re.search(r"(src|href)=\"(https?:)?//", text)
    assert re.findall(r'src="([^"]+)"', text) == ["pictures/0.jpg", "pictures/1.jpg"]
    assert text.count('loading="lazy"') == 2
    assert "7 of" not in text
    assert "red mug A" in text and "(answered)" in text


def test_where_the_call_was_aimed_is_marked(tmp_path):
    page = tmp_path / "index.html"
    write_report(page, "A suite", [view("find", right=True)])
    assert "left:50.0%;top:25.0%" in page.read_text()
