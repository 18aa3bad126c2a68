"""Pieces of the ratings by AGMA 2001 and 2003, without a sizing: steels, yielding, lives, damages."""

import math
from dataclasses import replace
from types import SimpleNamespace

import pytest

from gearwright.parts.agma908 import bending_geometry
from gearwright.parts.agma2001 import overload_distribution
from gearwright.parts.agma2003 import BENDING, CONTACT
from gearwright.parts.iso6336 import Treatment, damage_part
from gearwright.sizing.rating.agma import (
    bevel_making_of,
    hobbed_pair,
    making_of as cylindrical_making_of,
    worst_yielding,
    yield_strength_of,
    yielding_checks,
)
from gearwright.sizing.rating.iso6336 import Iso6336
from gearwright.sizing.rating.iso6336_inputs import steel_of
from gearwright.sizing.rating.protocol import MeshSpectrum
from rated_pieces import FIRST, METHODS, SECOND, loaded, near, rating


def test_yielding_is_judged_in_the_worst_static_case_of_agma_2001():
    """s_ay K_y J K_f F m_t/(W_max K_my) with W = T/r_1: 3 and 2 kN m once."""
    own = rating("agma2001")
    mesh = loaded("agma2001", cases=3, own=own)
    assert worst_yielding(mesh) is None
    loads = tuple(
        mesh.loads[0]._replace(torque=torque, static=static, case=name)
        for torque, static, name in ((9000.0, False, "lasts"), (2000.0, True, "light"), (3000.0, True, "worst"))
    )
    found = worst_yielding(mesh._replace(loads=loads))
    assert found.case == "worst"
    pair = hobbed_pair(mesh.heaviest.ask, 10.0, own)
    for gear in (0, 1):
        strength = yield_strength_of(own, gear)
        assert found.strengths[gear] == strength
        geometry = bending_geometry(pair, gear)
        transverse = 4e-3 / math.cos(own.helix_angle)
        force = 3000.0 / (0.5 * transverse * 23)
        expected = (
            strength * own.rules.agma2001.yield_factor * float(geometry.factor) * float(geometry.stress_correction)
        )
        expected *= 40e-3 * transverse / (force * float(overload_distribution(40e-3)))
        assert found.safeties[gear] == pytest.approx(expected, rel=1e-9)
    rated = SimpleNamespace(static=found, yielding_asked=1.3)
    checks = list(yielding_checks(rated, (FIRST, SECOND)))
    assert [(c.part, c.mode, c.value, c.limit, c.symbol, c.case) for c in checks] == [
        (part, "yielding root", found.safeties[gear], 1.3, "S_y", "worst") for gear, part in enumerate((FIRST, SECOND))
    ]
    assert list(yielding_checks(SimpleNamespace(static=None, yielding_asked=1.3), (FIRST, SECOND))) == []


def test_life_slopes_of_agma_are_the_inverse_of_its_exponents():
    assert METHODS["agma2003"].life_slope(rating("agma2003"), "pitting", None) == near(1.0 / 0.0602)
    assert METHODS["agma2003"].life_slope(rating("agma2003"), "bending", None) == near(1.0 / 0.1192)
    assert METHODS["agma2001"].life_slope(rating("agma2001"), "pitting", None) == near(1.0 / 0.056)
    assert METHODS["agma2001"].life_slope(rating("agma2001"), "bending", None) == near(1.0 / 0.1192)
    steel = steel_of(rating("iso6336"))
    assert steel.treatment is Treatment.NITRIDED
    slopes = [Iso6336().life_slope(rating("iso6336"), mode, None) for mode in ("pitting", "bending")]
    assert slopes == pytest.approx([math.log(20.0) / math.log(1.3), math.log(3000.0) / math.log(1.6)], rel=1e-6)


