"""Workbooks read without the library that wrote them: as the XML that they are."""

import io
import zipfile
from xml.etree import ElementTree

SHEET = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"


def book(content):
    """Return sheet -> its cells by place, of a workbook read without the library that wrote it."""
    files = zipfile.ZipFile(io.BytesIO(content))
    texts = ["".join(node.itertext()) for node in ElementTree.fromstring(files.read("xl/sharedStrings.xml"))]
    names = [sheet.get("name") for sheet in ElementTree.fromstring(files.read("xl/workbook.xml")).iter(f"{SHEET}sheet")]
    sheets = {}
    for place, name in enumerate(names, start=1):
        cells = ElementTree.fromstring(files.read(f"xl/worksheets/sheet{place}.xml")).iter(f"{SHEET}c")
        assert all(cell.find(f"{SHEET}f") is None for cell in cells if cell.get("t") in ("s", "str"))
        cells = ElementTree.fromstring(files.read(f"xl/worksheets/sheet{place}.xml")).iter(f"{SHEET}c")
        sheets[name] = {cell.get("r"): _value(cell, texts) for cell in cells}
    return sheets


def _value(cell, texts):
    found = cell.find(f"{SHEET}v")
    if found is None:
        return None
    return texts[int(found.text)] if cell.get("t") == "s" else float(found.text)
