"""Models by short names, as data: what suits each. Knows no harness."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from importlib.resources import files

import pydantic
import yaml

from probe.episodes.participation import Points
from probe.errors import BadData
from probe.files import fault
from probe.perception.points import Convention

_SERVICE, _LOCAL = "openai-api/endpoint/", "openai-api/vllm/"


class ModelSettings(pydantic.BaseModel, extra="forbid", frozen=True):
    """What suits a model.

    Attributes:
        id: The harness's name for it.
        points: How it counts places.
        pointing: How it writes places down when it points for perception.
        serve: How to start a server of its weights, if they are open.
    """

    id: str
    points: Points = "pixels"
    pointing: Convention = "pixels"
    serve: str | None = None


@lru_cache(1)
def known_models() -> Mapping[str, ModelSettings]:
    """All that have short names.

    Raises:
        BadData: The file breaks its schema.
    """
    source = files("probe.bench") / "data/models.yaml"
    try:
        found = yaml.safe_load(source.read_text())
        return pydantic.TypeAdapter(dict[str, ModelSettings]).validate_python(found)
    except (yaml.YAMLError, pydantic.ValidationError) as error:
        reason = fault(error, "it") if isinstance(error, pydantic.ValidationError) else str(error)
        raise BadData("models.yaml", reason, "Correct it") from error


def settings_of(name: str) -> ModelSettings:
    """What suits a model, by its short name or the harness's; of others only the name is known."""
    by_id = {known.id: known for known in known_models().values()}
    return known_models().get(name) or by_id.get(name) or ModelSettings(id=name)


def asked_as(name: str, acting: str, endpoint: str | None) -> str:
    """The harness's name for a model as it is asked, which records have of one that points.

    At an endpoint are the one that acts, and who has a name that no provider stands before.

    Args:
        name: The harness's name for it, without regard to the endpoint.
        acting: Likewise, of the one that acts.
        endpoint: Address of a server that speaks OpenAI's protocol; None for each one's usual.
    """
    bare = name.removeprefix(_LOCAL)
    there = name == acting or bare != name or "/" not in name
    return _SERVICE + bare if endpoint is not None and there else name
