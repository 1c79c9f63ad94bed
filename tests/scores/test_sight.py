from probe.scores.sight import sight_words


def test_results_without_sight_are_told_from_those_with():
    assert sight_words(["agentic", "direct", "scripted"]) == ""
    assert sight_words(["text-only", "text-only, short graphs, lighting hdri"]) == ""
    assert "sees no picture" in sight_words(["text-only, short graphs", "agentic"])
    assert sight_words([]) == ""
