"""STEP files (ISO 10303, AP214) of a scene's solids by Open CASCADE, of the extra ``cad``.

Tessellations are `shape`'s.
"""

import cmath
import io
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import Bools, Floats, Problem, Shown, SolveError, install, refuse, verb
from gearwright.shape import COLOURS, Bores, Node, Scene, scene
from gearwright.shape.chambers import Chamber, rim_of
from gearwright.shape.solids import Fastener, Layer, Section, Solid
from gearwright.sizing import Sizing
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# The verb: a sized gearbox as a STEP file, an assembly of named and coloured solids.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, repr=False)
class StepFile(Shown):
    """A STEP file."""

    content: bytes
    """As ISO 10303-21 has it, schema AP214, lengths in millimetres."""
    solids: int
    """Different ones [-]."""
    bodies: int
    """Places at which they stand [-]."""


@verb
def to_step(sizing: Sizing) -> StepFile:
    """Return gears, shafts, carriers and envelopes of bearings as an assembly in STEP AP214, named and coloured.

    Args:
        sizing: As sized.

    Raises:
        DesignError: If Open CASCADE, of the extra ``cad``, is not here.
    """
    if find_spec("OCP") is None:
        refuse([Problem("--to", f"step needs Open CASCADE, which is not here; {install('cad')}, or use glb")])

    built = scene(sizing, detail="smooth")
    return StepFile(assembly(built), len(built.solids), sum(bool(node.surface) for node in built.nodes))


# ----------------------------------------------------------------------------------------------------------------------
# Open CASCADE by the names of its classes, loaded on their first use: the rooms beside import without it, too.
# ----------------------------------------------------------------------------------------------------------------------


_ELSEWHERE = {"HArray1": "collections"}
"""Beginning of a name -> its module, where that is not the beginning itself."""


class Kernel:
    """The classes of Open CASCADE: ``occ.gp_Pnt`` is ``OCP.gp.gp_Pnt``."""

    def __getattr__(self, name: str) -> Any:
        """Return a class, and keep it.

        Args:
            name: As Open CASCADE has it, with its package before the first underscore.

        Raises:
            ModuleNotFoundError: If it is not installed.
            AttributeError: If it has no such class.
        """
        package = name.partition("_")[0]
        if not package:  # what looks a module through asks every object for names of Python's own
            raise AttributeError(name)
        found = getattr(import_module(f"OCP.{_ELSEWHERE.get(package, package)}"), name)
        setattr(self, name, found)
        return found


occ = Kernel()
"""What the rooms beside ask for classes."""


# ----------------------------------------------------------------------------------------------------------------------
# Outlines of teeth as wires: arcs where they follow circles about the axis, elsewhere splines through points.
# ----------------------------------------------------------------------------------------------------------------------


MM = 1e3
"""Millimetres, the unit of the files, in a metre [-]."""
SAME = 1e-9
"""Below which two places are one [m]."""
BETWEEN = 3
"""Parts into which a line on a cylinder is divided, so that its spline stays on it [-]."""


class Piece(NamedTuple):
    """A part of an outline between two corners."""

    points: tuple[int, ...]
    """Of the outline, in order."""
    is_arc: bool
    """Whether it is an arc about the axis."""


def pieces_of(section: Section, edges: Bools) -> tuple[Piece, ...]:
    """Return an outline in pieces, which all sections of one toothed wall share.

    Args:
        section: The first one.
        edges: Where the outline has corners.
    """
    return tuple(_pieces(section, edges))


def _pieces(section: Section, edges: Bools) -> Iterator[Piece]:
    count = len(section.radius)
    level = [np.abs(values - np.roll(values, -1)) < SAME for values in (section.radius, section.height)]
    arc = level[0] & level[1]
    parted = edges | arc | np.roll(arc, 1)
    start = int(np.argmax(parted))
    run = [start]
    for here, there in pairwise((start + k) % count for k in range(count + 1)):
        if arc[here]:
            yield Piece((here, there), is_arc=True)
            run = [there]
            continue
        run.append(there)
        if parted[there] or there == start:
            yield Piece(tuple(run), is_arc=False)
            run = [there]


