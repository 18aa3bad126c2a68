"""What the design file says about dynamics reaches the system."""

import math

import numpy as np
import pytest

from gearwright.dynamics import modes, simulate, statics
from gearwright.dynamics.assembly import assemble, assumptions
from gearwright.dynamics.equations import linear, state_matrix
from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import parse, read

IN_LINE = shipped_design("in-line-h2").read_text(encoding="utf-8")


def system_of(more="", *, text=IN_LINE, **options):
    return assemble(size(parse(f"{text}\n{more}")), **options)


def least_and_most(system, line):
    """Stiffness of a line over its mean, over one cycle of its tones."""
    series, row = system.arrays.variation, system.labels.lines.index(line)
    part = slice(series.start[row], series.start[row + 1])
    order = np.arange(1, part.stop - part.start + 1)
    angle = np.linspace(0.0, 2.0 * math.pi, 400)[:, None] * order
    curve = 1.0 + np.cos(angle) @ series.cosine[part] + np.sin(angle) @ series.sine[part]
    return curve.min(), curve.max()


@pytest.mark.parametrize("model", ["iso6336", "energy", "square-wave"])
def test_each_named_mesh_stiffness_gives_every_mesh_a_curve(model):
    """Kept harmonics are the tones of a stage; means of ISO and of the square wave are ISO's own."""
    system = system_of(f'[dynamics]\nmesh_stiffness = "{model}"\nharmonics = 3')
    assert len(system.labels.tones) == (2 * 3 if model != "square-wave" else 2 * 2)
    iso = system_of().arrays.stiffness
    if model == "energy":
        assert system.arrays.stiffness == pytest.approx(iso, rel=0.35)
    else:
        assert system.arrays.stiffness == pytest.approx(iso, rel=0.01)


def test_kuang_and_yangs_stiffness_is_refused_outside_its_range_with_the_mesh_named():
    """Their fit holds for external spur gears of 12 to 50 teeth; these planets have 54."""
    with pytest.raises(DesignError, match=r"dynamics.mesh_stiffness: first.sun-planet: 54 given"):
        system_of('[dynamics]\nmesh_stiffness = "kuang-yang"')


def test_a_stiffness_outside_its_standard_names_the_model_that_knows_it():
    """x_1 + x_2 = −0.8 of planet and ring, where ISO 6336-1 ends at −0.5 and strain energy does not.

    Where no model is asked, such a mesh alone follows strain energy, and the assumptions say so.
    """
    shifted = IN_LINE.replace("[planetaries.first]", "[planetaries.first]\nplanet_shift = -0.4\nring_shift = -0.4", 1)
    assert shifted != IN_LINE
    with pytest.raises(DesignError) as caught:
        system_of('[dynamics]\nmesh_stiffness = "iso6336"', text=shifted)
    assert caught.value.problems[0].path == "dynamics.mesh_stiffness"
    assert 'write dynamics.mesh_stiffness = "energy"' in caught.value.problems[0].message
    lines = [system_of(f"[dynamics]\n{more}", text=shifted) for more in ('mesh_stiffness = "energy"', "")]
    by_energy, unasked = (dict(zip(one.labels.lines, one.arrays.stiffness, strict=True)) for one in lines)
    assert unasked["first.planet-ring-1"] == by_energy["first.planet-ring-1"] > 0.0
    assert unasked["second.planet-ring-1"] != by_energy["second.planet-ring-1"]
    sizing = size(parse(shifted))
    told = [one for one in assumptions(sizing, lines[1]) if one.subject == "stiffness of first.planet-ring"]
    assert [(one.value.partition(":")[0], one.origin) for one in told] == [("energy", "default")]


def test_a_curve_from_a_file_beside_the_design_sets_mean_and_swing(tmp_path):
    """A triangle between 4e8 and 6e8 N/m: mean 5e8 exactly; first harmonics leave some of the ± 20 %."""
    (tmp_path / "curve.csv").write_text("phase_cycles,stiffness_n_m\n0,4e8\n0.5,6e8\n1,4e8\n", encoding="utf-8")
    more = '\n[dynamics.curves."first.sun-planet"]\nfile = "curve.csv"\n'
    (tmp_path / "design.toml").write_text(IN_LINE + more, encoding="utf-8")
    design = read(tmp_path / "design.toml")
    system = assemble(size(design))
    place = system.labels.lines.index("first.sun-planet-2")
    assert system.arrays.stiffness[place] == pytest.approx(5e8)
    assert least_and_most(system, "first.sun-planet-2") == pytest.approx((0.8, 1.2), abs=0.02)
    assert design.dynamics.curves["first.sun-planet"].phase_cycles == [0.0, 0.5, 1.0]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, "there is no such file"),
        ("phase,stiffness_n_m\n0,1\n", "lacks phase_cycles"),
        ("phase_cycles,stiffness_n_m\n0,4e8\n0.3,many\n0.6,4e8\n", "no 2 numbers in line 3"),
        ("phase_cycles,stiffness_n_m\n0,4e8\n0.3,-1\n0.6,4e8\n", "must be positive"),
        ("phase_cycles,stiffness_n_m\n0,4e8\n0.3,4e8\n0.2,4e8\n", "increase"),
        ("", "lacks phase_cycles and stiffness_n_m"),
    ],
)
def test_a_curve_that_cannot_be_used_is_refused_with_the_line_of_the_design(tmp_path, content, words):
    if content is not None:
        (tmp_path / "curve.csv").write_text(content, encoding="utf-8")
    more = '\n[dynamics.curves."first.sun-planet"]\nfile = "curve.csv"\n'
    (tmp_path / "design.toml").write_text(IN_LINE + more, encoding="utf-8")
    with pytest.raises(DesignError, match=words) as caught:
        read(tmp_path / "design.toml")
    assert caught.value.problems[0].line is not None


