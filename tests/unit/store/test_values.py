"""A value of any verb that is saved is loaded equal, kind for kind; what is none, or is damaged, is refused."""

import json
import re
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings, strategies as st
from hypothesis.extra import numpy as arrays

import gearwright as gw
from designs import PAIR
from gearwright.checks import Check
from gearwright.dynamics import Modes
from gearwright.dynamics.sharing import sharing_problem, sharing_study
from gearwright.dynamics.vibration import campbell
from gearwright.errors import DesignError
from gearwright.former_names import _moved, _renamed
from gearwright.identity import Kind, PartId, Role
from gearwright.mission import bearing_lives, durability, fly, gear_damage, phase_summaries
from gearwright.parts.iso6336 import StressBin
from gearwright.reviews import review
from gearwright.shipped import shipped_mission
from gearwright.sizing.bearing_arrangement import BearingPair
from gearwright.spec import parse_study, read_mission
from gearwright.store import KIND, VERSION, decoded, encoded
from gearwright.study.running import run
from gearwright.units import Origin
from same import same


def kept(value, folder):
    """Return a value after a file has held it."""
    path = folder / "value.json"
    gw.save(value, path)
    return gw.load(path)


NUMBERS = st.one_of(st.integers(), st.floats(), st.booleans(), st.complex_numbers(), st.none(), st.text())
DTYPES = st.one_of(
    arrays.floating_dtypes(sizes=(16, 32, 64)), arrays.integer_dtypes(), arrays.unsigned_integer_dtypes(),
    arrays.boolean_dtypes(), arrays.complex_number_dtypes(sizes=(64, 128)),
)  # fmt: skip
ARRAYS = DTYPES.flatmap(lambda dtype: arrays.arrays(dtype, arrays.array_shapes(min_dims=0, min_side=0, max_side=3)))
ENUMS = st.sampled_from([*Kind, *Role])
KEYS = st.one_of(st.text(), ENUMS, st.integers(), st.tuples(st.text(), st.integers()))


def _nested(inner):
    return st.one_of(
        st.lists(inner, max_size=3),
        st.lists(inner, max_size=3).map(tuple),
        st.dictionaries(KEYS, inner, max_size=3),
        st.dictionaries(st.text(), inner, max_size=3).map(MappingProxyType),
        st.builds(Origin, inner, inner),
        st.builds(PartId, ENUMS, st.text(), inner, st.text(), inner),
        st.builds(StressBin, inner, inner),
    )


@given(st.recursive(st.one_of(NUMBERS, ENUMS, ARRAYS), _nested, max_leaves=8))
@settings(suppress_health_check=[HealthCheck.too_slow])
def test_records_of_anything_come_back_as_they_were(value):
    text = json.dumps(encoded(value, "value"), allow_nan=False)
    assert same(decoded(json.loads(text)), value)


def test_equality_notices_a_kind_a_sign_and_a_type_of_number():
    assert not same((1.0,), [1.0])
    assert not same(0.0, -0.0)
    assert not same(np.float32([1.0]), np.float64([1.0]))
    assert not same(Kind.GEAR, "gear")


DESIGNS = ("in-line-h2", "off-set-h2", "differential-hybrid")


@pytest.mark.parametrize("name", DESIGNS)
def test_every_value_of_a_design_comes_back_equal(name, tmp_path):
    design = gw.read(gw.shipped_design(name))
    sizing = gw.size(design)
    system = gw.assemble(sizing)
    values = {
        "design": design,
        "sizing": sizing,
        "system": system,
        "modes": gw.modes(system),
        "campbell": campbell(system, np.linspace(0.5, 1.0, 3)),
        "trace": gw.simulate(system, 1e-5),
    }
    for what, value in values.items():
        assert same(kept(value, tmp_path), value), what
    assert kept(design, tmp_path) == design
    assert kept(sizing, tmp_path) == sizing


