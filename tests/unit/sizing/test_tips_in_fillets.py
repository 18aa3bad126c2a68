"""Tips of rings in the fillets of their mates: found where they are, and gone with the tip alteration that is named."""

import math
import re
from pathlib import Path

import pytest

import gearwright as gw
from gearwright.parts.gears import form_radius
from gearwright.sizing.mass import tooth_of
from gearwright.sizing.summaries import tips_in_fillets


def keyed(text: str, path: str, value: float) -> str:
    """Return a design's text with one key more."""
    table, _, key = path.rpartition(".")
    line, heading = f"{key} = {value:.4f}", re.compile(rf"^\[{re.escape(table)}\].*$", re.MULTILINE)
    return heading.sub(rf"\g<0>\n{line}", text) if heading.search(text) else f"{text}\n[{table}]\n{line}\n"


@pytest.mark.parametrize("name", ["in-line-h2", "geared-turbofan-star", "contra-rotating-propellers"])
def test_the_named_tip_alteration_keeps_them_out_and_no_more(name: str, tmp_path: Path) -> None:
    path = gw.shipped_design(name)
    text, found = path.read_text(encoding="utf-8"), tips_in_fillets(gw.size(gw.read(path)))
    assert found
    short, long = text, text
    for one in found:
        short = keyed(short, one.path, one.tip_alteration)
        long = keyed(long, one.path, one.tip_alteration + 0.002)
    for words, left in ((short, 0), (long, len(found))):
        (tmp_path / "design.toml").write_text(words, encoding="utf-8")
        assert len(tips_in_fillets(gw.size(gw.read(tmp_path / "design.toml")))) == left


def test_they_touch_where_the_line_of_action_says() -> None:
    sizing = gw.size(gw.read("in-line-h2"))
    one = tips_in_fillets(sizing)[0]
    gears = {gear.name: gear for gear in sizing.gears}
    planet, ring = (tooth_of(sizing, gears[name]) for name in one.mesh.gears)
    # By angles instead: along the line of action the ring's tip is ρ_2 from its base tangent, a sin α less.
    angle = math.acos(ring.base_radius / ring.tip_radius)
    touched = ring.base_radius * math.tan(angle) - one.mesh.centre_distance * math.sin(one.mesh.working_pressure_angle)
    radius = planet.base_radius / math.cos(math.atan(touched / planet.base_radius))
    assert one.below == pytest.approx(form_radius(planet) - radius, rel=1e-9)


def test_external_pairs_have_none() -> None:
    assert not tips_in_fillets(gw.size(gw.read("off-set")))


def test_the_review_says_so() -> None:
    review = gw.review(gw.read("in-line-h2"))
    said = [check for check in review.open if check.mode == "tips in fillets"]
    assert [str(check.part) for check in said] == ["first.planet-ring", "second.planet-ring"]
