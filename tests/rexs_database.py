"""What REXS's own database says of a file: unknown components and attributes, wrong units, ranges, relations."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

FOLDER = Path(__file__).parent / "rexs"
EXAMPLES = FOLDER / "examples"


@cache
def database(version):
    return json.loads((FOLDER / f"database-{version}.json").read_text(encoding="utf-8"))


def faults(content: bytes, version: str) -> list[str]:
    """Return everything of a file that is not as the database has it."""
    root = ElementTree.fromstring(content)
    kinds = {component.get("id"): component.get("type") for component in root.iterfind("components/component")}
    found = [] if root.get("version") == version else [f"the file says version {root.get('version')}"]
    components = root.findall("components/component")
    numbers = [component.get("id") for component in components]
    if len(set(numbers)) < len(numbers):
        found.append("components have numbers in common")
    for component in (*components, *root.iterfind("load_spectrum/load_case/component")):
        found += _of_component(component, kinds[component.get("id")], version)
    for relation in root.iterfind("relations/relation"):
        ends = sorted((ref.get("role"), kinds[ref.get("id")]) for ref in relation)
        allowed = database(version)["relations"].get(relation.get("type"), ())
        if ends not in [sorted(map(tuple, combination)) for combination in allowed]:
            found.append(f"relation {relation.get('type')} of {ends} is not allowed")
    return found


def _of_component(component: ElementTree.Element, kind: str, version: str) -> Iterator[str]:
    known = database(version)
    if kind not in known["components"]:
        yield f"there is no component {kind}"
        return
    names = list(known["attributes"])
    allowed = {names[place] for place in known["components"][kind]}
    for attribute in component:
        name = attribute.get("id")
        if name.startswith("custom_"):
            continue
        if name not in allowed:
            yield f"{kind} has no {name}"
            continue
        unit, value_type, limits, words = known["attributes"][name]
        if attribute.get("unit") != unit:
            yield f"{kind}.{name} is in {attribute.get('unit')}, not in {unit}"
        yield from _of_value(f"{kind}.{name}", attribute, value_type, limits, words)


def _of_value(name: str, attribute: ElementTree.Element, kind: str, limits: dict, words: list) -> Iterator[str]:
    if (kind.endswith("_array")) != (attribute.find("array") is not None):
        yield f"{name} is no {kind}"
    texts = [cell.text or "" for cell in attribute.iter("c")] or [attribute.text or ""]
    for text in texts:
        if words and text not in words:
            yield f"{name} is {text}, none of {words}"
        if kind.startswith("boolean") and text not in ("true", "false"):
            yield f"{name} is {text}, no {kind}"
        if kind.startswith("integer"):
            int(text)
        if kind.startswith("floating_point"):
            yield from _of_number(name, float(text), limits)


def _of_number(name: str, number: float, limits: dict) -> Iterator[str]:
    if "rangeMin" in limits:
        least, is_open = float(limits["rangeMin"]), limits.get("rangeMinIntervalOpen") == "true"
        if number < least or (number == least and is_open):
            yield f"{name} is {number}, below {least}"
    if "rangeMax" in limits:
        most, is_open = float(limits["rangeMax"]), limits.get("rangeMaxIntervalOpen") == "true"
        if number > most or (number == most and is_open):
            yield f"{name} is {number}, above {most}"
