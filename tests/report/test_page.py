"""The page: nothing can be injected, nothing is loaded from elsewhere, every number has its n."""

import json
import re
from dataclasses import replace

import pytest

from pages import Page
from played_examples import played, report_of, write_page
from probe.episodes.conditions import RendererKind
from probe.episodes.participation import Participation
from probe.report.page import LARGEST_SINGLE, TooManyEpisodes, write_report
from probe.report.rendering import digest
from probe.tasks.task import Option
from run_folders import DEMO, episode

EVIL = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'`--><!--\u2028&lt;"
OUTSIDE = re.compile(r"^(https?:|//|ftp:|ws)")


def hostile(folder):
    """A page in which whatever others wrote is hostile."""
    episodes = []
    for number, task in enumerate(DEMO.tasks):
        options = tuple(Option(it.letter, EVIL) for it in task.options)
        evil = replace(task, question=EVIL, options=options)
        fault = EVIL if number == 5 else None
        each = played(episode(task, agent=EVIL, words=EVIL, fault=fault, right=number % 2 == 0))
        episodes.append(replace(each, task=evil))
    return write_page(folder, episodes)


def test_words_of_models_and_catalogues_add_no_element(tmp_path):
    page, kind = Page(hostile(tmp_path)), Page(write_page(tmp_path / "kind", []))
    assert len(page.all("script")) == len(kind.all("script")) == 3
    assert {e.tag for e in page.elements} >= {"bdi", "table", "svg"}
    assert not [e for e in page.elements if any(name.startswith("on") for name in e.attributes)]
    assert not [e for e in page.all("img") if e.attributes["src"] == "x"]
    assert "alert(1)" in page.section("missing")
    assert "alert(1)" in page.section("scores")


def test_data_of_the_script_holds_the_words_as_they_were(tmp_path):
    page = Page(hostile(tmp_path))
    (index,) = page.all("script", id="index-data")
    found = json.loads(index.text)
    assert {task["question"] for task in found["tasks"]} == {EVIL}
    assert {text for task in found["tasks"] for _, text in task["options"]} == {EVIL}
    assert found["entrants"] == [f"{EVIL} (agentic)"]
    assert not set("<>&\u2028") & set(index.text)


def test_files_of_episodes_are_named_by_nobody(tmp_path):
    hostile(tmp_path)
    files = list((tmp_path / "episodes").iterdir())
    assert len(files) == 6
    assert all(re.fullmatch(r"[0-9a-f]{12}\.js", path.name) for path in files)
    for path in files:
        text = path.read_text()
        assert not set("<>&\u2028") & set(text)
        arguments = text.removeprefix("probeEpisode(").removesuffix(");\n")
        key, detail = json.loads(f"[{arguments}]")
        assert key == path.stem
        assert detail["steps"][0]["words"] == EVIL
        assert detail["steps"][2]["arguments"] == EVIL