def wire_of(section: Section, pieces: Sequence[Piece]) -> Any:
    """Return an outline as a closed wire [mm].

    Args:
        section: The outline.
        pieces: As its wall is divided.
    """
    wire = occ.BRepBuilderAPI_MakeWire()
    for piece in pieces:
        wire.Add(_edge(section, piece))
    return wire.Wire()


def _edge(section: Section, piece: Piece) -> Any:
    points = list(piece.points)
    radius, height, angle = section.radius[points], section.height[points], np.unwrap(section.angle[points])
    if piece.is_arc:
        places = [_place(radius[0], height[0], turn) for turn in (angle[0], angle.mean(), angle[1])]
        return occ.BRepBuilderAPI_MakeEdge(occ.GC_MakeArcOfCircle(*places).Value()).Edge()
    if np.ptp(radius) < SAME:
        radius, height, angle = (_divided(values) for values in (radius, height, angle))
    through = occ.HArray1_gp_Pnt(1, len(radius))
    for k, values in enumerate(zip(radius, height, angle, strict=True)):
        through.SetValue(k + 1, _place(*values))
    spline = occ.GeomAPI_Interpolate(through, False, SAME * MM)
    spline.Perform()
    return occ.BRepBuilderAPI_MakeEdge(spline.Curve()).Edge()


def _divided(values: Floats) -> Floats:
    whole = np.arange(len(values))
    return np.interp(np.linspace(0, len(values) - 1, BETWEEN * (len(values) - 1) + 1), whole, values)


def _place(radius: float, height: float, angle: float) -> Any:
    return occ.gp_Pnt(MM * float(radius) * math.cos(angle), MM * float(radius) * math.sin(angle), MM * float(height))


# ----------------------------------------------------------------------------------------------------------------------
# The exact form of a solid: surfaces of revolution about its axis, and walls through the outlines of its teeth.
# ----------------------------------------------------------------------------------------------------------------------


Place = tuple[float, float]
"""z and radius [m]."""
PAST = 1e-3
"""How far what is cut away reaches beyond a face [m]."""
FLAT, CURVED = 1e-3, 1e-2
"""How far edges of neighbouring faces may lie apart that are sewn, of flat ends and of ends on cones [mm]."""


class NotMade(Exception):
    """A body of which no closed and valid solid came."""


def made_of(solid: Solid | Chamber | Fastener) -> Any:
    """Return a closed and valid solid of Open CASCADE, in millimetres about z.

    Args:
        solid: What it is made of.

    Raises:
        NotMade: If none comes of it.
    """
    try:
        body = _made(solid)
    except Exception as error:
        if not type(error).__module__.startswith("OCP"):
            raise
        raise NotMade(f"Open CASCADE says {type(error).__name__}: {error}") from error
    if not _is_sound(body):  # mending might close it around another room
        raise NotMade("its faces cross or touch each other, or leave gaps")
    return body


def _is_sound(body: Any) -> bool:
    """Tell whether a shape is a solid whose faces enclose it and meet as they should."""
    kinds = occ.TopAbs_ShapeEnum
    return (
        body.ShapeType() == kinds.TopAbs_SOLID
        and all(map(occ.BRep_Tool.IsClosed_s, _parts(body, kinds.TopAbs_SHELL)))
        and bool(occ.BRepCheck_Analyzer(body).IsValid())
    )


