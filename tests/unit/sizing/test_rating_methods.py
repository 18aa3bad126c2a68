"""Methods of rating side by side: one dict, the same names in files, and a new one is a record and a line."""

import math
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated, ClassVar

import pytest

from gearwright.checks import Check, Status
from gearwright.errors import DesignError, Problem
from gearwright.mission import fly, gear_damage
from gearwright.mission.lives.life import STRENGTHENING, strengthened
from gearwright.particulars import particulars
from gearwright.render.answers.design import SizeAnswer, size_answer
from gearwright.render.answers.schema import described, plain
from gearwright.render.pages.report import report
from gearwright.render.tables.sizing import tables_of
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import named_results, size
from gearwright.sizing.rating import METHODS, STANDARD_MODULES, ClassDamage, Factor, Making, rating_of
from gearwright.sizing.rating.agma import Agma2001Rating
from gearwright.sizing.rating.lewis_hertz import LewisHertzRating
from gearwright.spec import edited, parse, read, read_mission, schema
from gearwright.spec.design import RATINGS, RatingMethod
from gearwright.units import Endless, Origin, Quantity

OFF_SET = read(shipped_design("off-set"))
AGMA = size(edited(OFF_SET, {"gears.rating": "agma2001"}))


def test_files_name_the_methods_that_there_are():
    assert set(RATINGS) == set(METHODS)
    assert schema()["$defs"]["GearRules"]["properties"]["rating"]["enum"] == list(METHODS)


@dataclass(frozen=True)
class DummyRating:
    """A mesh as no standard rates it: F_t over b m_n against 400 MPa."""

    method: ClassVar[str] = "dummy"
    case: str
    module_bending: Annotated[float, Quantity("length"), Origin("m³ = 2 T cos β/(z λ 400 MPa)", "dummy, eq. 1")]
    module_contact: Annotated[float, Quantity("length"), Origin("0", "dummy")]
    bending_stress: Annotated[float, Quantity("stress"), Origin("F_t/(b m_n)", "dummy, eq. 2")]
    bending_margin: Annotated[float, Quantity("ratio"), Origin("400 MPa/σ", "dummy, eq. 3")]
    contact_stress: Annotated[float, Quantity("stress"), Origin("0", "dummy")] = 0.0
    contact_margin: Annotated[float, Quantity("ratio"), Origin("∞", "dummy"), Endless()] = math.inf
    peaks: float = 1.0


class Dummy:
    """The whole of a new method."""

    edition, peaks, life_source = "Dummy, 2nd edition", "", "dummy, annex L"
    safeties = MappingProxyType({"pitting": ("contact_safety",), "bending": ("bending_safety",)})

    def refuse(self, rating, teeth):
        if 21 in teeth:
            yield Problem("pinion_teeth", "21; the dummy is superstitious, give another")

    def width_ratio(self, rating, small, large):
        return 10.0 + 0.0 * small

    def module(self, ask, rating):
        lean = math.cos(rating.helix_angle)
        needed = (2.0 * ask.per_tooth * lean / (ask.width_ratio * 400e6)) ** (1.0 / 3.0)
        return needed, 0.0 * needed

    def rate(self, mesh) -> DummyRating:
        lean = math.cos(mesh.rating.helix_angle)
        force = 2.0 * mesh.heaviest.torque * lean / (mesh.module * mesh.heaviest.ask.teeth[0])
        stress = force / (mesh.face_width * mesh.module)
        return DummyRating(mesh.heaviest.case, *mesh.asked, stress, 400e6 / stress)

    def reserve(self, rated):
        return rated.bending_margin

    def reserve_of(self, mesh):
        return self.reserve(self.rate(mesh))

    def life_slope(self, rating, mode, steel):
        return 10.0

    def damage(self, spectrum):
        return ClassDamage([0.0], [0.25]), ClassDamage([0.0], [0.125])

    def checks(self, rated, mesh, gears):
        yield Check(mesh, "dummy bending", "dummy, eq. 3", rated.bending_stress, 400e6, "stress", at_most=True)

    def factors(self, rated):
        yield Factor("dummy", "lucky number", "n", (7,), "number", "dummy, annex D")

    def making(self, rating):
        return Making("by eye")


def stress_column(sizing):
    return next(
        column for column in tables_of(particulars(sizing))["rating"].columns if column.name == "bending_stress"
    )


