"""REXS files as JSON and in archives: out, in, and everything that can be wrong with one."""

import base64
import io
import json
import struct
import zipfile

import pytest

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.exchange.rexs import LARGEST
from gearwright.exchange.rexs.files import opened
from shipped_work import sized


def plain(text):
    """Return a text as a number where it is one: 0 and 0.0 are the same."""
    try:
        return float(text)
    except ValueError:
        return " ".join(text.split())


def what_stands(document):
    """Return everything of a document but its lines."""

    def said(component):
        attributes = {key: (plain(one.text), tuple(map(plain, one.cells)), one.unit)
                      for key, one in component.attributes.items()}  # fmt: skip
        return component.kind, component.name, attributes

    parts = {number: said(component) for number, component in document.components.items()}
    cases = [{number: said(component) for number, component in case.items()} for case in document.cases]
    return document.version, parts, [(one.kind, one.ends) for one in document.relations], cases


def written(content, folder, name="gearbox.rexsj"):
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def refused(content, folder, name="gearbox.rexsj"):
    with pytest.raises(DesignError) as caught:
        gw.from_rexs(written(content, folder, name))
    return str(caught.value)


def archive(*entries):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as file:
        for name, content in entries:
            file.writestr(name, content)
    return packed.getvalue()


@pytest.mark.parametrize("design", ["e-axle", "ravigneaux-automatic"])
def test_every_form_says_the_same_and_gives_the_design_again(design, tmp_path):
    files = {form: written(gw.to_rexs(sized(design), form=form).content, tmp_path, f"box.{form}")
             for form in ("rexs", "rexsj", "rexsz")}  # fmt: skip
    told = [what_stands(opened(path)) for path in files.values()]
    assert told[0] == told[1] == told[2]
    assert {gw.from_rexs(path).design == gw.read(design) for path in files.values()} == {True}


def test_an_archive_may_hold_more_than_its_model(tmp_path):
    """As macOS packs it: a resource fork beside the model, and neutral data of tools."""
    model = gw.to_rexs(sized("star"), form="rexsj").content
    packed = archive(("box/gearbox.rexsj", model), ("__MACOSX/._gearbox.rexsj", b"\0"), ("flank.gde", b""))
    assert gw.from_rexs(written(packed, tmp_path, "gearbox.rexs.zip")).design == gw.read("star")


@pytest.mark.parametrize("code", ["float64", "float32"])
def test_coded_arrays_are_read_in_both_forms(code, tmp_path):
    """Vectors as FVA-Workbench codes them: base64 of numbers with the least byte first."""
    packed = base64.b64encode(struct.pack({"float64": "<3d", "float32": "<3f"}[code], 0.5, -2.0, 8.0)).decode()
    coded = {"id": "support_vector", "unit": "mm", "floating_point_array_coded": {"code": code, "value": packed}}
    part = {"id": 1, "type": "shaft", "attributes": [coded]}
    said = {"version": "1.7", "relations": [], "components": [part]}
    read = opened(written(json.dumps({"model": said}), tmp_path))
    assert read.components[1].attributes["support_vector"].cells == ("0.5", "-2.0", "8.0")
    array = f'<attribute id="support_vector" unit="mm"><array code="{code}">{packed}</array></attribute>'
    component = f'<component id="1" type="shaft">{array}</component>'
    text = f'<model version="1.7"><components>{component}</components></model>'
    read = opened(written(text, tmp_path, "gearbox.rexs"))
    assert read.components[1].attributes["support_vector"].cells == ("0.5", "-2.0", "8.0")


def test_problems_of_json_have_the_line_of_their_object(tmp_path):
    text = gw.to_rexs(sized("e-axle"), form="rexsj").content.decode()
    text = text.replace("custom_gearwright_design", "custom_other_design")
    lines = text.splitlines()
    place = next(k for k, line in enumerate(lines) if '"face_width"' in line)
    lines[place + 1] = lines[place + 1].replace("mm", "kg")
    assert f"line {place}: components.cylindrical_gear" in refused("\n".join(lines), tmp_path)


MODEL = '{"model": {"version": "1.7", "relations": [], "components": %s}}'


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ('{"model": {"version": "1.7"', "no whole JSON file"),
        ("[1, 2]", "give an object"),
        ('{"gearbox": {}}', "no REXS file"),
        ('{"model": {"version": "9.9", "relations": [], "components": []}}', "REXS 1.0 to 1.7 is read"),
        ('{"model": [' + "[" * 100_000, "too deep in each other"),
        (MODEL % '{"id": 1}', "components: is"),
        (MODEL % '[{"id": "x", "type": "shaft"}]', "give a whole number"),
        (MODEL % '[{"id": 1, "type": "shaft"}, {"id": 1, "type": "shaft"}]', "the id 1 stands at line 1, too"),
        (MODEL % "[" + "{}," * 300_001, "more than 300,000 objects"),
        (MODEL % '[{"id": 1, "type": "a", "attributes": [{"id": "b", "c": {"code": "float64", "value": "?"}}]}]',
         "no base64 of float64"),
        (MODEL % '[{"id": 1, "type": "a", "attributes": [{"id": "b", "c": {"code": "text", "value": ""}}]}]',
         "allowed: int32, float32, float64"),
        (MODEL % ("[" + "9" * 5000 + "]"), "no number"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_json_is_told(content, words, tmp_path):
    assert words in refused(content, tmp_path)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (archive(("readme.txt", b"")), "must hold one .rexs or .rexsj; it holds none"),
        (archive(("a.rexs", b""), ("b.rexsj", b"")), "it holds a.rexs, b.rexsj"),
        (archive(("a.rexs", b"<model/>"))[:40], "cannot be unpacked"),
        (archive(("a.rexs", b" " * (LARGEST + 1))), "more than 10,000,000 bytes"),
        (archive(("../../a.rexs", b"<svg/>")), "no REXS file"),
        (archive(("a.rexs", b"\xff\xfe")), "UTF-8"),
    ],
    ids=["empty", "two", "truncated", "bomb", "upwards", "bytes"],
)
def test_what_is_wrong_with_an_archive_is_told_and_nothing_is_unpacked_beside_it(content, words, tmp_path):
    assert words in refused(content, tmp_path, "gearbox.rexsz")
    assert [path.name for path in tmp_path.iterdir()] == ["gearbox.rexsz"]


def test_a_form_that_is_none_is_refused():
    with pytest.raises(DesignError, match="rexsx"):
        gw.to_rexs(sized("star"), form="rexsx")