@pytest.mark.parametrize("single", [False, True])
def test_the_policy_allows_no_network_and_exactly_these_scripts(tmp_path, single):
    report = report_of([played(episode(DEMO.tasks[0]))])
    if single:
        (tmp_path / "pictures").mkdir()
        for number in range(5):
            (tmp_path / "pictures" / f"{number}.webp").write_bytes(b"picture")
    write_report(tmp_path / "page.html", report, single=single)
    text = (tmp_path / "page.html").read_text()
    page = Page(text)
    (meta,) = [e for e in page.all("meta") if "http-equiv" in e.attributes]
    policy = dict(rule.split(" ", 1) for rule in str(meta.attributes["content"]).split("; "))
    own = [] if single else ["'self'", "file:"]
    scripts = re.findall(r"<script>(.*?)</script>", text, re.DOTALL)
    styles = re.findall(r"<style>(.*?)</style>", text, re.DOTALL)
    assert policy == {
        "default-src": "'none'",
        "script-src": " ".join([*own, *(f"'{digest(it)}'" for it in scripts)]),
        "style-src": " ".join(f"'{digest(it)}'" for it in styles),
        "img-src": " ".join([*own, "data:"]),
        "media-src": " ".join([*own, "data:"]),
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    assert (len(scripts), len(styles)) == (1, 1)
    assert not [e for e in page.elements if "style" in e.attributes]
    assert not [address for address in page.addresses() if OUTSIDE.match(address)]


def test_a_complete_run_has_a_headline_with_all_that_belongs_to_it(tmp_path):
    episodes = [played(episode(task, run=run)) for task in DEMO.tasks for run in range(2)]
    page = Page(write_page(tmp_path, episodes))
    (row,) = [e.text for e in page.all("tr") if e.text.startswith("anna agentic 100.0 %")]
    # All six right: Wilson's lower limits for 2 of 2, 34.2 %, in each of three types.
    # Of three types Count has a naive ceiling of a third: (0.2 + 0.2 + 1 / 3) / 3 in all.
    assert row == "anna agentic 100.0 % 62 to 100 % 20 % 24 % 100.0 % 100.0 % 6 12"
    (hidden,) = [e.text for e in page.all("tr") if e.text.startswith("anna (agentic) unknown")]
    assert hidden == "anna (agentic) unknown unknown"  # the ICC and the gap, in a fold
    assert "naive ceiling 20 % 33 % 20 %" in page.section("scores")
    assert "n = 2" in page.section("scores")
    assert "find, letter alone" in page.section("scores")
    assert page.section("missing") == "Missing Nothing. Every run of every task has a result."
    assert "one entrant, so nothing to compare" in page.section("differences")


def test_accuracy_by_necessary_manipulations_is_drawn_where_tasks_state_them(tmp_path):
    """Of three tasks that take one all are right, of three that take two one is."""
    tasks, episodes = [], []
    for number, task in enumerate(DEMO.tasks):
        measures = {**task.certificate.measures, "necessary": 1.0 + number % 2}
        tasks.append(replace(task, certificate=replace(task.certificate, measures=measures)))
        each = played(episode(task, right=number % 2 == 0 or number == 1))
        row = each.row.model_copy(update={"necessary": 1 + number % 2})
        episodes.append(replace(each, task=tasks[-1], row=row))
    write_report(tmp_path / "index.html", report_of(episodes, tasks))
    page = Page((tmp_path / "index.html").read_text())
    assert "Restraint" in page.section("scores")
    (figure,) = [e for e in page.all("svg") if e.attributes.get("class") == "steps"]
    assert " ".join((figure.attributes["aria-label"] or "").split()) == (
        "Right answers by necessary manipulations: 1 necessary: 100 % of 3; 2 necessary: 33 % of 3"
    )
    assert len(page.all("circle")) >= 2
    plain = Page(write_page(tmp_path / "plain", [played(episode(it)) for it in DEMO.tasks]))
    assert "Restraint" not in plain.section("scores")
    assert not [e for e in plain.all("svg") if e.attributes.get("class") == "steps"]


def test_what_went_wrong_between_models_and_us_is_all_named(tmp_path):
    faults = ("reply 1: the server failed 2 times: 429", "reply 3: empty")
    episodes = [
        replace(episode(task, agent="m"), participation=Participation("agentic", faults=said))
        for task, said in zip(DEMO.tasks, (faults, (), (EVIL,), *[()] * 3), strict=True)
    ]
    page = Page(write_page(tmp_path, [played(each) for each in episodes]))
    missing = page.section("missing")
    assert "2 episodes in which something went wrong, mended or not" in missing
    assert f"{DEMO.tasks[0].id} m (agentic) run 0: {'; '.join(faults)}" in missing
    assert DEMO.tasks[1].id not in missing
    assert f"{DEMO.tasks[2].id} m (agentic) run 0:" in missing and "alert(1)" in missing
    assert not [e for e in page.all("img") if e.attributes["src"] == "x"]


def test_an_incomplete_run_has_none(tmp_path):
    page = Page(write_page(tmp_path, [played(episode(DEMO.tasks[0]))]))
    (row,) = [e.text for e in page.all("tr") if e.text.startswith("anna agentic incomplete worst")]
    # One right of two in one of three types, the rest unknown.
    assert "worst 16.7 %, best 100.0 %" in row
    assert "1 of 6" in row
    assert not page.all("td", class_="big")


def test_pairs_have_a_verdict_and_ties_are_groups(tmp_path):
    episodes = [played(episode(task, agent=who)) for task in DEMO.tasks for who in ("anna", "bert")]
    section = Page(write_page(tmp_path, episodes)).section("differences")
    assert "anna (agentic) less bert (agentic) 0.0" in section
    assert "1.000 too few tasks to tell 6" in section
    assert "Not told apart anna (agentic) · bert (agentic)" in section


def test_settings_of_an_agent_are_a_family_of_their_own(tmp_path):
    episodes = [
        played(episode(task, right=setting == "agentic"), setting=setting)
        for task in DEMO.tasks
        for setting in ("agentic", "direct")
    ]
    section = Page(write_page(tmp_path, episodes)).section("differences")
    assert "Agentic against direct" in section
    assert "Over 1 agent and 6 tasks, agentic against direct: p = " in section


def test_the_figure_has_numbers_and_words(tmp_path):
    episodes = [played(episode(task, right=task.question_type != "count")) for task in DEMO.tasks]
    page = Page(write_page(tmp_path, episodes))
    (figure,) = page.all("div", class_="bars")
    assert figure.attributes["aria-label"] == (
        "beneath: 2 manipulated, right of 2. count: 2 manipulated, wrong of 2. "
        "find: 2 manipulated, right of 2. "
    )
    verdicts = {"beneath": "right", "count": "wrong", "find": "right"}
    bars = [f"{name} {name}, manipulated, {verdict}: 2 2 2" for name, verdict in verdicts.items()]
    assert figure.text == " ".join(bars)


@pytest.mark.parametrize("renderer", ["own", "filament", "blender"])
def test_pictures_that_agents_saw_otherwise_are_told_of(tmp_path, renderer: RendererKind):
    report = replace(report_of([played(episode(DEMO.tasks[0]))]), renderer=renderer)
    write_report(tmp_path / "index.html", report)
    notices = Page((tmp_path / "index.html").read_text()).all("p", class_="notice")
    told = "Blender drew the pictures of this page. Agents saw others, drawn by Filament."
    assert (told in {notice.text for notice in notices}) == (renderer == "blender")


def test_every_field_has_a_name(tmp_path):
    page = Page(write_page(tmp_path, [played(episode(DEMO.tasks[0]))]))
    labels = " ".join(e.text for e in page.all("label"))
    for name in ("Type", "Agent", "Result", "Outcome", "Search"):
        assert name in labels
    assert all(e.attributes.get("alt") for e in page.all("img"))
    assert all(e.attributes.get("aria-label") for e in page.all("svg", role="img"))
    assert page.elements[0].attributes["lang"] == "en"


def test_too_many_for_a_single_file(tmp_path):
    many = [played(episode(DEMO.tasks[0], run=run)) for run in range(LARGEST_SINGLE + 1)]
    with pytest.raises(TooManyEpisodes, match="Leave out --single-file"):
        write_report(tmp_path / "page.html", report_of(many), single=True)
    assert list(tmp_path.iterdir()) == []
