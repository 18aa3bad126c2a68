"""A housing as reduced matrices: files, units, what is wrong with them, and the same answers as the whole body."""

import json

import numpy as np
import pytest
from scipy.io import mmwrite
from scipy.linalg import eigh

from gearwright.dynamics import Model, modes
from gearwright.dynamics.model import Bearing, Disc, Rotor, Segment, add_bearing, add_body, add_rotor
from gearwright.dynamics.model.rotors import element
from gearwright.errors import DesignError
from gearwright.spec.bodies import ReducedBody, read_body

COUNT = 12
SEATS = {3: "left", 9: "right"}


def beam():
    """Return M and K of a wide beam, clamped at both ends, in y and its slope, as a housing of many coordinates."""
    mass, stiffness = (np.zeros((2 * COUNT + 2,) * 2) for _ in range(2))
    part = element(Segment(1.2 / COUNT, 0.12))
    for number in range(COUNT):
        here = slice(2 * number, 2 * number + 4)
        mass[here, here] += part.mass
        stiffness[here, here] += part.stiffness
    free = np.arange(2, 2 * COUNT)
    return mass[np.ix_(free, free)], stiffness[np.ix_(free, free)]


def craig_bampton(count):
    """Return matrices reduced to y of both seats and some modes with the seats held."""
    mass, stiffness = beam()
    seats = np.array([2 * station - 2 for station in SEATS])
    inner = np.setdiff1d(np.arange(len(mass)), seats)
    static = -np.linalg.solve(stiffness[np.ix_(inner, inner)], stiffness[np.ix_(inner, seats)])
    shapes = eigh(stiffness[np.ix_(inner, inner)], mass[np.ix_(inner, inner)])[1][:, :count]
    basis = np.zeros((len(mass), 2 + count))
    basis[seats, [0, 1]] = 1.0
    basis[inner, :2], basis[inner, 2:] = static, shapes
    points = [f"{seat} y" for seat in SEATS.values()] + [f"mode {number}" for number in range(1, count + 1)]
    return basis.T @ mass @ basis, basis.T @ stiffness @ basis, points


def mounted(body):
    """Return the frequencies of a rotor whose bearings sit on a housing in y, and on the ground in x."""
    model = Model()
    shaft = add_rotor(model, "shaft", Rotor([Segment(0.15, 0.05)] * 4, {2: Disc(8.0, 0.02, 0.04)}))
    housing = add_body(model, "housing", body)
    for station, seat in ((0, "left"), (4, "right")):
        add_bearing(model, f"bearing {seat}", shaft.at(station), Bearing((1e8, 1e8)), housing=housing.at(seat))
    return modes(model.build()).frequency


def whole():
    mass, stiffness = beam()
    names = [
        f"{SEATS.get(1 + place // 2, place // 2)} {'y' if place % 2 == 0 else 'slope'}" for place in range(len(mass))
    ]
    return ReducedBody(mass, stiffness, tuple(names))


def saved(folder, form, count=6, scale=(1.0, 1.0), units=("m", "kg")):
    mass, stiffness, points = craig_bampton(count)
    given = {"points": points, "length_unit": units[0], "mass_unit": units[1]}
    matrices = {"mass": mass * scale[0], "stiffness": stiffness * scale[1]}
    if form == "npz":
        np.savez(folder / "body.npz", **matrices, **given)
        return folder / "body.npz"
    for key, matrix in matrices.items():
        if form == "mtx":
            mmwrite(folder / f"{key}.mtx", matrix, precision=17)
        else:
            np.savetxt(folder / f"{key}.{form}", matrix, delimiter="," if form == "csv" else " ")
    rows = [f'{key} = "{key}.{form}"' for key in matrices]
    rows += [f"{key} = {json.dumps(value)}" for key, value in given.items()]
    (folder / "body.toml").write_text("\n".join(rows), encoding="utf-8")
    return folder / "body.toml"


def test_a_reduction_that_keeps_all_modes_is_the_whole_body():
    mass, stiffness, points = craig_bampton(2 * COUNT - 4)
    np.testing.assert_allclose(
        mounted(ReducedBody(mass, stiffness, tuple(points))), mounted(whole()), rtol=1e-6, atol=1e-3
    )


