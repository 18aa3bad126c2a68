"""Pieces of the rating by ISO 6336, without a sizing: limits, inputs, editions, oil films, static cases."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from gearwright.parts.iso6336 import Edition, RatingMethod, Treatment
from gearwright.parts.losses import OIL_DENSITY
from gearwright.parts.micropitting import FilmMesh, OilGrade, film_thickness
from gearwright.sizing.rating import METHODS as ALL
from gearwright.sizing.rating.geometry import cylindrical_mesh
from gearwright.sizing.rating.iso6336 import Strain, limited, of_each, safeties, static_checks
from gearwright.sizing.rating.iso6336_inputs import clause_of, quality_of, steel_of
from gearwright.sizing.rating.iso6336_scuffing import film_checks, oil_film, oil_of, scuffing_checks
from gearwright.sizing.rating.protocol import Factor
from rated_pieces import FIRST, MESH, METHODS, SECOND, loaded, near, rating


def test_static_cases_of_iso_6336_are_judged_by_the_one_that_comes_nearest():
    mesh = loaded("iso6336", cases=2)
    loads = (
        mesh.loads[0],
        mesh.loads[0]._replace(torque=1200.0, static=True, case="light", life=1.0),
        mesh.loads[0]._replace(torque=2400.0, static=True, case="worst", life=1.0),
    )
    rated = METHODS["iso6336"].rate(mesh._replace(loads=loads))
    assert rated.static.case == "worst"
    asked = rated.static_asked
    rows = [(c.part, c.mode, c.value, c.limit, c.symbol, c.exponent) for c in static_checks(rated, (FIRST, SECOND))]
    expected = []
    for part, strength in zip((FIRST, SECOND), rated.static.strengths, strict=True):
        expected.append((part, "static pitting", float(strength.contact_safety), asked[0], "S_H", 0.5))
        expected.append((part, "static tooth root", float(strength.bending_safety), asked[1], "S_F", 1.0))
        if strength.yielding_safety is not None:
            expected.append((part, "yielding root", float(strength.yielding_safety), asked[2], "S_y", 1.0))
    assert rows == expected


def test_scuffing_and_micropitting_are_judged_by_the_asked_method():
    film = SimpleNamespace(
        scuffing=SimpleNamespace(safety=2.1), flash=SimpleNamespace(safety=3.2),
        micropitting=SimpleNamespace(safety=1.4, point="AB"), scuffing_asked=1.8, micropitting_asked=1.1,
    )  # fmt: skip
    rows = {}
    for by in ("integral", "flash", "both"):
        film.scuffing_by = by
        rows[by] = [
            (c.part, c.mode, c.value, c.limit, c.symbol)
            for checks in (scuffing_checks(film, MESH), film_checks(film, MESH))
            for c in checks
        ]
    tiny = (MESH, "micropitting", 1.4, 1.1, "S_λ")
    assert rows["integral"] == [(MESH, "scuffing", 2.1, 1.8, "S_intS"), tiny]
    assert rows["flash"] == [(MESH, "scuffing", 3.2, 1.8, "S_B"), tiny]
    assert rows["both"] == [(MESH, "scuffing", 2.1, 1.8, "S_intS"), (MESH, "scuffing", 3.2, 1.8, "S_B"), tiny]
    film.micropitting = film.flash = film.scuffing = None
    assert list(film_checks(film, MESH)) == list(scuffing_checks(film, MESH)) == []


def test_every_clamp_of_iso_6336_is_named_at_its_value_and_nowhere_else():
    """K_3 2 and 1, K_α 1, Z_B 1, Z_W 1 and 1.2, Z_X 1, Y_X 1, 0.8, 0.85, Y_B 1, Y_DT 1 and 0.7."""
    clamps = [
        ("dynamic factor", "slope", 1.0, "least: from 3 m/s"),
        ("dynamic factor", "slope", 2.0, "greatest: up to 0.2 m/s"),
        ("load factors", "transverse contact", 1.0, "least"), ("load factors", "transverse bending", 1.0, "least"),
        ("pitting", "single contact", 1.0, "least: pitch point"),
        ("strength of flanks", "work hardening", 1.0, "least"),
        ("strength of flanks", "work hardening", 1.2, "greatest: 130 HB"),
        ("strength of flanks", "size", 1.0, "greatest"),
        ("strength of roots", "size", 1.0, "greatest"), ("strength of roots", "size", 0.8, "least"),
        ("strength of roots", "size", 0.7, "least"),
        ("strength of roots", "size", 0.85, "least"), ("tooth root", "rim", 1.0, "least: thick rim"),
        ("tooth root", "deep tooth", 1.0, "greatest"), ("tooth root", "deep tooth", 0.7, "least"),
    ]  # fmt: skip
    steel = steel_of(rating("iso6336"))
    mild = replace(steel, contact_strength=1000e6)
    for chapter, quantity, value, words in clamps:
        row = Factor(chapter, quantity, "", (value,), "ratio", "")
        at, beside = limited([row, replace(row, values=(value * 1.001,))], RATED, (mild, mild))  # type: ignore[arg-type]
        assert (at.limit, beside.limit) == (words, "")


STRENGTHS = SimpleNamespace(lubricant=0.97, speed=0.98, roughness=1.01, life=0.84)
RATED = SimpleNamespace(contact_strength=(STRENGTHS,) * 2, root_strength=(STRENGTHS,) * 2, cycles=(1e9, 2e10))
"""Of gears of which the second bears more cycles than tables of ISO 6336 have."""


@pytest.mark.parametrize(
    ("strength", "words"),
    [(700e6, "σ_Hlim counts as 850"), (850e6, "σ_Hlim counts as 850"), (1000e6, ""), (1200e6, "σ_Hlim counts as 1200"),
     (1500e6, "σ_Hlim counts as 1200")],
)  # fmt: skip
def test_film_and_life_stand_at_their_limits_by_the_softer_steel(strength, words):
    steel = replace(steel_of(rating("iso6336")), contact_strength=strength, treatment=Treatment.CASE_HARDENED)
    other = replace(steel, contact_strength=1600e6, treatment=Treatment.NITRIDED)
    values = {"lubricant": 0.97, "speed": 0.98, "roughness": 1.01}
    for name, value in values.items():
        row = Factor("strength of flanks", name, "", (value,), "ratio", "")
        (found,) = limited([row], RATED, (other, steel))  # type: ignore[arg-type]
        assert found.limit == words
    for chapter, values in (("strength of flanks", {1.6: "greatest: static", 1.3: "greatest: static"}),
                            ("strength of roots", {2.5: "greatest: static", 1.6: "greatest: static"})):  # fmt: skip
        for value, word in (values | {0.84: "beyond 1e10 cycles", 0.85: "", 1.0: ""}).items():
            (found,) = limited([Factor(chapter, "life", "", (value,), "ratio", "")], RATED, (other, steel))  # type: ignore[arg-type]
            assert found.limit == word


def test_clauses_are_those_of_the_edition():
    for source, former, din in (
        ("ISO 6336-1:2019, clause 4", "ISO 6336-1:2006, clause 4", "DIN 3990-1:1987"),
        ("ISO 6336-2:2019, clause 5", "ISO 6336-2:2006, clause 5", "DIN 3990-2:1987"),
        ("ISO 6336-3:2019, clause 5", "ISO 6336-3:2006, clause 5", "DIN 3990-3:1987"),
        ("ISO/TS 6336-20:2017, C_eff", "ISO/TR 13989-1:2000, C_eff", "DIN 3990-4:1987"),
        ("ISO 1328-1:2013", "ISO 1328-1:2013", "ISO 1328-1:2013"),
    ):
        assert clause_of(source, Edition.ISO2019) == source
        assert clause_of(source, Edition.ISO2006) == former
        assert clause_of(source, Edition.DIN1987) == din


def test_the_oil_of_a_design_is_thinned_to_its_temperature():
    """By Walther between ν_40 and ν_100 where both are given; η = ν ρ; the load stage and X_L by its kind."""
    rules = rating("iso6336").rules.iso6336.model_copy(
        update={"oil_viscosity": 150.0, "oil_viscosity_100": 15.5, "oil_temperature": 80.0, "scuffing_stage": 11,
                "oil_type": "polyglycol"}
    )  # fmt: skip
    low, high = math.log10(math.log10(150.7)), math.log10(math.log10(16.2))
    part = math.log10(353.0 / 313.0) / math.log10(373.0 / 313.0)
    expected = 10.0 ** (10.0 ** (low + (high - low) * part)) - 0.7
    oil = oil_of(rules)
    assert oil.dynamic_viscosity == pytest.approx(1e-6 * expected * OIL_DENSITY, rel=1e-9)
    assert (oil.temperature, oil.load_stage, oil.kind, oil.supply) == (80.0, 11.0, 0.7, 1.2)
    assert oil.viscosity_40 == near(150e-6)
    at_40 = oil_of(rules.model_copy(update={"oil_viscosity_100": None, "oil_temperature": 40.0}))
    assert at_40.dynamic_viscosity == pytest.approx(150e-6 * OIL_DENSITY, rel=1e-9)


def test_strains_of_several_loads_are_taken_apart_in_order():
    strain = Strain(np.array([1.0, 2.0]), 5.0, np.array([3.0, 4.0]), np.array([6.0, 7.0]))
    second = Strain(8.0, 9.0, 10.0, 11.0)
    parts = of_each(((strain, second), (second, strain)), 2)
    assert parts[0] == ((Strain(1.0, 5.0, 3.0, 6.0), second), (second, Strain(1.0, 5.0, 3.0, 6.0)))
    assert parts[1] == ((Strain(2.0, 5.0, 4.0, 7.0), second), (second, Strain(2.0, 5.0, 4.0, 7.0)))


def test_a_single_load_has_the_safety_of_its_own_limit():
    steel = steel_of(rating("iso6336"))
    rows = [Strain(100.0, 1.0, value, 1e7) for value in (150.0, 160.0, 170.0, 180.0)]
    assert safeties([((rows[0], rows[1]), (rows[2], rows[3]))], (steel, steel)) == ((1.5, 1.6), (1.7, 1.8))


def test_the_weakest_treatment_of_a_mesh_says_what_film_it_needs():
    """W_W 0.5 through-hardened, 0.65 induction-hardened, 1 case-hardened, 1.5 nitrided: the softer flank of two."""
    own = rating("iso6336")
    rules = own.rules.iso6336.model_copy(update={"micropitting_stage": 8})
    own = replace(own, rules=own.rules.model_copy(update={"iso6336": rules}), helix_angle=0.0)
    mesh = loaded("iso6336", own=own)
    factors = METHODS["iso6336"].rate(mesh).factors
    film = oil_film(mesh, factors)
    assert steel_of(own).treatment is Treatment.NITRIDED
    bare = film.micropitting.permissible / 1.5
    wheel = SimpleNamespace(steel="case-hardened", grade="MQ", hardness_hv=700.0, yield_strength=None)
    mixed = own.rules.model_copy(update={"iso6336": rules.model_copy(update={"wheel": wheel})})
    other = oil_film(mesh._replace(rating=replace(own, rules=mixed)), factors)
    assert other.micropitting.permissible == pytest.approx(bare, rel=1e-9)
    geometry = cylindrical_mesh((23, 59), 4e-3, 40e-3, own)
    assert own.load_factor == 1.06, "the torque is that of the path that carries most, the force that of the mean"
    force = 2.0 * 700.0 / 1.06 / (23 * 4e-3)
    relief = factors.relief
    part = min(1.0, relief.amount * relief.stiffness / (force * 1.06 * float(factors.loads.application) / 40e-3))
    longest = max(float(ratio) for ratio in geometry.addendum_contact_ratios)
    assert int(factors.grade) <= 6 and part > 0.5
    line = FilmMesh(
        geometry, force, float(factors.loads.contact), 500.0, rules.flank_roughness / 6.0, grade=int(factors.grade),
        elastic_modulus=own.material.elastic_modulus, poisson_ratio=own.material.poisson_ratio, supply=1.2,
        relief=1.0 + float(part) * (0.24 * longest + 0.71 * longest**2),
    )  # fmt: skip
    alone = film_thickness(line, OilGrade(rules.oil_viscosity * 1e-6), rules.oil_temperature)
    assert film.micropitting.films == pytest.approx(alone.relative(rules.flank_roughness / 6.0).tolist(), rel=1e-6)
    assert film.flash is not None and film.integral is not None


def test_a_steel_of_the_asked_reliability_is_that_of_the_table():
    assert "K_R" not in steel_of(rating("iso6336")).source
    own = rating("iso6336")
    rules = own.rules.iso6336.model_copy(update={"reliability": 0.999})
    surer = steel_of(replace(own, rules=own.rules.model_copy(update={"iso6336": rules})))
    assert "K_R = 1.25" in surer.source
    assert surer.contact_strength == near(steel_of(own).contact_strength / 1.25)
    assert surer.bending_strength == near(steel_of(own).bending_strength / 1.25)


def test_method_c_says_up_to_which_speed_it_holds():
    """v z_1/100 √(u²/(1 + u²)) below 3 m/s (ISO 6336-1:2006, clause 6)."""
    own = rating("iso6336")
    rules = own.rules.iso6336.model_copy(update={"dynamic_method": "C"})
    mesh = loaded("iso6336", own=replace(own, rules=own.rules.model_copy(update={"iso6336": rules})))
    rated = METHODS["iso6336"].rate(mesh)
    (check,) = (c for c in METHODS["iso6336"].checks(rated, MESH, (FIRST, SECOND)) if c.mode == "speed of K_V")
    assert (check.part, check.limit, check.at_most, check.dimension) == (MESH, 3.0, True, "velocity")
    speed = 500.0 * 23 * 4e-3 / math.cos(own.helix_angle) / 2.0
    assert check.value == pytest.approx(speed * 0.23 * 59 / math.hypot(23, 59), rel=1e-9)
    assert check.exponent is None and check.symbol == "v z_1/100"


def test_methods_have_their_editions_by_name():
    editions = {name: method.edition for name, method in ALL.items()}
    assert editions == {
        "lewis-hertz": "Lewis and Hertz", "iso6336": "ISO 6336, method B", "iso6336-2006": "ISO 6336:2006, method B",
        "din3990": "DIN 3990:1987, method B", "iso10300": "ISO 10300, method B1", "agma2001": "ANSI/AGMA 2001-D04",
        "agma2003": "ANSI/AGMA 2003-D19",
    }  # fmt: skip
    for name in ("iso6336", "iso6336-2006", "din3990"):
        assert ALL[name].rate(loaded("iso6336", own=rating(name))).method == name


@pytest.mark.parametrize(("root", "dynamic"), [("B", "B"), ("C", "B"), ("B", "C")])
def test_roots_and_dynamic_factors_are_rated_by_the_methods_that_are_asked(root, dynamic):
    own = rating("iso6336")
    rules = own.rules.iso6336.model_copy(update={"root_method": root, "dynamic_method": dynamic})
    asked = replace(own, rules=own.rules.model_copy(update={"iso6336": rules}))
    quality = quality_of(asked, idlers=(True, False))
    assert (quality.choices.root, quality.choices.dynamic) == (RatingMethod(root), RatingMethod(dynamic))
    assert quality.mean_stresses == (0.7, 1.0)


def test_all_that_iso_6336_computes_has_its_rows():
    own = rating("iso6336")
    wheel = SimpleNamespace(steel="case-hardened", grade="MQ", hardness_hv=700.0, yield_strength=None)
    rules = own.rules.iso6336.model_copy(update={"micropitting_stage": 8, "wheel": wheel})
    own = replace(own, rules=own.rules.model_copy(update={"iso6336": rules}))
    mesh = loaded("iso6336", own=own)
    once = mesh.loads[0]._replace(static=True, life=1.0, case="once")
    rated = METHODS["iso6336"].rate(mesh._replace(loads=(mesh.loads[0], once)))
    rows = list(METHODS["iso6336"].factors(rated))
    chapters = list(dict.fromkeys(row.chapter for row in rows))
    expected = {"steel", "steel of the second gear", "mesh", "dynamic factor", "face load factor", "pitting"}
    expected |= {"tooth root", "scuffing", "scuffing, flash temperature", "micropitting", "static strength"}
    assert expected <= set(chapters)
    second = {row.quantity: row.values for row in rows if row.chapter == "steel of the second gear"}
    assert second["contact strength"] == (rated.mate_steel.contact_strength,)
