"""AGMA 2003 as designs reach it: keys, refusals, limits shown, Miner's sum, modules that just bear the load."""

import numpy as np
import pytest

from designs import PAIR, changed, problem
from gearwright.parts.agma2003 import BENDING, BENDING_CRITICAL, CONTACT, BevelEdition, rate_agma_bevel
from gearwright.parts.iso6336 import damage_part
from gearwright.sizing import size
from gearwright.sizing.rating import METHODS, Ask, MeshSpectrum, bevel_pair, rating_of
from gearwright.sizing.rating.agma import bevel_making_of as making_of, duty_of
from gearwright.spec import parse

BEVEL = f"""\
{PAIR}kind = "bevel"
axis_angle_deg = 90
spiral_angle_deg = 35
pinion_teeth = 20
wheel_teeth = 60

[gears]
rating = "agma2001"
"""
TABLE = "[gears.agma2003]\n"


def rated(text):
    (mesh,) = size(parse(text)).meshes
    assert mesh.rating.method == "agma2003"
    return mesh.rating


@pytest.mark.parametrize("name", ["agma2001", "agma2003"])
def test_bevel_stages_of_agma_are_rated_by_agma_2003(name):
    assert rated(changed(BEVEL, "agma2001", name)) == rated(BEVEL)


@pytest.mark.parametrize(
    ("rules", "path", "told"),
    [
        ('steel = "nitralloy-135m"\ngrade = 1', "gears.agma2003.grade", "nitralloy-135m steel has 2"),
        ('steel = "through-hardened"\ngrade = 3', "gears.agma2003.grade", "has 1 and 2"),
        ('steel = "through-hardened"\nhardness_hb = 420', "gears.agma2003.hardness_hb", "180 to 400 HB"),
        ('steel = "through-hardened"\nwheel_hardness_hb = 150', "gears.agma2003.wheel_hardness_hb", "180 to 400 HB"),
        ("quality_number = 12", "gears.agma2003.quality_number", "11"),
        ("reliability = 0.99999", "gears.agma2003.reliability", "0.9999"),
        ('edition = "C10"', "gears.agma2003.edition", "B97"),
    ],
)
def test_what_the_tables_do_not_have_is_told_by_its_key(rules, path, told):
    found = problem(BEVEL + TABLE + rules + "\n", sized=True)
    assert path in found.path
    assert told in found.message


def test_a_life_beyond_the_figures_is_rated_by_their_last_lines():
    """3.4822 N^−0.0602 and 1.3558 N^−0.0178 beyond 1e10 cycles too."""
    mesh = size(parse(BEVEL + "[service]\nlife_h = 30000\n")).meshes[0].rating.factors.mesh
    assert mesh.cycles[0] > 1e10
    assert mesh.contact_cycles[0] == pytest.approx(3.4822 * mesh.cycles[0] ** -0.0602, rel=1e-9)
    assert mesh.bending_cycles[0] == pytest.approx(1.3558 * mesh.cycles[0] ** -0.0178, rel=1e-9)


def test_cylindrical_stages_are_not_rated_by_agma_2003():
    text = changed(BEVEL, 'kind = "bevel"\naxis_angle_deg = 90\nspiral_angle_deg = 35\n', "")
    found = problem(changed(text, "agma2001", "agma2003"))
    assert found.path == "gears.rating" or found.path.endswith("gears.rating")
    assert "AGMA 2003 does not cover cylindrical gears" in found.message


@pytest.mark.parametrize("spiral", ["35", "0"])
def test_the_module_that_is_asked_for_just_bears_the_load(spiral):
    rating = rating_of(parse(changed(BEVEL, "spiral_angle_deg = 35", f"spiral_angle_deg = {spiral}")), "stage")
    ask = Ask(400.0 / 20.0, (20, 60), 8.0, speed=300.0)
    bending, contact = (float(module) for module in METHODS["agma2003"].module(ask, rating))
    rules, making = rating.rules.agma2003, making_of(rating)
    duty = duty_of(rating, ask, 400.0, speed=300.0, life=rating.service.life)
    roots = rate_agma_bevel(bevel_pair((20, 60), bending, 8.0 * bending, rating), duty, making).gears
    flanks = rate_agma_bevel(bevel_pair((20, 60), contact, 8.0 * contact, rating), duty, making).gears
    assert min(gear.bending_safety for gear in roots) == pytest.approx(rules.bending_safety, rel=2e-3)
    assert min(gear.contact_safety for gear in flanks) == pytest.approx(rules.pitting_safety, rel=2e-3)


