"""The power that air of a temperature leaves: a mission's law without a deck held against engines by their components.

    python benchmarks/temperature_lapse.py

Prints what `P_0 δ_t θ_t^n` of a mission that states no exponents is above each engine, in per cent, over pressure
altitude and days off the standard one; below, the same with the exponent -0.5 of a constant turbine temperature alone.
"""

from gearwright.air import air_at, stagnation_ratios
from gearwright.catalogue import DesignPoint
from gearwright.catalogue.turboshafts import highest_state, inlet_at, turboshaft_engine
from gearwright.machines import Engine, power_limits
from gearwright.machines.turboshaft import steady_state
from gearwright.spec import EngineRules
from gearwright.units import KWH

RPM = 0.10471975511965977
ENGINES = {
    "376 kW, 8.2": DesignPoint(376e3, 0.35 / KWH, 2.2, 8.2, 51500 * RPM),
    "835 kW, 9": DesignPoint(835e3, 0.35 / KWH, 3.609, 9.0, 43000 * RPM),
    "1500 kW, 17": DesignPoint(1500e3, 0.29 / KWH, 5.5, 17.0, 44000 * RPM),
    "3000 kW, 18": DesignPoint(3000e3, 0.27 / KWH, 11.0, 18.0, 29000 * RPM),
}
"""Power and pressure ratio -> design point; air flow and consumption are those of engines of their size."""
ALTITUDES, DAYS, MACHS = (0.0, 2000.0, 4000.0, 6000.0), (-20.0, -10.0, 0.0, 10.0, 20.0, 30.0, 40.0), (0.0, 0.3, 0.5)


def law(exponents):
    """Return an engine of 1 W whose core follows exponents."""
    return Engine(1.0, 1.0, 1.0, 0.0, 0.0, *exponents)


def table(mach, laws):
    """Print the errors at one Mach number."""
    for name, design in ENGINES.items():
        engine = turboshaft_engine(design)
        hottest = steady_state(engine, inlet_at(0.0, 0.0), design.speed).between
        print(f"\n{name}, Mach {mach:g}: above the components in %, at ISA", *(f"{day:+6g}" for day in DAYS))
        for label, engine_law in laws.items():
            for altitude in ALTITUDES:
                errors = []
                for day in DAYS:
                    theta, delta = stagnation_ratios(air_at(altitude, day), mach)
                    top = highest_state(engine, inlet_at(altitude, mach, day), hottest)[1].power / design.power
                    errors.append(100.0 * (power_limits(engine_law, theta, delta, 1.0).core / top - 1.0))
                print(f"{label:>36s} {altitude:6g} m", *(f"{error:6.1f}" for error in errors))


if __name__ == "__main__":
    usual = EngineRules()
    exponents = (usual.temperature_exponent, usual.hot_exponent)
    laws = {f"n = {exponents[0]:g}, {exponents[1]:g}": law(exponents), "n = -0.5": law((-0.5, -0.5))}
    for mach in MACHS:
        table(mach, laws)
