"""Functional mock-up units (FMI 2.0 and 3.0): a drive train in C for simulators of others, which needs no Python.

What moves and by which laws is `dynamics`; here it is only written in another language.
"""

from gearwright.exchange.fmu.write import (
    COMPILERS,
    Binary,
    FmuFile,
    MachinePort,
    Port,
    compiled,
    fmu_of_system,
    fmu_of_window,
    ports_of,
    to_fmu,
)

__all__ = [
    "COMPILERS",
    "Binary",
    "FmuFile",
    "MachinePort",
    "Port",
    "compiled",
    "fmu_of_system",
    "fmu_of_window",
    "ports_of",
    "to_fmu",
]
