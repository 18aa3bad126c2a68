"""What the workbench answers: the numbers of the public verbs, problems at their lines, the newest question first."""

import asyncio
import json
import re
import struct

import numpy as np
import pytest

import gearwright as gw
from gearwright.particulars import particulars
from gearwright.render.answers.design import size_answer
from gearwright.render.answers.schema import plain

pytestmark = pytest.mark.extra("starlette", "httpx", "tomlkit", "uvicorn")


def text_of(name):
    return gw.shipped_design(name).read_text(encoding="utf-8")


@pytest.mark.parametrize("name", gw.shipped_designs())
def test_every_shipped_design_has_the_numbers_of_the_command_line(asked, name):
    text = text_of(name)
    told = asked.post("/api/size", text=text)
    assert told.status_code == 200, told.text
    expected = plain(size_answer(particulars(gw.size(gw.read(name)))))
    assert told.json()["result"] == json.loads(json.dumps(expected))
    groups = asked.post("/api/form", text=text).json()
    keys = {(*group["path"], field["key"]) for group in groups for field in group["written"]}
    assert ("level",) in keys or ("shafts",) in keys
    drawn = asked.post("/api/flow", text=text)
    assert drawn.status_code == 200 and drawn.text.startswith("<svg")


def test_the_model_is_the_scene_with_what_is_said_of_it(asked):
    answer = asked.post("/api/model", text=text_of("in-line-h2"))
    (length,) = struct.unpack_from("<I", answer.content)
    facts = json.loads(answer.content[4 : 4 + length])
    sizing = gw.size(gw.read("in-line-h2"))
    assert facts["parts"]["first.sun"]["teeth"] == sizing.teeth["first.sun"]
    assert answer.content[4 + length : 8 + length] == b"glTF"


def test_what_is_wrong_is_told_with_its_line(asked):
    text = text_of("in-line-h2").replace("speed_rpm = 20000", "sped_rpm = 20000")
    problems = asked.post("/api/size", text=text).json()["problems"]
    line = text.split("\n").index("sped_rpm = 20000") + 1
    assert line in [problem["line"] for problem in problems]


@pytest.mark.parametrize(
    "text", ["", "[[[", "a = 1", "\x00", "[turbines]", "name = 3", "﻿", "a.b.c.d = []", "[planetaries.first]"]
)
def test_broken_texts_are_refused_with_reasons(asked, text):
    for verb in ("size", "flow", "model", "schematic"):
        answer = asked.post(f"/api/{verb}", text=text)
        assert answer.status_code == 422 and answer.json()["problems"], (verb, answer.text)


NO_SENSE = [
    ("flow", {"case": "nope"}),
    ("flow", {"case": 3}),
    ("flow", {"case": ["rated"]}),
    ("edit", {"path": []}),
    ("edit", {"path": ["a", 3]}),
    ("edit", {"path": "a"}),
    ("edit", {"path": ["a"] * 9, "value": 1}),
    ("edit", {"path": ["name", "x"], "value": 1}),
]


@pytest.mark.parametrize(("verb", "options"), NO_SENSE)
def test_a_question_that_makes_no_sense_is_refused(asked, verb, options):
    assert asked.post(f"/api/{verb}", text=text_of("in-line-h2"), **options).status_code == 422


def test_an_entry_is_changed_and_comments_stay(asked):
    text = text_of("in-line-h2")
    changed = asked.post("/api/edit", text=text, path=["turbines", "gas-turbine", "speed_rpm"], value=21000).json()[
        "text"
    ]
    assert changed == text.replace("speed_rpm = 20000", "speed_rpm = 21000")
    level = asked.post("/api/edit", text=text, path=["level"], value="preliminary").json()["text"]
    assert 'level = "preliminary"' in level and "# a first sizing, its shafts of one diameter" in level
    added = asked.post("/api/edit", text=text, path=["planetaries", "first", "module_mm"], value=2.0).json()["text"]
    assert gw.parse(added).planetaries["first"].module == pytest.approx(2e-3)
    gone = asked.post("/api/edit", text=added, path=["planetaries", "first", "module_mm"], value=None).json()["text"]
    assert gw.parse(gone) == gw.parse(text)


