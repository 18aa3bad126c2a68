"""Electric motors, short-circuited windings, batteries and thermal networks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple, TypeVar

import numpy as np

from gearwright.base import FOOT, POUND, POUND_FORCE, RPM, Floats
from gearwright.elementwise import Values

# ----------------------------------------------------------------------------------------------------------------------
# An electric motor: mass from torque and speed, inverter, cooling, largest power; rotor inertia; losses.
# ----------------------------------------------------------------------------------------------------------------------


PUBLIC_LAW = (0.02992, 0.8326, 0.2339)
"""a, b, c of m = a T^b n^c, T [N m], n [rpm], m [kg]: fitted to the rows of the catalogue's electric machines that are
rated for any time, made for aircraft, and weighed without inverter."""
PUBLIC_BAND = 1.34
"""Factor of one standard deviation of the law [-]."""
DENSEST = 25e3
"""Power over mass that no public machine rated for any time passes [W/kg]; the densest states 24.9 kW/kg."""
INVERTER_DENSITY = 12e3
"""Power over mass of an inverter [W/kg]: between 7.5 of a certified small one and 19 of NASA's goal."""
EFFICIENCY = 0.95
"""Of motor with inverter at its rating [-], as in missions; 0.954 is stated of one of 200 kW."""
COOLING_DENSITY = 0.8e-3
"""Mass of coolers, pumps and coolant over the heat [kg/W]; an estimate between 0.21 kg/kW, computed for fuel cells of
an airliner, and 1.5 kg/kW."""
TIP_SPEED = 220.0
"""Surface speed that a rotor of magnets in a carbon sleeve bears [m/s]; 150 without the sleeve."""
AIR_GAP_SHEAR = 40e3
"""Shear stress in the air gap of a liquid-cooled machine for any time [Pa]."""
SLENDEST = 1.5
"""Length over diameter of a rotor [-]."""
POWER_LAW_COEFFICIENT = 1.854
"""k of m = k T^0.33 [kg/(N m)^0.33]: the motor is 30 % of gearbox and motor at 4500 rpm, as Pulvirenti 2023 says."""
POWER_LAW_EXPONENT = 0.33
ROTOR_SHARE = 0.4
"""Part of the motor's mass that turns; an assumption for the inertia estimate only."""
MEAN_DENSITY = 4500.0
"""Mean density of motor and housing [kg/m³]; an assumption for sizes and inertia only."""
LENGTH_RATIO = {"radial": 1.5, "axial": 0.4}
"""Length over diameter: a radial-flux machine is slender, an axial-flux machine squat (Pulvirenti 2023, §2.2)."""
LOSS_SHARES = (0.5, 0.3, 0.1, 0.1)
"""Assumed parts of copper, iron, windage and constant losses at the rated point [-]."""


def motor_mass(torque: float, speed: float) -> float:
    """Return the mass of an electric motor or generator without inverter and cooling [kg].

    Args:
        torque: Rated for any time [N m].
        speed: At that torque [rad/s].

    Source: m = a T^b n^c, fitted to public machines for aircraft (catalogue/data/electric_machines.csv), 68 % within a
        factor of 1.34; not below the mass of 25 kW/kg.
    Valid for: 10 to 1500 N m, 1300 to 11 200 rpm, 6 to 460 kW; beyond by extrapolation.

    >>> round(motor_mass(2132.7, 4500 * RPM)), round(motor_mass(479.9, 20000 * RPM))
    (127, 52)
    """
    coefficient, by_torque, by_speed = PUBLIC_LAW
    law = coefficient * math.pow(torque, by_torque) * math.pow(speed / RPM, by_speed)
    return max(law, torque * speed / DENSEST)


def inverter_mass(power: float, density: float = INVERTER_DENSITY) -> float:
    """Return the mass of the inverter of a motor [kg].

    Args:
        power: Rated, at the motor's shaft [W].
        density: Power over mass [W/kg].

    Source: power density; 7.5 to 19 kW/kg are public.

    >>> round(inverter_mass(1005e3), 1)
    83.8
    """
    return power / density


