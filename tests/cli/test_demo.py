"""`probe demo` short of its episodes."""

from __future__ import annotations

from probe.cli.demo import demo
from probe.runs.plan import RunOrder


def test_the_chosen_renderer_is_a_condition_of_the_run(tmp_path, monkeypatch):
    orders = list[RunOrder]()
    monkeypatch.setattr("probe.cli.demo.run_order", lambda _, order, *__: orders.append(order) or 0)
    monkeypatch.setattr("probe.cli.demo.write_run_report", lambda runs: tmp_path / "index.html")
    for renderer in ("own", "blender"):
        demo(tmp_path, renderer=renderer)
    assert [order.conditions.label for order in orders] == ["", "renderer blender"]
