"""Every verb answers about every design what it answered when ``answers.json`` was written by ``answers.py``."""

import json

import pytest
from answers import FILE, answered, differences, leaves
from record import designs, sized

DESIGNS = designs()
STORED = json.loads(FILE.read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", DESIGNS)
def test_answers_did_not_move(name):
    assert differences(STORED[name], answered(sized(name))) == {}


def test_no_design_is_stored_that_is_gone():
    assert STORED.keys() == DESIGNS.keys()


def test_numbers_words_and_signs_all_count():
    """Two records that differ in one leaf differ in their leaves; sentences do not count."""
    assert list(leaves({"a": {"kind": True}, "b": [1.5, 2j]})) != list(leaves({"a": {"kind": False}, "b": [1.5, 2j]}))
    assert list(leaves("sun")) != list(leaves("ring"))
    assert list(leaves("a sentence")) == []