def test_a_flight_and_what_it_does_come_back_equal(tmp_path):
    mission = read_mission(shipped_mission("thesis"))
    flight = fly(gw.size(gw.read(gw.shipped_design("in-line-h2"))), mission)
    lives = (durability(flight), gear_damage(flight), bearing_lives(flight), phase_summaries(flight))
    for value in (mission, flight, *lives):
        assert same(kept(value, tmp_path), value)


def test_a_study_of_sharing_comes_back_equal(tmp_path):
    study = sharing_study(sharing_problem(gw.size(gw.read(gw.shipped_design("in-line-h2"))), "first"))
    assert same(kept(study, tmp_path), study)


def test_the_table_of_a_study_comes_back_equal(tmp_path):
    study = parse_study('schema = 1\nname = "s"\ndesigns = ["in-line-h2", "off-set-h2"]\nresults = ["gear_mass"]\n')
    table = run(study, {name: gw.read(gw.shipped_design(name)) for name in study.designs})
    assert same(kept(table, tmp_path), table)
    assert same(kept(study, tmp_path), study)


def test_a_review_comes_back_equal_though_it_stands_above_the_store(tmp_path):
    verdict = review(gw.read(gw.shipped_design("in-line")))
    assert kept(verdict, tmp_path) == verdict


def test_several_values_stand_in_one_file(tmp_path):
    sizing = gw.size(gw.parse(PAIR))
    both = {"design": sizing.design, "checks": list(sizing.checks)}
    assert kept(both, tmp_path) == both
    assert isinstance(kept(both, tmp_path)["checks"][0], Check)


def test_a_file_is_text_that_says_what_it_is(tmp_path):
    gw.save(gw.parse(PAIR), tmp_path / "design.json")
    text = json.loads((tmp_path / "design.json").read_text(encoding="utf-8"))
    assert (text["format"], text["version"], text["gearwright"]) == (KIND, VERSION, gw.__version__)
    assert text["value"]["$record"] == "spec.design.design:Design"


@pytest.mark.parametrize(
    ("value", "says"),
    [
        (3, "this is of type int; give what a verb returned"),
        (print, "this is of type builtin_function_or_method"),
        ((), "an empty tuple"),
        (gw.Model(), "this is of type Model"),
        ([gw.parse(PAIR), "word"], "this is of type list"),
        (Origin("x", object()), r"Origin\.source is of type object, which no file keeps"),
        (Origin("x", {"a": [print]}), r"Origin\.source\['a'\]\[0\] is of type builtin_function_or_method"),
        (Origin("x", np.array([object()])), r"Origin\.source is an array of object"),
    ],
)
def test_what_is_no_value_is_not_saved(value, says, tmp_path):
    with pytest.raises(DesignError, match=says):
        gw.save(value, tmp_path / "value.json")
    assert not list(tmp_path.iterdir())


@pytest.fixture(scope="module")
def text(tmp_path_factory):
    """The file of a sizing."""
    path = tmp_path_factory.mktemp("store") / "sizing.json"
    gw.save(gw.size(gw.parse(PAIR)), path)
    return path.read_text(encoding="utf-8")


def problem_of(content, folder):
    """Return what loading a file with this text says."""
    (folder / "value.json").write_text(content, encoding="utf-8")
    with pytest.raises(DesignError) as caught:
        gw.load(folder / "value.json")
    assert caught.value.source == str(folder / "value.json")
    return caught.value.problems[0].message


