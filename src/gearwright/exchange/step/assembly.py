"""A scene as a document of Open CASCADE: equal bodies share one solid, every place has its own name."""

from __future__ import annotations

import io
import math
from typing import Any

import numpy as np

from gearwright.errors import Problem, SolveError, refuse
from gearwright.exchange.step.kernel import occ
from gearwright.exchange.step.solids import NotMade, made_of
from gearwright.exchange.step.wires import MM
from gearwright.shape import COLOURS, Node, Scene
from gearwright.version import __version__


def assembly(scene: Scene) -> bytes:
    """Return a scene as STEP AP214.

    Args:
        scene: Its solids.

    Raises:
        DesignError: If no solid comes of some bodies, with all of them by name; nothing is written.
        SolveError: If Open CASCADE does not write it.
    """
    _silence()
    document = occ.TDocStd_Document(occ.TCollection_ExtendedString("XmlOcaf"))
    shapes = occ.XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    colours = occ.XCAFDoc_DocumentTool.ColorTool_s(document.Main())
    whole = shapes.NewShape()
    _name(whole, scene.name)
    labels, made = dict[str, Any](), _bodies(scene)
    for node in scene.nodes:
        if not node.surface:
            continue
        if node.surface not in labels:
            label = labels[node.surface] = shapes.AddShape(made[node.surface], False)
            _name(label, node.surface)
            colour = occ.Quantity_Color(*COLOURS[node.look], occ.Quantity_TypeOfColor.Quantity_TOC_RGB)
            colours.SetColor(label, colour, occ.XCAFDoc_ColorType.XCAFDoc_ColorGen)
        _name(shapes.AddComponent(whole, labels[node.surface], occ.TopLoc_Location(_placed(node))), node.name)
    shapes.UpdateAssemblies()
    return _written(document)


def _bodies(scene: Scene) -> dict[str, Any]:
    """Return name of a solid -> what Open CASCADE makes of it; refuse all at once that it makes nothing of."""
    made, problems = dict[str, Any](), list[Problem]()
    for name in dict.fromkeys(node.surface for node in scene.nodes if node.surface):
        try:
            made[name] = made_of(scene.solids[name])
        except NotMade as error:
            problems.append(Problem("--to", f"step has no solid of {name!r}: {error}; use glb, which has its surface"))
    refuse(problems)
    return made


def _silence() -> None:
    """Take from Open CASCADE what it says to standard output, which is the caller's."""
    occ.Message.DefaultMessenger_s().RemovePrinters(occ.Message_PrinterOStream.get_type_descriptor_s())


def _name(label: Any, text: str) -> None:
    occ.TDataStd_Name.Set_s(label, occ.TCollection_ExtendedString(text, True))


def _placed(node: Node) -> Any:
    cosine, sine = math.cos(node.phase), math.sin(node.phase)
    turned = node.axes.turned @ np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    placed = occ.gp_Trsf()
    rows = np.column_stack([turned, MM * np.asarray(node.axes.origin)])
    placed.SetValues(*(float(value) for value in rows.ravel()))
    return placed


def _written(document: Any) -> bytes:
    writer = occ.STEPCAFControl_Writer()
    occ.Interface_Static.SetCVal_s("write.step.schema", "AP214IS")
    occ.Interface_Static.SetCVal_s("write.step.unit", "MM")
    writer.SetNameMode(True)
    writer.SetColorMode(True)
    writer.Transfer(document)
    header = occ.APIHeaderSection_MakeHeader(writer.ChangeWriter().Model())
    header.SetOriginatingSystem(occ.TCollection_HAsciiString(f"gearwright {__version__}"))
    stream = io.BytesIO()
    if (status := writer.WriteStream(stream).name) != "IFSelect_RetDone":
        raise SolveError(f"Open CASCADE did not write the assembly ({status}); glb needs nothing but gearwright")
    return stream.getvalue()
