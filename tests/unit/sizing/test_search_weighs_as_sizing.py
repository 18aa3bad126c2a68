"""The search for teeth and the sizing are two ways to one mass: what the chosen teeth weigh in the search is what they
weigh once every gear has been sized, whatever the arrangement, the rules and the load cases are.
"""

import numpy as np
import pytest

import gearwright as gw
import gearwright.sizing.teeth.search as search
from designs import HYBRID, PAIR, changed
from gearwright.sizing import size
from gearwright.spec import edited, parse

SET = '[planetaries.stage]\nsun = "{}"\nring = "{}"\ncarrier = "{}"\nplanets = {}\n'
ALONE = '[pairs.stage]\npinion = "fast"\nwheel = "slow"\n'


def planetary(sun, ring, carrier, planets, slow):
    """Return a design of one planetary set, by its members, planets and slower speed [rpm]."""
    return changed(changed(PAIR, ALONE, SET.format(sun, ring, carrier, planets)), "2000", str(slow))


THREE = changed(PAIR, '["fast", "slow"]', '["fast", "slow", "third"]')
COAXIAL = changed(THREE, 'shaft = "slow"\nspeed_rpm = 2000', 'shaft = "third"\nspeed_rpm = 900')
COAXIAL += '[pairs.next]\npinion = "slow"\nwheel = "third"\ncoaxial_with = "stage"\n'
IDLER = changed(THREE, 'shaft = "slow"\nspeed_rpm = 2000', 'shaft = "third"\nspeed_rpm = 1800')
IDLER += '[pairs.next]\npinion = "stage.wheel"\nwheel = "third"\n'
TWINS = changed(PAIR, '["fast", "slow"]', '["fast", "second", "slow"]')
TWINS = changed(TWINS, 'pinion = "fast"', 'pinion = ["fast", "second"]')
TWINS += '[turbines.other]\nshaft = "second"\npower_kw = 60\nspeed_rpm = 6000\n'
CASES = PAIR + "[cases.climb.turbine]\npower_kw = 95\nspeed_rpm = 4500\n[cases.climb]\nshare = 1\n"
RULES = "[gears]\nhelix_angle_deg = 25\nweb_ratio = 0.6\nrim_thickness_ratio = 3\nmesh_load_factor = 1.3\n"
BEVEL = changed(PAIR, 'wheel = "slow"', 'wheel = "slow"\nkind = "bevel"\naxis_angle_deg = 90\nspiral_angle_deg = 35')
TWO_BEVELS = changed(TWINS, 'wheel = "slow"', 'wheel = "slow"\nkind = "bevel"\naxis_angle_deg = 90')
ISO = '[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n'
FREE = "[gears.iso6336]\nstandard_modules = false\n"
PARKED = "[cases.parked]\nstatic = true\nturbine.torque_nm = 200\n[cases.climb]\nshare = 1\nturbine.power_kw = 95\n"
BEVELS = {
    "standard modules": BEVEL + ISO,
    "modules as they come": BEVEL + ISO + FREE,
    "a given width": BEVEL + ISO + "face_width_ratio = 6\n",
    "a limit load": BEVEL + ISO + PARKED,
    "two pinions": TWO_BEVELS + ISO,
}
DESIGNS = {
    "pair": PAIR,
    "internal pair": PAIR + "internal = true\n",
    "two halves": PAIR + "halves = 2\n",
    "given ratio": PAIR + "ratio = 3.1\n",
    "sun to carrier": planetary("fast", "ground", "slow", 3, 1300),
    "sun to ring": planetary("fast", "slow", "ground", 4, 1900),
    "ring to carrier": planetary("ground", "fast", "slow", 5, 4600),
    "pairs on common axes": COAXIAL,
    "a wheel between two": IDLER,
    "two pinions": TWINS,
    "a case of more torque": CASES,
    "two sets": HYBRID,
}
SHIPPED = ["in-line", "mixed", "mixed-h2", "off-set-h1", "single-planetary", "star", "twin-engine-sprag"]


def masses(text, monkeypatch):
    """Return the mass of the lightest choice as the search weighs it, and that of the sized gears [kg]."""
    weighed, weigh = [], search.aligned
    monkeypatch.setattr(search, "aligned", lambda *given: weighed.append(weigh(*given)) or weighed[-1])
    sizing = size(parse(text))
    return weighed[0].mass.min(), sizing.gear_mass


@pytest.mark.parametrize("rules", ["", RULES], ids=["usual rules", "other rules"])
@pytest.mark.parametrize("name", DESIGNS)
def test_chosen_teeth_weigh_in_the_search_what_sized_gears_weigh(name, rules, monkeypatch):
    searched, sized = masses(DESIGNS[name] + rules, monkeypatch)
    assert searched == pytest.approx(sized, rel=1e-9)


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_designs_weigh_in_the_search_what_their_sized_gears_weigh(name, monkeypatch):
    searched, sized = masses(gw.shipped_design(name).read_text(encoding="utf-8"), monkeypatch)
    assert searched == pytest.approx(sized, rel=1e-9)


@pytest.mark.parametrize("name", [name for name in BEVELS if name != "two pinions"])
def test_sized_bevel_gears_weigh_no_more_than_their_teeth_in_the_search_which_takes_the_least_module(name, monkeypatch):
    """And the teeth that the search finds lightest make no lighter complete gearbox that passes."""
    fronts, weigh = [], search.aligned
    monkeypatch.setattr(search, "aligned", lambda *given: fronts.append(weigh(*given)) or fronts[-1])
    sizing, front = size(parse(BEVELS[name])), fronts[0]
    (own,) = np.flatnonzero(np.all([front.teeth[gear] == number for gear, number in sizing.teeth.items()], axis=0))
    assert sizing.gear_mass <= front.mass[own] * (1.0 + 1e-9)
    lightest = {f"pairs.{gear}_teeth": int(front.teeth[gear][front.mass.argmin()])
                for gear in sizing.teeth}  # fmt: skip
    other = size(edited(sizing.design, lightest))
    fails = any(check.fails for check in other.checks)
    assert fails or gw.complete_mass(other).total >= gw.complete_mass(sizing).total * (1.0 - 1e-9)
