"""A scene as a document of Open CASCADE: equal bodies share one solid, every place has its own name."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
from OCP.gp import gp_Trsf
from OCP.Interface import Interface_Static
from OCP.Message import Message, Message_PrinterOStream
from OCP.Quantity import Quantity_Color, Quantity_TypeOfColor
from OCP.STEPCAFControl import STEPCAFControl_Writer
from OCP.TCollection import TCollection_ExtendedString, TCollection_HAsciiString
from OCP.TDataStd import TDataStd_Name
from OCP.TDocStd import TDocStd_Document
from OCP.TopLoc import TopLoc_Location
from OCP.XCAFDoc import XCAFDoc_ColorType, XCAFDoc_DocumentTool

from gearwright.exchange.step.solids import made_of
from gearwright.exchange.step.wires import MM
from gearwright.shape import COLOURS, Node, Scene
from gearwright.version import __version__


def write_assembly(scene: Scene, path: Path) -> None:
    """Write a scene as STEP AP214.

    Args:
        scene: Its solids.
        path: The file.

    Raises:
        OSError: If Open CASCADE does not write it.
    """
    _silence()
    document = TDocStd_Document(TCollection_ExtendedString("XmlOcaf"))
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    colours = XCAFDoc_DocumentTool.ColorTool_s(document.Main())
    whole = shapes.NewShape()
    _name(whole, scene.name)
    labels: dict[str, Any] = {}
    for node in scene.nodes:
        if not node.surface:
            continue
        if node.surface not in labels:
            label = labels[node.surface] = shapes.AddShape(made_of(scene.solids[node.surface]), False)
            _name(label, node.surface)
            colour = Quantity_Color(*COLOURS[node.look], Quantity_TypeOfColor.Quantity_TOC_RGB)
            colours.SetColor(label, colour, XCAFDoc_ColorType.XCAFDoc_ColorGen)
        _name(shapes.AddComponent(whole, labels[node.surface], TopLoc_Location(_placed(node))), node.name)
    shapes.UpdateAssemblies()
    _write(document, path)


def _silence() -> None:
    """Take from Open CASCADE what it says to standard output, which is the caller's."""
    Message.DefaultMessenger_s().RemovePrinters(Message_PrinterOStream.get_type_descriptor_s())


def _name(label: Any, text: str) -> None:
    TDataStd_Name.Set_s(label, TCollection_ExtendedString(text, True))


def _placed(node: Node) -> Any:
    cosine, sine = math.cos(node.phase), math.sin(node.phase)
    turned = node.axes.turned @ np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    placed = gp_Trsf()
    rows = np.column_stack([turned, MM * np.asarray(node.axes.origin)])
    placed.SetValues(*(float(value) for value in rows.ravel()))
    return placed


def _write(document: Any, path: Path) -> None:
    writer = STEPCAFControl_Writer()
    Interface_Static.SetCVal_s("write.step.schema", "AP214IS")
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    writer.SetNameMode(True)
    writer.SetColorMode(True)
    writer.Transfer(document)
    header = APIHeaderSection_MakeHeader(writer.ChangeWriter().Model())
    header.SetOriginatingSystem(TCollection_HAsciiString(f"gearwright {__version__}"))
    if writer.Write(str(path)).name != "IFSelect_RetDone":
        raise OSError(f"Open CASCADE did not write {path}")