def cooling_mass(power: float, density: float = COOLING_DENSITY) -> float:
    """Return the mass of what cools a motor and its inverter [kg].

    Args:
        power: Rated, at the motor's shaft [W].
        density: Mass over the heat [kg/W].

    Source: heat P (1/η - 1) with η = 0.95 of motor and inverter; an estimate.

    >>> round(cooling_mass(1005e3), 1)
    42.3
    """
    return density * power * (1.0 / EFFICIENCY - 1.0)


def largest_power(speed: float, tip_speed: float = TIP_SPEED) -> float:
    """Return the largest power of an electric machine whose rotor's surface bears a speed [W].

    Args:
        speed: Of the rotor [rad/s].
        tip_speed: Of its surface [m/s].

    Source: P = T Ω, T = 2 σ V of a rotor of volume V = π/4 D² L, D = 2 v/Ω and L = λ D: P = 4 π σ λ v³/Ω².
    Valid for: 40 kPa, λ = 1.5: rpm √kW ≤ 8.6e5 at 220 m/s.

    >>> round(largest_power(20000 * RPM) / 1e3)
    1830
    """
    return 4.0 * math.pi * AIR_GAP_SHEAR * SLENDEST * tip_speed**3 / speed**2


def motor_mass_ndarc(torque: float) -> float:
    """Return the mass of a motor by NDARC's law [kg]: of its torque alone, whatever its speed.

    Args:
        torque: Rated torque [N m].

    Source: m[lb] = 0.3928 Q[lb ft]^0.8587; Johnson, NDARC (NASA/TP-2015-218751), electric motor weight. On the
        public machines of `motor_mass` 26 % too light, × 1.38; 9 % up to 3000 rpm, 33 % above 6000 rpm.

    >>> round(motor_mass_ndarc(2132.7), 1)
    99.1
    """
    return 0.3928 * math.pow(torque / (POUND_FORCE * FOOT), 0.8587) * POUND


def motor_mass_power_law(torque: float) -> float:
    """Return the mass of a motor by a power law of its torque [kg]; about a quarter of NDARC's.

    Args:
        torque: Rated torque [N m].

    Source: m = k T^0.33; Pulvirenti 2023, appendix. Its exponent is doubtful (NDARC 0.8587), its k is not printed.

    >>> round(motor_mass_power_law(2132.7), 1)
    23.3
    """
    return POWER_LAW_COEFFICIENT * math.pow(torque, POWER_LAW_EXPONENT)


def motor_diameter(mass: float, length_ratio: float) -> float:
    """Return the outer diameter of a motor taken as a cylinder of mean density [m].

    Args:
        mass: [kg].
        length_ratio: Length over diameter [-].

    Source: cylinder of 4500 kg/m³; an estimate.
    """
    return math.cbrt(4.0 * mass / (math.pi * length_ratio * MEAN_DENSITY))


def rotor_inertia(mass: float, diameter: float) -> float:
    """Return the polar inertia of a motor's rotor [kg m²].

    Args:
        mass: Of the whole motor [kg].
        diameter: Outer diameter of the motor [m].

    Source: disc of 40 % of the mass and 60 % of the diameter; an estimate.
    """
    return ROTOR_SHARE * mass * (0.6 * diameter) ** 2 / 8.0


class MotorLosses(NamedTuple):
    """Coefficients of P_loss = k_c T² + k_i ω + k_w ω³ + C."""

    copper: float
    """k_c [W/(N m)²]."""
    iron: float
    """k_i [W s/rad]."""
    windage: float
    """k_w [W s³/rad³]."""
    constant: float
    """C: electronics, while it runs [W]."""
    peak_torque: float
    """Torque limit [N m]."""
    peak_power: float
    """Power limit at the shaft [W]."""
    eddy: float = 0.0
    """k_e of k_e ω² [W s²/rad²]."""
    stray: float = 0.0
    """k_s of k_s |T| ω: switching and stray load, inverter [-]."""


