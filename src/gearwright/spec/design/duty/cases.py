"""Load cases: what each machine does, how long, and what is engaged."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from pydantic import ConfigDict, Field

from gearwright.spec.record import Record
from gearwright.units import Power, Ratio, Speed, Time, Torque


class Drive(Record):
    """What one machine does in a case."""

    power: Power | None = Field(
        None,
        ge=-1e9,
        le=1e9,
        description="Power into the train; negative takes power out; of a propeller, rotor or load more than 0 asks for"
        " drives = true; left out, and no other: it balances the rest",
    )
    torque: Torque | None = Field(
        None,
        description="Torque into the train, instead of power; negative takes power out; it may stand still; of a"
        " propeller, rotor or load more than 0 asks for drives = true",
    )
    rating: Ratio | None = Field(
        None, ge=-1, le=1, description="Part of its rated power, instead of power; -1 takes all of it"
    )
    balances: bool = Field(
        False, description="Its torque follows from equilibrium, also where it takes a power of its own otherwise"
    )
    drives: bool = Field(
        False,
        description="Of a propeller, rotor or load, which take power: in this case it gives what is said, driven by the"
        " air or by what it moves",
    )
    speed: Speed | None = Field(None, ge=0.1, le=2e4, description="Speed, where it is not the rated one")

    @property
    def stated(self) -> bool:
        """True where it says what the machine gives or takes."""
        return self.power is not None or self.torque is not None or self.rating is not None

    @property
    def idles(self) -> bool:
        """True where the machine neither gives nor takes anything."""
        return self.power == 0.0 or self.torque == 0.0 or self.rating == 0.0


IDLES, BALANCES = Drive(power=0.0), Drive(balances=True)


class Spectrum(Record):
    """A load spectrum, said once for all cases that name it: levels of their loads, and how long each lasts."""

    load: list[Ratio] = Field(min_length=1, description="Levels: parts of the loads of the case that names it, 0 to 1")
    share: list[Ratio] = Field(min_length=1, description="Share of the time of that case for each level, with sum 1")


class Case(Record):
    """A load case: besides its own keys one table for each machine that does something else than usual."""

    model_config: ClassVar[ConfigDict] = ConfigDict(extra="allow")
    others: ClassVar[type[Record] | None] = Drive
    __pydantic_extra__: dict[str, Drive] = Field(init=False)

    duration: Time | None = Field(
        None, gt=0, description="How long it lasts in one flight or other cycle of use; all of them make up the life"
    )
    share: Ratio | None = Field(
        None, ge=0, le=1, description="Share of the life that it lasts, instead of durations; their sum is 1"
    )
    static: bool = Field(
        False, description="A limit load: it is judged against static strength and yield, and counts no cycles"
    )
    spectrum: str | None = Field(
        None,
        description="Name of a load spectrum, [spectra.NAME]; what the case says is its level 1;"
        " left out: that of [service], else this level all the time",
    )
    engaged: list[str] | None = Field(
        None,
        description="Clutches and brakes that hold, the others are open; left out: as their kind says;"
        " overrunning ones act by themselves",
    )

    @property
    def machines(self) -> Mapping[str, Drive]:
        """Machine -> what it does; one left out does what it does usually."""
        return self.__pydantic_extra__ or {}