def _made(solid: Solid | Chamber | Fastener) -> Any:
    if isinstance(solid, Chamber):
        return _chamber(solid)
    if isinstance(solid, Fastener):
        return _fastener(solid)
    if not solid.sections:
        return occ.BRepPrimAPI_MakeRevol(occ.BRepBuilderAPI_MakeFace(_way(solid.profile), True).Face(), _axis()).Shape()
    if solid.bores is not None:
        return _plate(solid, solid.bores)
    if not any(radius for _, radius in solid.profile):
        return _prism(solid)
    if solid.holes is not None:
        count, circle, radius = solid.holes
        middles = [cmath.rect(circle, 2.0 * math.pi * k / count) for k in range(count)]
        return _bored(made_of(solid._replace(holes=None)), solid, middles, radius)
    wires, wall = _wall(solid)
    behind = occ.BRepPrimAPI_MakeRevol(_way(solid.profile), _axis()).Shape()
    flat = float(np.ptp(solid.sections[0].height)) < SAME
    sewn = occ.BRepBuilderAPI_Sewing(FLAT if flat else CURVED)
    sewn.Add(wall)
    sewn.Add(behind)
    for end, place in zip((0, -1) if solid.inside else (-1, 0), (solid.profile[0], solid.profile[-1]), strict=True):
        section, ring = solid.sections[end], _ring(behind, place)
        loops = (ring, wires[end]) if solid.inside else (wires[end], ring)
        sewn.Add(_flat_end(section, *loops) if flat else _round_end(section, *loops, place))
    sewn.Perform()
    shell = _only(sewn.SewedShape(), occ.TopAbs_ShapeEnum.TopAbs_SHELL)
    body = occ.BRepBuilderAPI_MakeSolid(occ.TopoDS.Shell(shell)).Solid()
    occ.BRepLib.OrientClosedSolid_s(body)
    return body


def _bored(body: Any, solid: Solid, middles: Sequence[complex], radius: float) -> Any:
    """Return a body with round holes along its axis."""
    low, high = (end(place for place, _ in solid.profile) for end in (min, max))
    for middle in middles:
        axis = occ.gp_Ax2(occ.gp_Pnt(MM * middle.real, MM * middle.imag, MM * (low - PAST)), _up())
        bored = occ.BRepPrimAPI_MakeCylinder(axis, MM * radius, MM * (high - low + 2.0 * PAST)).Shape()
        body = occ.BRepAlgoAPI_Cut(body, bored).Shape()
    return _only(body, occ.TopAbs_ShapeEnum.TopAbs_SOLID)


def _plate(solid: Solid, bores: Bores) -> Any:
    """Return the plate of a carrier: straight between its corners, round in its holes."""
    low, high = (section.points for section in solid.sections)
    build = occ.BRepBuilderAPI_MakeFace(_polygon(low), True)
    (height, bore), _ = sorted(solid.profile)
    for middle, radius in [*((middle, bores.radius) for middle in bores.middles), *([(0j, bore)] if bore else [])]:
        down = occ.gp_Ax2(occ.gp_Pnt(MM * middle.real, MM * middle.imag, MM * height), _up().Reversed())
        edge = occ.BRepBuilderAPI_MakeEdge(occ.gp_Circ(down, MM * radius)).Edge()
        build.Add(occ.BRepBuilderAPI_MakeWire(edge).Wire())
    return _pulled(build.Face(), high[0] - low[0])


def _chamber(chamber: Chamber) -> Any:
    """Return a wall with its plates: a block, less the room inside, less what goes through the plates."""
    low, high = chamber.span
    inside = [place - way * (end.thickness if end else -PAST)
              for place, end, way in zip(chamber.span, chamber.ends, (-1.0, 1.0), strict=True)]  # fmt: skip
    found = occ.BRepAlgoAPI_Cut(_block(chamber.outer, low, high), _block(chamber.inner, *inside)).Shape()
    for place, end in zip(chamber.span, chamber.ends, strict=True):
        if end is None:
            continue
        for hole in end.holes:
            through = _block(hole, place - end.thickness - PAST, place + end.thickness + PAST)
            found = occ.BRepAlgoAPI_Cut(found, through).Shape()
    for opening in chamber.openings:
        rims = [rim_of(opening, loop) for loop in (chamber.inner, chamber.outer)]
        past = PAST * np.append(opening.way, 0.0)
        found = occ.BRepAlgoAPI_Cut(found, _swept(rims[0] - past, rims[1][0] - rims[0][0] + 2.0 * past)).Shape()
    return _only(found, occ.TopAbs_ShapeEnum.TopAbs_SOLID)


