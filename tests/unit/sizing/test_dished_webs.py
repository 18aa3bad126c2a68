"""Dished webs: what they weigh, where they meet their hubs, as solids and on sheets."""

import math
import re

import pytest

import gearwright as gw
from gearwright.cli import main
from gearwright.errors import DesignError
from gearwright.parts.gears import Blank, SeatHub, blank_volume, dishes_behind, revolved_volume, way_behind
from gearwright.render.drawings.catalogue import sheets
from gearwright.render.drawings.entities import Words
from gearwright.shape import edges_of, scene, solid_masses
from gearwright.shape.solids import inner_profile
from gearwright.sizing.mass import gear_blanks
from gearwright.spec import design_text, edited
from overlaps import overlaps
from shipped_work import sized


def dished(name, dish, **more):
    return gw.size(edited(gw.read(name), {"gears.web_dish": dish, **more}))


def test_a_sheared_web_fills_as_much():
    """Cavalieri: rim, leaning web of the same thickness along the axis and hub, by the way around them."""
    blank = Blank(0.1, 0.09, 0.03, 0.02, 0.04, 0.01, dish=0.012)
    way = inner_profile(blank)
    assert (0.005 + 0.012, 0.03) in way and (-0.005 + 0.012, 0.03) in way and (0.005, 0.09) in way
    swept = revolved_volume([*way, (-0.02, 0.1), (0.02, 0.1)])
    assert swept == pytest.approx(blank_volume(blank), rel=1e-12)
    assert blank_volume(blank) == pytest.approx(blank_volume(blank._replace(dish=0.0)), rel=1e-12)


def test_a_wheel_with_a_dished_web_weighs_as_before_and_stands_aside_at_its_hub():
    straight, leaning = sized("ec120b"), dished("ec120b", -0.05)
    one, other = (gear_blanks(sizing)["helical.wheel"] for sizing in (straight, leaning))
    assert other.dish == pytest.approx(-0.05 * (other.rim_radius - other.hub_radius))
    assert blank_volume(other) == pytest.approx(blank_volume(one), rel=1e-12)
    weighed = {item.part: item.each for item in gw.complete_mass(leaning).parts if item.group == "gears"}
    before = {item.part: item.each for item in gw.complete_mass(straight).parts if item.group == "gears"}
    assert weighed["helical.wheel"] == pytest.approx(before["helical.wheel"], rel=1e-12)
    assert weighed["bevel.wheel"] == pytest.approx(before["bevel.wheel"], rel=5e-3)  # its rim is cut elsewhere


def test_solids_of_dished_wheels_are_closed_weigh_as_sized_and_meet_nothing():
    sizing = dished("ec120b", -0.05)
    built = scene(sizing, detail="smooth")
    for key in ("helical.wheel", "bevel.wheel"):
        surface = next(built.surfaces[name] for name in built.surfaces if name.startswith(key))
        assert edges_of(surface) == (0, 0)
    given = {path.removesuffix(".mass") for path in sizing.given if path.endswith(".mass")}
    for row in solid_masses(sizing, built):
        if str(row.part) not in given and row.weighed and "wheel" in str(row.part):
            assert row.solid == pytest.approx(row.weighed, rel=5e-3), row.part
    assert not list(overlaps(sizing, scene(sizing, detail="coarse")))


def test_a_bevel_web_leans_by_its_dish_on_both_faces():
    """A rim from 100 to 130 mm, a plate of 12 mm, a hub of 45 mm: both faces lean by 0.1."""
    toe, heel, seat = (0.0, 0.1), (0.03, 0.13), SeatHub(-0.02, 0.04, 0.045)
    straight = way_behind(toe, heel, 0.03, web=0.012, seat=seat)
    leaning = way_behind(toe, heel, 0.03, web=0.012, seat=seat, dish=0.1)
    hub = 0.045
    assert (straight[2], straight[-2]) == ((0.012, hub), (0.0, hub))
    assert leaning[2] == (pytest.approx(0.012 + 0.1 * (0.1 - hub)), hub)
    assert leaning[-2] == (pytest.approx(0.1 * (0.1 - hub)), hub)
    z, r = leaning[1]  # on the rim, and on the back face, 12 mm behind the front one along the axis
    assert r - 0.1 == pytest.approx(z * 0.03 / 0.03)
    assert z == pytest.approx(0.012 + 0.1 * (0.1 - r))
    with pytest.raises(DesignError, match=r"dish: 0.6 given; must be from -0.3636 to 0.5091"):
        way_behind(toe, heel, 0.03, web=0.012, seat=seat, dish=0.6)