def rated_losses(power: float, speed: float, *, efficiency: float, overload: float = 1.0) -> MotorLosses:
    """Return the coefficients of a motor that has an efficiency at its rated point.

    Args:
        power: Rated shaft power [W].
        speed: Rated speed [rad/s].
        efficiency: At the rated point, with its inverter [-].
        overload: Limits over ratings, of torque and power [-].

    Source: form of Larminie and Lowry, Electric Vehicle Technology Explained (2012), eq. 7.23; the split of the
        losses at the rated point is an assumption.
    """
    lost = power * (1.0 / efficiency - 1.0)
    torque = power / speed
    copper, iron, windage, constant = (share * lost for share in LOSS_SHARES)
    return MotorLosses(
        copper / torque**2, iron / speed, windage / speed**3, constant, overload * torque, overload * power
    )


def shared_losses(power: float, speed: float, *, lost: float, shares: Sequence[float], overload: float) -> MotorLosses:
    """Return the coefficients of a motor whose loss at the rated point is divided by stated parts.

    Args:
        power: Rated shaft power [W].
        speed: Rated speed [rad/s].
        lost: There, with its inverter [W].
        shares: Of copper, hysteresis, eddy currents, windage, stray load and switching, constant; their sum is 1 [-].
        overload: Limits over ratings, of torque and power [-].

    Source: P = k_c T² + k_i ω + k_e ω² + k_w ω³ + k_s |T| ω + C. With parts of 0.29, 0.11, 0.16, 0, 0.44 and 0 it has
        the efficiencies of a published map of 1800 N m and 6000 rpm (NASA Aviary) within 0.0065 above a tenth of the
        torque and a sixth of the speed.
    """
    torque = power / speed
    copper, iron, eddy, windage, stray, constant = (share * lost for share in shares)
    limits = overload * torque, overload * power
    coefficients = copper / torque**2, iron / speed, windage / speed**3, constant
    return MotorLosses(*coefficients, *limits, eddy / speed**2, stray / power)


def motor_loss(motor: MotorLosses, torque: Values, speed: Values) -> Values:
    """Return the power that a motor or generator turns into heat [W].

    Args:
        motor: Its coefficients.
        torque: At the shaft, of either sign [N m].
        speed: [rad/s].

    Source: Larminie and Lowry (2012), eq. 7.23, with eddy currents and stray load where they are
        given. A motor without torque is switched off and only its iron and windage
        are dragged along.
    """
    turning = abs(speed)
    dragged = motor.iron * turning + motor.eddy * turning**2 + motor.windage * turning**3
    switched_on = motor.constant * (torque != 0.0)
    return dragged + motor.copper * torque * torque + motor.stray * abs(torque) * turning + switched_on


# ----------------------------------------------------------------------------------------------------------------------
# A permanent-magnet motor whose three phases are short-circuited while it turns.
# ----------------------------------------------------------------------------------------------------------------------


class Winding(NamedTuple):
    """One phase of a permanent-magnet motor without saliency."""

    back_emf: float
    """E, open-circuit voltage at the rated speed, rms [V]."""
    inductance: float
    """L, synchronous [H]."""
    resistance: float
    """R [Ω]."""
    pole_pairs: int
    """p"""
    rated_speed: float
    """At which E is given [rad/s]."""

    @property
    def linkage(self) -> float:
        """ψ = √2 E/(p Ω_r), amplitude of the flux linkage of the magnets [V s]."""
        return math.sqrt(2.0) * self.back_emf / (self.pole_pairs * self.rated_speed)


