"""A scene as a binary glTF 2.0 file, which browsers, slides and modellers open: one mesh a surface, one node a body.

It asks readers for no extension of glTF; arrays that are equal to the bit, as those of tubes with equal corners are,
are written once.

Every node says in its extras whose body it is, as what it is painted, and how fast it turns about its own z in every
load case; planets are children of their carrier and turn against it.
"""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearwright.arrays import Floats
from gearwright.shape.record import Node, Scene
from gearwright.shape.solids import Surface
from gearwright.version import __version__

COLOURS: Mapping[str, tuple[float, float, float]] = {
    "sun": (0.80, 0.33, 0.18),
    "pinion": (0.80, 0.33, 0.18),
    "planet": (0.20, 0.46, 0.72),
    "wheel": (0.20, 0.46, 0.72),
    "ring": (0.50, 0.54, 0.58),
    "bell": (0.50, 0.54, 0.58),
    "seat": (0.50, 0.54, 0.58),
    "shaft": (0.70, 0.71, 0.70),
    "pin": (0.70, 0.71, 0.70),
    "carrier": (0.85, 0.63, 0.13),
    "bearing": (0.33, 0.60, 0.53),
    "holder": (0.36, 0.39, 0.44),
    "screw": (0.36, 0.39, 0.44),
    "housing": (0.62, 0.68, 0.74),
}
"""What a body is -> its colour, red, green and blue, told apart by those who do not tell red from green [-]."""
SEEN_THROUGH = 0.25
"""How much of a housing is seen of what is seen through it [-]."""
PLACES = 12
"""Decimals of places [m] and of quaternions [-]: beyond what readers of single precision see."""
_FLOAT, _SHORT, _LONG = 5126, 5123, 5125
_VERTICES, _INDICES = 34962, 34963


def glb(scene: Scene) -> bytes:
    """Return a scene as a binary glTF 2.0 file, lengths in metres.

    Args:
        scene: The scene.

    Source: glTF 2.0 specification, Khronos Group (ISO/IEC 12113:2022): header, a JSON chunk, a binary chunk.

    >>> import gearwright as gw
    >>> glb(gw.scene(gw.size(gw.read("off-set")), detail="coarse"))[:4]
    b'glTF'
    """
    buffer = _Buffer()
    looks = list(dict.fromkeys(node.look for node in scene.nodes))
    meshes: dict[tuple[str, str], int] = {}
    listed: list[dict[str, Any]] = []
    attributes = {key: _attributes(buffer, surface) for key, surface in scene.surfaces.items()}
    for node in scene.nodes:
        key = (node.surface, node.look)
        if node.surface and key not in meshes:
            meshes[key] = len(listed)
            primitive = {**attributes[node.surface], "material": looks.index(node.look)}
            listed.append({"name": node.surface, "primitives": [primitive]})
    document = {
        "asset": {"version": "2.0", "generator": f"gearwright {__version__}"},
        "scene": 0,
        "scenes": [
            {
                "name": scene.name,
                "nodes": [k for k, node in enumerate(scene.nodes) if not node.on],
                "extras": {"cases": list(scene.cases), "approximations": list(scene.approximations)},
            }
        ],
        "nodes": _nodes(scene, meshes),
        "meshes": listed,
        "materials": [_material(look) for look in looks],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": buffer.length}],
    }
    return _packed(document, buffer)