@pytest.mark.parametrize("share", [0.0, 0.1, 0.5, 0.99])
def test_a_file_that_ends_early_is_refused(text, share, tmp_path):
    assert "is damaged" in problem_of(text[: int(share * len(text))], tmp_path)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('"version": 1', '"version": 2', "this version reads form 1: update gearwright"),
        ('"version": 1', '"version": 0', "this version reads form 1: save the value again"),
        ('"version": 1', '"version": "one"', "save the value again"),
        ('"format": "gearwright value"', '"format": "weather"', "gw.save did not write this file"),
        ("sizing.result:Sizing", "sizing.result:Gone", "this version has no sizing.result:Gone"),
        ("sizing.result:Sizing", "no.such:Sizing", "this version has no no.such:Sizing"),
        ("sizing.result:Sizing", "os:system", "this version has no os:system"),
        ("sizing.result:Sizing", "units:math.inf", "units:math.inf is no record"),
        ("sizing.result:Sizing", "spec.record:BaseModel", "spec.record:BaseModel is no record"),
        ("sizing.result:Sizing", "identity:Kind", "identity:Kind is no record"),
        ("sizing.result:Sizing", "__main__:x", "is no name of a record"),
        ("sizing.result:Sizing", "..os:system", "is no name of a record"),
        ('"$record"', '"$call"', "'\\$call' is not known"),
        ('"teeth": ', '"tooth": ', "unexpected keyword argument 'tooth'"),
        ('{"$record": "spec.design.design:Design"', '{"$record": "spec.design.stages:Pair"', "spec.design.stages:Pair"),
    ],
)  # fmt: skip
def test_a_file_of_another_version_or_hand_is_refused(text, old, new, says, tmp_path):
    assert old in text
    assert re.search(says, problem_of(text.replace(old, new), tmp_path))


@pytest.mark.parametrize("content", ["", "{}", "[]", "3", '{"format": "gearwright value"}', "[" * 100_000, "\x00"])
def test_what_gearwright_did_not_write_is_refused(content, tmp_path):
    problem_of(content, tmp_path)


@pytest.mark.parametrize(
    "tree",
    [
        {"$array": "<f8", "shape": [2], "values": [1.0]},
        {"$array": "<f8", "shape": [-1], "values": [1.0]},
        {"$array": "|O", "shape": [1], "values": [1.0]},
        {"$array": "<f8", "shape": [1], "values": ["word"]},
        {"$array": "<i1", "shape": [1], "values": [1000]},
        {"$enum": "identity:Kind", "value": "teapot"},
        {"$pairs": [[1]]},
        {"$float": "1e5"},
        {"$scalar": "<f8", "shape": [1], "values": [1.0]},
    ],
)
def test_a_tree_that_no_value_makes_is_refused(tree, tmp_path):
    head = {"format": KIND, "version": VERSION, "gearwright": "0"}
    assert "incomplete or damaged" in problem_of(json.dumps({**head, "value": tree}), tmp_path)


def test_an_interrupted_write_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "design.json"
    gw.save(gw.parse(PAIR), path)
    before = path.read_bytes()

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("gearwright.files.os.fsync", interrupted)
    with pytest.raises(KeyboardInterrupt):
        gw.save(gw.size(gw.parse(PAIR)), path)
    assert path.read_bytes() == before
    assert [file.name for file in tmp_path.iterdir()] == ["design.json"]


def test_modes_are_loaded_as_what_they_are(tmp_path):
    assert isinstance(kept(gw.modes(gw.assemble(gw.size(gw.parse(PAIR)))), tmp_path), Modes)


def test_a_file_that_names_former_modules_is_loaded():
    """A sizing that was saved when each record stood in a module of its own."""
    saved = Path(__file__).parent / "data" / "sizing_by_former_modules.json"
    assert "sizing.arranged:" in saved.read_text(encoding="utf-8")
    assert gw.load(saved).design == gw.parse(PAIR)


def test_every_former_module_has_its_place():
    for module, now in _moved().items():
        assert find_spec(f"gearwright.{now}"), module


def test_every_former_name_of_a_record_has_its_record():
    for former, now in _renamed().items():
        module, _, name = former.partition(":")
        assert isinstance(vars(import_module(f"gearwright.{module}"))[now], type), former
        assert name not in vars(import_module(f"gearwright.{module}")), former


def test_a_record_by_its_former_name_is_loaded():
    """As it was saved when another record of its layer had the same name."""
    value = BearingPair(("6204", "6205"), ("6206", "6207"), "first")
    saved = json.dumps(encoded(value)).replace(":BearingPair", ":Option")
    assert "sizing.bearing_arrangement:Option" in saved
    assert decoded(json.loads(saved)) == value