def short_circuit_torque(winding: Winding, speed: float, *, before: float, time: Floats) -> Floats:
    """Return the torque of a motor after all its phases are short-circuited at constant speed [N m].

    Args:
        winding: Its phase.
        speed: Of its rotor [rad/s].
        before: Torque until then, by a current in phase with E [N m].
        time: Since then [s], shape (n,).

    Returns:
        Positive where it drives, shape (n,).

    Source: voltage equations in coordinates of the rotor (Park 1929), L di/dt = −(R + j ω L) i − j ω ψ, i = i_d + j i_q
        and T = 3/2 p ψ i_q, solved in closed form for constant ω = p Ω.
        Without resistance and load its peak is 3 E²/(Ω X), X = p Ω L, which is also the greatest torque of a motor that
        slips a pole on a voltage E.
    Valid for: no saliency (L_d = L_q), no saturation, no damper winding.

    >>> winding = Winding(back_emf=100.0, inductance=1e-3, resistance=0.0, pole_pairs=4, rated_speed=250.0)
    >>> quarter = np.array([0.5 * math.pi / (4 * 250.0)])
    >>> round(-float(short_circuit_torque(winding, 250.0, before=0.0, time=quarter)[0]), 3)  # 3 E²/(Ω X)
    120.0
    """
    linkage = winding.linkage
    if linkage == 0.0 or speed == 0.0:
        return np.zeros(len(time))
    electric = winding.pole_pairs * speed
    per_current = 1.5 * winding.pole_pairs * linkage
    settled = -1j * electric * linkage / complex(winding.resistance, electric * winding.inductance)
    decay = complex(winding.resistance / winding.inductance, electric)
    current = settled + (1j * before / per_current - settled) * np.exp(-decay * time)
    return np.asarray(per_current * current.imag)


# ----------------------------------------------------------------------------------------------------------------------
# A battery as an open-circuit voltage that falls with its charge, behind a resistance.
# ----------------------------------------------------------------------------------------------------------------------


T = TypeVar("T", float, Any)

EMPTY, OVERLOADED, FULL = "empty", "overloaded", "full"
"""What stops a battery."""


class Battery(NamedTuple):
    """A battery pack."""

    charge: float
    """Capacity Q [C]."""
    full_voltage: float
    """Open-circuit voltage at full charge [V]."""
    empty_voltage: float
    """Open-circuit voltage at no charge [V]."""
    resistance: float
    """R [Ω]."""
    highest_rate: float
    """Highest current over the capacity, charging or discharging: C-rate [1/h]."""
    minimum: float
    """State of charge below which it must not go [-]."""


class BatteryStep(NamedTuple):
    """A battery over one interval of constant power."""

    state_of_charge: float
    """At the end of the interval [-]."""
    current: float
    """Positive discharges [A]."""
    open_power: float
    """Power of its chemistry, V_oc I [W]; its integral is the change of the stored energy."""
    loss: float
    """R I² [W]."""
    terminal_voltage: float
    """V [V]."""
    fault: str
    """Empty, or ``empty``, ``overloaded``, ``full``: then the interval cannot be flown."""


def stored_energy(battery: Battery, state_of_charge: float) -> float:
    """Return the energy that a battery holds [J].

    Args:
        battery: The battery.
        state_of_charge: s [-].

    Source: Q ∫ V_oc ds with V_oc linear in s.
    """
    rise = battery.full_voltage - battery.empty_voltage
    return battery.charge * (battery.empty_voltage * state_of_charge + 0.5 * rise * state_of_charge**2)


def highest_current(battery: Battery) -> float:
    """Return the largest current that its C-rate allows, charging or discharging [A].

    Args:
        battery: The battery.

    Source: definition of the C-rate: current over capacity, per hour.
    """
    return battery.highest_rate * battery.charge / 3600.0


def current_of(battery: Battery, state_of_charge: T, power: T, duration: float) -> tuple[T, T]:
    """Return the current of constant power at a battery's terminals [A], and V² - 4 R P, negative where there is none.

    Args:
        battery: The battery.
        state_of_charge: At the start [-]; a number or an array.
        power: At the terminals; negative charges [W]; a number or an array.
        duration: [s].

    Source: (V_oc - R I) I = P with V_oc at s - I Δt/(2 Q): a quadratic in I.
    """
    rise = battery.full_voltage - battery.empty_voltage
    voltage = battery.empty_voltage + rise * state_of_charge
    effective = battery.resistance + 0.5 * rise * duration / battery.charge
    square = voltage * voltage - 4.0 * effective * power
    return 2.0 * power / (voltage + np.sqrt(np.maximum(square, 0.0))), square  # holds without any resistance, too