class _Buffer:
    """The binary chunk as it grows, with what stands where."""

    def __init__(self) -> None:
        self.known: dict[tuple[bytes, str, int], int] = {}
        self.parts: list[bytes] = []
        self.length = 0
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(self, values: NDArray[Any], kind: str, component: int, target: int, *, bounds: bool) -> int:
        """Add an array, where none is equal to the bit; return the number of its accessor."""
        data = values.tobytes()
        key = (data, kind, component)
        if key in self.known:
            return self.known[key]
        self.views.append({"buffer": 0, "byteOffset": self.length, "byteLength": len(data), "target": target})
        entry: dict[str, Any] = {"bufferView": len(self.views) - 1, "componentType": component, "type": kind,
                                 "count": len(values)}  # fmt: skip
        if bounds:
            entry |= {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        self.known[key] = len(self.accessors)
        self.accessors.append(entry)
        data += b"\0" * (-len(data) % 4)
        self.parts.append(data)
        self.length += len(data)
        return len(self.accessors) - 1


def _attributes(buffer: _Buffer, surface: Surface) -> dict[str, Any]:
    points, normals = (np.ascontiguousarray(rows, dtype="<f4") for rows in (surface.points, surface.normals))
    short = len(points) < 65535
    numbers = surface.triangles.astype("<u2" if short else "<u4").ravel()
    return {
        "attributes": {
            "POSITION": buffer.add(points, "VEC3", _FLOAT, _VERTICES, bounds=True),
            "NORMAL": buffer.add(normals, "VEC3", _FLOAT, _VERTICES, bounds=False),
        },
        "indices": buffer.add(numbers, "SCALAR", _SHORT if short else _LONG, _INDICES, bounds=False),
    }


def _material(look: str) -> dict[str, Any]:
    surface = {"baseColorFactor": [*COLOURS[look], 1.0], "metallicFactor": 0.4, "roughnessFactor": 0.45}
    if look != "housing":
        return {"name": look, "pbrMetallicRoughness": surface}
    surface["baseColorFactor"] = [*COLOURS[look], SEEN_THROUGH]
    return {"name": look, "pbrMetallicRoughness": surface, "alphaMode": "BLEND"}


def _nodes(scene: Scene, meshes: Mapping[tuple[str, str], int]) -> list[dict[str, Any]]:
    """Return all nodes, carriers with the numbers of what is on them."""
    carried: dict[str, list[int]] = {}
    for k, node in enumerate(scene.nodes):
        if node.on:
            carried.setdefault(node.on, []).append(k)
    turns: dict[bytes, list[float]] = {}
    found = [_node(scene, node, meshes, turns) for node in scene.nodes]
    for node, entry in zip(scene.nodes, found, strict=True):
        if node.name in carried:
            entry["children"] = carried[node.name]
    return found


def _node(
    scene: Scene, node: Node, meshes: Mapping[tuple[str, str], int], turns: dict[bytes, list[float]]
) -> dict[str, Any]:
    """Return a node with its place beside its carrier, which stands unturned; turns that are known are kept."""
    turned, place = node.axes.turned, node.axes.origin
    if node.phase:
        turned = turned @ _about(node.phase)
    if node.on:
        above = scene.by_name[node.on].axes
        turned, place = above.turned.T @ turned, above.turned.T @ (place - above.origin)
    extras = {"part": str(node.part), "kind": str(node.part.kind), "look": node.look,
              "spin_rad_s": dict(node.spins)}  # fmt: skip
    key = turned.tobytes()
    if key not in turns:
        turns[key] = [round(x, PLACES) for x in quaternion(turned)]
    found: dict[str, Any] = {"name": node.name, "translation": [round(x, PLACES) for x in place.tolist()],
                             "rotation": turns[key], "extras": extras}  # fmt: skip
    if node.surface:
        found["mesh"] = meshes[node.surface, node.look]
    return found


def _about(angle: float) -> Floats:
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])


def quaternion(turned: Floats) -> list[float]:
    """Return a rotation as a unit quaternion x, y, z, w [-].

    Args:
        turned: Its matrix, shape (3, 3).

    Source: the largest of the four squares first, so that no root of a small number divides.
    """
    m = turned
    squares = [1.0 + m[0, 0] - m[1, 1] - m[2, 2], 1.0 - m[0, 0] + m[1, 1] - m[2, 2],
               1.0 - m[0, 0] - m[1, 1] + m[2, 2], 1.0 + m[0, 0] + m[1, 1] + m[2, 2]]  # fmt: skip
    k = int(np.argmax(squares))
    rows = [
        [squares[0], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0], m[2, 1] - m[1, 2]],
        [m[0, 1] + m[1, 0], squares[1], m[1, 2] + m[2, 1], m[0, 2] - m[2, 0]],
        [m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], squares[2], m[1, 0] - m[0, 1]],
        [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], squares[3]],
    ]
    found = np.array(rows[k])
    return [float(x) for x in found / np.linalg.norm(found)]


def _packed(document: Mapping[str, Any], buffer: _Buffer) -> bytes:
    words = json.dumps(document, separators=(",", ":"), ensure_ascii=False, allow_nan=False).encode()
    words += b" " * (-len(words) % 4)
    length = 12 + 8 + len(words) + 8 + buffer.length
    head = struct.pack("<4sIIII", b"glTF", 2, length, len(words), 0x4E4F534A)
    return b"".join([head, words, struct.pack("<II", buffer.length, 0x004E4942), *buffer.parts])
