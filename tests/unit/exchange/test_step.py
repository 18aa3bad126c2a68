"""STEP files, read back by Open CASCADE: names, colours, places and volumes of what was written."""

import math
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import gearwright as gw
from gearwright.exchange import step as write
from gearwright.exchange.step import to_step
from gearwright.parts.gears import Blank, TransverseTooth, transverse_form
from gearwright.shape.solids import Section, Solid, disc_gear, loop_of, surface_of
from gearwright.shape.surfaces import Bores
from shipped_work import sized
from step_files import volume_of


def test_who_lacks_open_cascade_is_told_what_to_install(monkeypatch):
    monkeypatch.setattr(write, "find_spec", lambda name: None)
    with pytest.raises(gw.DesignError, match=r"Open CASCADE.*pip install.*\[cad\].*or use glb"):
        to_step(sized("star"))


def test_the_rooms_of_step_import_where_open_cascade_is_not():
    """A finder that knows no Open CASCADE stands before all others in an interpreter of its own."""
    code = """
import sys
class Without:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] == "OCP":
            raise ModuleNotFoundError(name)
sys.meta_path.insert(0, Without())
from gearwright.exchange import step
try:
    step.occ.gp_Pnt
except ModuleNotFoundError as error:
    print(error)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "OCP\n"


@pytest.mark.extra("OCP")
def test_bodies_of_which_no_solid_comes_are_refused_by_name_and_nothing_is_written():
    """A plate whose hole reaches beyond its outline, and one whose outline crosses itself: both are named at once."""
    from gearwright.exchange.step import assembly

    def plate(angles, *middles):
        outlines = (Section(np.full(4, 0.05), np.radians(angles), np.full(4, place)) for place in (-0.01, 0.01))
        way = ((0.01, 0.0), (-0.01, 0.0))
        return Solid(way, tuple(outlines), np.zeros(4, bool), bores=Bores(middles, 0.01))

    built, names = gw.scene(sized("single-planetary"), detail="smooth"), ("first.sun", "first.planet")
    spoilt = dict(zip(names, (plate([0, 90, 180, 270], 0.045 + 0j), plate([0, 120, 60, 240])), strict=True))
    nodes = tuple(node for node in built.nodes if node.surface in (*names, "shaft input"))
    few = replace(built, solids={**built.solids, **spoilt}, nodes=nodes)
    with pytest.raises(gw.DesignError) as told:
        assembly(few)
    assert [problem.path for problem in told.value.problems] == ["--to", "--to"]
    assert all(name in str(told.value) for name in ("'first.sun'", "'first.planet'", "use glb"))


@pytest.mark.extra("OCP")
def test_the_plate_of_a_carrier_is_straight_between_its_corners_and_round_in_its_holes():
    """Area of its polygon by its corners, less pins and bore, times its thickness: no spline bulges beyond it."""
    from gearwright.exchange.step import made_of

    plate = gw.scene(sized("hybrid-turboprop"), detail="smooth").solids["second.carrier"]
    low, high = (section.points for section in plate.sections)
    x, y = low[:, 0], low[:, 1]
    outline = 0.5 * float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))
    bore = plate.profile[0][1]
    holes = math.pi * (len(plate.bores.middles) * plate.bores.radius**2 + bore**2)
    assert volume_of(made_of(plate)) == pytest.approx((outline - holes) * (high - low)[0, 2], rel=1e-9)


@pytest.mark.extra("OCP")
def test_wheels_of_face_gears_are_valid_solids_and_nothing_is_said(capfd):
    """`--json` and pipes own standard output: Open CASCADE says nothing there."""
    from OCP.BRepCheck import BRepCheck_Analyzer

    from gearwright.exchange.step import assembly, made_of

    built = gw.scene(sized("face-gear-split-torque"), detail="smooth")
    wheel = made_of(built.solids["first.wheel"])
    assert BRepCheck_Analyzer(wheel).IsValid()
    assert volume_of(wheel) == pytest.approx(built.surfaces["first.wheel"].volume, rel=4e-3)
    few = replace(built, nodes=tuple(node for node in built.nodes if node.look in ("pinion", "shaft")))
    assert assembly(few).startswith(b"ISO-10303-21;")
    assert capfd.readouterr().out == ""


@pytest.mark.extra("OCP")
def test_a_helical_wheel_has_the_volume_of_its_teeth():
    """A helix moves metal about the axis and adds none: triangulated to 10 µm, it has the volume of a spur gear."""
    from OCP.BRepGProp import BRepGProp
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.GProp import GProp_GProps

    from gearwright.exchange.step import made_of

    tooth = TransverseTooth(23, 3e-3, 0.3)
    blank = Blank(tooth.root_radius, 0.0, 0.01, 0.01, 0.02, 0.02)

    def solid(points, turn):
        levels = [(place, turn * place / 0.01) for place in (-0.01, 0.0, 0.01)]
        return disc_gear(loop_of(transverse_form(tooth, fillet=points, flank=points), 23), levels, blank)

    made, properties = made_of(solid(10, 0.08)), GProp_GProps()
    BRepMesh_IncrementalMesh(made, 0.01, False, 0.1, False)
    BRepGProp.VolumeProperties_s(made, properties, False, False, True)
    assert 1e-9 * properties.Mass() == pytest.approx(surface_of(solid(60, 0.0), 720).volume, rel=4e-4)  # chords of both


@pytest.mark.extra("OCP")
def test_holes_are_bored_through_a_web():
    from OCP.BRepCheck import BRepCheck_Analyzer

    from gearwright.exchange.step import made_of

    tooth = TransverseTooth(20, 3e-3)
    blank = Blank(tooth.root_radius, 0.02, 0.008, 0.006, 0.02, 0.006)
    loop = loop_of(transverse_form(tooth, fillet=3, flank=3), 20)
    plain, bored = (
        made_of(disc_gear(loop, [(-0.01, 0.0), (0.01, 0.0)], blank._replace(holes=holes))) for holes in (0, 5)
    )
    assert BRepCheck_Analyzer(bored).IsValid()
    radius = blank._replace(holes=5).hole_radius
    assert volume_of(plain) - volume_of(bored) == pytest.approx(5 * math.pi * radius**2 * 0.006, rel=1e-6)
