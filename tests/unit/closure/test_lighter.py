"""A closure looks for something lighter both ways, and what it leaves has nothing lighter beside it."""

from functools import cache

import pytest

from designs import PAIR
from gearwright.closure import FREEDOMS, Step, Wishes, close
from gearwright.closure.loop import Factors, changes_of, confirmed
from gearwright.errors import DesignError, GearwrightError
from gearwright.reviews import Verdict, review
from gearwright.sizing import size
from gearwright.sizing.mass import complete_mass
from gearwright.spec import design_text, edited, parse

RATED = edited(parse(PAIR), {"gears.rating": "iso6336"})
COARSE = (20, 34, 42, 52)
"""Numbers of teeth of a pinion that are tried by hand."""


@cache
def closed(*free, lighten=True):
    return close(RATED, wishes=Wishes(lighten=lighten, free=free))


def test_other_teeth_and_modules_are_lighter_and_pass_their_review():
    assert closed().whole.total < 0.99 * closed(lighten=False).whole.total
    assert review(parse(design_text(closed().design))).verdict is Verdict.PASSES_SO_FAR
    assert Step.LIGHTEN in [row.step for row in closed().rounds]


def test_no_pair_of_a_coarse_grid_is_lighter():
    """Modules of ISO 54 and numbers of teeth as a user would try them, each at its least whole width that serves."""
    grid = [lightest(module, teeth) for teeth in COARSE for module in (1.5, 2.0, 2.5, 3.0, 4.0)]
    lighter = [design for design in grid if design and mass_of(design) < closed().whole.total * (1.0 - 2e-3)]
    assert [design.name for design in lighter if not review(design).failing] == []


def mass_of(design):
    return complete_mass(size(design)).total


def lightest(module, teeth):
    """Return the narrowest pair that meets its strengths, else None."""
    low, high = 3, int(min(20 * module, 0.8 * module * teeth))
    if not serves(module, teeth, high):
        return None
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if serves(module, teeth, middle) else (middle, high)
    return pair(module, teeth, high)


def pair(module, teeth, width):
    own = {"module_mm": module, "pinion_teeth": teeth, "wheel_teeth": 3 * teeth, "face_width_mm": width}
    return edited(RATED, {"name": f"{module} {teeth}", **{f"pairs.stage.{key}": own[key] for key in own}})


def serves(module, teeth, width):
    """Tell whether a pair meets its strengths, shaken as its own forced response says."""
    try:
        own = pair(module, teeth, width)
        shaken = edited(own, changes_of(own, Factors(confirmed(size(own)), {})))
        return not any(check.fails for check in size(shaken).checks)
    except GearwrightError:
        return False


def test_a_better_steel_is_taken_only_where_it_is_free():
    kept, free = closed(lighten=False), closed("material")
    assert kept.design.gears.material == RATED.gears.material
    assert free.whole.total < closed().whole.total
    assert free.design.gears.iso6336.grade == "ME" or free.design.gears.material != RATED.gears.material


def test_teeth_that_the_design_gives_stay_unless_they_are_free():
    given = edited(RATED, {"pairs.stage.pinion_teeth": 20, "pairs.stage.wheel_teeth": 60})
    kept = close(given, wishes=Wishes(separate=False))
    assert kept.design.pairs["stage"].pinion_teeth == 20
    free = close(given, wishes=Wishes(separate=False, free=("teeth",)))
    assert free.design.pairs["stage"].pinion_teeth != 20
    assert free.whole.total < kept.whole.total


def test_a_freedom_that_there_is_not_is_refused_with_the_nearest():
    with pytest.raises(DesignError, match="tooth") as found:
        Wishes(free=("tooth",))
    assert "teeth" in str(found.value)
    assert set(FREEDOMS) == {"teeth", "shifts", "planets", "helix", "material", "rims", "webs"}
