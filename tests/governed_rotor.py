"""A governed propeller on a rigid train, linear about one operating point: kernels are held against it."""

import numpy as np

from gearwright.machines import GovernorState, governor_rates, marched


def governed_response(governor, rotor, kick, *, duration, step=1e-3):
    """Return time [s], ω - ω_set [rad/s] and blade angle [rad] after a speed error, by I ω̇ = s ω - q (β - β_0)."""
    trim = (governor.reference - rotor.pitch) / governor.integral if governor.integral else 0.0

    def rates(state):
        speed, pitch, pitch_rate, error_sum = (float(value) for value in state)
        torque = rotor.speed_slope * speed - rotor.pitch_slope * (pitch - rotor.pitch)
        moved = governor_rates(governor, GovernorState(pitch, pitch_rate, error_sum), -speed)
        return np.array([torque / rotor.inertia, *moved])

    time, states = marched(rates, (kick, rotor.pitch, 0.0, trim), duration=duration, step=step)
    return time, states[:, 0], states[:, 1]
