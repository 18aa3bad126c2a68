"""What the general arrangement has of bells, seats of rings and standing carriers, and what it says it has not."""

import pytest

from gearwright.render.drawings.assembly_sheets import arrangement_content, set_notes
from gearwright.sizing.mass import complete_mass
from shipped_work import coarse, sized


def rows(name):
    parts = next(
        grid for grid in arrangement_content(sized(name), coarse(sized(name))).grids if grid.title.startswith("Parts")
    )
    return {row[2]: row for row in parts.rows}


@pytest.mark.parametrize(
    ("name", "bell", "ring"),
    [("star", "first.ring", "second.ring"), ("wolfrom-reducer", "wolfrom.turned", "wolfrom.held")],
)
def test_bells_keepers_and_splines_are_in_the_list_of_parts_with_their_masses(name, bell, ring):
    masses = {item.part: item.each for item in complete_mass(sized(name)).parts}
    listed = rows(name)
    assert listed[f"Bell of {bell}"][4] == f"{masses[f'{bell} bell']:.3g}"
    assert listed[f"Keeper of {ring}"][4] == f"{masses[f'{ring} keeper']:.3g}"
    assert listed[f"Gear {ring}"][4] == f"{masses[ring] + masses[f'{ring} splines']:.3g}"
    assert ", W " in listed[f"Gear {ring}"][3]


def test_what_is_not_sized_or_drawn_of_sets_is_said():
    star, plain, compound = (" ".join(set_notes(sized(name), cut=True))
                             for name in ("star", "in-line-h2", "wolfrom-reducer"))  # fmt: skip
    assert "standing carrier of first" in star and "Bells of rings" in star
    assert "carrier" not in plain and "Bells" not in plain and "lands of the housing" in plain
    assert "Planets and carrier of wolfrom are not drawn" in compound
    assert "lands" not in " ".join(set_notes(sized("star"), cut=False))
    assert not list(set_notes(sized("off-set"), cut=True))
