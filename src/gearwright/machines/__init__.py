"""Turbine, motor and propeller as the gearbox sees them: mass and inertia by closed laws."""