def test_a_bevel_web_may_lean_until_its_faces_reach_the_ends_of_hub_or_rim():
    """The plate of 12 mm above, 55 mm high: 20 mm of hub before it, 28 mm behind it, 18 mm of rim that rises 30."""
    toe, heel, seat = (0.0, 0.1), (0.03, 0.13), SeatHub(-0.02, 0.04, 0.045)
    assert dishes_behind(toe, heel, 0.03, web=0.012, seat=seat) == pytest.approx((-0.02 / 0.055, 0.028 / 0.055))
    long = SeatHub(-0.05, 0.04, 0.045)
    least, most = dishes_behind(toe, heel, 0.03, web=0.012, seat=long)
    assert (least, most) == pytest.approx((-0.018 / 0.03, 0.028 / 0.055))
    assert way_behind(toe, heel, 0.03, web=0.012, seat=long, dish=0.999 * least)[1] == pytest.approx(heel, rel=5e-3)
    for beyond in (1.001 * least, 1.001 * most):
        with pytest.raises(DesignError, match="dish"):
            way_behind(toe, heel, 0.03, web=0.012, seat=long, dish=beyond)
    assert dishes_behind(toe, heel, 0.0, web=0.012) is None and dishes_behind(toe, heel, 0.08, web=0.012) is None


def test_webs_that_lean_too_far_are_refused_by_the_sizing_with_how_far_each_may():
    with pytest.raises(DesignError) as refused:
        dished("ec120b", 0.9)
    helical, bevel = refused.value.problems
    assert helical.path == bevel.path == "gears.web_dish"
    assert helical.message == (
        "0.9 given; must be from -0.066 to 0.066, so that the web of helical.wheel meets rim and hub with all of its"
        " thickness: lean it less, or write another web_dish in [pairs.helical.gears]"
    )
    assert "of bevel.wheel" in bevel.message and bevel.message.endswith("in [pairs.bevel.gears]")


@pytest.mark.parametrize("pair", ["helical", "bevel"])
@pytest.mark.parametrize("end", [0, 1])
def test_the_limits_that_are_told_are_weighed_and_what_is_beyond_is_refused_where_it_is_written(pair, end):
    path = f"pairs.{pair}.gears.web_dish"
    with pytest.raises(DesignError) as refused:
        gw.size(edited(gw.read("ec120b"), {path: (-0.9, 0.9)[end]}))
    (problem,) = refused.value.problems
    assert problem.path == path and problem.message.endswith("lean it less")
    told = float(re.search(r"from (\S+) to ([^,]+),", problem.message)[end + 1])
    sizing = gw.size(edited(gw.read("ec120b"), {path: told}))
    assert gw.complete_mass(sizing).total > 0.0 and scene(sizing, detail="coarse").surfaces
    with pytest.raises(DesignError, match=path):
        gw.size(edited(gw.read("ec120b"), {path: told + (-1e-4, 1e-4)[end]}))


def test_the_dish_of_a_wheel_without_a_web_is_told_where_it_is_the_pairs_own():
    """A wheel of one piece with its shaft is solid: a dish of all wheels passes it by, its own one has no effect."""
    path = "pairs.tail-take-off.gears.web_dish"
    with pytest.raises(DesignError, match=f"{path}: -0.05 given; tail-take-off.wheel has no web"):
        gw.size(edited(gw.read("ec120b"), {path: -0.05}))


@pytest.mark.parametrize("command", ["check", "size", "draw"])
def test_commands_say_before_they_draw_what_drawings_would_refuse(command, tmp_path, monkeypatch, capsys):
    file = tmp_path / "leaning.toml"
    file.write_text(design_text(edited(gw.read("ec120b"), {"pairs.bevel.gears.web_dish": 0.5})), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.argv", ["gearwright", command, str(file)])
    with pytest.raises(SystemExit) as ended:
        main()
    written = capsys.readouterr()
    assert ended.value.code and "pairs.bevel.gears.web_dish: 0.5 given; must be from" in written.out + written.err


@pytest.mark.parametrize(
    ("name", "more", "said"),
    [
        ("ec120b", {"gears.web_holes": 6}, "gears.web_dish: 0.05 given with 6 holes; a web has one of the two"),
        (
            "face-gear-split-torque",
            {},
            "must be 0, as webs of face gears are straight: write 0 in [pairs.first.gears]",
        ),
        ("single-planetary", {"planetaries.first.gears.web_dish": 0.1}, "planetaries.first.gears.web_dish"),
    ],
)
def test_bad_dishes_are_refused_by_name(name, more, said):
    with pytest.raises(DesignError) as refused:
        dished(name, 0.05, **more)
    assert said in str(refused.value)


@pytest.mark.parametrize("dish", [1.5, -1.01])
def test_a_dish_beyond_its_range_is_refused(dish):
    with pytest.raises(DesignError, match="web_dish"):
        edited(gw.read("ec120b"), {"gears.web_dish": dish})


def test_sheets_say_how_webs_lean_and_what_is_not_assessed():
    sizing = dished("ec120b", -0.05)
    said = {
        sheet.name: " ".join(words.text for words in sheet.entities if isinstance(words, Words))
        for sheet in sheets(sizing, ["gear"])
    }
    lean = f"{math.degrees(math.atan(0.05)):.2f}°"
    assert f"towards the shaft's first end, {lean}" in said["gear-helical.wheel"]
    assert f"Web dished by {lean}: at its hub towards the apex" in said["gear-bevel.wheel"]
    assert all(
        said[f"gear-{name}"].count("stiffness of its cone is not") == 1 for name in ("helical.wheel", "bevel.wheel")
    )
    assert "dished" not in said["gear-bevel.pinion"]
