"""Remarks of checks are shown where the checks are."""

from gearwright.checks import Check
from gearwright.identity import Kind, PartId
from gearwright.render.tables.checks import review_tables


def test_what_would_help_a_check_that_fails_is_shown_beside_the_list():
    part = PartId(Kind.BEARING, "input-front")
    fast = Check(part, "speed factor", "n d_m in mm/min", 2e6, 1.5e6, "number", at_most=True, why="a smaller bore")
    slow = Check(part, "static safety", "ISO 76:2006", 3.0, 1.5)
    waived = Check(part, "life", "ISO 281:2007", 1.0, 2.0, "life", why="a larger one", waiver="as tested")
    remarks = next(table for table in review_tables([fast, slow, waived]) if table.title == "Remarks")
    assert [tuple(cell.text for cell in row) for row in remarks.rows] == [
        ("input-front", "speed factor", "a smaller bore")
    ]
