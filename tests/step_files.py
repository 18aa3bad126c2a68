"""STEP files read back by Open CASCADE: names, colours, places and volumes; imported where the extra ``cad`` is."""

import numpy as np


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


def volume_of(shape):
    """Return the volume of a solid in millimetres [m³]; over ends with many teeth it is integrated to 3 %."""
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties)
    return 1e-9 * properties.Mass()


def middle_of(shape):
    """Return the centre of mass of a solid where it stands [m]."""
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties)
    middle = properties.CentreOfMass()
    return np.array([middle.X(), middle.Y(), middle.Z()]) / 1e3


def place_of(shape):
    """Return where the origin of a solid's own axes stands [m]."""
    moved = shape.Location().Transformation().TranslationPart()
    return np.array([moved.X(), moved.Y(), moved.Z()]) / 1e3


def closed_solids(shape):
    """Return how many solids a valid shape has; all their shells are closed."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer

    assert BRepCheck_Analyzer(shape).IsValid()
    count = {TopAbs_ShapeEnum.TopAbs_SHELL: 0, TopAbs_ShapeEnum.TopAbs_SOLID: 0}
    for kind in count:
        walk = TopExp_Explorer(shape, kind)
        while walk.More():
            assert kind != TopAbs_ShapeEnum.TopAbs_SHELL or BRep_Tool.IsClosed_s(walk.Current())
            count[kind] += 1
            walk.Next()
    assert count[TopAbs_ShapeEnum.TopAbs_SHELL] == count[TopAbs_ShapeEnum.TopAbs_SOLID]
    return count[TopAbs_ShapeEnum.TopAbs_SOLID]