def test_a_text_of_very_many_dotted_keys_is_changed_by_hand(asked):
    """What keeps comments takes time with the square of their number: 20 s for 500 keys of eight names."""
    text = text_of("in-line-h2") + "".join("a." * 7 + f"b{k} = 1\n" for k in range(500))
    told = asked.post("/api/edit", text=text, path=["turbines", "gas-turbine", "speed_rpm"], value=21000)
    assert told.status_code == 422 and "3500 names in dotted keys" in told.json()["problems"][0]["message"]
    few = text_of("in-line-h2").replace("[turbines.gas-turbine]", "[turbines]\ngas-turbine.name-of-none.x = 1", 1)
    told = asked.post("/api/edit", text=few, path=["name"], value="other")
    assert told.status_code == 200 and "gas-turbine.name-of-none.x = 1" in told.json()["text"]


def test_a_quantity_is_written_in_another_unit_and_stays_what_it_is(asked):
    text = text_of("in-line-h2")
    path = ["turbines", "gas-turbine", "power_kw"]
    changed = asked.post("/api/edit", text=text, path=path, key="power_hp").json()["text"]
    assert "power_hp = 1402.7" in changed and "power_kw = 1046\nspeed" not in changed
    power = gw.parse(changed).turbines["gas-turbine"].power
    assert power == pytest.approx(1046e3, rel=1e-11)  # written with twelve digits


def test_of_questions_that_wait_the_newest_is_answered(asked):
    texts = [text_of("ec120b").replace("6125", str(6100 + k)) for k in range(6)]

    async def asking():
        async with asked.client() as client:
            sent = [asyncio.create_task(client.post("/api/size", json={"text": text, "page": "one"})) for text in texts]
            other = asyncio.create_task(client.post("/api/size", json={"text": texts[0], "page": "two"}))
            return [(await task).status_code for task in [*sent, other]]

    *mine, other = asked.runner.run(asking())
    assert mine[-1] == 200 and other == 200
    assert 409 in mine and set(mine) <= {200, 409, 422}


def test_a_file_is_the_file_of_the_command(asked):
    from gearwright.formats import AS_USUAL, FORMATS

    sizing = gw.size(gw.read("single-planetary"))
    for name in ("glb", "rexs", "csv"):
        answer = asked.job("export", text=text_of("single-planetary"), format=name)[1]
        files = (answer.content, FORMATS[name](sizing, AS_USUAL)[0])
        assert len({re.sub(rb'date="[^"]*"', b"", file) for file in files}) == 1, name  # REXS says when it was written


def test_solids_carry_the_contact_temperature_of_gears_that_a_standard_rates(asked):
    answer = asked.post("/api/model", text=text_of("in-line-h2-star"))
    (length,) = struct.unpack_from("<I", answer.content)
    parts = json.loads(answer.content[4 : 4 + length])["parts"]
    meshes = [mesh for mesh in gw.size(gw.read("in-line-h2-star")).meshes if "first.planet" in mesh.gears]
    hottest = max(float(mesh.rating.flash.contact) for mesh in meshes)  # of sun and ring
    assert parts["first.planet"]["temperature"] == pytest.approx(hottest, rel=1e-12)
    assert "temperature" not in parts["first.carrier"]


def test_the_server_is_ended_when_it_is_asked(asked):
    assert asked.post("/api/quit").status_code == 200 and asked.ended


@pytest.mark.parametrize("seed", range(6))
def test_random_changes_of_the_form_have_the_numbers_or_the_problems_of_the_command_line(asked, seed):
    random = np.random.default_rng(seed)
    text = gw.shipped_design(str(random.choice(["single-planetary", "in-line-h2", "off-set"]))).read_text("utf-8")
    for _ in range(6):
        groups = asked.post("/api/form", text=text).json()
        fields = [(group, field) for group in groups for field in (*group["written"], *group["possible"][:2])
                  if field["kind"] in ("number", "integer") and field["key"] != "schema"]  # fmt: skip
        group, field = fields[random.integers(len(fields))]
        value = (field["value"] or 1.0) * random.choice([0.0, 0.5, 0.97, 1.03, 2.0, -1.0])
        value = round(value) if field["kind"] == "integer" else float(value)
        changed = asked.post("/api/edit", text=text, path=[*group["path"], field["key"]], value=value)
        if changed.status_code != 200:
            continue
        text = changed.json()["text"]
        answer = asked.post("/api/size", text=text)
        try:
            expected = plain(size_answer(particulars(gw.size(gw.parse(text)))))
        except gw.DesignError as error:
            told = [problem["message"] for problem in answer.json()["problems"]]
            assert answer.status_code == 422 and told == [problem.message for problem in error.problems]
        else:
            assert answer.json()["result"] == json.loads(json.dumps(expected))
