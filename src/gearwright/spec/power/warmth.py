"""What warms up beside the gearbox: cells of a battery, windings of motors."""

from __future__ import annotations

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Ratio, Time


class CellRules(Record):
    """The battery as an equivalent circuit that warms and ages."""

    ocv_charge: list[float] | None = Field(
        None, min_length=2, max_length=101, description="States of charge from 0 to 1, rising; with ocv_v"
    )
    ocv_v: list[float] | None = Field(
        None, min_length=2, max_length=101, description="Open-circuit voltages there; left out: a line between the two"
    )
    slow_resistance_ohm: float = Field(0.0, ge=0, le=100, description="R_1 of the pair of R and C")
    slow_time: Time = Field(30.0, ge=0.01, le=1e5, description="τ = R_1 C_1 of the pair")
    activation_k: float = Field(0.0, ge=0, le=2e4, description="B of R = R_25 e^(B (1/T - 1/298.15 K))")
    start_temperature_k: float = Field(298.15, ge=180, le=400, description="Of the cells at the start")
    specific_energy_wh_kg: float = Field(180.0, gt=1, le=2000, description="Of the pack: says its mass")
    heat_capacity_j_kg_k: float = Field(1000.0, gt=1, le=1e4, description="Of the pack")
    cooling_w_k: float = Field(0.0, ge=0, le=1e7, description="From the cells to coolant or air")
    coolant_temperature_k: float | None = Field(
        None, ge=180, le=400, description="Of the coolant; left out: the air around the aircraft cools"
    )
    highest_temperature_k: float = Field(333.15, ge=180, le=500, description="Of the cells, where a flight ends")
    lowest_temperature_k: float = Field(253.15, ge=150, le=400, description="Of the cells, where a flight ends")
    cycle_life: float | None = Field(
        None, gt=0, le=1e7, description="Equivalent full cycles at 25 °C until the pack is worn; left out: not counted"
    )
    calendar_years: float | None = Field(
        None, gt=0, le=1e3, description="Years at 25 °C until the pack is worn; left out: not counted"
    )
    doubling_k: float = Field(10.0, gt=0, le=100, description="Rise of temperature that doubles ageing")
    bus_resistance_ohm: float = Field(0.0, ge=0, le=10, description="Of the DC bus between pack and inverters")


class WindingRules(Record):
    """The warmth of a motor: winding and case; all motors of a gearbox are alike."""

    winding_capacity_j_k: float = Field(gt=0, le=1e8, description="Of copper and insulation")
    case_capacity_j_k: float = Field(gt=0, le=1e8, description="Of iron and case")
    winding_to_case_w_k: float = Field(gt=0, le=1e6, description="Between them")
    case_to_coolant_w_k: float = Field(ge=0, le=1e6, description="From the case to coolant or air")
    coolant_temperature_k: float | None = Field(
        None, ge=180, le=450, description="Of the coolant; left out: the air around the aircraft cools"
    )
    start_temperature_k: float | None = Field(None, ge=180, le=450, description="At the start; left out: the coolant's")
    rated_winding_k: float = Field(393.15, ge=200, le=600, description="Of the winding at which motor.efficiency holds")
    derate_from_k: float | None = Field(
        None, ge=180, le=700, description="From here on the limits fall, to nothing at the highest; left out: they hold"
    )
    highest_winding_k: float = Field(
        453.15, ge=180, le=700, description="Of the winding; 453.15 K is class H of IEC 60085"
    )
    winding_loss: Ratio = Field(1.0, ge=0, le=1, description="Part of the copper loss that warms the winding itself")