def battery_step(battery: Battery, state_of_charge: float, power: float, duration: float) -> BatteryStep:
    """Return a battery after an interval of constant power at its terminals.

    The current is that of the middle of the interval, where the open-circuit voltage is its mean: what the chemistry
    gives is then exactly the change of the stored energy.

    Args:
        battery: The battery.
        state_of_charge: At the start [-].
        power: At the terminals; negative charges [W].
        duration: [s].

    Source: `current_of`.
    """
    rise = battery.full_voltage - battery.empty_voltage
    current, square = map(float, current_of(battery, state_of_charge, power, duration))
    final = state_of_charge - current * duration / battery.charge
    middle = battery.empty_voltage + rise * 0.5 * (state_of_charge + final)
    fault = ""
    if square < 0.0 or abs(current) > highest_current(battery) * (1.0 + 1e-9):
        fault = OVERLOADED
    elif final < battery.minimum:
        fault = EMPTY
    elif final > 1.0 + 1e-12:
        fault = FULL
    terminal = middle - battery.resistance * current
    return BatteryStep(final, current, middle * current, battery.resistance * current * current, terminal, fault)


# ----------------------------------------------------------------------------------------------------------------------
# A battery as an equivalent circuit: a curve of open-circuit voltage, a resistance, a pair of R and C, warmth.
# ----------------------------------------------------------------------------------------------------------------------


REFERENCE = 298.15
"""Temperature at which resistances are stated [K]."""
_MOST_ROUNDS = 60
_SETTLED = 1e-15
"""Change of a current that has settled, over the largest one [-]."""


class Cells(NamedTuple):
    """What a battery is beyond a straight line behind a resistance."""

    charges: tuple[float, ...]
    """States of charge of the curve, rising from 0 to 1 [-]."""
    voltages: tuple[float, ...]
    """Open-circuit voltages there [V]."""
    slow_resistance: float
    """R_1 of the pair [Ω]."""
    time: float
    """τ = R_1 C_1 of the pair [s]."""
    activation: float
    """B of R = R_25 e^(B (1/T - 1/298.15 K)) [K]; 0: whatever the temperature."""


class CellState(NamedTuple):
    """What cells remember."""

    charge: float
    """State of charge [-]."""
    polarisation: float = 0.0
    """Voltage of the pair v_1 [V]."""


class CellStep(NamedTuple):
    """Cells over one interval of constant power."""

    step: BatteryStep
    """As of a plain battery; its loss is the heat of both resistances."""
    state: CellState
    """At its end."""


def resistance_factor(cells: Cells, temperature: float) -> float:
    """Return by what the resistances are larger than at 25 °C [-].

    Args:
        cells: The cells.
        temperature: Theirs [K].

    Source: Arrhenius.
    """
    return math.exp(cells.activation * (1.0 / temperature - 1.0 / REFERENCE))


def held_energy(battery: Battery, cells: Cells, state: CellState) -> float:
    """Return the energy that cells hold, with that of the pair's capacity [J].

    Args:
        battery: With its charge.
        cells: With its curve.
        state: Of them.

    Source: Q ∫ U ds over the straight pieces of the curve; C_1 v_1²/2 with C_1 = τ/R_1 at 25 °C.
    """
    total, s = 0.0, min(max(state.charge, 0.0), 1.0)
    pieces = zip(cells.charges, cells.charges[1:], cells.voltages, cells.voltages[1:], strict=False)
    for low, high, first, last in pieces:
        if s <= low:
            break
        end = min(s, high)
        slope = (last - first) / (high - low)
        total += (end - low) * (first + 0.5 * slope * (end - low))
    slow = 0.5 * cells.time / cells.slow_resistance * state.polarisation**2 if cells.slow_resistance else 0.0
    beyond = (state.charge - s) * (cells.voltages[-1] if state.charge > 1.0 else cells.voltages[0])
    return battery.charge * (total + beyond) + slow


