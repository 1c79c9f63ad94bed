import pytest

from probe.episodes.conventions import CONVENTIONS, claim_convention, read_conventions
from probe.errors import BadData

SELF = "agentic, pointer self"


def test_each_agent_has_a_convention_in_each_setting_and_it_stays(tmp_path):
    assert read_conventions(tmp_path) == {}
    claim_convention(tmp_path, "anna", SELF, "yx1000")
    claim_convention(tmp_path, "anna", "agentic, pointer eyes", "pixels")
    claim_convention(tmp_path, "bert", SELF, "xy100")
    claim_convention(tmp_path, "anna", SELF, "yx1000")
    told = (
        r"pointing=yx1000 for anna \(agentic, pointer self\), not pixels. Name the model as before"
    )
    with pytest.raises(BadData, match=rf"{CONVENTIONS}: was begun with {told}"):
        claim_convention(tmp_path, "anna", SELF, "pixels")
    assert read_conventions(tmp_path) == {
        ("anna", SELF): "yx1000",
        ("anna", "agentic, pointer eyes"): "pixels",
        ("bert", SELF): "xy100",
    }


@pytest.mark.parametrize(
    "text", ["", "[]", '{"pointers":[{"agent":"a","setting":"agentic","pointing":"inches"}]}']
)
def test_what_is_no_such_file_is_refused(tmp_path, text):
    (tmp_path / CONVENTIONS).write_text(text)
    with pytest.raises(BadData, match=f"{CONVENTIONS}.*Delete it, and start the same run again"):
        claim_convention(tmp_path, "anna", SELF, "pixels")
