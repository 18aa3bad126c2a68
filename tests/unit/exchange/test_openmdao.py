"""A design as a component of OpenMDAO: values, units, partials, refusals, and the example of the documentation."""

import importlib.util
from pathlib import Path

import pytest

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.exchange.openmdao import component, variable
from shipped_work import sized

ROOT = Path(__file__).parents[3]
SPEED, PLANETS, POWER = "motors.electric.speed_rpm", "planetaries.second.planets", "turbines.gas-turbine.power_kw"
NEEDED = pytest.mark.extra("openmdao")


def problem(*asked, design="in-line-h2", **how):
    """Return OpenMDAO's problem of one component, set up."""
    import openmdao.api as om

    made = om.Problem(reports=False)
    made.model.add_subsystem("box", component(gw.read(design), *asked, **how), promotes=["*"])
    made.setup()
    return made


@NEEDED
def test_results_come_in_their_units_as_the_verbs_give_them():
    made = problem([SPEED], ["mass", "meshes.second.sun-planet.centre_distance", "cases.rated.intermediate.speed"])
    made.set_val(variable(SPEED), 5000.0 / 60.0, units="rev/s")
    made.run_model()
    sizing = gw.size(gw.edited(gw.read("in-line-h2"), {SPEED: 5000.0}))
    named = gw.named_results(sizing)
    distance = named["meshes.second.sun-planet.centre_distance"].value
    assert made.get_val("mass")[0] == pytest.approx(sizing.mass, rel=1e-12)  # revolutions to rpm and back
    assert made.get_val("meshes:second:sun_planet:centre_distance", units="mm")[0] == pytest.approx(1e3 * distance)
    assert made.get_val("cases:rated:intermediate:speed", units="rpm")[0] == pytest.approx(5000.0, rel=0.025)
    assert made.model.box.designed().motors["electric"].speed == pytest.approx(sizing.design.motors["electric"].speed)


@NEEDED
@pytest.mark.filterwarnings(r"ignore:\s*Component .* has zero derivatives")
@pytest.mark.parametrize("teeth", ["chosen", "frozen"])
def test_partials_are_those_of_plain_differences_where_no_teeth_change(teeth):
    """Rel. 1e-5: steps of 0.5 of the two differ by their squares over the value's, 1e-8, and by rounding."""
    start = {SPEED: 4500.0, POWER: 1050.0}  # cruise takes 1046 kW, and no less may be rated
    made = problem(start, ["total_mass", "gear_mass", "meshes.first.sun-planet.tangential_force"], teeth=teeth)
    made.run_model()
    told = made.check_partials(out_stream=None, method="fd", form="central", step=0.5)["box"]
    slopes = {pair: (entry["J_fwd"][0][0], entry["J_fd"][0][0]) for pair, entry in told.items()}
    assert sum(abs(ours) > 1e-6 for ours, _ in slopes.values()) >= 4
    for pair, (ours, theirs) in slopes.items():
        assert ours == pytest.approx(theirs, rel=1e-5, abs=1e-9), pair


@NEEDED
def test_the_mass_of_similar_gears_grows_as_their_power():
    """Lewis and Hertz with widths in modules: m³ is as the torque is, and so are masses; their slope is M/P."""
    made = problem(["turbines.gas-turbine.power_kw"], ["gear_mass"], design="single-planetary", teeth="frozen")
    made.run_model()
    power = made.get_val(variable(POWER))[0]
    slope = made.compute_totals(["gear_mass"], [variable(POWER)])["gear_mass", variable(POWER)][0][0]
    assert slope == pytest.approx(made.get_val("gear_mass")[0] / power, rel=1e-6)


@NEEDED
def test_planets_are_a_discrete_input():
    made = problem([SPEED, PLANETS], ["mass"])
    made.set_val(variable(PLANETS), 4)
    made.run_model()
    expected = gw.size(gw.edited(gw.read("in-line-h2"), {PLANETS: 4})).mass
    assert made.get_val("mass")[0] == expected


@NEEDED
def test_what_cannot_be_sized_is_an_analysis_error_in_our_words():
    import openmdao.api as om

    made = problem([SPEED], ["mass"], teeth="frozen")
    for value, words in ((6000.0, "the teeth and the other speeds give 4500 rpm"), (float("nan"), "finite")):
        made.set_val(variable(SPEED), value)
        with pytest.raises(om.AnalysisError, match=words):
            made.run_model()


@NEEDED
@pytest.mark.parametrize(
    ("inputs", "outputs", "words"),
    [
        (["motors.electric.sped_rpm"], ["mass"], "did you mean|write speed|motors.electric.speed_rpm"),
        (["motors.electric.shaft"], ["mass"], "motors.electric.shaft: no number stands there"),
        (["motors.electric"], ["mass"], "this is a table"),
        (["planetaries.first.module_mm"], ["mass"], "no number stands there.*inputs = {path: number}"),
        (["mission.step_s"], ["mass"], "there is no mission"),
        ([SPEED], ["masse"], "did you mean mass"),
        ([SPEED], ["fly.fuel"], "mission"),
        (SPEED, ["mass"], "is of type str"),
        ([SPEED], [], "give a list"),
        ([SPEED, "motors.electric.speed_rad_s"], ["mass"], "given twice"),
    ],
)
def test_a_path_or_result_that_is_no_number_is_refused_by_name(inputs, outputs, words):
    with pytest.raises(DesignError, match=words):
        component(gw.read("in-line-h2"), inputs, outputs)


@NEEDED
def test_names_that_openmdao_cannot_tell_apart_are_refused():
    text = (
        gw.design_text(gw.read("in-line-h2")).replace("cases.cruise", "cases.a-b").replace("cases.rated", "cases.a_b")
    )
    design = gw.edited(gw.parse(text), {"cases.a_b.electric.rating": None, "cases.a_b.electric.power_kw": 900.0})
    paths = ["cases.a-b.electric.power_kw", "cases.a_b.electric.power_kw"]
    with pytest.raises(DesignError, match=r"a_b\.electric.*is that of cases\.a-b\.electric"):
        component(design, paths, ["mass"])


@NEEDED
def test_frozen_teeth_leave_no_ratio_to_change():
    design = gw.edited(gw.read("in-line-h2"), {"planetaries.first.ratio_split": 1.0})
    with pytest.raises(DesignError, match="with frozen teeth it changes nothing"):
        component(design, ["planetaries.first.ratio_split"], ["mass"], teeth="frozen")


@NEEDED
def test_the_example_of_the_documentation_ends_below_its_grid():
    """From near the best teeth to the limits of speed and battery: lighter than the grid's 515.17 kg."""
    spec = importlib.util.spec_from_file_location("optimise_motor", ROOT / "docs" / "examples" / "optimise_motor.py")
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    ((start, _),) = example.grid([5800.0], [0.32])
    made = example.problem(start[1], start[3], "frozen")
    made.run_driver()
    mass, _, ahead, _, energy = example.state(made)
    assert mass < 514.0
    assert ahead == pytest.approx(0.0, abs=0.01)
    assert energy == pytest.approx(example.BATTERY, rel=1e-4)


def test_without_openmdao_the_component_is_refused_with_what_to_install(monkeypatch):
    monkeypatch.setattr("gearwright.exchange.openmdao.find_spec", lambda name: None)
    with pytest.raises(DesignError, match=r"OpenMDAO.*pip install.*\[openmdao\]"):
        component(sized("in-line-h2").design, [SPEED], ["mass"])