def open_voltage(cells: Cells, charge: float) -> float:
    """Return the open-circuit voltage [V].

    Args:
        cells: With their curve.
        charge: State of charge [-].
    """
    pieces = zip(cells.charges, cells.charges[1:], cells.voltages, cells.voltages[1:], strict=False)
    for low, high, first, last in pieces:
        if charge <= high:
            return first + (last - first) * max(charge - low, 0.0) / (high - low)
    return cells.voltages[-1]


def cell_step(
    battery: Battery, cells: Cells, state: CellState, *, power: float, duration: float, temperature: float
) -> CellStep:
    """Return cells after an interval of constant power at their terminals.

    The current is constant in the interval; open-circuit voltage and the pair's voltage are their exact means for it,
    so that what the chemistry gives is power, heat and the pair's energy, to rounding.

    Args:
        battery: Capacity, resistance and limits.
        cells: Curve, pair, activation.
        state: At the start.
        power: At the terminals; negative charges [W].
        duration: [s].
        temperature: Of the cells [K].

    Source: (U_mean - R_0 I - v_mean) I = P; v_1' = (R_1 I - v_1)/τ, whose mean is R_1 I + (v_0 - R_1 I) φ(Δt/τ).
    """
    warm = resistance_factor(cells, temperature)
    fast, slow = battery.resistance * warm, cells.slow_resistance  # the pair stays: its capacity would warm up, too
    x = duration / cells.time
    phi = -math.expm1(-x) / x
    held = CellState(state.charge)
    current, square, mean = 0.0, 0.0, open_voltage(cells, state.charge)
    for _ in range(_MOST_ROUNDS):
        voltage, effective = mean - state.polarisation * phi, fast + slow * (1.0 - phi)
        square = voltage * voltage - 4.0 * effective * power
        after = 2.0 * power / (voltage + math.sqrt(max(square, 0.0)))
        settled = abs(after - current) <= _SETTLED * highest_current(battery)
        current = after
        passed = current * duration / battery.charge
        if abs(passed) > 1e-12:
            there = held_energy(battery, cells, CellState(state.charge - passed))
            mean = (held_energy(battery, cells, held) - there) / (battery.charge * passed)
        if settled:
            break
    final = state.charge - current * duration / battery.charge
    last = slow * current + (state.polarisation - slow * current) * math.exp(-x)
    terminal = power / current if current else mean - state.polarisation * phi
    gained = 0.5 * cells.time / slow * (last**2 - state.polarisation**2) if slow else 0.0
    heat = (mean - terminal) * current - gained / duration
    fault = _fault(battery, current, final, square)
    return CellStep(BatteryStep(final, current, mean * current, heat, terminal, fault), CellState(final, last))


def _fault(battery: Battery, current: float, final: float, square: float) -> str:
    if square < 0.0 or abs(current) > highest_current(battery) * (1.0 + 1e-9):
        return OVERLOADED
    if final < battery.minimum:
        return EMPTY
    return FULL if final > 1.0 + 1e-12 else ""


def straight(battery: Battery, *, slow_resistance: float = 0.0, time: float = 1.0, activation: float = 0.0) -> Cells:
    """Return cells whose curve is a battery's straight line.

    Args:
        battery: With its two voltages.
        slow_resistance: R_1 [Ω].
        time: τ [s].
        activation: B [K].
    """
    return Cells((0.0, 1.0), (battery.empty_voltage, battery.full_voltage), slow_resistance, time, activation)


# ----------------------------------------------------------------------------------------------------------------------
# A network of heat: capacities, conductances between them and to what they cannot warm, exact over an interval.
# ----------------------------------------------------------------------------------------------------------------------


class Network(NamedTuple):
    """Bodies of one temperature each, in one order."""

    capacity: Floats
    """C of each body, shape (bodies,) [J/K]."""
    between: Floats
    """G between bodies, symmetric, its diagonal not read, shape (bodies, bodies) [W/K]."""
    outside: Floats
    """G from bodies to surroundings, shape (bodies, surroundings) [W/K]."""


class Warmed(NamedTuple):
    """A network after an interval."""

    temperature: Floats
    """Of each body at its end, shape (bodies,) [K]."""
    mean: Floats
    """Mean of the interval, shape (bodies,) [K]."""
    rejected: Floats
    """Mean heat into each of the surroundings, shape (surroundings,) [W]."""


