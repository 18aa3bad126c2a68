"""What a sizing says: masses, efficiencies, speeds that deviate, results by name; and that its numbers are numbers.

How they are shown is for `render`.
"""

from gearwright.sizing.answers.breakdown import (
    AskedSpeed,
    MassPart,
    asked_speeds,
    bearing_forces,
    mass_groups,
    mass_parts,
)
from gearwright.sizing.answers.gate import refuse_no_numbers
from gearwright.sizing.answers.governing import governing_case, telling_cases
from gearwright.sizing.answers.named import TEXT, Named, asked_results, named_results, pick, total_results
from gearwright.sizing.answers.passing import Passing, locking_checks, passing
from gearwright.sizing.answers.remarks import remarks

__all__ = [
    "TEXT",
    "AskedSpeed",
    "MassPart",
    "Named",
    "Passing",
    "asked_results",
    "asked_speeds",
    "bearing_forces",
    "governing_case",
    "locking_checks",
    "mass_groups",
    "mass_parts",
    "named_results",
    "passing",
    "pick",
    "refuse_no_numbers",
    "remarks",
    "telling_cases",
    "total_results",
]
