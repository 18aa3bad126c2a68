"""Designs, loads and comparisons with which pieces of methods of rating are tested, each without a sizing."""

from dataclasses import replace

import pytest

from gearwright.identity import Kind, PartId
from gearwright.shipped import shipped_design
from gearwright.sizing.rating import Ask, rating_of
from gearwright.sizing.rating.agma import Agma2001, Agma2003
from gearwright.sizing.rating.iso6336 import Iso6336
from gearwright.sizing.rating.iso10300 import Iso10300
from gearwright.sizing.rating.lewis_hertz import LewisHertz
from gearwright.sizing.rating.protocol import Load, LoadedMesh
from gearwright.spec import edited, parse, read
from mounted_designs import HELICOPTER

METHODS = {
    "lewis-hertz": LewisHertz(),
    "iso6336": Iso6336(),
    "iso10300": Iso10300(),
    "agma2001": Agma2001(),
    "agma2003": Agma2003(),
}
OFF_SET = read(shipped_design("off-set"))
BEVEL = parse(HELICOPTER)
MESH, FIRST, SECOND = (PartId(Kind.MESH, name) for name in ("mesh", "one", "two"))


def rating(method: str, **rules: object):
    """Return the resolved rules of a stage that a method rates, without sizing its design."""
    bevel = method in ("iso10300", "agma2003")
    stage = "pairs.bevel.gears" if bevel else "gears"
    told = {f"{stage}.{key}": value for key, value in {"rating": method, **rules}.items()}
    return rating_of(edited(BEVEL if bevel else OFF_SET, told), "bevel" if bevel else "first")


def loaded(method: str, torque: float = 700.0, *, cases: int = 1, module: float = 4e-3, width: float = 40e-3, own=None):
    own = own or rating(method)
    ask = Ask(torque / 23, (23, 59), width / module, speed=500.0)
    loads = tuple(
        Load(f"case {k}", torque * (1.0 - 0.2 * k), ask._replace(per_tooth=torque * (1.0 - 0.2 * k) / 23), 3.6e6)
        for k in range(cases)
    )
    return LoadedMesh(own, module, width, loads[0], loads, (1e-3, 2e-3))


def near(value: float) -> object:
    return pytest.approx(value, rel=1e-9)


def told(method: str, **asked: float):
    """Return rules of a method with asked safeties that are not 1, K_A = 1.25 and a helix."""
    own = rating(method)
    table = "iso6336" if method == "iso10300" else method
    rules = own.rules.model_copy(update={table: getattr(own.rules, table).model_copy(update=asked)})
    return replace(own, rules=rules, service=own.service.model_copy(update={"application_factor": 1.25}))
