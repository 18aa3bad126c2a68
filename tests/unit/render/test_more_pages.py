"""Pages of validation, drawings and windows: alone, the same each time, with the numbers of their commands."""

import re

from gearwright.particulars import particulars
from gearwright.render.drawings.catalogue import sheets
from gearwright.render.drawings.writers import sheet_svg
from gearwright.render.pages.report import DrawnSheet, sheets_page
from gearwright.render.pages.validation import by_source, validation_page
from gearwright.validate import Case, published
from html_checks import stands_alone
from shipped_work import sized


def test_a_validation_page_says_first_whether_all_numbers_come_out():
    sources = list(by_source(published("ISO 281:2007")))
    page = validation_page(sources)
    stands_alone(page)
    assert '<div class="verdict good">' in page and page == validation_page(sources)
    shown = re.findall(r'data-v="(\d+)"', page)
    count = sum(map(len, sources))
    assert shown[:2] == [str(count), str(count)]
    wrong = Case("two", "a book", "-", (3.0,), lambda: (2.0,), 1e-6, "none")
    missed = validation_page(list(by_source([wrong])))
    assert '<div class="verdict bad">' in missed and "0 of 1" in missed and "missed" in missed


def test_a_page_of_drawings_has_every_sheet_once_and_its_ids_apart():
    sizing = sized("in-line-h2")
    drawn = [
        DrawnSheet(sheet.name, sheet.title, sheet.size.name, "1:1", sheet_svg(sheet, f"{sheet.name}-"))
        for sheet in sheets(sizing, ["shaft"])
    ]
    page = sheets_page(particulars(sizing), drawn)
    stands_alone(page)
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert len(ids) == len(set(ids)) and page.count("<figure") == len(drawn)
    assert set(re.findall(r"url\(#([^)]+)\)", page)) <= set(ids)