def test_a_wheel_of_its_own_steel_by_agma_2001():
    """Grade 1 at 240 HB: s_at = 77.3 HB + 12 800, s_ac = 322 HB + 29 100 psi; rims by 1.6 ln(2.242/m_B)."""
    own = rating("agma2001")
    rules = own.rules.agma2001
    wheel = SimpleNamespace(steel="through-hardened", grade=1, hardness_hb=240.0)
    other = rules.model_copy(update={"steel": "through-hardened", "grade": 1, "hardness_hb": 300.0, "wheel": wheel})
    changed = replace(own, rules=own.rules.model_copy(update={"agma2001": other, "rim_ratio": 0.8}))
    making = cylindrical_making_of(changed)
    psi = 6894.757
    assert making.strength.bending == pytest.approx((77.3 * 300.0 + 12800.0) * psi, rel=1e-6)
    assert making.wheel.strength.bending == pytest.approx((77.3 * 240.0 + 12800.0) * psi, rel=1e-6)
    assert making.wheel.strength.contact == pytest.approx((322.0 * 240.0 + 29100.0) * psi, rel=1e-6)
    hard = making.wheel.hardnesses
    assert (hard.pinion, hard.wheel, hard.hard_pinion, hard.hard_wheel) == (300.0, 240.0, False, False)
    assert hard.roughness == rules.flank_roughness
    assert making.rims == (1.0, near(1.6 * math.log(2.242 / 0.8)))
    assert cylindrical_making_of(own).rims == (1.0, 1.0)
    case = other.model_copy(update={"steel": "carburised"})
    told_case = cylindrical_making_of(replace(changed, rules=changed.rules.model_copy(update={"agma2001": case})))
    assert told_case.wheel.hardnesses.hard_pinion and not told_case.wheel.hardnesses.hard_wheel


def test_yield_strengths_of_two_steels_are_each_gears_own():
    """482 HB − 32 800 psi of AGMA 2001-D04, clause 16.4: 300 HB and 240 HB."""
    own = rating("agma2001")
    wheel = SimpleNamespace(steel="through-hardened", grade=1, hardness_hb=240.0)
    other = own.rules.agma2001.model_copy(
        update={"steel": "through-hardened", "grade": 1, "hardness_hb": 300.0, "wheel": wheel}
    )
    changed = replace(own, rules=own.rules.model_copy(update={"agma2001": other}))
    mesh = loaded("agma2001", own=changed)
    once = mesh.loads[0]._replace(static=True)
    found = worst_yielding(mesh._replace(loads=(once,)))
    assert found.strengths == pytest.approx([(482.0 * hb - 32800.0) * 6894.757 for hb in (300.0, 240.0)], rel=1e-6)
    unknown = replace(own, material=replace(own.material, yield_strength=None))
    case = own.rules.agma2001.model_copy(update={"steel": "carburised", "grade": 1, "wheel": None})
    bare = replace(unknown, rules=own.rules.model_copy(update={"agma2001": case}))
    assert worst_yielding(mesh._replace(rating=bare, loads=(once,))) is None
    half = bare.rules.agma2001.model_copy(update={"wheel": wheel})
    half_known = replace(bare, rules=bare.rules.model_copy(update={"agma2001": half}))
    assert yield_strength_of(half_known, 1) is not None
    assert worst_yielding(mesh._replace(rating=half_known, loads=(once,))) is None


@pytest.mark.parametrize("method", ["agma2001", "agma2003"])
def test_damages_of_agma_are_turns_over_what_the_curves_bear(method):
    """N where the stress cycle factor equals the stress over its limit; the wheel turns 23/59 as often, three mates."""
    torque = 900.0 if method == "agma2001" else 2600.0
    own = loaded(method, torque, width=30e-3)
    ask = own.heaviest.ask._replace(passes=(2.0, 3.0))
    load = own.heaviest._replace(ask=ask, life=1.0)
    factors = METHODS[method].rate(own._replace(heaviest=load, loads=(load,))).factors
    spectrum = MeshSpectrum(
        own.rating, ask, own.module, own.face_width, torques=(torque,), speeds=(500.0,), turns=(3e6,), steel=None
    )  # type: ignore[arg-type]
    mesh = factors if method == "agma2001" else factors.mesh
    damages = [parts.within() for parts in METHODS[method].damage(spectrum)]
    making = (cylindrical_making_of if method == "agma2001" else bevel_making_of)(own.rating)
    curves = making.curves_of(0) if method == "agma2001" else (CONTACT, BENDING)
    for gear, turns in enumerate((2.0 * 3e6, 3.0 * 3e6 * 23 / 59)):
        one = factors.gears[gear]
        flank = float(one.contact_stress * mesh.contact_cycles[gear] / one.contact_limit)
        root = float(one.bending_stress * mesh.bending_cycles[gear] / one.bending_limit)
        assert damages[gear].pitting == pytest.approx(damage_part(turns, flank, curves[0]), rel=1e-9)
        assert damages[gear].bending == pytest.approx(damage_part(turns, root, curves[1]), rel=1e-9)
        assert damages[gear].pitting > 0.0
