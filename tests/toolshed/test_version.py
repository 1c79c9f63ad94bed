from probe.toolshed.version import TOOLS_VERSION, release_words, tools_words


def test_results_of_one_version_need_no_words():
    assert tools_words([]) == tools_words([1, 1]) == ""


def test_results_of_several_versions_are_said_to_be_so():
    assert "different versions of the tools (1 and 2)" in tools_words([2, 1, 2])
    assert "(1, 2 and 4)" in tools_words([4, 1, 2])


def test_a_version_leads_to_its_release():
    assert release_words(1) == "probe-vqa 0.1"
    assert str(TOOLS_VERSION + 1) in release_words(TOOLS_VERSION + 1)
