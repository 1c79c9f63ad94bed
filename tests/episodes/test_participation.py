"""A model's part in a record, on disk and in scores."""

from __future__ import annotations

import json
from dataclasses import replace

from probe.episodes.files import line_of, record_of
from probe.episodes.folder import standing
from probe.episodes.participation import ModelReply, Participation
from probe.scores.marking import row_of
from probe.tasks.grading import Score
from run_folders import DEMO, episode

TASK = DEMO.tasks[0]
SEAT = Participation(
    "direct", "0-1000", (ModelReply(0, "Hm."), ModelReply(2)), 100, 20, 0.25, ("reply 1: empty",)
)
RECORD = replace(episode(TASK), participation=SEAT)


def test_it_is_read_as_it_was_written():
    assert record_of(line_of(RECORD)) == RECORD
    assert RECORD.setting == "direct"


def test_records_of_before_have_none():
    document = json.loads(line_of(episode(TASK)))
    del document["seat"], document["sum"]
    old = record_of(json.dumps(document).encode())
    assert old.participation is None and old.setting == ""


def test_settings_of_a_model_are_apart():
    agentic = replace(RECORD, participation=replace(SEAT, setting="agentic"))
    assert standing([RECORD, agentic]) == [RECORD, agentic]


def test_rows_tell_tokens_and_cost():
    row = row_of(TASK, RECORD, Score(True, True, "right"), suite="demo", setting=RECORD.setting)
    assert (row.setting, row.tokens_in, row.tokens_out, row.cost) == ("direct", 100, 20, 0.25)