def _fastener(fastener: Fastener) -> Any:
    """Return a screw with what is on it, as one body."""
    first, *others = map(_layer, fastener.layers)
    for layer in others:
        first = occ.BRepAlgoAPI_Fuse(first, layer).Shape()
    return _only(first, occ.TopAbs_ShapeEnum.TopAbs_SOLID)


def _layer(layer: Layer) -> Any:
    """Return a ring, round or with a hexagon outside."""
    if layer.is_hexagon:
        corner = layer.outer / math.cos(math.pi / 6.0)
        angles = np.arange(6) * (math.pi / 3.0)
        body = _block(corner * np.stack([np.cos(angles), np.sin(angles)], axis=1), layer.start, layer.end)
    else:
        body = _cylinder(layer.outer, layer.start, layer.end)
    if not layer.bore:
        return body
    return occ.BRepAlgoAPI_Cut(body, _cylinder(layer.bore, layer.start - PAST, layer.end + PAST)).Shape()


def _cylinder(radius: float, low: float, high: float) -> Any:
    axis = occ.gp_Ax2(occ.gp_Pnt(0.0, 0.0, MM * low), _up())
    return occ.BRepPrimAPI_MakeCylinder(axis, MM * radius, MM * (high - low)).Shape()


def _block(outline: Floats, low: float, high: float) -> Any:
    """Return what a polygon sweeps along z."""
    corners = np.column_stack([outline, np.full(len(outline), low)])
    return _swept(corners, np.array([0.0, 0.0, high - low]))


def _swept(corners: Floats, way: Floats) -> Any:
    """Return what a plane polygon sweeps along a straight way."""
    return _pulled(occ.BRepBuilderAPI_MakeFace(_polygon(corners), True).Face(), way)


def _polygon(corners: Floats) -> Any:
    """Return a closed wire of straight lines."""
    build = occ.BRepBuilderAPI_MakePolygon()
    for corner in corners:
        build.Add(occ.gp_Pnt(*(MM * float(part) for part in corner)))
    build.Close()
    return build.Wire()


def _pulled(face: Any, way: Floats) -> Any:
    """Return what a plane face sweeps along a straight way."""
    return occ.BRepPrimAPI_MakePrism(face, occ.gp_Vec(*(MM * float(part) for part in way))).Shape()


def _prism(solid: Solid) -> Any:
    """Return a body without a bore, whose outline is the same at both ends."""
    assert solid.edges is not None
    first, last = solid.sections[0], solid.sections[-1]
    plane = occ.gp_Pln(occ.gp_Pnt(0.0, 0.0, MM * float(first.height[0])), _up())
    face = occ.BRepBuilderAPI_MakeFace(plane, wire_of(first, pieces_of(first, solid.edges)), True).Face()
    return occ.BRepPrimAPI_MakePrism(face, occ.gp_Vec(0.0, 0.0, MM * float(last.height[0] - first.height[0]))).Shape()


def _up() -> Any:
    return occ.gp_Dir(0.0, 0.0, 1.0)


def _axis() -> Any:
    return occ.gp_Ax1(occ.gp_Pnt(0.0, 0.0, 0.0), _up())


def _way(profile: Sequence[Place]) -> Any:
    """Return straight lines in the plane of x and z; those that begin and end on the axis are closed along it."""
    places = [profile[0]]
    places += [there for here, there in pairwise(profile) if math.dist(here, there) > SAME]
    if places[0] != places[-1] and places[0][1] == places[-1][1] == 0.0:
        places.append(places[0])
    wire = occ.BRepBuilderAPI_MakeWire()
    for here, there in pairwise(places):
        ends = (occ.gp_Pnt(MM * radius, 0.0, MM * height) for height, radius in (here, there))
        wire.Add(occ.BRepBuilderAPI_MakeEdge(*ends).Edge())
    return wire.Wire()


