"""Faults that draws had left: overlaps above 1 in a film's load, levels of a share, shifts of compound sets."""

import numpy as np
import pytest

from designs import PAIR
from gearwright.parts.gears import CylindricalGear, GearPair
from gearwright.parts.iso6336 import mesh_geometry
from gearwright.parts.micropitting import load_sharing, path_places
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.rating import context_of, rating_of
from gearwright.sizing.rating.context import _loads as loads_of  # the division of a life, which records only sum
from gearwright.spec import parse, read
from gearwright.spec.design import compound_shifts

LIFE = 5000.0 * 3600.0


@pytest.mark.parametrize(("width", "overlap"), [(0.012, 0.8), (0.0193, 1.3), (0.03, 2.0), (0.045, 3.0)])
def test_buttressing_grows_with_overlap_to_one_and_no_further(width, overlap):
    """ISO/TR 15144-1, clause 11.5: X_but = 1 + 0.3 ε_β at A and E, 1.3 from ε_β = 1 on; 1 away from them."""
    slant = np.radians(25.0)
    pair = mesh_geometry(GearPair(*(CylindricalGear(z, 2e-3, width, helix_angle=slant) for z in (23, 64))))
    reached = float(pair.overlap_ratio)
    assert reached == pytest.approx(overlap, rel=0.02)
    ends = load_sharing(pair, 6, path_places(pair))[[0, 2, 3, 4, 6]]
    part = min(max((reached - 0.8) / 0.4, 0.0), 1.0)
    wide = part / float(pair.transverse_contact_ratio)
    end = (1.0 + 0.3 * min(reached, 1.0)) * ((1.0 - part) / 3.0 + wide)
    middle = (1.0 - part) + wide
    assert ends == pytest.approx([end, middle, middle, middle, end], rel=1e-9)


def test_each_level_of_a_case_lasts_its_part_of_the_share_under_its_part_of_the_load():
    """5000 h, 0.6 and 0.4 of them by the cases, 0.1, 0.2 and 0.7 of these by levels; one of them lasts for nothing."""
    text = PAIR + "pinion_teeth = 24\nwheel_teeth = 71\nmodule_mm = 3\nface_width_mm = 30\n"
    text += '[gears]\nrating = "iso6336"\n[service]\nlife_h = 5000\nspectrum = "own"\n'
    text += "[spectra.own]\nload = [1.0, 0.8, 0.5, 0.2]\nshare = [0.1, 0.2, 0.7, 0.0]\n"
    text += "[cases.cruise]\nshare = 0.6\nturbine.power_kw = 100\n[cases.climb]\nshare = 0.4\nturbine.power_kw = 90\n"
    sizing = size(parse(text))
    context = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, {})
    loads = list(loads_of(context, sizing.train.meshes[0]))
    assert [load.life for load in loads] == pytest.approx(
        [LIFE * share * part for share in (0.6, 0.4) for part in (0.1, 0.2, 0.7)], rel=1e-12
    )
    assert [load.case for load in loads] == ["cruise"] * 3 + ["climb"] * 3
    torques = [100e3 / (6000.0 * np.pi / 30.0) * power * level for power in (1.0, 0.9) for level in (1.0, 0.8, 0.5)]
    assert [load.torque for load in loads] == pytest.approx(torques, rel=1e-9)


@pytest.mark.parametrize("name", ["wolfrom-reducer", "geared-turbofan-star"])
def test_a_compound_set_is_rated_with_the_shifts_of_its_own_meshes(name):
    """Once its teeth are known, and no other stage is; each mesh has the two shifts of its own gears."""
    sizing = size(read(shipped_design(name)))
    design = sizing.design
    ((stage, _),) = design.epicyclics.items()
    rating, shifts = rating_of(design, stage, sizing.teeth), compound_shifts(design, stage)
    assert rating.compound == shifts
    assert rating_of(design, stage).compound is None
    for mesh in (mesh for mesh in sizing.train.meshes if mesh.stage == stage):
        own = rating.of_mesh(mesh)
        assert own.compound is None
        assert own.shifts == shifts.meshes[mesh.own]
    for gear in (gear for gear in sizing.train.gears if gear.stage == stage):
        assert rating.shift_of(gear) == shifts.gears[gear.own]


def test_a_stage_that_is_no_compound_set_has_no_shifts_of_one():
    sizing = size(parse(PAIR + "pinion_teeth = 24\nwheel_teeth = 71\nmodule_mm = 3\nface_width_mm = 30\n"))
    assert rating_of(sizing.design, sizing.meshes[0].stage, sizing.teeth).compound is None