def test_modules_asked_at_once_are_those_of_each_alone():
    rating = rating_of(parse(BEVEL), "stage")
    teeth = np.array([18, 20, 20]), np.array([54, 60, 70])
    torques = np.array([300.0, 400.0, 500.0]) / teeth[0]
    both = METHODS["agma2003"].module(Ask(torques, teeth, 8.0, speed=300.0), rating)
    for place in range(3):
        pair = int(teeth[0][place]), int(teeth[1][place])
        alone = METHODS["agma2003"].module(Ask(float(torques[place]), pair, 8.0, speed=300.0), rating)
        assert [float(mode[place]) for mode in both] == pytest.approx([float(module) for module in alone], rel=1e-12)
    assert [float(module) for module in METHODS["agma2003"].module(Ask(0.0, (20, 60), 8.0), rating)] == [0.0, 0.0]


@pytest.mark.parametrize(("critical", "curve"), [("false", BENDING), ("true", BENDING_CRITICAL)])
def test_damage_is_stress_over_its_limit_on_the_curves(critical, curve):
    rating = rating_of(parse(BEVEL + TABLE + f"critical_service = {critical}\n"), "stage")
    ask = Ask(0.0, (20, 60), 8.0, idlers=(False, True), passes=(2.0, 1.0))
    spectrum = MeshSpectrum(rating, ask, 3e-3, 24e-3, (300.0, 200.0), (300.0, 250.0), (1e6, 4e6), None)
    found = [parts.within() for parts in METHODS["agma2003"].damage(spectrum)]
    pair, making = bevel_pair((20, 60), 3e-3, 24e-3, rating), making_of(rating)
    for gear, turns in enumerate((2.0, 1.0 / 3.0)):
        flanks, roots = [], []
        for torque, speed in ((300.0, 300.0), (200.0, 250.0)):
            one = rate_agma_bevel(pair, duty_of(rating, ask, torque, speed=speed, life=1.0), making)
            flanks.append(one.gears[gear].contact_stress / making.strengths[gear].contact)
            roots.append(one.gears[gear].bending_stress / making.strengths[gear].bending / (0.7 if gear else 1.0))
        cycles = [turns * 1e6, turns * 4e6]
        assert found[gear].pitting == pytest.approx(sum(map(damage_part, cycles, flanks, [CONTACT] * 2)), rel=1e-9)
        assert found[gear].bending == pytest.approx(sum(map(damage_part, cycles, roots, [curve] * 2)), rel=1e-9)
    assert METHODS["agma2003"].life_slope(rating, "pitting", None) == pytest.approx(1.0 / 0.0602)
    assert METHODS["agma2003"].life_slope(rating, "bending", None) == pytest.approx(1.0 / 0.1192)


def test_cases_that_share_the_life_are_summed_and_leave_more_than_the_heaviest_alone():
    shared = (
        BEVEL + "[cases.hard.turbine]\nrating = 1\n[cases.easy.turbine]\npower_kw = 40\n[cases.hard]\nshare = 0.1\n"
    )
    found = rated(shared + "[cases.easy]\nshare = 0.9\n")
    alone = found.factors.gears
    for gear in (0, 1):
        assert found.pitting[gear] > alone[gear].contact_safety
        assert found.bending[gear] > alone[gear].bending_safety


def test_rows_tell_at_which_limit_a_factor_stands():
    record = rated(f"{BEVEL}cutter_radius_mm = 25\n{TABLE}blank_temperature = 160\n")
    limits = {(row.chapter, row.quantity): row.limit for row in METHODS["agma2003"].factors(record)}
    assert limits["mesh", "curvature"] == "greatest"
    assert limits["mesh", "temperature"] == ""
    cool = {row.quantity: row.limit for row in METHODS["agma2003"].factors(rated(BEVEL)) if row.chapter == "mesh"}
    assert cool["curvature"] == "least, or straight teeth"
    assert cool["temperature"] == "least: up to 250 °F"
    assert all(row.clause.startswith("ANSI/AGMA 2003-D19") for row in METHODS["agma2003"].factors(record))


def test_making_and_checks_speak_of_agma_2003():
    text = BEVEL + TABLE + 'steel = "through-hardened"\ngrade = 1\nhardness_hb = 350\nwheel_hardness_hb = 250\n'
    record = rated(text + 'edition = "B97"\nmounting = "straddle"\ncrowned = false\n')
    assert record.edition is BevelEdition.B97
    assert record.factors.mesh.crowning == 2.0
    assert record.factors.mesh.hardness_ratio[1] > 1.0
    assert record.factors.strength[0].contact > record.factors.strength[1].contact
    making = METHODS["agma2003"].making(rating_of(parse(text), "stage"))
    assert (making.accuracy, making.steel) == (
        "Q_v 11 AGMA 2003",
        ("AGMA 2003-D19", "through-hardened, grade 1, 350 HB"),
    )
    checks = [check for check in size(parse(text)).checks if check.clause.startswith("AGMA 2003")]
    assert [check.mode for check in checks] == ["pitting", "tooth root", "pitting", "tooth root", "velocity"]
