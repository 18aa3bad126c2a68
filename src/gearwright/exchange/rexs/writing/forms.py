"""The forms of a REXS file beside XML: the same in JSON, and either in an archive."""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Callable, Mapping
from typing import Any, Literal
from xml.etree import ElementTree

from gearwright.exchange.rexs.words import OWN, words

Form = Literal["rexs", "rexsj", "rexsz"]
FORMS: tuple[Form, ...] = ("rexs", "rexsj", "rexsz")
"""Ends of the names of REXS files: XML, JSON, and XML in an archive."""
_MOMENT = (1980, 1, 1, 0, 0, 0)
"""What an archive says of when its file was changed: nothing, so that equal files make equal archives."""
_PLAIN: Mapping[str, Callable[[str], object]] = {
    "floating_point": float, "floating_point_array": float, "integer": int, "reference_component": int,
    "boolean": "true".__eq__, "boolean_array": "true".__eq__,
}  # fmt: skip
"""Type of an attribute -> its value of a text, or those of its cells; of all others the text itself."""


def formed(content: bytes, form: Form) -> bytes:
    """Return a REXS file in another form.

    Args:
        content: As XML.
        form: That is wanted.
    """
    if form == "rexsj":
        model = _model(ElementTree.fromstring(content))
        return json.dumps({"model": model}, ensure_ascii=False, indent=1).encode()
    if form == "rexsz":
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
            entry = zipfile.ZipInfo("model.rexs", _MOMENT)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
        return packed.getvalue()
    return content


def _model(root: ElementTree.Element) -> dict[str, Any]:
    spectrum = root.find("load_spectrum")
    cases = [] if spectrum is None else spectrum.findall("load_case")
    return {
        **root.attrib,
        "relations": [
            {"id": int(relation.attrib["id"]), "type": relation.attrib["type"],
             "refs": [{**ref.attrib, "id": int(ref.attrib["id"])} for ref in relation]}
            for relation in root.iterfind("relations/relation")
        ],
        "components": [_component(part) for part in root.iterfind("components/component")],
        "load_spectrum": {
            "id": 1,
            "load_cases": [{"id": int(case.attrib["id"]), "components": [_component(part) for part in case]}
                           for case in cases],
        },
    }  # fmt: skip


def _component(part: ElementTree.Element) -> dict[str, Any]:
    return {**part.attrib, "id": int(part.attrib["id"]), "attributes": [_attribute(said) for said in part]}


def _attribute(said: ElementTree.Element) -> dict[str, Any]:
    name = said.attrib["id"]
    kind = "string" if name in OWN else words()[name].kind
    read, array = _PLAIN.get(kind, str), said.find("array")
    value = read(said.text or "") if array is None else [read(cell.text or "") for cell in array]
    return {"id": name, "unit": said.attrib["unit"], kind: value}
