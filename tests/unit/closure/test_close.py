"""A closed design meets everything in an independent review of its text, and no less would do."""

import math
import re
from functools import cache
from io import StringIO

import pytest
from rich.console import Console

from designs import PAIR
from gearwright.closure import Outcome, Step, Wishes, close, contradictions, requirement_of
from gearwright.closure.moves import LIGHTER
from gearwright.closure.requirements import stage_lives
from gearwright.errors import DesignError
from gearwright.render.words.review import closure_text
from gearwright.reviews import Verdict, review
from gearwright.shipped import shipped_designs
from gearwright.sizing import size
from gearwright.sizing.mass import complete_mass
from gearwright.spec import design_text, edited, parse, read

HOUR = 3600.0
LIGHT = Wishes(lighten=False)
OPEN = edited(parse(PAIR), {"gears.rating": "iso6336"})
UNRELIEVED = edited(OPEN, {"gears.iso6336.tip_relief_um": 0.0})
"""Teeth without relief, whose forced response asks for more than K_V by their rating."""
RATED = edited(UNRELIEVED, {"gears.iso6336.narrowest_modules": 1.0})
"""The same with faces as narrow as they need be, so that strengths alone say how wide they are."""


@cache
def closed(*, left_out=(), rounded=True, hours=None):
    """The pair, closed as asked."""
    life = None if hours is None else hours * HOUR
    return close(RATED, wishes=Wishes(life, rounded=rounded, lighten=False, left_out=frozenset(left_out)))


def replay(found):
    """Return the review of the written design alone."""
    return review(parse(design_text(found.design)))


def test_an_independent_review_of_the_written_design_passes():
    assert closed().outcome is Outcome.CLOSED
    assert closed().unmet == ()
    assert replay(closed()).verdict is Verdict.PASSES_SO_FAR
    assert replay(closed()).failing == ()


def test_the_review_knows_the_sizes_that_the_closure_found():
    assert size(parse(design_text(closed().design))).mass == pytest.approx(closed().mass, rel=1e-12)


@pytest.mark.parametrize("rounded", [True, False])
@pytest.mark.parametrize("path", ["pairs.stage.face_width_mm", "layout.fast.diameter_mm", "layout.slow.diameter_mm"])
def test_a_size_2_percent_less_fails(path, rounded):
    """Of rounded sizes a millimetre less, where that is more."""
    design = closed(rounded=rounded).design
    table, name, key = path.split(".")
    record = getattr(design, table)[name]
    value = 1e3 * getattr(record, key.removesuffix("_mm"))
    less = min(0.98 * value, value - 1.0) if rounded else 0.98 * value
    assert review(edited(design, {path: less})).failing != ()


def test_the_next_smaller_whole_millimetre_fails():
    width = closed().design.pairs["stage"].face_width
    assert width * 1e3 == pytest.approx(round(width * 1e3), abs=1e-9)
    smaller = edited(closed().design, {"pairs.stage.face_width_mm": width * 1e3 - 1.0})
    assert "stage.pinion pitting" in [check.name for check in size(smaller).checks if check.fails]


def test_a_face_is_no_narrower_than_six_modules_though_its_teeth_would_bear_more():
    """As the strengths of 2.5 mm teeth pass with less than 15 mm: 5 % are to spare."""
    given = {"pairs.stage.pinion_teeth": 53, "pairs.stage.wheel_teeth": 158, "pairs.stage.module_mm": 2.5}
    wide = close(edited(UNRELIEVED, given), wishes=LIGHT)
    stage = wide.design.pairs["stage"]
    assert wide.outcome is Outcome.CLOSED
    assert stage.face_width == pytest.approx(6.0 * 2.5e-3)
    assert min(check.reserve for check in wide.checks if check.mode == "pitting") > 1.02


def test_of_a_lightened_gearbox_no_lighter_standard_module_and_whole_width_meets_the_strengths():
    """Modules of ISO 54 from 1.5 to 3.5 mm, whole widths from six modules to what the rules allow, as a user would try.

    A closure compares complete gearboxes; what saves less than a thousandth of one counts as no lighter.
    """
    found = close(UNRELIEVED)
    best, design, looked = complete_mass(found.sizing).total, found.design, 0
    for module in (1.5, 1.75, 2.0, 2.25, 2.5, 2.75, 3.0, 3.5):
        for width in range(
            math.ceil(6 * module), int(min(20 * module, 0.8 * module * found.sizing.gears[0].teeth)) + 1
        ):
            if complete_mass(size(_with(design, module, width))).total >= best * (1.0 - LIGHTER):
                break
            assert not _does(design, module, width), (module, width)
            looked += 1
    assert looked > 0


