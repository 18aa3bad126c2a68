"""The name of a schema counts up when a key of its answer changes, so that no program reads what it does not know."""

from __future__ import annotations

import pytest
from schemas import digest, keys, recorded

from gearwright.cli.answers import ANSWERS, answer_schema


@pytest.mark.parametrize("command", ANSWERS)
def test_keys_of_an_answer_change_with_the_name_of_its_schema_alone(command: str) -> None:
    name = answer_schema(command)["$id"]
    assert name in recorded(), f"{name} is new: PYTHONPATH=tests python tests/golden/schemas.py"
    assert digest(command) == recorded()[name], f"keys of {name} changed: count its number up in REVISIONS"


def test_a_key_that_is_renamed_moves_the_digest() -> None:
    schema = {
        "properties": {"result": {"$ref": "#/$defs/A"}},
        "$defs": {"A": {"properties": {"x_mm": {"type": "string"}}}},
    }
    renamed = {**schema, "$defs": {"A": {"properties": {"y_mm": {"type": "string"}}}}}
    assert sorted(keys(schema)) != sorted(keys(renamed))
    assert "/A/x_mm: string" in set(keys(schema))
