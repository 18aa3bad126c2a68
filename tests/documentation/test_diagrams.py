"""Every length and angle of the design file is drawn where it is measured."""

import pytest
from test_site import reference

from gearwright.render.diagrams import DIAGRAMS
from gearwright.spec import quantity_of
from gearwright.spec.design import Design

ENDINGS = {"length": "mm", "angle": "deg"}
"""Dimension of what is measured -> unit that its key is drawn with."""


def measured():
    """Return table -> keys of its lengths and angles."""
    keys = {}
    for record, path in reference.sections_of(Design).items():
        for name, info in record.model_fields.items():
            quantity = quantity_of(info)
            if quantity is not None and quantity.dimension in ENDINGS:
                keys.setdefault(".".join(path), set()).add(f"{name}_{ENDINGS[quantity.dimension]}")
    return keys


def test_every_length_and_angle_is_in_a_diagram():
    drawn = {(table, key) for diagram in DIAGRAMS for table in diagram.tables for key in diagram.keys}
    wanted = {(table, key) for table, keys in measured().items() for key in keys}
    assert len(wanted) > 70
    assert sorted(wanted - drawn) == []


@pytest.mark.parametrize("diagram", DIAGRAMS, ids=lambda diagram: diagram.name)
def test_a_diagram_says_keys_of_its_tables_alone(diagram):
    keys = measured()
    assert diagram.keys, "it says no key"
    assert diagram.keys <= set().union(*(keys[table] for table in diagram.tables))
    assert all(diagram.keys & keys[table] for table in diagram.tables)