def test_a_new_method_is_a_record_and_a_line(monkeypatch):
    """It sizes gears to its stress, and stands in checks, results, JSON and on the page with its own sources."""
    monkeypatch.setitem(METHODS, "dummy", Dummy())
    monkeypatch.setitem(RATINGS, "dummy", RatingMethod("Dummy", frozenset({"cylindrical"}), ()))
    design = edited(OFF_SET, {"gears.rating": "dummy"})
    sizing = size(design)
    for mesh in sizing.meshes:
        assert isinstance(mesh.rating, DummyRating)
        assert mesh.bending_stress == pytest.approx(400e6, rel=1e-9)
        assert named_results(sizing)[f"meshes.{mesh.name}.module_bending"].value == mesh.module_bending > 0.0
    assert {"dummy, eq. 3"} == {check.clause for check in sizing.checks if check.mode == "dummy bending"}
    written = plain(size_answer(particulars(sizing)))["meshes"][0]["rating"]
    assert written["method"] == "dummy" and written["bending_stress_mpa"] == pytest.approx(400.0, rel=1e-9)
    definitions = {}
    described(SizeAnswer, definitions)
    assert definitions["DummyRating"]["properties"]["bending_stress_mpa"]["source"] == "dummy, eq. 2"
    assert {origin.source for origin in stress_column(sizing).origins} == {"dummy, eq. 2"}
    page = report(sizing)
    assert "dummy, annex D" in page and "Dummy, 2nd edition" in page
    assert "Lewis 1892" not in page and "eq. 2.1<" not in page and "ISO 6336-3:2019" not in page
    with pytest.raises(DesignError, match="superstitious"):
        size(edited(design, {"pairs.first.pinion_teeth": 21}))
    with pytest.raises(DesignError, match="Dummy does not cover internal gears"):
        edited(read(shipped_design("in-line")), {"gears.rating": "dummy"})


def test_without_its_line_the_name_is_refused_with_what_there_is():
    with pytest.raises(
        DesignError,
        match=r"'dummy' is not .*'lewis-hertz', 'iso6336', .*, 'din3990', 'iso10300', 'agma2001' or 'agma2003'",
    ):
        edited(OFF_SET, {"gears.rating": "dummy"})


def test_agma_sizes_external_gears_to_its_safeties_and_tells_what_its_factors_do_not_cover():
    rules = AGMA.design.gears.agma2001
    for mesh in AGMA.meshes:
        assert isinstance(mesh.rating, Agma2001Rating)
        assert min(mesh.rating.pitting) >= rules.pitting_safety
        assert min(mesh.rating.bending) >= rules.bending_safety
    clauses = {check.clause for check in AGMA.checks if check.mode in ("pitting", "tooth root")}
    assert clauses == {"AGMA 2001-D04, eq. 4", "AGMA 2001-D04, eq. 13"}
    for stage in AGMA.design.pairs:
        gear = next(gear for gear in AGMA.gears if gear.stage == stage)
        below = max(module for module in STANDARD_MODULES if module < 1e3 * gear.module - 1e-9)
        sizes = {"module_mm": below, "face_width_mm": gear.face_width * below / gear.module}
        smaller = size(edited(AGMA.design, {f"pairs.{stage}.{key}": value for key, value in sizes.items()}))
        assert min(min(mesh.bending_margin, mesh.contact_margin) for mesh in smaller.meshes) < 1.0
    fast = [check for check in AGMA.checks if check.mode == "velocity" and check.status is Status.FAILS]
    assert {check.part.name for check in fast} == {"first"}
    assert all(check.value > check.limit == pytest.approx(50.8) for check in fast)


def test_the_module_that_agma_asks_for_just_meets_its_safeties():
    """Without rounding the governing safety is the asked one; 2e-3 by the steps of the search and of the width."""
    free = edited(OFF_SET, {"gears.rating": "agma2001", "gears.agma2001.standard_modules": False})
    for mesh in size(edited(free, {"gears.face_width_ratio": 12})).meshes:
        assert min(mesh.bending_margin, mesh.contact_margin) == pytest.approx(1.0, abs=2e-3)


@pytest.mark.parametrize(
    ("name", "edits", "words"),
    [
        ("in-line", {"gears.rating": "agma2001"}, r'internal gears; write rating = "lewis-hertz" .* or "iso6336"'),
        ("face-gear-split-torque", {"gears.rating": "agma2001"}, "AGMA 2001 does not cover face gears"),
        ("off-set", {"gears.rating": "iso10300"}, r'ISO 10300 does not cover cylindrical .*"agma2001" \(AGMA 2001\)'),
        ("off-set", {"gears.rating": "agma2001", "gears.iso6336.grade": "ME"}, "has no effect with AGMA 2001"),
        ("off-set", {"gears.rating": "iso6336", "gears.agma2001.grade": 1}, 'write rating = "agma2001"'),
    ],
)
def test_what_a_method_does_not_cover_is_refused_with_one_that_does(name, edits, words):
    with pytest.raises(DesignError, match=words):
        edited(read(shipped_design(name)), edits)


def test_a_steel_that_agma_does_not_have_is_refused_at_its_key():
    steel = {"gears.rating": "agma2001", "gears.agma2001.steel": "through-hardened"}
    with pytest.raises(DesignError, match=r"gears\.agma2001\.grade: 3 given; .* grades 1 to 2"):
        size(edited(OFF_SET, {**steel, "gears.agma2001.grade": 3}))
    with pytest.raises(DesignError, match=r"agma2001\.hardness_hb: 450 HB"):
        size(edited(OFF_SET, {**steel, "gears.agma2001.hardness_hb": 450.0}))


def test_cases_of_the_life_are_summed_by_miner_with_agma_too():
    """The rated case for half of the life alone is safer, and another half at less power takes a little of that."""
    cases = {f"{kind}": size(parse(PAIR + SHARES[kind])) for kind in SHARES}
    whole, mixed = (min(cases[kind].meshes[0].rating.pitting) for kind in ("whole", "mixed"))
    half = min(cases["half"].meshes[0].rating.pitting)
    assert whole < mixed < half
    assert half / whole == pytest.approx(2.0**0.023, rel=1e-6)


