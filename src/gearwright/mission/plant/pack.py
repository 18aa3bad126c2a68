"""The battery of a flight: a plain one, or cells that polarise, warm and age."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.machines import Battery, BatteryStep, battery_step, stored_energy
from gearwright.machines.power import Cells, CellState, Network, cell_step, held_energy, straight, warmed
from gearwright.spec import BatteryRules, CellRules
from gearwright.units import CELSIUS

YEAR = 365.25 * 86400.0
"""[s]"""
_REFERENCE = 298.15
"""Temperature at which lives are stated [K]."""


class PackState(NamedTuple):
    """What a battery remembers from interval to interval."""

    charge: float
    """State of charge [-]."""
    polarisation: float = 0.0
    """Of the slow pair [V]."""
    temperature: float | None = None
    """Of the cells [K]; None for a plain battery."""
    throughput: float = 0.0
    """Charge that went in or out [C]."""
    worn: float = 0.0
    """Part of its life that is spent [-]."""


class Pack(NamedTuple):
    """The battery of one gearbox."""

    battery: Battery
    """Its resistance holds the bus, too."""
    cells: Cells | None
    rules: CellRules | None
    mass: float
    """[kg]"""

    def start(self, charge: float) -> PackState:
        """Return the state with which a flight begins.

        Args:
            charge: State of charge [-].
        """
        return PackState(charge, temperature=self.rules.start_temperature_k if self.rules else None)

    def energy(self, state: PackState) -> float:
        """Return what the battery holds [J].

        Args:
            state: Of it.
        """
        if self.cells is None:
            return stored_energy(self.battery, state.charge)
        return held_energy(self.battery, self.cells, CellState(state.charge, state.polarisation))

    def drawn(self, state: PackState, power: float, duration: float, air: float) -> tuple[BatteryStep, PackState]:
        """Return a battery over an interval, and its state at the end.

        Args:
            state: At the start.
            power: At the bus; negative charges [W].
            duration: [s].
            air: Temperature of the air [K].

        Raises:
            DesignError: The cells become too warm or too cold.
        """
        if self.cells is None or self.rules is None:
            step = battery_step(self.battery, state.charge, power, duration)
            return step, state._replace(charge=step.state_of_charge)
        warm = state.temperature or _REFERENCE
        _within(self.rules, warm)
        held = CellState(state.charge, state.polarisation)
        step, after = cell_step(self.battery, self.cells, held, power=power, duration=duration, temperature=warm)
        lost = step.loss * (1.0 - self._bus_part())
        end, mean = self._warmed(warm, lost, air, duration)
        passed = abs(step.current) * duration
        worn = state.worn + self._worn(passed, duration, mean)
        return step, PackState(after.charge, after.polarisation, end, state.throughput + passed, worn)

    def _bus_part(self) -> float:
        bus = self.rules.bus_resistance_ohm if self.rules else 0.0
        return bus / self.battery.resistance if bus else 0.0

    def _warmed(self, warm: float, lost: float, air: float, duration: float) -> tuple[float, float]:
        """Return the temperature at the end of an interval, and its mean [K]."""
        assert self.rules is not None  # called for cells alone
        capacity = self.mass * self.rules.heat_capacity_j_kg_k
        network = Network(np.array([capacity]), np.zeros((1, 1)), np.array([[self.rules.cooling_w_k]]))
        around = np.array([self.rules.coolant_temperature_k or air])
        after = warmed(network, np.array([warm]), np.array([lost]), surroundings=around, duration=duration)
        return float(after.temperature[0]), float(after.mean[0])

    def _worn(self, passed: float, duration: float, temperature: float) -> float:
        """Return the part of its life that an interval takes [-].

        Source: Miner's sum of throughput over cycle life, two capacities a cycle, and of time over calendar life; both
            double with every `doubling_k` above 25 °C.
        """
        assert self.rules is not None  # called for cells alone
        rules = self.rules
        faster = math.exp2((temperature - _REFERENCE) / rules.doubling_k)
        cycles = passed / (2.0 * self.battery.charge) / rules.cycle_life if rules.cycle_life else 0.0
        years = duration / YEAR / rules.calendar_years if rules.calendar_years else 0.0
        return faster * (cycles + years)


def _within(rules: CellRules, temperature: float) -> None:
    limits = ((rules.highest_temperature_k, "highest"), (rules.lowest_temperature_k, "lowest"))
    for limit, name in limits:
        if (temperature - limit) * (1.0 if name == "highest" else -1.0) > 1e-9:
            fix = "cool it more, draw less" if name == "highest" else "let it start warmer, cool it less"
            found = f"the cells are at {temperature - CELSIUS:.1f} °C, the {name} is {limit - CELSIUS:.1f} °C"
            raise DesignError([Problem(f"battery.cells.{name}_temperature_k", f"{found}; {fix}, or change the limit")])


def pack_of(rules: BatteryRules) -> Pack:
    """Return the battery that a mission says.

    Args:
        rules: Of the mission.
    """
    mean = 0.5 * (rules.full_voltage_v + rules.empty_voltage_v)
    bus = rules.cells.bus_resistance_ohm if rules.cells else 0.0
    battery = Battery(
        rules.energy / mean,
        rules.full_voltage_v,
        rules.empty_voltage_v,
        rules.resistance_ohm + bus,
        rules.highest_c_rate,
        rules.minimum_charge,
    )
    if rules.cells is None:
        return Pack(battery, None, None, 0.0)
    return _celled(rules, battery, rules.cells)


def _celled(rules: BatteryRules, battery: Battery, cells: CellRules) -> Pack:
    slow, time, activation = cells.slow_resistance_ohm, cells.slow_time, cells.activation_k
    curve = straight(battery, slow_resistance=slow, time=time, activation=activation)
    if cells.ocv_charge and cells.ocv_v:
        pieces = list(zip(cells.ocv_charge, cells.ocv_v, strict=True))
        held = sum((b - a) * 0.5 * (u + v) for (a, u), (b, v) in pairwise(pieces))
        battery = battery._replace(charge=rules.energy / held, full_voltage=pieces[-1][1], empty_voltage=pieces[0][1])
        curve = curve._replace(charges=tuple(cells.ocv_charge), voltages=tuple(cells.ocv_v))
    mass = rules.energy / (cells.specific_energy_wh_kg * 3600.0)
    return Pack(battery, curve, cells, mass)
