import pytest

from probe.scores.published import PrintedRow, PrintedTable, is_share, printed_table, recount


def by_row():
    return {(it.row.model, it.row.setting): it for it in recount(printed_table())}


def test_the_table_is_the_papers():
    table = printed_table()
    assert sum(table.tasks.values()) == 150
    assert len(table.rows) == 16
    assert all(set(row.percent) == set(table.tasks) for row in table.rows)
    assert {row.setting for row in table.rows} == {"direct", "agentic"}


def test_averages_that_do_not_follow_are_named():
    rows = by_row()
    # Added up on paper: (28.2 + 79.2 + 59.3 + 29.1 + 0.0 + 38.0) / 6 and so on.
    assert rows["Nemotron 2-VL", "agentic"].macro == pytest.approx(233.8 / 6)
    assert rows["GPT-5.4", "direct"].macro == pytest.approx(303.8 / 6)
    assert rows["GPT-5.4", "agentic"].macro == pytest.approx(354.0 / 6)
    assert {who for who, it in rows.items() if not it.follows} == {
        ("GPT-5.4", "direct"),
        ("GPT-5.4", "agentic"),
        ("Opus 4.7", "direct"),
        ("Nemotron 2-VL", "agentic"),
        ("Qwen3.5-VL", "direct"),
    }


def test_three_direct_averages_are_pooled_instead():
    rows = by_row()
    assert {who for who, it in rows.items() if it.pooled_instead} == {
        ("GPT-5.4", "direct"),
        ("Opus 4.7", "direct"),
        ("Qwen3.5-VL", "direct"),
    }
    # (28 * 71.4 + 24 * 87.5 + 28 * 42.9 + 21 * 19.0 + 23 * 8.7 + 26 * 53.8) / 150
    assert rows["Opus 4.7", "direct"].pooled == pytest.approx(7298.3 / 150)


def test_gains():
    rows = by_row()
    assert {who for who, it in rows.items() if not it.gain_follows} == {("GPT-5.4", "agentic")}
    gpt = rows["GPT-5.4", "agentic"]
    assert (gpt.gain, gpt.macro_gain) == (pytest.approx(6.9), pytest.approx(50.2 / 6))
    assert rows["Nemotron 2-VL", "agentic"].macro_gain == pytest.approx((233.8 - 232.6) / 6)
    assert rows["Opus 4.7", "direct"].gain is None


def test_cells_that_no_count_of_episodes_gives():
    rows = by_row()
    # 42.9 % of 69 episodes would be 29.6 of them.
    assert rows["Gemini Robotics ER 1.6", "agentic"].unreachable == ("reduce", "beneath")
    assert rows["Gemini 3.1 Pro", "direct"].unreachable == ()
    assert len(rows["Gemini 3.1 Pro", "direct"].single) == 6


@pytest.mark.parametrize(
    ("percent", "of", "possible"),
    [(33.3, 3, True), (33.4, 3, False), (66.7, 3, True), (66.6, 3, False), (0.0, 7, True),
     (100.0, 7, True), (42.9, 69, False), (4.4, 23, False), (4.3, 23, True), (6.2, 16, True),
     (6.3, 16, True)],
)  # fmt: skip
def test_shares(percent, of, possible):
    assert is_share(percent, of) == possible


def printed(average: float, gain: float | None, a: float, b: float):
    rows = [
        PrintedRow(model="m", setting="direct", percent={"a": 10.0, "b": 20.0}, average=15.0),
        PrintedRow(
            model="m", setting="agentic", percent={"a": a, "b": b}, average=average, gain=gain
        ),
    ]
    return recount(PrintedTable(tasks={"a": 10, "b": 30}, rows=tuple(rows)))[1]


@pytest.mark.parametrize(
    ("average", "follows", "pooled"),
    [(50.0, True, False), (50.05, True, False), (50.1, False, False), (49.9, False, False),
     (55.0, False, True), (54.91, False, True), (54.9, False, False)],
)  # fmt: skip
def test_rounding_is_allowed_for(average, follows, pooled):
    found = printed(average, None, 40.0, 60.0)
    assert (found.follows, found.pooled_instead) == (follows, pooled)


@pytest.mark.parametrize(
    ("gain", "follows"), [(35.0, True), (35.1, True), (35.2, False), (34.8, False)]
)
def test_a_gain_is_a_difference_of_two_rounded_numbers(gain, follows):
    assert printed(50.0, gain, 40.0, 60.0).gain_follows == follows