def test_a_curve_of_a_mesh_that_is_not_there_names_the_nearest():
    with pytest.raises(DesignError, match=r"did you mean first\.sun-planet\?"):
        system_of('[dynamics.curves."first.sun-planets"]\nphase_cycles = [0, 0.5]\nstiffness_n_m = [1e8, 1e8]')


def test_backlash_of_a_planetary_set_reaches_each_of_its_meshes():
    text = IN_LINE.replace("planets = 3\n", "planets = 3\nbacklash_um = 60\n")
    system = system_of(text=text)
    widths = dict(zip(system.labels.lines, system.arrays.backlash, strict=True))
    assert widths["first.sun-planet-1"] == widths["first.planet-ring-3"] == pytest.approx(60e-6)
    assert widths["second.sun-planet-1"] == 0.0


RIGID = """
[planetaries.first.bearings]
rigid = ["sun", "carrier", "ring", "pin"]
[planetaries.second.bearings]
rigid = ["sun", "carrier", "ring", "pin"]
[dynamics]
fidelity = "translational"
"""


def test_translations_on_rigid_bearings_are_the_rotational_model():
    """Two builders, one model: frequencies, speeds and static forces; 1e-9 is rounding."""
    one, other = system_of(), system_of(RIGID)
    assert modes(other).frequency == pytest.approx(modes(one).frequency, rel=1e-9, abs=1e-6)
    force = dict(zip(one.labels.lines, statics(one, balance="accelerate").force, strict=True))
    for name, value in zip(other.labels.lines, statics(other, balance="accelerate").force, strict=True):
        assert value == pytest.approx(force[name], rel=1e-6), name


@pytest.mark.parametrize("design", ["single-planetary", "in-line-h2", "star", "differential-hybrid"])
def test_the_rigid_rotation_of_a_set_with_translations_does_not_drive_itself(design):
    """The planets' centrifugal preload turns with the carrier: no root grows; without that by 8 to 47 1/s."""
    text = shipped_design(design).read_text(encoding="utf-8")
    arrays = system_of('[dynamics]\nfidelity = "translational"', text=text).arrays
    free = arrays._replace(centripetal=arrays.centripetal._replace(value=arrays.centripetal.value * 0.0))
    # A double root at zero is found to the square root of rounding, as without any centripetal term.
    noise = np.linalg.eigvals(state_matrix(linear(free))).real.max()
    assert np.linalg.eigvals(state_matrix(linear(arrays))).real.max() < max(1e-3, 10.0 * noise)


def test_a_floating_sun_has_no_support_and_a_ring_on_the_ground_gives_way():
    more = '[planetaries.first.bearings]\nsun_n_um = 0\n[dynamics]\nfidelity = "translational"'
    lines = system_of(more).labels.lines
    assert "first.sun.support.x" not in lines and "second.sun.support.x" in lines
    assert "first.ring.support.rotation" in lines


def test_energy_closes_with_translations():
    """Input work = output work + dissipated + stored, with Coriolis and centripetal terms, to 1e-6."""
    trace = simulate(system_of('[dynamics]\nfidelity = "translational"'), 0.01)
    assert abs(trace.work.imbalance) < 1e-6


def test_bearings_given_twice_are_refused():
    more = '[supports.input]\nradial_n_um = 100\n[dynamics]\nfidelity = "translational"'
    with pytest.raises(DesignError, match=r"supports\.input: first.sun has bearings in planetaries"):
        system_of(more)


def test_bearings_that_nothing_reads_are_refused_with_the_entry_that_is_missing():
    with pytest.raises(DesignError, match=r'planetaries\.first\.bearings: has no effect .*fidelity = "translational"'):
        system_of("[planetaries.first.bearings]\nsun_n_um = 0")
