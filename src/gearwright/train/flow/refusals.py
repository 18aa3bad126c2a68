"""Why a load case has no torques, or more than one set of them, and what would do."""

from __future__ import annotations

from collections.abc import Sequence

from gearwright.errors import DesignError, Problem
from gearwright.spec import GROUND, Design
from gearwright.train.graph import Train


def ambiguous(design: Design, case: str, undecided: Sequence[str]) -> DesignError:
    """Return the error of a case in which equilibrium leaves open how machines divide what the others leave.

    Args:
        design: With its cases.
        case: Name of the case.
        undecided: The machines that balance and whose torque equilibrium does not decide.
    """
    names = " and ".join(undecided)
    write, many = f"[cases.{case}.{undecided[-1]}] power_kw = -100", "both" if len(undecided) == 2 else "all"
    missing = ""
    if case not in design.cases:
        missing = f"; {case!r}, every machine at its rating, is the case of a design without cases"
        drives = " and ".join(f"[cases.take-off.{name}] rating = 1" for name in (*design.turbines, *design.motors))
        write = f"{drives} with [cases.take-off.{undecided[-1]}] power_kw = -100"
    return DesignError([
        Problem(
            f"cases.{case}",
            f"{names} {many} balance one branch, and nothing says how they divide its power{missing}; give the"
            f" power or torque of all but one, such as {write} (negative takes power), or 0 for one that idles",
        )
    ])  # fmt: skip


def unbalanced(train: Train, balancing: Sequence[str], case: str) -> DesignError:
    """Return the error of a case in which no torques balance.

    Args:
        train: The graph.
        balancing: The machines that are free to balance.
        case: Name of the case.
    """
    takers = ", ".join(balancing) or "no machine"
    held = {mesh.stage for mesh in train.meshes if GROUND in mesh.nodes}
    loose = ", ".join(dict.fromkeys(mesh.stage for mesh in train.meshes if mesh.stage not in held))
    fix = (
        f"All three members of {loose} turn: ground one, or put a machine that balances on each"
        if loose
        else "Join the shafts, engage a clutch, or leave out the power of one more machine so that it balances"
    )
    return DesignError([
        Problem(
            f"cases.{case}",
            f"no torques balance: {takers} is free to balance, and the power of some machine has no path to it. {fix}",
        )
    ])  # fmt: skip