def _with(design, module, width):
    return edited(design, {"pairs.stage.module_mm": module, "pairs.stage.face_width_mm": width})


def _does(design, module, width):
    return not [check for check in size(_with(design, module, width)).checks if check.fails]


@pytest.mark.parametrize("hours", [100, 300, 1000])
def test_a_life_that_is_asked_is_met_within_2_percent_where_sizes_are_continuous(hours):
    """Pinion at 6000 rpm: 3.6e7 to 3.6e8 cycles, above the knee of the contact curve, where a life costs strength."""
    found = closed(rounded=False, hours=hours)
    assert found.life == pytest.approx(hours * HOUR, rel=0.02)
    assert replay(found).failing == ()
    shorter = edited(found.design, {"service.life_h": 1.03 * hours})
    assert [check.name for check in size(shorter).checks if check.fails] == [found.lives[0].governs]


@pytest.mark.parametrize(
    ("mode", "asked"),
    [("scuffing", {"scuffing_safety": 5.0}), ("micropitting", {"micropitting_stage": 5, "micropitting_safety": 10.0})],
)
def test_hot_flanks_and_thin_films_have_no_life_in_hours(mode, asked):
    """Scuffing is one hot contact (ISO/TS 6336-20, -21) and a film is thick or thin: no number of cycles moves them."""
    design = closed(rounded=False).design
    harder = size(edited(design, {f"gears.iso6336.{key}": value for key, value in asked.items()}))
    assert any(check.mode == mode and check.fails for check in harder.checks)
    (before,), (after,) = stage_lives(size(design)), stage_lives(harder)
    assert (after.life, after.governs) == (before.life, before.governs)


def test_a_longer_life_costs_mass():
    assert closed(rounded=False, hours=1000).mass > closed(rounded=False, hours=100).mass


def test_without_the_requirement_of_flanks_the_design_fails_its_review():
    found = closed(left_out=("flank",))
    assert found.mass < closed().mass
    assert {requirement_of(check) for check in replay(found).failing} == {"flank"}


def test_without_confirmed_dynamic_factors_the_gearbox_is_lighter_and_its_peaks_fail():
    """Teeth of class 1 hardly deviate, so that method B sees little of what their varying stiffness does."""
    fine = edited(RATED, {"gears.iso6336.tolerance_class": 1, "gears.iso6336.pitting_safety": 1.0,
                          "service.application_factor": 1.0})  # fmt: skip
    blind = close(fine, wishes=Wishes(lighten=False, left_out=frozenset({"peaks"})))
    assert blind.mass < close(fine, wishes=LIGHT).mass
    assert "peaks" in {requirement_of(check) for check in replay(blind).failing}
    assert replay(close(fine, wishes=LIGHT)).failing == ()


def test_the_rounds_tell_what_was_proportioned_and_confirmed():
    steps = [row.step for row in closed().rounds]
    assert steps[:4] == [Step.PROPORTION, Step.CONFIRM, Step.PROPORTION, Step.CONFIRM]
    assert closed().rounds[-1].change < 0.005
    confirmed = [row.what for row in closed().rounds if row.step is Step.CONFIRM]
    told = re.compile(r"stage K_V [\d.]+ by (forced response|its rating; forced response [\d.]+)")
    assert all(told.fullmatch(what) for what in confirmed)


def test_stages_without_fatigue_are_rated_by_iso_6336():
    bare = close(parse(PAIR), wishes=Wishes(separate=False, lighten=False))
    assert bare.design.rating("stage") == "iso6336"
    kept = edited(parse(PAIR), {"gears.bending_safety": 3.0})
    assert (
        "bending_safety" not in close(kept, wishes=Wishes(separate=False, lighten=False)).design.gears.model_fields_set
    )


def test_a_width_that_is_given_is_kept_and_told_where_it_does_not_do():
    narrow = close(edited(RATED, {"pairs.stage.face_width_mm": 12, "pairs.stage.module_mm": 2}))
    assert narrow.design.pairs["stage"].face_width == pytest.approx(0.012)
    assert narrow.outcome is Outcome.OPEN
    assert {row.requirement for row in narrow.unmet} >= {"flank"}
    assert all("stage.face_width" in row.kept for row in narrow.unmet if row.requirement == "flank")
    assert "stage.pinion pitting" in [check.name for check in replay(narrow).failing]


