"""Designs with changed keys are sized and assembled as when ``keys.json`` was written by ``keys.py``."""

import json

import pytest
from keys import FILE, fingerprint
from record import designs

from gearwright.spec import edited

AT_ONCE = 8
"""Changes that one test looks at."""
ROUNDING = 1e-5
"""What rounding may add up to: a fingerprint sums some thousand numbers, zeros with rounding among them."""

STORED = json.loads(FILE.read_text(encoding="utf-8"))
PLACED = list(enumerate(STORED))
BATCHES = [PLACED[start : start + AT_ONCE] for start in range(0, len(STORED), AT_ONCE)]
DESIGNS = designs()


@pytest.mark.parametrize(
    "batch", BATCHES, ids=lambda batch: f"{batch[0][1]['design']}-{next(iter(batch[0][1]['change']))}"
)
def test_every_key_moves_what_it_moved(batch):
    moved = {
        f"{row['design']}: {row['change']}": (row["number"], found)
        for place, row in batch
        if abs((found := fingerprint(edited(DESIGNS[row["design"]], row["change"]), place)) - row["number"]) > ROUNDING
    }
    assert moved == {}
