import base64
import hashlib
import json

from probe.report.rendering import digest, joined, script_json


def test_no_text_ends_a_script_or_a_comment():
    said = {"words": "</script><!-- & \u2028\u2029 \ud800"}
    text = script_json(said)
    assert not set("<>&\u2028\u2029") & set(text)
    assert json.loads(text) == said


def test_a_digest_is_what_the_policy_wants():
    wanted = base64.b64encode(hashlib.sha256("ä".encode()).digest()).decode()
    assert digest("ä") == f"sha256-{wanted}"


def test_styles_are_joined_as_they_are():
    text = joined("report", ("print.css", "base.css"))
    assert text.index("@media print") < text.index("--paper: #fdfdfc")