PAIR = """
schema = 1
name = "One pair"
level = "concept"
shafts = ["fast", "slow"]
[motors.drive]
shaft = "fast"
power_kw = 200
speed_rpm = 6000
[propellers.load]
shaft = "slow"
speed_rpm = 1800
diameter_m = 2
[pairs.only]
pinion = "fast"
wheel = "slow"
pinion_teeth = 24
wheel_teeth = 80
[gears]
rating = "agma2001"
[overrides]
"only.module_mm" = 3
"only.face_width_mm" = 40
[cases.low.drive]
power_kw = 150
[cases.rated.drive]
rating = 1
"""
SHARES = {
    "whole": "[service]\nlife_h = 1000\nshares = { rated = 1.0, low = 0.0 }\n",
    "half": "[service]\nlife_h = 500\nshares = { rated = 1.0, low = 0.0 }\n",
    "mixed": "[service]\nlife_h = 1000\nshares = { rated = 0.5, low = 0.5 }\n",
}


def test_the_edition_of_2006_rates_rings_by_rounder_fillets_and_helical_teeth_without_load_sharing():
    """A ring of few teeth is cut rounder by |z_n| than by −|z_n|, where all else of its section is the same."""
    by = {name: size(edited(read(shipped_design("in-line")), {"gears.rating": name, "overrides.first.module_mm": 3}))
          for name in ("iso6336", "iso6336-2006")}  # fmt: skip
    rows = {
        name: next(mesh for mesh in sizing.meshes if mesh.name == "first.planet-ring").rating
        for name, sizing in by.items()
    }
    assert [rows[name].method for name in by] == list(by)
    new, old = (rows[name].factors.bending[1] for name in by)
    assert old.load_sharing == 1.0
    assert old.section.fillet_radius > 0.38 > new.section.fillet_radius  # the rack's own, in modules
    assert old.section.stress_correction < 0.98 * new.section.stress_correction
    assert (old.section.chord, old.section.lever) == (new.section.chord, new.section.lever)


def test_a_flight_asks_each_method_for_its_damage():
    """The same gears by the first sizing's fallback, by ISO 6336 and by AGMA 2001: three sums, of three S-N curves."""
    mission = read_mission(shipped_mission("regional-250nm"))
    sums = {}
    for method in ("lewis-hertz", "iso6336", "agma2001"):
        flight = fly(size(edited(OFF_SET, {"gears.rating": method})), mission)
        rows = gear_damage(flight)
        assert {row.mode for row in rows} == {"pitting", "bending"}
        sums[method] = rows[0].damage
    assert all(math.isfinite(damage) and damage > 0.0 for damage in sums.values())
    assert len(set(sums.values())) == 3


@pytest.mark.parametrize(("method", "table"), [("iso6336", "iso6336"), ("agma2001", "agma2001")])
def test_a_stage_is_strengthened_where_its_method_reads(method, table):
    """A larger factor of Lewis changes nothing in gears that a standard rates."""
    design = edited(OFF_SET, {"gears.rating": method})
    worst = gear_damage(fly(size(design), read_mission(shipped_mission("regional-250nm"))))[0]
    stage = next(name for name in design.stages if worst.gear.startswith(f"{name}."))
    key = "bending_safety" if worst.mode == "bending" else "pitting_safety"
    before, after = (getattr(which.rules(stage), table) for which in (design, strengthened(design, worst)))
    assert getattr(after, key) == pytest.approx(getattr(before, key) * STRENGTHENING, rel=1e-12)
    assert rating_of(strengthened(design, worst), stage).method == method


def test_nominal_loads_are_said_where_they_are_true():
    sentence = "without application and dynamic factor"
    assert sentence not in report(AGMA)
    first = size(edited(OFF_SET, {"pairs.first.gears.rating": "agma2001"}))
    assert {type(mesh.rating) for mesh in first.meshes} == {Agma2001Rating, LewisHertzRating}
    assert f"Gears of second are sized {sentence}" in report(first)
    sources = [origin.source for origin in stress_column(first).origins]
    assert sources == ["ANSI/AGMA 2001-D04, eq. 10"] * 2 + ["Lewis 1892"] * 2


def test_a_life_falls_with_the_slope_of_its_own_method():
    """Z_N and Y_N of carburised steel below their corners, AGMA 2001-D04, clause 17."""
    rating, method = rating_of(AGMA.design, "first"), METHODS["agma2001"]
    steel = read_mission(shipped_mission("regional-250nm")).gears
    assert method.life_slope(rating, "pitting", steel) == pytest.approx(1.0 / 0.056, rel=1e-12)
    assert method.life_slope(rating, "bending", steel) == pytest.approx(1.0 / 0.1192, rel=1e-12)
    first = rating_of(OFF_SET, "first")
    assert METHODS["lewis-hertz"].life_slope(first, "pitting", steel) != method.life_slope(rating, "pitting", steel)
