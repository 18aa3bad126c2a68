"""Size, fly, resize until the life is met."""

import pytest

from gearwright.errors import DesignError, SolveError
from gearwright.mission import fly
from gearwright.mission.lives import gear_damage, life as life_module, size_for_life
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import edited_mission, parse, read, read_mission

DESIGN = read(shipped_design("in-line-h2"))
MISSION = read_mission(shipped_mission("thesis"))


def test_a_longer_life_costs_mass_and_is_met():
    short = size_for_life(DESIGN, MISSION, 100.0)
    long = size_for_life(DESIGN, MISSION, 20_000.0)
    assert short.rounds == 0
    assert short.mass_of_life == 0.0
    assert long.damages[0].life >= 20_000.0
    assert 0.0 < long.mass_of_life < long.mass_before
    assert long.flight.sizing is long.sizing


def test_only_the_stage_that_fails_is_strengthened():
    """The first sun fails first in this mission, by pitting, before 5000 h; the second stage keeps its rules."""
    found = size_for_life(DESIGN, MISSION, 5000.0)
    assert found.rounds > 0
    assert found.sizing.design.planetaries["second"].gears is None
    assert found.sizing.design.rules("first").contact_safety > DESIGN.rules("first").contact_safety


def test_a_life_out_of_reach_is_refused(monkeypatch):
    monkeypatch.setattr(life_module, "MOST_ROUNDS", 2)
    with pytest.raises(SolveError, match="after 2 rounds"):
        size_for_life(DESIGN, MISSION, 1e6)


def test_a_life_of_a_material_without_s_n_data_is_refused_with_what_it_lacks_and_what_helps():
    """Neither the design nor the mission says how its flanks are hardened; the mission may."""
    text = shipped_design("in-line-h2").read_text(encoding="utf-8").replace('"nitriding-steel-785"', '"mine"')
    mine = parse(f"{text}\n{MINE}")
    with pytest.raises(DesignError, match="'mine' has no class of ISO 6336-5 and so no S-N data; give steel, one of"):
        size_for_life(mine, MISSION, 100.0)
    told = edited_mission(MISSION, {"gears.steel": "nitrided"})
    assert gear_damage(fly(size(mine), told)) == gear_damage(fly(size(DESIGN), MISSION))


MINE = """
[materials.mine]
elastic_modulus_gpa = 210
poisson_ratio = 0.3
density_kg_m3 = 7850
yield_strength_mpa = 785
hardness_hb = 600
"""
"""The material of the shipped design without its class."""
