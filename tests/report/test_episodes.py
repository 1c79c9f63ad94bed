from played_examples import played
from probe.report.episodes import detail_of, index_of, keys_of, name_of
from probe.scores.missing import Gap
from probe.scores.row import Entrant
from run_folders import DEMO, episode

FIRST, SECOND = DEMO.tasks[:2]
ANNA = Entrant("anna", "agentic")


def test_keys_stay_the_same_and_tell_all_apart():
    one, two = played(episode(FIRST)), played(episode(FIRST, run=1))
    again = played(episode(FIRST, fault="gone"))
    keys = keys_of([one, two, again])
    assert len(set(keys)) == 3
    assert keys_of([two, one])[::-1] == keys[:2]
    direct = played(episode(FIRST), setting="direct")
    assert keys_of([direct])[0] not in keys


def test_settings_named_after_agents_are_said_once():
    assert name_of(Entrant("random", "random")) == "random"
    assert name_of(ANNA) == "anna (agentic)"


def test_a_failure_of_ours_is_neither_right_nor_wrong():
    verdicts = [
        (each.verdict, each.outcome)
        for each in (
            played(episode(FIRST)),
            played(episode(FIRST, right=False)),
            played(episode(FIRST, fault="RenderFailed: gone")),
        )
    ]
    assert verdicts == [("right", "right"), ("wrong", "wrong"), ("missing", "our fault")]


def test_the_index_places_tasks_entrants_and_what_never_was():
    episodes = [played(episode(FIRST)), played(episode(SECOND, right=False))]
    gaps = {
        ANNA: [
            Gap(SECOND.id, SECOND.question_type, 1, "never run"),
            Gap(FIRST.id, FIRST.question_type, 1, "RenderFailed: gone"),
            Gap("elsewhere-1", "count", 0, "never run"),
        ]
    }
    index = index_of(episodes, [ANNA], gaps)
    assert [(it["task"], it["entrant"], it["verdict"]) for it in index["episodes"]] == [
        (0, 0, "right"),
        (1, 0, "wrong"),
    ]
    assert index["never"] == [{"task": 1, "entrant": 0, "run": 1}]
    assert index["tasks"][0]["truth"] == FIRST.answer
    assert index["tasks"][0]["options"][0] == ["A", FIRST.options[0].text]
    assert {it["picture_px"] for it in index["episodes"]} == {1024}


def test_a_replay_has_a_picture_and_the_words_of_each_step():
    detail = detail_of(played(episode(FIRST, words="Hm.")))
    assert detail["start"] == "pictures/0.webp"
    assert [step["picture"] for step in detail["steps"]] == [
        f"pictures/{n}.webp" for n in range(1, 5)
    ]
    assert [step["status"] for step in detail["steps"]] == ["done", "failed", "malformed", "done"]
    first = detail["steps"][0]
    assert (first["tool"], first["words"], first["point"]) == ("find_object", "Hm.", (512, 256))
    assert detail["answer"] == {"choice": FIRST.answer, "point": None}
    assert detail["seconds"] == [4.0, 8.0]
    assert detail_of(played(episode(FIRST, fault="gone")))["answer"] is None
