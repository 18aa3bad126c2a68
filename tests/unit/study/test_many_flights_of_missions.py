"""Many flights of every shipped mission are each alone; whoever computes them, in whatever parts, killed or not."""

from __future__ import annotations

from pathlib import Path

import pytest
from fault_studies import command, done, ended, kill, until

import gearwright as gw
from gearwright.spec import parse_study
from gearwright.study.cases import cases, flown_together
from gearwright.study.journal import rows_of
from gearwright.study.running import run_study

SHIPPED = {
    "thesis": "in-line-h2",
    "thesis-chapter-4": "in-line-h2",
    "equal-power": "off-set-h2",
    "strategies": "in-line-h2",
    "ways-down": "in-line-h2",
    "regional-250nm": "in-line",
    "regional-aircraft": "in-line",
    "hybrid-reserves": "in-line-h2",
    "rotor-schedule": "face-gear-split-torque",
    "ec120b-sortie": "ec120b",
    "ec120b-trim": "ec120b",
}
"""Mission -> a design that flies it."""
SCATTER = {"mission.isa_offset_k": {"distribution": "normal", "mean": -4.0, "deviation": 3.0}}


def test_every_shipped_mission_is_flown_many_times():
    assert set(SHIPPED) == {path.stem for path in gw.shipped_mission("thesis").parent.glob("*.toml")}


@pytest.mark.parametrize("name", SHIPPED)
def test_scattered_flights_of_a_mission_are_those_one_by_one(name):
    """1e-12 is asked; they have the same bits."""
    design, mission = gw.read(SHIPPED[name]), gw.read_mission(name)
    results = ("fly.fuel", "fly.duration", "fly.gearbox_loss")
    table = gw.fly_many(design, mission, SCATTER, 3, seed=5, results=results)
    sizing = gw.size(design)
    for row in table.rows:
        offset = row.inputs["mission.isa_offset_k"]
        flight = gw.fly(sizing, gw.edited_mission(mission, {"isa_offset_k": offset}))
        for key, alone in zip(results, (flight.fuel, flight.duration, flight.balance.gearbox_loss), strict=True):
            assert row.number(key) == pytest.approx(alone, rel=1e-12)


TEXT = """
schema = 1
name = "killed"
designs = ["in-line-h2"]
results = ["fly.fuel", "fly.minimum_charge", "fly.life"]
[fly]
mission = "thesis"
[axes]
"mission.isa_offset_k" = {distribution = "normal", mean = 0, deviation = 8}
"mission.phases.cruise.duration_min" = {from = 25, to = 50}
[sampling]
method = "random"
count = COUNT
seed = 11
"""


def study_of(count):
    """Return a study of scattered flights."""
    return parse_study(TEXT.replace("COUNT", str(count)))


def test_parts_of_any_size_and_any_number_of_workers_give_the_same_bits():
    designs, study = {"in-line-h2": gw.read("in-line-h2")}, study_of(12)
    whole, drawn = run_study(study, designs), list(cases(study))
    for size in (1, 5):
        parts = [flown_together(study, designs, drawn[k : k + size]) for k in range(0, len(drawn), size)]
        assert [row for part in parts for row in part] == list(whole.rows)
    for workers in (1, 3):
        assert run_study(study, designs, workers=workers) == whole


def test_flights_that_are_killed_are_resumed_to_the_same_bits(tmp_path: Path):
    count = 200
    (tmp_path / "study.toml").write_text(TEXT.replace("COUNT", str(count)), encoding="utf-8")
    process = command(tmp_path, "study", "study.toml", "--journal", "j", "--workers", "2")
    with ended(process):
        until(lambda: ((tmp_path / "j").exists() and done(tmp_path / "j") > 0) or process.poll() is not None, "flights")
        kill(process.pid)
    flown = done(tmp_path / "j")
    assert 0 < flown < count
    process = command(tmp_path, "resume", "j")
    with ended(process):
        process.communicate(timeout=120.0)
        assert process.returncode == 0
    rows = rows_of(tmp_path / "j")
    assert len(rows) == count
    drawn = list(cases(study_of(count)))
    designs = {"in-line-h2": gw.read("in-line-h2")}
    for first in (0, flown - 8, count - 16):  # flights before, about and after the kill
        assert rows[first : first + 16] == flown_together(study_of(count), designs, drawn[first : first + 16])