def _matrix(network: Network) -> Floats:
    """Return K of Q = K T - G_out T_out, shape (bodies, bodies) [W/K]."""
    links = network.between - np.diag(np.diag(network.between))
    return np.asarray(np.diag(links.sum(axis=1) + network.outside.sum(axis=1)) - links)


def steady(network: Network, heat: Floats, surroundings: Floats) -> Floats:
    """Return the temperatures at which a network comes to rest, shape (bodies,) [K].

    Args:
        network: The network.
        heat: Into each body, shape (bodies,) [W].
        surroundings: Their temperatures, shape (surroundings,) [K].

    Source: K T = Q + G_out T_out.
    """
    return np.asarray(np.linalg.solve(_matrix(network), heat + network.outside @ surroundings), float)


class Relaxing(NamedTuple):
    """A network by its modes."""

    network: Network
    root: Floats
    """√C of each body, shape (bodies,)."""
    rates: Floats
    """At which modes decay, shape (bodies,) [1/s]."""
    modes: Floats
    """Of C^-1/2 K C^-1/2, shape (bodies, bodies)."""

    def after(self, temperature: Floats, heat: Floats, *, surroundings: Floats, duration: float) -> Floats:
        """Return the temperatures of `warmed` at the end, shape (bodies,) [K].

        Args:
            temperature: Of each body at the start, shape (bodies,) [K].
            heat: Into each body, shape (bodies,) [W].
            surroundings: Their temperatures, shape (surroundings,) [K].
            duration: [s].
        """
        decays, inwards = self.rates * duration, (heat + self.network.outside @ surroundings) / self.root
        start, driven = self.modes.T @ (self.root * temperature), self.modes.T @ inwards
        end = np.exp(-decays) * start + _mean_decay(decays) * duration * driven
        return np.asarray(self.modes @ end / self.root)


def relaxing(network: Network) -> Relaxing:
    """Return a network by its modes.

    Args:
        network: The network.
    """
    root = np.sqrt(network.capacity)
    rates, modes = np.linalg.eigh(_matrix(network) / np.outer(root, root))
    return Relaxing(network, root, np.maximum(rates, 0.0), modes)


def warmed(network: Network, temperature: Floats, heat: Floats, *, surroundings: Floats, duration: float) -> Warmed:
    """Return a network after an interval of constant heat and surroundings.

    What it stores and rejects adds up to what heats it, to rounding: no step is too long.

    Args:
        network: The network.
        temperature: Of each body at the start, shape (bodies,) [K].
        heat: Into each body, shape (bodies,) [W].
        surroundings: Their temperatures, shape (surroundings,) [K].
        duration: [s].

    Source: C dT/dt = Q - K T + G_out T_out, by the modes of C^-1/2 K C^-1/2; e^-x and φ(x) = (1 - e^-x)/x are exact.
    """
    _, root, rates, modes = relaxing(network)
    decays = rates * duration
    first = _mean_decay(decays)
    start, driven = modes.T @ (root * temperature), modes.T @ ((heat + network.outside @ surroundings) / root)
    end = np.exp(-decays) * start + first * duration * driven
    middle = first * start + _mean_rise(decays, first) * duration * driven
    mean = modes @ middle / root
    rejected = network.outside.T @ mean - network.outside.sum(axis=0) * surroundings
    return Warmed(modes @ end / root, mean, rejected)


def _mean_decay(decays: Floats) -> Floats:
    small = np.where(decays < 1e-8, 1.0, decays)
    return np.where(decays < 1e-8, 1.0 - 0.5 * decays, -np.expm1(-small) / small)


def _mean_rise(decays: Floats, first: Floats) -> Floats:
    """(1 - φ)/x, by its series where it would cancel."""
    small = np.where(decays < 1e-3, 1.0, decays)
    series = 0.5 - decays / 6.0 + decays**2 / 24.0 - decays**3 / 120.0
    return np.where(decays < 1e-3, series, (1.0 - first) / small)
