"""What one bearing bears over the life that is asked of it, by the load cases and their levels."""

from __future__ import annotations

from collections.abc import Sequence

from gearwright.arrays import Floats
from gearwright.catalogue import BearingSpectrum
from gearwright.sizing.rating import Context
from gearwright.spec.design import levels_of, shares_of


def duty_of(
    context: Context, radial: Floats, axial: Floats, speeds: Sequence[float], *, life: float | None = None
) -> BearingSpectrum:
    """Return what a bearing bears: every case for the static safety, then its levels for the life.

    Without shares one case lasts the whole life.

    Args:
        context: What sizing reads.
        radial: In every case [N].
        axial: In every case [N].
        speeds: Of one ring against the other, in every case [rad/s].
        life: Asked; left out: that of the service [s].
    """
    design, service, said = context.design, context.design.service, shares_of(context.design)
    shares = said or {context.reference.case: 1.0}
    levels = [
        (k, level, part * shares.get(case, 0.0))
        for k, case in enumerate(context.flows)
        for level, part in levels_of(design, case)
    ]
    whole = [(k, 1.0, 0.0) for k in range(len(context.flows))]
    rows = [*whole, *levels]
    return BearingSpectrum(
        radial=tuple(level * float(radial[k]) for k, level, _ in rows),
        axial=tuple(level * float(axial[k]) for k, level, _ in rows),
        speed=tuple(speeds[k] for k, _, _ in rows),
        share=tuple(share for _, _, share in rows),
        life=life or service.bearing_life,
        static_safety=service.static_safety,
        mean_factor=1.0 if said or service.spectrum else service.mean_load,
        limit_factor=service.application_factor,
    )