def test_a_life_that_no_material_gives_is_told_with_the_best_that_was_found():
    """At the largest safety a module would have to grow beyond the widest face: nothing of its series does."""
    asked = close(edited(RATED, {"gears.iso6336.widest_modules": 1.5, "gears.iso6336.pitting_safety": 5}),
                  wishes=Wishes(1e6 * HOUR, separate=False, lighten=False))  # fmt: skip
    for row in asked.unmet:
        assert row.helps
        assert row.check.margin < 1.0


def test_wishes_that_cannot_be_are_refused():
    assert problem_of(life=-1.0).path == "life"
    assert "flank" in problem_of(left_out=frozenset({"flanks"})).message


def problem_of(**wishes):
    """Return the one problem of wishes."""
    with pytest.raises(DesignError) as found:
        Wishes(**wishes)
    (only,) = found.value.problems
    return only


def test_every_check_of_the_shipped_designs_belongs_to_a_requirement():
    """A review that can fail by something that no requirement names would be out of the closure's sight."""
    unnamed = {
        check.mode
        for name in shipped_designs()
        for check in size(read(name)).checks
        if check.ratio is not None and requirement_of(check) == "others"
    }
    assert unnamed == set()


def test_relieved_teeth_close_lighter_and_have_the_dynamic_factor_of_their_rating():
    """Left open, relief leaves little for the forced response: K_V of ISO 6336-1 governs, and the rounds say so."""
    relieved = close(OPEN, wishes=LIGHT)
    assert relieved.outcome is Outcome.CLOSED and replay(relieved).failing == ()
    assert relieved.mass < closed().mass
    rated = relieved.sizing.meshes[0].rating
    made, factors = rated.made, rated.factors
    load = float(factors.tangential_force / relieved.sizing.gears[0].face_width) * OPEN.service.application_factor
    left = abs(1.0 - float(factors.relief.stiffness) * made.relief / load)
    left += float(factors.relief.stiffness) * made.tolerance / load
    assert float(factors.dynamic.relief_term) == pytest.approx(left, rel=1e-9) and left < 0.5
    assert f"K_V {rated.peaks / OPEN.service.application_factor:.3f} by its rating" in relieved.rounds[-1].what
    assert "by forced response" in closed().rounds[1].what


def test_the_screen_shows_the_first_round_of_each_kind_and_the_last_or_all():
    found = closed()
    widest = Console(width=200, file=StringIO())
    told = []
    for all_rounds in (False, True):
        with widest.capture() as screen:
            widest.print(closure_text(found, all_rounds=all_rounds))
        told.append([line.split()[1] for line in screen.get().splitlines() if line.split()[:1] == ["round"]])
    kinds = [row.step for row in found.rounds]
    expected = sorted({*(kinds.index(kind) + 1 for kind in kinds), len(kinds)})
    assert told == [[str(number) for number in expected], [str(number + 1) for number in range(len(kinds))]]
    assert len(told[0]) < len(told[1])


def test_the_screen_says_once_over_what_was_searched():
    design = edited(RATED, {"pairs.stage.face_width_mm": 12, "pairs.stage.module_mm": 2})
    narrow = close(design, wishes=Wishes(separate=False, lighten=False))
    widest = Console(width=400, file=StringIO())
    with widest.capture() as screen:
        widest.print(closure_text(narrow))
    words = screen.get()
    assert len(narrow.unmet) > 1
    assert words.count("not met:") == len(narrow.unmet)
    assert words.lower().count(" searched ") == 1 + bool(narrow.effort.not_searched)


def test_what_stands_against_what_is_not_met_is_named():
    design = edited(RATED, {"pairs.stage.face_width_mm": 12, "pairs.stage.module_mm": 2})
    narrow = close(design, wishes=Wishes(separate=False, lighten=False))
    found = {row.against: row for row in contradictions(design, narrow)}
    for given in ("pairs.stage.face_width_mm = 12", "pairs.stage.module_mm = 2"):
        assert "stage.pinion tooth root" in found[given].unmet
        assert {"flank", "root"} <= set(found[given].requirements)
    wide, large = (close(edited(design, {f"pairs.stage.{key}": None}), wishes=Wishes(separate=False, lighten=False))
                   for key in ("face_width_mm", "module_mm"))  # fmt: skip
    assert found["pairs.stage.face_width_mm = 12"].mass == pytest.approx(wide.mass)
    assert found["pairs.stage.module_mm = 2"].mass == pytest.approx(large.mass)
    assert large.mass > wide.mass, "a face of 12 mm bears its load with modules of 9 mm alone"
    assert contradictions(RATED, closed()) == ()
