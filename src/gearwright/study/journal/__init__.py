"""Journals of studies: files that lose no finished case, what they hold, and what is saved of a damaged one.

What is computed and when it is written is for `running`.
"""

from gearwright.study.journal.file import dumped, summed
from gearwright.study.journal.journal import (
    Journal,
    Recorded,
    Status,
    begin,
    in_memory,
    opened,
    recorded,
    rows_of,
    status,
    verify,
)
from gearwright.study.journal.made_with import changes_of, made_with

__all__ = [
    "Journal",
    "Recorded",
    "Status",
    "begin",
    "changes_of",
    "dumped",
    "in_memory",
    "made_with",
    "opened",
    "recorded",
    "rows_of",
    "status",
    "summed",
    "verify",
]
