"""What every method's rating hands on, without a sizing: judgements, reserves, rows, making."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from gearwright.sizing.rating.agma import Agma2001, Agma2003
from gearwright.sizing.rating.iso6336 import Iso6336
from gearwright.sizing.rating.iso6336_inputs import steel_of
from gearwright.sizing.rating.iso10300 import Iso10300
from gearwright.sizing.rating.lewis_hertz import LewisHertz
from rated_pieces import FIRST, MESH, METHODS, SECOND, loaded, near, rating, told

ROWS = {
    "iso6336": ("ISO 6336-2, 5.3", "ISO 6336-3, 5.2"), "agma2001": ("AGMA 2001-D04, eq. 4", "AGMA 2001-D04, eq. 13"),
    "iso10300": ("ISO 10300-2, eq. 5", "ISO 10300-3, eq. 5"),
    "agma2003": ("AGMA 2003-D19, eq. 2", "AGMA 2003-D19, eq. 6"),
}  # fmt: skip


@pytest.mark.parametrize("method", ROWS)
@pytest.mark.parametrize("cases", [1, 2])
def test_every_safety_is_judged_by_its_clause_on_its_gear(method, cases):
    rated = METHODS[method].rate(loaded(method, cases=cases, width=30e-3))
    checks = list(METHODS[method].checks(rated, MESH, (FIRST, SECOND)))
    for gear, part in enumerate((FIRST, SECOND)):
        own = [check for check in checks if check.part == part]
        rows = [(c.mode, c.clause, c.value, c.limit, c.symbol, c.at_most) for c in own]
        assert rows == [
            ("pitting", ROWS[method][0], rated.pitting[gear], rated.pitting_asked, "S_H", False),
            ("tooth root", ROWS[method][1], rated.bending[gear], rated.bending_asked, "S_F", False),
        ]
    rest = {check.mode: check for check in checks if check.part == MESH}
    assert len(rest) + 4 == len(checks)
    if method.startswith("agma"):
        speed = rated.factors.speed if method == "agma2001" else rated.factors.mesh.speed
        check = rest["velocity"]
        assert (check.value, check.limit, check.at_most) == (float(speed), rated.velocity_limit, True)
        assert check.dimension == "velocity" and check.exponent is None
    assert rated.bending_margin == near(min(rated.bending) / rated.bending_asked)
    assert rated.contact_margin == near(min(rated.pitting) / rated.pitting_asked)
    assert (rated.module_bending, rated.module_contact, rated.case) == (1e-3, 2e-3, "case 0")


@pytest.mark.parametrize("method", [*ROWS, "lewis-hertz"])
def test_reserves_take_the_root_or_the_square_of_the_flank(method):
    for bending, contact, reserve in ((1.3, 1.2, 1.3), (1.6, 1.2, 1.44), (0.9, 0.5, 0.25)):
        rated = SimpleNamespace(bending_margin=bending, contact_margin=contact)
        assert METHODS[method].reserve(rated) == near(reserve)  # type: ignore[arg-type]


@pytest.mark.parametrize("method", ["agma2001", "agma2003", "iso6336", "iso10300"])
def test_two_equal_halves_of_a_life_rate_as_the_whole(method):
    """Miner: one case of all the life, or two of half of it under the same load, have the same safeties."""
    whole = loaded(method, width=30e-3)
    half = tuple(whole.heaviest._replace(life=1.8e6, case=name) for name in ("a", "b"))
    halves = METHODS[method].rate(whole._replace(loads=half))
    alone = METHODS[method].rate(whole)
    assert halves.pitting == pytest.approx(alone.pitting, rel=1e-6)
    assert halves.bending == pytest.approx(alone.bending, rel=1e-6)
    lighter = METHODS[method].rate(whole._replace(loads=(half[0],)))
    assert min(lighter.pitting) > min(alone.pitting)


@pytest.mark.parametrize("method", ROWS)
def test_a_rating_hands_on_stresses_margins_and_peaks(method):
    own = told(method, pitting_safety=1.3, bending_safety=1.7)
    rated = METHODS[method].rate(loaded(method, width=30e-3, own=own))
    assert (rated.pitting_asked, rated.bending_asked) == (1.3, 1.7)
    assert rated.contact_margin == near(min(rated.pitting) / 1.3)
    assert rated.bending_margin == near(min(rated.bending) / 1.7)
    factors = rated.factors
    if method.startswith("agma"):
        roots = [float(gear.bending_stress) for gear in factors.gears]
        flanks = [float(gear.contact_stress) for gear in factors.gears]
        peak = (factors if method == "agma2001" else factors.mesh).dynamic
        # (A + Q_v − 3)² ft/min with A = 50 + 56 (1 − 0.25 (12 − Q_v)^⅔)
        quality = getattr(own.rules, method).quality_number
        base = 50.0 + 56.0 * (1.0 - 0.25 * (12.0 - quality) ** (2.0 / 3.0))
        assert rated.velocity_limit == pytest.approx((base + quality - 3.0) ** 2 * 0.3048 / 60.0, rel=1e-9)
    else:
        roots = [float(root.stress) for root in factors.bending]
        pitting = factors.pitting
        flanks = [float(s) for s in pitting.stresses] if method == "iso6336" else [pitting.stress]
        peak = factors.loads.dynamic
    assert roots[0] != roots[1]
    assert rated.bending_stress == max(roots) and rated.contact_stress == max(flanks)
    assert rated.peaks == near(1.25 * float(peak))
    assert len(rated.pitting) == len(rated.bending) == 2 and len(set(rated.bending)) == 2


@pytest.mark.parametrize("method", ROWS)
def test_every_row_of_a_rating_stands_in_its_chapter(method):
    rows = list(METHODS[method].factors(METHODS[method].rate(loaded(method, width=30e-3))))
    chapters = {row.chapter for row in rows}
    assert "mesh" in chapters and all(isinstance(chapter, str) for chapter in chapters)
    assert {"strength of flanks", "tooth root"} <= chapters or {"tooth root"} <= chapters or method == "agma2001"
    assert all(row.values and row.clause for row in rows)


def test_how_gears_are_made_is_said_in_the_words_of_each_method():
    iso = rating("iso6336").rules.iso6336
    made = Iso6336().making(rating("iso6336"))
    assert iso.tolerance_class is None and (made.accuracy, made.iso_class) == ("by speed, ISO 1328-1", None)
    told = Iso6336().making(rating("iso6336", iso6336={"tolerance_class": 7}))
    assert (told.accuracy, told.iso_class) == ("7 ISO 1328-1", 7)
    assert made.roughness == (iso.flank_roughness, iso.root_roughness)
    assert made.steel[0] == "ISO 6336-5" and made.iso_steel == steel_of(rating("iso6336"))
    bevel = Iso10300().making(rating("iso10300"))
    assert bevel.accuracy.endswith("ISO 17485") and bevel.iso_class is None
    assert LewisHertz().making(rating("lewis-hertz")).accuracy == "not chosen (Lewis and Hertz)"
    for method, name in ((Agma2001(), "agma2001"), (Agma2003(), "agma2003")):
        own = rating(name)
        rules = getattr(own.rules, name)
        for steel, shown in (("carburised", False), ("through-hardened", True)):
            other = rules.model_copy(update={"steel": steel, "hardness_hb": 320.0, "grade": 2})
            made = method.making(replace(own, rules=own.rules.model_copy(update={name: other})))
            assert made.accuracy.startswith(f"Q_v {rules.quality_number} AGMA")
            assert made.steel[1].startswith(f"{steel}, grade 2") and ("320 HB" in made.steel[1]) is shown
