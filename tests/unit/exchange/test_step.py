"""STEP files, read back by Open CASCADE: names, colours, places and volumes of what was written."""

import math
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import gearwright as gw
from gearwright.exchange.step import to_step, write
from gearwright.parts.gears import Blank, TransverseTooth, transverse_form
from gearwright.shape import COLOURS
from gearwright.shape.record import triangles_of
from gearwright.shape.solids import Chamber, Fastener, disc_gear, loop_of, surface_of
from shipped_work import sized


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
from gearwright.exchange.step import assembly, kernel, solids, wires
try:
    kernel.occ.gp_Pnt
except ModuleNotFoundError as error:
    print(error)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "OCP\n"


def read_back(content, folder):
    """Return instance -> its solid in its place, and solid -> its colour, of a STEP file."""
    from OCP.collections import Sequence_TDF_Label
    from OCP.Quantity import Quantity_Color
    from OCP.STEPCAFControl import STEPCAFControl_Reader
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDataStd import TDataStd_Name
    from OCP.TDF import TDF_Label
    from OCP.TDocStd import TDocStd_Document
    from OCP.XCAFDoc import XCAFDoc_ColorType, XCAFDoc_DocumentTool

    path = folder / "read.step"
    path.write_bytes(content)
    document = TDocStd_Document(TCollection_ExtendedString("XmlOcaf"))
    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True)
    reader.SetColorMode(True)
    reader.ReadFile(str(path))
    reader.Transfer(document)
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    colours = XCAFDoc_DocumentTool.ColorTool_s(document.Main())

    def name_of(label):
        found = TDataStd_Name()
        assert label.FindAttribute(TDataStd_Name.GetID_s(), found)
        return found.Get().ToExtString()

    roots = Sequence_TDF_Label()
    shapes.GetFreeShapes(roots)
    assert roots.Length() == 1
    parts, bodies, painted = Sequence_TDF_Label(), {}, {}
    shapes.GetComponents_s(roots.Value(1), parts)
    for k in range(1, parts.Length() + 1):
        referred, colour = TDF_Label(), Quantity_Color()
        shapes.GetReferredShape_s(parts.Value(k), referred)
        bodies[name_of(parts.Value(k))] = shapes.GetShape_s(parts.Value(k))
        kinds = (XCAFDoc_ColorType.XCAFDoc_ColorGen, XCAFDoc_ColorType.XCAFDoc_ColorSurf)
        assert any(colours.GetColor(shapes.GetShape_s(referred), kind, colour) for kind in kinds)
        painted[name_of(referred)] = (colour.Red(), colour.Green(), colour.Blue())
    return name_of(roots.Value(1)), bodies, painted


@pytest.mark.extra("OCP")
def test_a_gearbox_is_read_back_with_the_names_colours_places_and_volumes_of_its_solids(tmp_path, monkeypatch):
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    from gearwright.exchange.step.solids import made_of, volume_of

    built, shapes = gw.scene(sized("ec120b"), detail="smooth"), []

    def recorded(solid):
        shapes.append(made_of(solid))
        return shapes[-1]

    monkeypatch.setattr("gearwright.exchange.step.assembly.made_of", recorded)
    title, bodies, painted = read_back(to_step(sized("ec120b")).content, tmp_path)
    every = dict.fromkeys(node.surface for node in built.nodes if node.surface)
    volumes = dict(zip(every, map(volume_of, shapes), strict=True))
    assert title == built.name
    nodes = {node.name: node for node in built.nodes if node.surface}
    assert bodies.keys() == nodes.keys()
    for label, node in nodes.items():
        surface, properties = built.surfaces[node.surface], GProp_GProps()
        BRepGProp.VolumeProperties_s(bodies[label], properties)
        written = volumes[node.surface]
        assert 1e-9 * properties.Mass() == pytest.approx(written, rel=1e-5), (
            label
        )  # integrated over other splits of faces
        # Open CASCADE integrates over ends with many teeth to a hundredth; circles of 90 corners lose 0.08 %,
        # of which thin rings feel several times their share, as bores gain as much.
        solid = built.solids[node.surface]
        flat = isinstance(solid, Chamber)
        near = 1e-9 if flat else 0.03 if isinstance(solid, Fastener) else 0.012 if solid.sections else 6e-3
        assert written == pytest.approx(triangles_of(solid, 720).volume, rel=near), label
        middle = properties.CentreOfMass()
        along = (np.array([middle.X(), middle.Y(), middle.Z()]) / 1e3 - node.axes.origin) @ node.axes.turned
        off_axis = flat or label.startswith("housing, mount")
        assert off_axis or math.hypot(along[0], along[1]) < 1e-3 * surface.reach, label  # round bodies, on their axes
        assert BRepCheck_Analyzer(bodies[label]).IsValid(), label
        assert painted[node.surface] == pytest.approx(COLOURS[node.look], abs=2e-3), label


@pytest.mark.extra("OCP")
def test_wheels_of_face_gears_are_valid_solids_and_nothing_is_said(capfd, tmp_path):
    """`--json` and pipes own standard output: Open CASCADE says nothing there."""
    from OCP.BRepCheck import BRepCheck_Analyzer

    from gearwright.exchange.step.assembly import write_assembly
    from gearwright.exchange.step.solids import made_of, volume_of

    built = gw.scene(sized("face-gear-split-torque"), detail="smooth")
    wheel = made_of(built.solids["first.wheel"])
    assert BRepCheck_Analyzer(wheel).IsValid()
    assert volume_of(wheel) == pytest.approx(built.surfaces["first.wheel"].volume, rel=4e-3)
    few = replace(built, nodes=tuple(node for node in built.nodes if node.look in ("pinion", "shaft")))
    write_assembly(few, tmp_path / "few.step")
    assert (tmp_path / "few.step").read_bytes().startswith(b"ISO-10303-21;")
    assert capfd.readouterr().out == ""


@pytest.mark.extra("OCP")
def test_a_helical_wheel_has_the_volume_of_its_teeth():
    """A helix moves metal about the axis and adds none: triangulated to 10 µm, it has the volume of a spur gear."""
    from OCP.BRepGProp import BRepGProp
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.GProp import GProp_GProps

    from gearwright.exchange.step.solids import made_of

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

    from gearwright.exchange.step.solids import made_of, volume_of

    tooth = TransverseTooth(20, 3e-3)
    blank = Blank(tooth.root_radius, 0.02, 0.008, 0.006, 0.02, 0.006)
    loop = loop_of(transverse_form(tooth, fillet=3, flank=3), 20)
    plain, bored = (
        made_of(disc_gear(loop, [(-0.01, 0.0), (0.01, 0.0)], blank._replace(holes=holes))) for holes in (0, 5)
    )
    assert BRepCheck_Analyzer(bored).IsValid()
    radius = blank._replace(holes=5).hole_radius
    assert volume_of(plain) - volume_of(bored) == pytest.approx(5 * math.pi * radius**2 * 0.006, rel=1e-6)
