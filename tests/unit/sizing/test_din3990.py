"""DIN 3990 beside ISO 6336: what parts the two, and nothing else."""

import math

import pytest

from designs import PAIR, problem
from gearwright.parts.iso6336 import PairRating
from gearwright.sizing import size
from gearwright.sizing.insight import usual_values
from gearwright.sizing.rating import METHODS, MeshRating
from gearwright.spec import parse


def design(method: str, module: float = 3.0, *, rules: str = "") -> str:
    """A helical pair of given teeth, module and width that runs longer than every knee."""
    return (
        f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n\n[gears]\nrating = "{method}"\nhelix_angle_deg = 15\n{rules}\n'
        f'[service]\nlife_h = 20000\n[overrides]\n"stage.module_mm" = {module}\n"stage.face_width_mm" = 40\n'
    )


def rated(method: str, module: float = 3.0, *, rules: str = "") -> MeshRating:
    return size(parse(design(method, module, rules=rules))).meshes[0].rating


def factors(method: str, module: float = 3.0, *, rules: str = "") -> PairRating:
    return rated(method, module, rules=rules).factors


def test_the_strength_does_not_fall_beyond_the_knee():
    """2.4e9 cycles of the pinion: ISO 6336 goes down to 0.85 at 1e10, DIN 3990 stays at 1."""
    din, iso = factors("din3990"), factors("iso6336")
    assert [float(strength.life) for strength in din.contact_strength] == [1.0, 1.0]
    assert [float(strength.life) for strength in din.root_strength] == [1.0, 1.0]
    assert all(0.85 < float(strength.life) < 1.0 for strength in (*iso.contact_strength, *iso.root_strength))


def test_roots_are_those_of_the_edition_of_2006():
    din, old = factors("din3990"), factors("iso6336-2006")
    for mine, theirs in zip(din.bending, old.bending, strict=True):
        assert float(mine.nominal_stress) == pytest.approx(float(theirs.nominal_stress), rel=1e-12)
        assert float(mine.stress) == pytest.approx(float(theirs.stress), rel=1e-12)


def test_slanted_lines_lessen_the_contact_stress_of_din_and_raise_that_of_iso():
    """Z_β = √cos 15° in DIN 3990-2:1987; its inverse since the correction of ISO 6336-2 in 2008."""
    slant = math.sqrt(math.cos(math.radians(15.0)))
    din, iso = factors("din3990").pitting, factors("iso6336").pitting
    assert float(din.geometry.helix) == pytest.approx(slant, rel=1e-12)
    assert float(din.nominal_stress / iso.nominal_stress) == pytest.approx(slant**2, rel=1e-12)


def test_flanks_of_great_modules_bear_less():
    """Z_X of case-hardened steel by DIN 3990-2:1987: 1 to 10 mm, 1.05 − 0.005 m_n beyond."""
    steel = 'iso6336 = { steel = "case-hardened" }'
    sizes = {module: factors("din3990", module, rules=steel) for module in (8.0, 10.0, 16.0)}
    assert [float(rated.contact_strength[0].size) for rated in sizes.values()] == pytest.approx([1.0, 1.0, 0.97])
    assert float(factors("iso6336", 16.0, rules=steel).contact_strength[0].size) == 1.0


def test_every_quantity_names_the_standard_that_rates():
    """No row of a rating by one edition names another, but steels and scuffing, which have standards of their own.

    C_eff is of the document on scuffing of the same time. Teeth are of a class of ISO 1328-1, whoever rates them, and
    how well a relief is made no standard says.
    """
    wanted = {
        "din3990": ("DIN 3990-", "DIN 3990-4:1987"),
        "iso6336-2006": (":2006", "ISO/TR 13989-1:2000, C_eff"),
        "iso6336": (":2019", "ISO/TS 6336-20:2017, C_eff"),
    }
    for method, (words, scuffing) in wanted.items():
        rows = [row for row in METHODS[method].factors(rated(method)) if not row.chapter.startswith(("steel", "scuff"))]
        assert len(rows) > 50
        told = {row.quantity: row.clause for row in rows if row.quantity == "deflection" or words not in row.clause}
        assert told == {
            "deflection": scuffing, "grade": "ISO 1328-1:2013; not stated: by v",
            "tolerance": "estimate for ground teeth",
        }, method  # fmt: skip


def test_usual_values_and_judgements_name_the_standard_that_rates():
    for method, part in (("din3990", "DIN 3990-{}:1987"), ("iso6336", "ISO 6336-{}")):
        sizing = size(parse(design(method)))
        sources = {row.quantity: row.source for row in usual_values(sizing)}
        assert sources["tip relief C_a"].startswith(part.format(1))
        clauses = {check.mode: check.clause for check in sizing.checks}
        for mode, number in (("pitting", 2), ("tooth root", 3), ("main resonance", 1)):
            assert clauses[mode].startswith(part.format(number)), mode


def test_rings_are_refused_with_the_methods_that_rate_them():
    internal = design("din3990").replace('wheel = "slow"', 'wheel = "slow"\ninternal = true')
    assert "iso6336" in problem(internal, sized=True).message
