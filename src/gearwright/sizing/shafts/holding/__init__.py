"""What holds, closes and tightens along shafts that are sized, and what it cuts into them; no shaft is sized here.

Retention at ends, then what each holder is, covers with seals, both rings of every bearing, threads, grooves and lips.
"""

from gearwright.sizing.shafts.holding.grooves import Groove, cut_steps, groove_checks, grooves
from gearwright.sizing.shafts.holding.held import Held, held_rings, holders_of, holding_checks
from gearwright.sizing.shafts.holding.holders import Holder
from gearwright.sizing.shafts.holding.retention import ENDS, Retention, ends, retention_checks, retentions
from gearwright.sizing.shafts.holding.seals import Sealed, case_hardened, seal_checks, sealed_exits, unsealed_exits
from gearwright.sizing.shafts.holding.threads import Thread, threads

__all__ = [
    "ENDS",
    "Groove",
    "Held",
    "Holder",
    "Retention",
    "Sealed",
    "Thread",
    "case_hardened",
    "cut_steps",
    "ends",
    "groove_checks",
    "grooves",
    "held_rings",
    "holders_of",
    "holding_checks",
    "retention_checks",
    "retentions",
    "seal_checks",
    "sealed_exits",
    "threads",
    "unsealed_exits",
]
