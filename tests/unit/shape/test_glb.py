"""A GLB file holds to glTF 2.0, and says what the scene says."""

import json
import math
import struct

import numpy as np
import pytest

import gearwright as gw
from gearwright.shape import glb, scene
from gearwright.shape.scene import quaternion
from gearwright.shipped import shipped_designs
from shipped_work import sized

NAMES = shipped_designs()
SIZES = {5123: 2, 5125: 4, 5126: 4}
TYPES = {5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC3": 3}


def read(data):
    """Return the document and the arrays of a GLB file; whatever is against the specification fails."""
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<II", data, 12)
    assert kind == 0x4E4F534A
    assert size % 4 == 0
    document = json.loads(data[20 : 20 + size])
    rest, kind = struct.unpack_from("<II", data, 20 + size)
    assert kind == 0x004E4942
    assert rest % 4 == 0
    binary = data[28 + size :]
    assert len(binary) == rest == document["buffers"][0]["byteLength"]
    arrays = []
    for accessor in document["accessors"]:
        view = document["bufferViews"][accessor["bufferView"]]
        width, part = WIDTHS[accessor["type"]], SIZES[accessor["componentType"]]
        assert view["byteOffset"] % part == 0
        assert view["byteLength"] == accessor["count"] * width * part
        assert view["byteOffset"] + view["byteLength"] <= rest
        values = np.frombuffer(binary, TYPES[accessor["componentType"]], accessor["count"] * width, view["byteOffset"])
        arrays.append(values.reshape(-1, width) if width > 1 else values)
        if "min" in accessor:
            assert accessor["min"] == arrays[-1].min(axis=0).tolist()
            assert accessor["max"] == arrays[-1].max(axis=0).tolist()
    return document, arrays


@pytest.mark.parametrize("name", NAMES)
def test_the_file_of_a_shipped_design_holds_to_the_specification(name):
    built = scene(sized(name), detail="coarse")
    document, arrays = read(glb(built))
    assert document["asset"]["version"] == "2.0"
    for mesh in document["meshes"]:
        (primitive,) = mesh["primitives"]
        points, normals = (arrays[primitive["attributes"][key]] for key in ("POSITION", "NORMAL"))
        numbers = arrays[primitive["indices"]]
        assert "min" in document["accessors"][primitive["attributes"]["POSITION"]]
        assert len(points) == len(normals)
        assert numbers.max() < len(points)
        assert len(numbers) % 3 == 0
        assert np.allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-3)
        assert primitive["material"] < len(document["materials"])
    seen = []
    for node in document["nodes"]:
        assert math.isclose(math.hypot(*node["rotation"]), 1.0, abs_tol=1e-9)
        assert set(node["extras"]["spin_rad_s"]) == set(built.cases)
        seen += node.get("children", [])
    assert len(seen) == len(set(seen))  # a tree
    assert not set(seen) & set(document["scenes"][0]["nodes"])
    assert sorted([*seen, *document["scenes"][0]["nodes"]]) == list(range(len(built.nodes)))


def test_places_and_turns_of_nodes_are_those_of_the_scene():
    built = scene(sized("twin-engine-helicopter"), detail="coarse")
    document, _ = read(glb(built))
    above = {child: node for node in document["nodes"] for child in node.get("children", [])}
    for k, (node, entry) in enumerate(zip(built.nodes, document["nodes"], strict=True)):
        turned, place = matrix(entry["rotation"]), np.array(entry["translation"])
        if k in above:
            frame = matrix(above[k]["rotation"])
            turned, place = frame @ turned, frame @ place + np.array(above[k]["translation"])
        assert place == pytest.approx(node.axes.origin, abs=1e-9)
        cosine, sine = math.cos(node.phase), math.sin(node.phase)
        about = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
        assert turned == pytest.approx(node.axes.turned @ about, abs=1e-9)


def test_in_line_h2_is_a_small_file_whose_vertices_are_shared():
    data = glb(scene(sized()))
    assert len(data) <= 1.5e6
    document, arrays = read(data)
    points = sum(len(arrays[mesh["primitives"][0]["attributes"]["POSITION"]]) for mesh in document["meshes"])
    corners = sum(len(arrays[mesh["primitives"][0]["indices"]]) for mesh in document["meshes"])
    assert corners > 2.5 * points


def test_arrays_that_are_equal_to_the_bit_are_written_once():
    document, arrays = read(glb(scene(sized("ec120b"), detail="coarse")))
    kinds = [(entry["componentType"], entry["type"]) for entry in document["accessors"]]
    assert len({(kind, values.tobytes()) for kind, values in zip(kinds, arrays, strict=True)}) == len(arrays)
    assert len(arrays) < 2.5 * len(document["meshes"])  # tubes share their normals and triangles
    assert "extensionsRequired" not in document


@pytest.mark.parametrize("seed", range(6))
def test_a_quaternion_turns_as_its_matrix(seed):
    turned, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    turned *= np.sign(np.linalg.det(turned))
    assert matrix(quaternion(turned)) == pytest.approx(turned, abs=1e-12)


@pytest.mark.parametrize("axis", range(3))
def test_half_a_turn_is_a_quaternion_too(axis):
    turned = -np.eye(3)
    turned[axis, axis] = 1.0
    assert matrix(quaternion(turned)) == pytest.approx(turned, abs=1e-12)


def matrix(values):
    x, y, z, w = values
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def test_a_scene_is_kept_in_a_file_and_read_back(tmp_path):
    built = gw.scene(sized("off-set"), detail="coarse")
    gw.save(built, tmp_path / "scene.json")
    again = gw.load(tmp_path / "scene.json")
    assert glb(again) == glb(built)