def test_few_modes_are_enough_below_half_of_the_first_that_is_left_out():
    """Craig & Bampton: frequencies come from above and near the whole body's where its modes are kept."""
    part, exact = (
        mounted(body)[:14] for body in (ReducedBody(*craig_bampton(6)[:2], tuple(craig_bampton(6)[2])), whole())
    )
    low = (exact > 0.0) & (exact < 1200.0)
    assert np.sum(low) >= 4
    assert np.all(part[low] >= exact[low] * (1.0 - 1e-9))
    np.testing.assert_allclose(part[low], exact[low], rtol=1e-3)


@pytest.mark.parametrize("form", ["npz", "csv", "txt", "mtx"])
def test_every_form_of_file_gives_the_same_body(tmp_path, form):
    body = read_body(saved(tmp_path, form))
    mass, stiffness, points = craig_bampton(6)
    np.testing.assert_allclose(body.mass, mass, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(body.stiffness, stiffness, rtol=1e-12, atol=1e-3)
    assert body.points == tuple(points)


def test_tonnes_and_millimetres_give_the_same_frequencies(tmp_path):
    """A seat's t and N/mm are 1e3 kg and 1e3 N/m; a mode's own coordinate may have any scale."""
    body = read_body(saved(tmp_path, "npz", scale=(1e-3, 1e-3), units=("mm", "t")))
    plain = read_body(saved(tmp_path, "csv"))
    np.testing.assert_allclose(body.mass[:2, :2], plain.mass[:2, :2], rtol=1e-12)
    np.testing.assert_allclose(mounted(body), mounted(plain), rtol=1e-7, atol=1e-4)


def broken(folder, change):
    mass, stiffness, points = craig_bampton(2)
    given = {"mass": mass, "stiffness": stiffness, "points": points, "length_unit": "m", "mass_unit": "kg"}
    change(given)
    np.savez(folder / "body.npz", **given)
    return folder / "body.npz"


def _twist(given):
    given["mass"] = given["mass"].copy()
    given["mass"][0, 1] += 1.0


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda given: given.pop("mass_unit"), "mass_unit: missing"),
        (lambda given: given.update(length_unit="inch"), "'inch' given; name the unit"),
        (lambda given: given.update(points=["left y"]), "1 names for 4 coordinates of mass"),
        (lambda given: given.update(points=["left y", "left y", "a", "b"]), "stands there twice"),
        (lambda given: given.update(points=["a", "b", "c", "d"]), r"none is a place \(one word\) and a direction"),
        (lambda given: given.update(mass=given["mass"][:3]), "a square matrix is needed"),
        (lambda given: given.update(mass=-given["mass"]), "a mass is positive in every motion"),
        (lambda given: given.update(stiffness=-given["stiffness"]), "a stiffness is nowhere negative"),
        (lambda given: given.update(stiffness=given["stiffness"] * np.nan), "must be a finite number"),
        (lambda given: given.update(colour=1.0), "there is no such key"),
        (_twist, "it is not symmetric: entries 0, 1 and 1, 0"),
    ],
)
def test_matrices_that_are_no_body_are_refused(tmp_path, change, message):
    with pytest.raises(DesignError, match=message):
        read_body(broken(tmp_path, change))


def test_files_that_are_no_matrices_are_refused(tmp_path):
    (tmp_path / "body.npz").write_bytes(b"no archive")
    with pytest.raises(DesignError, match=r"no \.npz of plain arrays"):
        read_body(tmp_path / "body.npz")
    path = saved(tmp_path, "csv")
    (tmp_path / "mass.csv").write_text("1,2\n3,four\n", encoding="utf-8")
    with pytest.raises(DesignError, match=r"mass\.csv is no matrix of numbers"):
        read_body(path)
    path.write_text('mass = "../mass.csv"', encoding="utf-8")
    with pytest.raises(DesignError, match="in the folder of this file"):
        read_body(path)
    with pytest.raises(DesignError, match="there is no such file"):
        read_body(tmp_path / "none.npz")