def _wall(solid: Solid) -> tuple[list[Any], Any]:
    """Return the outlines at both ends, and flanks, fillets and lands between them."""
    assert solid.edges is not None
    pieces = pieces_of(solid.sections[0], solid.edges)
    wires = [wire_of(section, pieces) for section in solid.sections]
    first, last = solid.sections[0], solid.sections[-1]
    if np.array_equal(first.angle, last.angle) and np.array_equal(first.radius, last.radius):
        prism = occ.BRepPrimAPI_MakePrism(wires[0], occ.gp_Vec(0.0, 0.0, MM * float(last.height[0] - first.height[0])))
        return [occ.TopoDS.Wire(prism.FirstShape()), occ.TopoDS.Wire(prism.LastShape())], prism.Shape()
    loft = occ.BRepOffsetAPI_ThruSections(False, len(wires) == 2, SAME * MM)
    for wire in wires:
        loft.AddWire(wire)
    loft.CheckCompatibility(False)
    loft.Build()
    return wires, loft.Shape()


def _parts(shape: Any, kind: Any) -> Iterator[Any]:
    walk = occ.TopExp_Explorer(shape, kind)
    while walk.More():
        yield walk.Current()
        walk.Next()


def _only(shape: Any, kind: Any) -> Any:
    """Return the one part of its kind of a shape."""
    found = list(_parts(shape, kind))
    if len(found) != 1:
        raise NotMade(f"{len(found)} bodies come of its faces where one is meant")
    return found[0]


def _ring(behind: Any, place: Place) -> Any:
    """Return the circle of a surface of revolution at a place, as a wire."""
    for part in _parts(behind, occ.TopAbs_ShapeEnum.TopAbs_EDGE):
        edge = occ.TopoDS.Edge(part)
        curve = occ.BRepAdaptor_Curve(edge)
        if curve.GetType() == occ.GeomAbs_CurveType.GeomAbs_Circle:
            circle = curve.Circle()
            found = (circle.Location().Z() / MM, circle.Radius() / MM)
            if math.dist(found, place) < SAME:
                return occ.BRepBuilderAPI_MakeWire(edge).Wire()
    raise NotMade(f"no circle of radius {MM * place[1]:.4g} mm where its end is")


def _flat_end(section: Section, outer: Any, inner: Any) -> Any:
    plane = occ.gp_Pln(occ.gp_Pnt(0.0, 0.0, MM * float(section.height[0])), _up())
    face = occ.BRepBuilderAPI_MakeFace(plane, outer, True)
    face.Add(occ.TopoDS.Wire(inner.Reversed()))
    mended = occ.ShapeFix_Face(face.Face())
    mended.FixOrientation()
    mended.Perform()
    return mended.Face()


def _round_end(section: Section, outer: Any, inner: Any, place: Place) -> Any:
    """Return the end of teeth on a back cone, or on a cylinder about the axis."""
    low, high = int(np.argmin(section.height)), int(np.argmax(section.height))
    rise, out = float(section.height[high] - section.height[low]), float(section.radius[high] - section.radius[low])
    if abs(out) < SAME:
        about = occ.gp_Ax3(occ.gp_Pnt(0.0, 0.0, 0.0), _up())
        surface = occ.Geom_CylindricalSurface(about, MM * float(section.radius[0]))
    else:
        base = occ.gp_Ax3(occ.gp_Pnt(0.0, 0.0, MM * place[0]), _up())
        surface = occ.Geom_ConicalSurface(base, math.atan(out / rise), MM * place[1])
    build = occ.BRepBuilderAPI_MakeFace(surface, outer, True)
    build.Add(occ.TopoDS.Wire(inner.Reversed()))
    face = build.Face()
    for edge in _parts(face, occ.TopAbs_ShapeEnum.TopAbs_EDGE):
        occ.ShapeFix_Edge().FixAddPCurve(occ.TopoDS.Edge(edge), face, False)
    mended = occ.ShapeFix_Shape(face)
    mended.Perform()
    return mended.Shape()


# ----------------------------------------------------------------------------------------------------------------------
# A scene as a document of Open CASCADE: equal bodies share one solid, every place has its own name.
# ----------------------------------------------------------------------------------------------------------------------


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
