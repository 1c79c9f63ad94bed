"""Reads YAML that people write; apart from probe.files, which agents' own processes import."""

from __future__ import annotations

from pathlib import Path

import yaml
from pydantic import ValidationError

from probe import reading
from probe.errors import BadData
from probe.files import Document, fault, unread


def read_yaml(path: Path, model: type[Document], remedy: str) -> Document:
    """Read a YAML or JSON file that a person wrote.

    Args:
        path: The file.
        model: Its schema.
        remedy: What to do about a file that breaks it.

    Raises:
        BadData: It can't be read, is too large, or breaks the schema; the first broken field is
            named.
    """
    try:
        return model.model_validate(yaml.safe_load(reading.contents(path)))
    except OSError as error:
        raise BadData(path, unread(path, error), "Check the path") from error
    except ValidationError as error:
        raise BadData(path, fault(error, "the file"), remedy) from error
    except (ValueError, yaml.YAMLError) as error:
        raise BadData(path, f"is no YAML: {error}", remedy) from error
